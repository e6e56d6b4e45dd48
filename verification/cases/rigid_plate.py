# SPDX-License-Identifier: BSD-3-Clause
"""A rigid plate on a bar without Poisson's effect: driven at constant speed, and pressed slowly. The force on the plate."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

YOUNG, DENSITY, LENGTH, RADIUS = 20e9, 2300.0, 0.048, 0.003
SPEED, TRAVEL = 0.1, 0.25e-3
WAVE = (YOUNG / DENSITY) ** 0.5
TRANSIT = LENGTH / WAVE
AREA = {"axisymmetric": np.pi * RADIUS**2, "plane strain": RADIUS}


def mean_force(history, begin, end):
    """Impulse on the plate between two times over the time between."""
    at = [np.interp(time, history["time"], history["Plate_impulse_y"]) for time in (begin, end)]
    return (at[1] - at[0]) / (end - begin)


def driven(barreno, settings, area):
    """Forces over rho c v A: of the plateau, and of all until the wave is nearly back."""
    history = run_deck(barreno, "rigid_plate.xml", settings).table("history.csv")
    force = DENSITY * WAVE * SPEED * area
    return mean_force(history, 0.4 * TRANSIT, 1.6 * TRANSIT) / force, mean_force(history, 0.0, 1.6 * TRANSIT) / force


def pressed(barreno, settings, area):
    """At rest: force over that of the shortened bar, and over stress times area in the middle half of the bar."""
    slowly = {
        "Bodies/Plate/Motion": f"{{0 m/s, {-TRAVEL / (2.0 * TRANSIT)} m/s}}",
        "Bodies/Plate/Motion Times": f"{{0 s, {2.0 * TRANSIT} s, {4.0 * TRANSIT} s}}",
        "Bodies/Plate/Motion Factors": "{0, 1, 0}",
        "Step/Damping": f"{3.0 / TRANSIT} 1/s",
        "Time/End Time": f"{16.0 * TRANSIT} s",
    }
    run = run_deck(barreno, "rigid_plate.xml", {**settings, **slowly})
    force = mean_force(run.table("history.csv"), 12.0 * TRANSIT, 16.0 * TRANSIT) / area
    bar = run.particles()
    middle = (np.abs(bar["y"] - 0.5 * LENGTH) < 0.25 * LENGTH) & np.isfinite(bar["stress_yy"])
    return force / (-YOUNG * np.log(1.0 - TRAVEL / LENGTH)), force / -np.mean(bar["stress_yy"][middle])


def run(barreno, full):
    result = Result(
        "Rigid plate on a bar",
        "The force on a rigid body in history.csv agrees with the wave and the stress in the bar.",
        "rho c v A until the wave returns; at rest -E ln(1 - travel / length) A, and stress times area.",
        ["mode", "cell [m]", "driven, F / (rho c v A)", "from the start on", "pressed, F / (E strain A)", "F / (stress A)"],
        [],
        notes="The compressed bar is too stiff by up to one cell over its length: the cell that the plate enters is fully constrained.",
    )
    for mode, area in AREA.items():
        for h in [1e-3, 0.5e-3] + ([0.25e-3] if full else []):
            settings = {"Grid/Mode": mode, "Grid/Cell Size": f"{h} m"}
            plateau, whole = driven(barreno, settings, area)
            short, stress = pressed(barreno, settings, area)
            result.rows.append([mode, h, plateau, whole, short, stress])
            where = f"{mode}, {h} m"
            result.demand(f"error of the force on the plateau, {where}", abs(plateau - 1.0), 1e-3)
            result.demand(f"error of the force with the front's width, {where}", abs(whole - 1.0), 10.0 * h)
            result.demand(f"error of the force against the shortening, in cells over the length, {where}",
                abs(short - 1.0) * LENGTH / h, 1.0)
            result.demand(f"error of the force against the stress, {where}", abs(stress - 1.0), 1e-4)
    return result
