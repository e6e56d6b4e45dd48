# SPDX-License-Identifier: BSD-3-Clause
"""Rock around the hole: rings in which crushing or dilation has changed its porosity and broken its grains, their permeability and
skin."""

import dataclasses

import numpy as np

from barreno.report.hole import jet_particles
from barreno.report.particles import areas_of
from barreno.report.porosity import IMPAIRED, breakage_of, permanent_porosity, relative_permeability, skin, virgin_porosity

HIGH = 2.0  # cells: distance of the rows of rings, and half the height over which one is averaged
CHANGED = 0.05  # of the virgin porosity: less change is no zone


@dataclasses.dataclass
class Rings:
    """Rings of rock around the hole at a depth."""

    depth: float  # [m]
    edges: np.ndarray  # radii, one more than there are rings; the first is the wall [m]
    porosity: np.ndarray  # nan where there is no rock
    breakage: np.ndarray
    virgin: float

    @property
    def radius(self):
        return 0.5 * (self.edges[1:] + self.edges[:-1])

    @property
    def permeability(self):
        return relative_permeability(self.porosity, self.virgin, self.breakage)

    @property
    def skin(self):
        there = np.isfinite(self.porosity)
        permeability = np.where(there, self.permeability, 1.0)
        return skin(self.edges, permeability) if self.edges[0] > 0.0 else float("nan")

    def reach(self, changed):
        """Inner radius of the first ring for which something holds, and outer radius of the last; those of the wall where none is."""
        found = np.flatnonzero(changed & np.isfinite(self.porosity))
        return (float(self.edges[found[0]]), float(self.edges[found[-1] + 1])) if len(found) else (float(self.edges[0]),) * 2

    @property
    def crushed(self):
        """From and to which radius."""
        return self.reach(self.porosity < (1.0 - CHANGED) * self.virgin)

    @property
    def dilated(self):
        return self.reach(self.porosity > (1.0 + CHANGED) * self.virgin)

    @property
    def impaired(self):
        return self.reach(self.permeability < IMPAIRED)

    @property
    def zones(self):
        """As summary.json has them half-way down the hole (`penetration.zones_in_body.NAME`)."""
        (crushed_from, crushed_to), dilated_to = self.crushed, self.dilated[1]
        return {"depth": self.depth, "radius": float(self.edges[0]), "crushed_from": crushed_from, "crushed_to": crushed_to,
            "dilated_to": dilated_to, "impaired_to": self.impaired[1], "least_porosity": float(np.nanmin(self.porosity)),
            "least_permeability": float(np.nanmin(self.permeability)), "greatest_breakage": float(np.nanmax(self.breakage)),
            "skin": self.skin}


class Rock:
    """Particles with pores: where they are, their bulk and the part of it that is grains."""

    def __init__(self, frame, deck, face):
        shapes, of = frame.shapes
        porosity, breakage = permanent_porosity(frame, deck)[of], breakage_of(frame)[of]
        keep = np.isfinite(porosity) & ~jet_particles(frame, deck)[of]
        centre, half = shapes[keep].mean(axis=1), 0.5 * np.ptp(shapes[keep], axis=1)
        self.r, self.depth = np.abs(centre[:, 0]), deck.direction * (centre[:, 1] - face)
        self.half_width, self.half_height = half[:, 0], half[:, 1]
        names = [frame.file.block_names[b] for b in np.unique(frame.block[of][keep])]
        self.material = names[0] if names else ""
        self.virgin = virgin_porosity(deck, self.material) if names else float("nan")
        bulk = areas_of(shapes[keep]) * (self.r if deck.mode == "axisymmetric" else 1.0)
        # Debris lies in pieces: what is between them is no pore.
        ratio = np.maximum(np.nan_to_num(frame.of_alive(["volume_ratio"])[of][keep], nan=1.0), 1.0)
        self.porosity, self.breakage, self.bulk = porosity[keep], breakage[keep], bulk / ratio
        self.of, self.volume = of[keep], bulk  # particle of each shape; volume with what is between pieces, over 2 pi if axisymmetric

    def __len__(self):
        return len(self.r)

    @property
    def width(self):
        return float(self.r.max(initial=0.0))


def shares(middle, half, edges):
    """(particle, interval between edges): which part of its extent a particle has in each."""
    low, high = (middle - half)[:, None], (middle + half)[:, None]
    common = np.minimum(high, edges[1:]) - np.maximum(low, edges[:-1])
    return np.maximum(common, 0.0) / np.maximum(high - low, np.finfo(float).tiny)


def rings_at(rock, hole, depth, wall=None):
    """Rings one cell wide from the wall outwards, averaged over four cells of depth. A particle that is wider than a ring has its part in
    each that it covers.

    @param wall  radius; None: that of the hole
    """
    wall = hole.radius_at(depth) if wall is None else wall
    count = max(1, int((rock.width - wall) / hole.cell))
    edges = wall + hole.cell * np.arange(count + 1)
    within = depth + HIGH * hole.cell * np.array([-1.0, 1.0])
    row = np.abs(rock.depth - depth) < HIGH * hole.cell + rock.half_height
    bulk = rock.bulk[row] * shares(rock.depth[row], rock.half_height[row], within)[:, 0]
    in_rings = bulk[:, None] * shares(rock.r[row], rock.half_width[row], edges)
    total = in_rings.sum(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        porosity, breakage = (np.where(total > 0.0, values[row] @ in_rings / total, np.nan) for values in (rock.porosity, rock.breakage))
    return Rings(depth, edges, porosity, breakage, rock.virgin)


def chosen_depths(hole, top):
    """A quarter, half and three quarters of the hole's length in rock, which begins at a depth."""
    return [top + part * (hole.length - top) for part in (0.25, 0.5, 0.75)] if hole.length > top + 2.0 * hole.cell else []


def zones_of(rock, hole, top):
    """Rings in rows of two cells where the hole is open and has rock around it."""
    return [rings_at(rock, hole, depth) for depth in np.arange(top + hole.cell, hole.length, HIGH * hole.cell)]
