# SPDX-License-Identifier: BSD-3-Clause
"""Cylinder test in one dimension: velocity of the copper wall where it has moved 6, 12.5 and 19 mm, for four explosives."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

MOVED = (6.0, 12.5, 19.0)  # of the outer surface [mm]
BORE, OUTER, COPPER = 12.7e-3, 15.306e-3, 8930.0
# Mean velocity of the wall [m/s], from a Lagrangian calculation in one dimension with 60 cells of gas and 8 of copper.
EXACT = {"comp_b": (1381.0, 1545.0, 1600.0), "tnt": (1164.0, 1318.0, 1377.0), "c_4": (1346.0, 1490.0, 1545.0),
    "pbx_9404": (1569.0, 1743.0, 1797.0)}


def settings(card, h):
    return {
        "Materials/Comp B/Card": f"{card}.xml",
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{40 mm, {h} mm}}",
        "Bodies/Charge/Upper": f"{{12.7 mm, {h} mm}}",
        "Bodies/Tube/Upper": f"{{15.306 mm, {h} mm}}",
        "Detonation/Detonators/Face/Position": f"{{0 mm, {0.5 * h} mm}}",
    }


def wall(start, particles):
    """Outer radius of the tube and its mean velocity. The radius follows from the mean of r^2 over the mass and the area of the section,
    which the pressure no longer changes by then: r_out^2 = mean + area / (2 pi)."""
    copper = np.isnan(particles["burn"])
    mass = start["x"][copper]  # of particles of one size: as their radius at the start
    square = float(np.average(particles["x"][copper] ** 2, weights=mass))
    radius = np.sqrt(square + 0.5 * (OUTER**2 - BORE**2))
    return radius, float(np.average(particles["velocity_x"][copper], weights=mass))


def run(barreno, full):
    result = Result(
        "Cylinder test",
        "Products on their isentropes, to seven times the volume of the explosive, drive a wall as fast as another method finds.",
        "An independent Lagrangian calculation in one dimension (finite differences, radial motion, all burnt at the start, copper "
        "without strength). Mean velocity of the wall when its outer surface has moved 6, 12.5 and 19 mm.",
        ["explosive", "cell [mm]", *(f"velocity at {x:g} mm [m/s]" for x in MOVED), *(f"error at {x:g} mm" for x in MOVED),
         "energy ledger remainder"],
        [],
    )  # fmt: skip
    for card in EXACT if full else ("comp_b",):
        for h in (0.4, 0.2) if full else (0.4,):
            finished = run_deck(barreno, "cylinder_test.xml", settings(card, h))
            history = np.array([wall(finished.particles(0), finished.particles(step)) for step in range(finished.instants())])
            moved, speed = 1e3 * (history[:, 0] - OUTER), history[:, 1]
            found = [float(np.interp(x, moved, speed)) for x in MOVED]
            errors = [a / b - 1.0 for a, b in zip(found, EXACT[card])]
            remainder = finished.summary["balances"]["energy"]["error"]
            result.rows.append([card, h, *found, *errors, remainder])
            for x, error in zip(MOVED, errors):
                result.demand(f"{card}, {h} mm: velocity at {x:g} mm", abs(error), 0.02)
            result.demand(f"{card}, {h} mm: energy ledger remainder", abs(remainder), 1e-3)
    return result
