# SPDX-License-Identifier: BSD-3-Clause
"""Shocks in water: their speed against the line through the points that were measured."""
from cases.shock_water import jump, plateau, settings
from tools.experiment import RECALLED, Experiment
from tools.runs import run_deck

CELLS = (1.0, 0.5)  # mm
SPEEDS = (0.5, 1.0, 2.0)  # u_p [km/s]
REST, SLOPE = 1.647, 1.921  # of the measured line [km/s]
MARSH = "Marsh, LASL Shock Hugoniot Data (1980): U_s = 1.647 km/s + 1.921 u_p"


def shock_speed(barreno, cells, speed):
    """[km/s]"""
    shape = {"Step/Shape Function": "quadratic B-spline"}
    run = run_deck(barreno, "shock_water.xml", {**settings(cells, 1e3 * speed), **shape})
    return 1e-3 * jump(1e3 * speed)["shock speed"] * (1.0 + plateau(run, 1e3 * speed, 1e-3 * cells)["shock speed"])


def run(barreno, full):
    cells = CELLS if full else CELLS[:1]
    experiment = Experiment(
        "Shocks in water",
        "A shock in water is as fast as measured.",
        "symmetric impact of two layers (`input_xml/shock_water.xml`), card `water`, quadratic B-spline; u_p is half of the velocity of "
        "impact. Plane strain, one cell wide; cells",
        cells=list(cells),
    )  # fmt: skip
    for speed in SPEEDS if full else SPEEDS[1:2]:
        experiment.compare(f"U_s at u_p = {speed:g} km/s [km/s]", f"{REST + SLOPE * speed:.3f}", RECALLED, MARSH,
            [shock_speed(barreno, h, speed) for h in cells])
    experiment.notes = (
        "The card's line goes through the sound speed, 1.483 km/s, where that of the shocks does not: "
        "[liquids](materials/liquids.md#values-and-marks). Its jump conditions are verified in "
        "[shock_water](verification/shock_water.md)."
    )
    return experiment
