# SPDX-License-Identifier: BSD-3-Clause
"""Liquids at rest: between two blocks under pressure, in a column under its own pressure, and in a column under gravity."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DENSITY, C0 = 998.2, 1483.0  # of water.xml: Density, Sound Speed
LENGTH, RESERVOIR = 0.1, 0.5e6  # of water_hammer.xml [m, Pa]
GRAVITY = 1e4  # [m/s2]: the weight of the column is 1 MPa

AWAKE = {"Step/Skip Dormant Tiles": "false", "Step/Rest Motion": "0"}  # every node moves, every particle is updated
STILL = {**AWAKE, "Bodies/Column/Velocity": "{0 m/s, 0 m/s}"}


def fastest(run):
    """Largest velocity of a particle at the end, over the sound speed."""
    last = run.particles()
    return float(np.sqrt(last["velocity_x"] ** 2 + last["velocity_y"] ** 2).max()) / C0


def spread(run, pressure):
    """Largest difference of a particle's pressure to this one at the end, over it."""
    return float(np.abs(run.particles()["pressure"] / pressure - 1.0).max())


def weight_error(run, h):
    """Largest difference of the pressure to the reservoir's and the weight above, over the weight of the column: means over the particles
    of a cell, whose strains are one."""
    first, last = run.particles(0), run.particles()
    above = first["density"] * (LENGTH - first["x"]) * GRAVITY
    excess = last["pressure"] - RESERVOIR - above
    cell = np.floor(first["x"] / h).astype(int)
    means = np.bincount(cell, excess) / np.bincount(cell)
    return float(np.abs(means).max() / (DENSITY * LENGTH * GRAVITY))


def run(barreno, full):
    result = Result(
        "Liquids at rest",
        "A liquid starts in equilibrium with what surrounds it, and carries its own weight.",
        "no motion; p = p_0 + g m / A below the mass m.",
        ["what", "shape function", "largest velocity over c", "pressure error"],
        [],
    )
    for shape in ("GIMP", "CPDI") if full else ("GIMP",):
        gap = run_deck(barreno, "liquid_gap.xml", {**AWAKE, "Step/Shape Function": shape})
        column = run_deck(barreno, "water_hammer.xml", {**STILL, "Step/Shape Function": shape})
        for name, finished, pressure in (("gap", gap, 10e6), ("column", column, RESERVOIR)):
            result.rows.append([name, shape, fastest(finished), spread(finished, pressure)])
            result.demand(f"velocity over c, {name}, {shape}", fastest(finished), 1e-13)
            result.demand(f"pressure, {name}, {shape}", spread(finished, pressure), 1e-9)
    for cells in (50, 100, 200) if full else (50, 100):
        h = LENGTH / cells
        settings = {
            **STILL,
            "Grid/Cell Size": f"{h!r} m",
            "Grid/Upper": f"{{{LENGTH + 4 * h!r} m, {h!r} m}}",
            "Bodies/Column/Upper": f"{{{LENGTH!r} m, {h!r} m}}",
            "Body Force/Kind": "gravity",
            "Body Force/Acceleration": f"{{-{GRAVITY!r} m/s2, 0 m/s2}}",
            "Step/Damping": "46000 1/s",  # critical for the slowest mode
            "Time/End Time": "1 ms",
            "Output/Field Interval": "1 ms",
        }
        heavy = run_deck(barreno, "water_hammer.xml", settings)
        result.rows.append([f"weight, {cells} cells", "as in the deck", fastest(heavy), weight_error(heavy, h)])
        result.demand(f"pressure under its weight, {cells} cells", weight_error(heavy, h), 1e-3)
    result.notes = (
        "Under gravity the largest error is that of the two cells at the ends of the column, whose nodes carry half a cell; between "
        "them it is below 1e-5. The particles of a cell have one strain, so that single pressures are those of a cell's middle."
    )
    return result
