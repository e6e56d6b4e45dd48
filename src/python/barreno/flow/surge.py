# SPDX-License-Identifier: BSD-3-Clause
"""Clean-up of the hole by a surge: rock without cohesion leaves the wall where the gradient of the pore pressure exceeds a limit."""

import dataclasses

import numpy as np

from barreno.flow.rings import in_cells, rings_of, with_voids
from barreno.flow.solve import Flow, solve
from barreno.report.porosity import permanent_porosity, virgin_porosity
from barreno.report.run import opened
from barreno.report.zones import CHANGED, Rock
from barreno.runs.faults import Fault

LIMIT = 1e8  # assumed [Pa/m]: debris that keeps a strength of 0.1 MPa over 1 mm; docs/flow.md has its range
DAMAGE = 0.9  # assumed: rock that keeps less than a tenth of its cohesion counts as loose
LOOSE = 0.5  # of the rock in a cell, above which the cell is loose
FED = {"radial": (np.s_[:, -1],), "axial": (np.s_[-1],), "both": (np.s_[:, -1], np.s_[-1])}  # cells at the faces that feed the flow


@dataclasses.dataclass
class Inflow:
    """A hole with the rock around it, and the flow into it."""

    rings: object
    shot: Flow
    virgin: Flow  # into the same hole in rock as it was


@dataclasses.dataclass
class Cleaning:
    pressure: float  # of the pores far away, less that of the hole [Pa]
    limit: float  # [Pa/m]
    measure: str  # of lost cohesion
    before: Inflow
    after: Inflow
    mass: float  # of the rock that went [kg]
    passes: int  # that removed rock
    steepest: float  # gradient in loose rock at the wall, before [Pa/m]


def loose_particles(frame, deck):
    """(whether each particle has lost its cohesion, whether it has a history of damage): by its damage, or where the card has none by
    pores that plastic flow has opened beyond the virgin ones, as in the dilated zone of the report."""
    damage = frame.of_alive(["damage"])
    virgin = np.array([virgin_porosity(deck, name) for name in frame.file.block_names])[frame.block]
    dilated = permanent_porosity(frame, deck) > (1.0 + CHANGED) * virgin
    return np.where(np.isfinite(damage), damage >= DAMAGE, dilated), np.isfinite(damage)


def measure_of(damaged):
    """@param damaged  whether particles of the rock have a history of damage"""
    by_damage = f"damage of at least {DAMAGE:g}"
    by_pores = f"porosity more than {CHANGED:.0%} above the virgin one, by dilation"
    return by_damage if damaged.all() else by_pores if not damaged.any() else f"{by_damage}, or where the rock has no damage {by_pores}"


def debris_of(frame, deck, rings):
    """(whether a cell is loose, mass in every cell, measure of lost cohesion, whether there is any)"""
    of, rock = rings.rock.of, rings.rock
    loose, damaged = (values[of] for values in loose_particles(frame, deck))
    mass = 2.0 * np.pi * rock.volume * frame.of_alive(["density"])[of]
    bulk, of_loose, masses = in_cells(rock, rings.radii, rings.depths, rock.bulk, rock.bulk * loose, mass, by_depth=True)
    cells = (of_loose > LOOSE * bulk) & (rings.permeability > 0.0)
    return cells, masses, measure_of(damaged), bool(loose.any() or damaged.any())


def check_pressure(run, rings, pressure):
    """The hole cannot be further below the pore pressure than to zero; a rock whose run has no pore pressure says nothing of it."""
    frame = run.file.frame(0)
    start = Rock(frame, run.deck, 0.0)
    highest = float(np.nan_to_num(frame.of_alive(["pore_pressure"])[start.of]).max(initial=0.0))
    if 0.0 < highest < pressure:
        raise Fault(f"--surge of {1e-6 * pressure:.4g} MPa is more than the pore pressure of {run.folder} at its start, "
            f"{1e-6 * highest:.4g} MPa: the pressure in the hole would be below zero; give a lower one.")


