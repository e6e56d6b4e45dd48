# SPDX-License-Identifier: BSD-3-Clause
"""A plate thrown by a detonation that runs towards it, with the other face of the charge free: its velocity."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

SPEED, DENSITY, COPPER = 8000.0, 1600.0, 8930.0  # of the deck [m/s, kg/m3, kg/m3]
LENGTH = 0.02  # of the charge [m]
INSTANTS = (3.0, 5.0)  # in L / D
FINE = 0.25  # cells of which the limits are demanded [mm]


def exact(ratio, instant):
    """u / D of a rigid plate with C / M = ratio, at t = instant L / D, for gamma = 3."""
    h = 32.0 / 27.0 * ratio
    return 1.0 - 2.0 / h * (np.sqrt(1.0 + h - h / instant) - 1.0) - 1.0 / np.sqrt((1.0 + h) * instant**2 - h * instant)


def settings(ratio, h):
    plate = 1e3 * LENGTH * (1.0 + DENSITY / (ratio * COPPER))  # its far face [mm]
    return {
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{60 mm, {h} mm}}",
        "Bodies/Charge/Upper": f"{{20 mm, {h} mm}}",
        "Bodies/Plate/Upper": f"{{{plate!r} mm, {h} mm}}",
    }


def run(barreno, full):
    result = Result(
        "Flyer plate",
        "The energy of the explosive goes into the plate as it should, and not into the gas.",
        "Aziz, Hurwitz & Sternberg, Phys. Fluids 4 (1961) 380-384: a rigid plate, gamma = 3. The plate is copper, which rings by some per "
        "mille of its speed; its mean velocity is compared.",
        ["charge over plate (mass)", "cell [mm]", *(f"error of u at {x:g} L/D" for x in INSTANTS), "energy given over that of the charge",
         "removed particles", "energy ledger remainder"],
        [],
    )  # fmt: skip
    for ratio in (0.5, 1.0, 2.0):
        for h in (0.5, FINE) if full else (FINE,):
            finished = run_deck(barreno, "flyer_plate.xml", settings(ratio, h))
            errors = []
            for instant in INSTANTS:
                now = finished.particles(int(round(instant)))
                plate = np.isnan(now["burn"])
                mean = float(now["velocity_x"][plate].mean())  # of equal masses
                errors.append(mean / SPEED / exact(ratio, now["time"] * SPEED / LENGTH) - 1.0)
            balances = finished.summary["balances"]
            charge = DENSITY * LENGTH * 1e-3 * h * SPEED**2 / 16.0
            gone = sum(cause["count"] for cause in finished.summary["removed_particles"].values())
            result.rows.append([ratio, h, *errors, balances["energy"]["explosive"] / charge, gone, balances["energy"]["error"]])
            for instant, error in zip(INSTANTS, errors):
                if h == FINE:
                    result.demand(f"C/M {ratio:g}, {h} mm: velocity at {instant:g} L/D", abs(error), 0.02)
            result.demand(f"C/M {ratio:g}, {h} mm: energy ledger remainder", abs(balances["energy"]["error"]), 1e-3)
    result.notes = (
        "Limits are demanded with cells of 0.25 mm; those of 0.5 mm are shown, and miss 2 % once, for the thickest plate at 3 L/D. That "
        "plate is "
        "four tenths as thick as the charge, and waves run through it: it is not the rigid one of the exact solution while it is pushed."
    )
    return result
