# SPDX-License-Identifier: BSD-3-Clause
"""Rock around a hole on rings of equal cells, from the particles of a run: porosity, breakage, permeability, and which cells the hole has
taken."""

import dataclasses

import numpy as np

from barreno.report.hole import face_of, measure_hole, rear_of
from barreno.report.hole_section import face_of_rock
from barreno.report.porosity import LEAST_PERMEABILITY, relative_permeability
from barreno.report.zones import Rock, shares
from barreno.runs.faults import Fault

CHUNK = 256  # particles at once
ROCK = 0.5  # of a cell's volume, from which on it is rock


@dataclasses.dataclass
class Rings:
    radii: np.ndarray  # edges [m]
    depths: np.ndarray  # edges, below the outer face [m]
    porosity: np.ndarray  # (rows, columns); nan: no rock
    breakage: np.ndarray  # of grains; nan: no rock
    permeability: np.ndarray  # over that of virgin rock; 0: no rock
    hole: np.ndarray  # whether a cell belongs to the hole
    virgin: float  # porosity
    wall: np.ndarray  # radius of the hole in every row; 0 below the hole [m]
    hole_length: float  # in rock [m]
    rock: Rock = dataclasses.field(repr=False)  # the particles

    @property
    def hole_volume(self):
        return float(np.sum(np.pi * self.wall**2) * (self.depths[1] - self.depths[0]))

    @property
    def hole_radius(self):
        """Of the round hole of its length that has its volume [m]."""
        return float(np.sqrt(self.hole_volume / np.pi / self.hole_length))

    @property
    def middles(self):
        """(radii, depths) of the cells' middles."""
        return tuple(0.5 * (edges[1:] + edges[:-1]) for edges in (self.radii, self.depths))

    @property
    def virgin_mobility(self):
        """The same hole in rock as it was."""
        return np.where(self.permeability > 0.0, 1.0, 0.0)


def in_cells(rock, radii, depths, *amounts, by_depth=False):
    """Sums over cells of amounts that particles carry, from the parts of particles that lie in them.

    @param by_depth  particles in the order of their depth, of which a chunk touches few rows: faster, with other last digits
    """
    sums = [np.zeros((len(depths) - 1, len(radii) - 1)) for _ in amounts]
    order = np.argsort(rock.depth, kind="stable") if by_depth else np.arange(len(rock))
    for first in range(0, len(rock), CHUNK):
        some = order[first : first + CHUNK]
        high = shares(rock.depth[some], rock.half_height[some], depths)
        wide = shares(rock.r[some], rock.half_width[some], radii)
        met = np.flatnonzero(high.any(axis=0)) if by_depth else ()
        rows = slice(met[0], met[-1] + 1) if len(met) else slice(None)
        for total, amount in zip(sums, amounts):
            total[rows] += (high[:, rows] * amount[some, None]).T @ wide
    return sums


def rock_in_cells(rock, radii, depths):
    """(mean porosity, mean breakage, part of the volume that is rock) of cells."""
    bulk, pores, broken = in_cells(rock, radii, depths, rock.bulk, rock.bulk * rock.porosity, rock.bulk * rock.breakage, by_depth=True)
    volume = np.diff(depths)[:, None] * 0.5 * (radii[1:] ** 2 - radii[:-1] ** 2)
    with np.errstate(invalid="ignore", divide="ignore"):
        return pores / bulk, broken / bulk, bulk / volume


def permeability_of(there, porosity, breakage, virgin):
    """k/k_0 of cells; 0 where there is no rock."""
    found = relative_permeability(np.where(there, porosity, virgin), virgin, np.where(there, breakage, 0.0))
    return np.where(there, np.maximum(found, LEAST_PERMEABILITY), 0.0)


def with_neighbours(cells):
    """Cells and those that share a face with one."""
    wider = cells.copy()
    wider[1:] |= cells[:-1]
    wider[:-1] |= cells[1:]
    wider[:, 1:] |= cells[:, :-1]
    wider[:, :-1] |= cells[:, 1:]
    return wider


def with_voids(hole, empty):
    """The hole with all cells without rock that it leads to."""
    while True:
        wider = with_neighbours(hole) & (hole | empty)
        if (wider == hole).all():
            return hole
        hole = wider


def conducts(deck, rock):
    """Whether the deck gives its rock no permeability, or one above 0."""
    given = deck.vector(f"Pore Flow/Rocks/{rock.material}/Permeability")
    return not given or max(given) > 0.0


def rings_of(run, time, cell=None):
    """@param cell  size of the rings' cells; half that of the run along the jet's path if it is not given [m]
    @raises Fault  where there is no hole to flow into, or no rock with pores"""
    deck = run.deck
    if deck.mode != "axisymmetric":
        raise Fault(f"{run.folder} is {deck.mode}; flow is computed through rings of axisymmetric runs alone.")
    if not (deck.has_jet or deck.forms_jet):
        raise Fault(f"{run.folder} has no jet, and so no hole to flow into; its deck has neither Jet nor Jet Monitor.")
    frame, table = run.frame(time), run.depth_table()
    hole = measure_hole(frame, deck, face_of(table, frame.file, deck))
    rock = Rock(frame, deck, hole.face)
    if not (len(rock) and rock.virgin > 0.0):
        raise Fault(f"{run.folder} has no rock with pores, so nothing flows; give a run with a target of Arenisca whose p3_crush_curve is "
            "above 0.")
    if not conducts(deck, rock):
        raise Fault(f"{run.folder} has rock of Pore Flow whose Permeability is 0, so nothing flows; give it one, or leave Pore Flow out.")
    top, rear = face_of_rock(frame, deck, hole.face), rear_of(frame.file, deck, hole.face)
    if hole.length <= top:
        raise Fault(f"{run.folder} has no hole in its rock at {1e6 * frame.time:.4g} us (it is closed, or ends above the rock), so nothing "
            "flows into it; take a later --time, or another run.")
    size = cell or 0.5 * hole.cell
    whole = Rock(run.file.frame(0), deck, hole.face)
    width = float((whole.r + whole.half_width).max())
    radii = np.linspace(0.0, width, max(2, round(width / size)) + 1)
    depths = np.linspace(top, rear, max(2, round((rear - top) / size)) + 1)
    porosity, breakage, part = rock_in_cells(rock, radii, depths)
    middle = 0.5 * (depths[1:] + depths[:-1])
    wall = np.array([hole.radius_at(depth) if depth < hole.length else 0.0 for depth in middle])
    in_hole = (0.5 * (radii[1:] + radii[:-1])[None, :] < wall[:, None])
    there = ~in_hole & (part > ROCK) & np.isfinite(porosity)
    in_hole = with_voids(in_hole, ~there)
    if not in_hole.any():
        raise Fault(f"the hole of {run.folder} is thinner than the cells of {1e3 * size:.3g} mm, so nothing flows into it; give a smaller "
            "--cell.")
    permeability = permeability_of(there, porosity, breakage, rock.virgin)
    porosity, breakage = (np.where(there, values, np.nan) for values in (porosity, breakage))
    return Rings(radii, depths, porosity, breakage, permeability, in_hole, rock.virgin, wall, min(hole.length, rear) - top, rock)