def gradient_of(rings, flow):
    """Gradient of the pressure at the wall in cells of rock next to the hole, for a pressure drop of 1; 0 elsewhere [1/m]. Radially it is
    that of the solver's law between the wall and the cell's middle, p = p(wall) + c ln r; in both directions the steeper of two faces
    counts."""
    middle, pressure = rings.middles[0], np.nan_to_num(flow.pressure)
    at_wall = np.zeros((2, *pressure.shape))

    def steepen(way, rock, hole, per_pressure):
        value = np.where(rings.hole[hole], pressure[rock] * per_pressure, 0.0)
        at_wall[way][rock] = np.maximum(at_wall[way][rock], value)

    first, last = np.s_[:, :-1], np.s_[:, 1:]
    steepen(0, last, first, 1.0 / (rings.radii[1:-1] * np.log(middle[1:] / rings.radii[1:-1])))
    steepen(0, first, last, 1.0 / (rings.radii[1:-1] * np.log(rings.radii[1:-1] / middle[:-1])))
    half = 0.5 * np.diff(rings.depths)[:, None]
    steepen(1, np.s_[1:], np.s_[:-1], 1.0 / half[1:])
    steepen(1, np.s_[:-1], np.s_[1:], 1.0 / half[:-1])
    return np.where(rings.hole | (rings.permeability <= 0.0), 0.0, np.hypot(*at_wall))


def held_rock(rings, hole):
    """Rock that hangs together with the rock at the outer radius or the rear."""
    rock = (rings.permeability > 0.0) & ~hole
    edge = np.zeros_like(rock)
    for face in FED["both"]:
        edge[face] = rock[face]
    return with_voids(edge, rock)


def widened(rings, gone):
    """The rings when cells of rock have gone: the hole takes them and the empty cells that they lead to."""
    hole = with_voids(rings.hole | gone, ~(rings.permeability > 0.0) | gone)
    inner = np.maximum(rings.radii[:-1][None, :], rings.wall[:, None])
    rings_gone = np.where(gone, np.maximum(rings.radii[1:][None, :] ** 2 - inner**2, 0.0), 0.0)
    wall = np.sqrt(rings.wall**2 + rings_gone.sum(axis=1))
    on_axis = np.flatnonzero(gone[:, 0])
    end = rings.depths[on_axis[-1] + 1] - rings.depths[0] if len(on_axis) else 0.0
    porosity, breakage = (np.where(gone, np.nan, values) for values in (rings.porosity, rings.breakage))
    return dataclasses.replace(rings, hole=hole, wall=wall, hole_length=max(rings.hole_length, float(end)), porosity=porosity,
        breakage=breakage, permeability=np.where(gone, 0.0, rings.permeability))


def refuse_all(folder, former, rings, boundary, pressure):
    """A hole that reaches a face which feeds it, and did not before, has no rock to flow through."""
    if any(rings.hole[face].any() and not former.hole[face].any() for face in FED[boundary]):
        raise Fault(f"a surge of {1e-6 * pressure:.4g} MPa would remove the rock of {folder} as far as the face that the fluid comes from "
            f"({boundary} flow), so no rock is left to flow through; give a lower --surge or a higher --surge-limit.")


def cleaned(folder, boundary, pressure, limit, time=None, cell=None, ranks=1):
    """The hole before and after a surge. All loose cells at the wall whose gradient exceeds the limit go at once, and what hangs on nothing
    any more with them; then the flow is solved anew, until nothing goes."""
    with opened(folder) as run:
        rings = rings_of(run, time, cell)
        loose, masses, measure, any_loose = debris_of(run.frame(time), run.deck, rings)
        check_pressure(run, rings, pressure)
    if pressure > 0.0 and not any_loose:
        raise Fault(f"no rock of {folder} has lost its cohesion: its card has no damage, and none has dilated, so no surge removes any; "
            "leave --surge out, or run the deck with a card that has damage, as berea_sandstone_damage.")
    shot = solve(rings, rings.permeability, boundary, ranks)
    before = Inflow(rings, shot, solve(rings, rings.virgin_mobility, boundary, ranks))
    mass, passes, steepest = 0.0, 0, pressure * float(np.where(loose, gradient_of(rings, shot), 0.0).max(initial=0.0))
    while (gone := loose & (pressure * gradient_of(rings, shot) > limit)).any():
        gone |= held_rock(rings, rings.hole) & ~held_rock(rings, rings.hole | gone)
        mass, passes = mass + float(masses[gone].sum()), passes + 1
        rings = widened(rings, gone)
        refuse_all(folder, before.rings, rings, boundary, pressure)
        shot = solve(rings, rings.permeability, boundary, ranks)
    after = Inflow(rings, shot, solve(rings, rings.virgin_mobility, boundary, ranks)) if passes else before
    return Cleaning(pressure, limit, measure, before, after, mass, passes, steepest)
