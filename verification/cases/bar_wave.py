# SPDX-License-Identifier: BSD-3-Clause
"""Standing wave of an elastic bar, fixed at one end: frequency and energy against the exact mode."""
import math

import numpy as np
from tools.case import Result
from tools.runs import order, run_deck
from scipy.optimize import curve_fit

SPEED, LENGTH = 1000.0, 1.0
OMEGA = math.pi * SPEED / (2.0 * LENGTH)


def settings(cells):
    h = LENGTH / cells
    return {
        "Grid/Cell Size": f"{h!r} m",
        "Grid/Upper": f"{{{1.0 + 4 * h!r} m, {h!r} m}}",
        "Bodies/Bar/Upper": f"{{1 m, {h!r} m}}",
        "Time/End Time": "4 ms",
        "Output/Field Interval": "4 ms",
    }


def frequency(run):
    """K(t) = K0 cos^2(omega t + phase) over one period, by least squares; velocity leads by half a step."""
    table = run.table("history.csv")
    kinetic = table["kinetic"] / table["kinetic"][0]
    fit, _ = curve_fit(lambda t, w, a, phase: a * np.cos(w * t + phase) ** 2, table["time"], kinetic, p0=[OMEGA, 1.0, 0.0])
    return fit[0], table


def run(barreno, full):
    result = Result(
        "Standing wave of an elastic bar",
        "GIMP at two particles per cell: the frequency of the first mode converges at second order, and energy is conserved.",
        "omega = pi c / (2 L), uniaxial strain.",
        ["cells", "frequency error", "order", "energy drift over one period", "energy ledger remainder"],
        [],
    )
    errors = []
    for cells in (10, 20, 40, 80) if full else (10, 20):
        finished = run_deck(barreno, "bar_wave.xml", settings(cells))
        omega, table = frequency(finished)
        errors.append(abs(omega / OMEGA - 1.0))
        energy = table["kinetic"] + table["elastic"]
        drift = abs(energy[-1] / energy[0] - 1.0)
        rate = order(errors)[-1] if len(errors) > 1 else float("nan")
        result.rows.append([cells, errors[-1], rate, drift, finished.summary["balances"]["energy"]["error"]])
    # Lumped mass and linear functions: omega_h / omega = (2 / k h) sin(k h / 2), here the fourth of a wave in the bar.
    k_h = math.pi / 2.0 / 20
    dispersion = 1.0 - 2.0 / k_h * math.sin(k_h / 2.0)
    result.demand("frequency error at 20 cells against the dispersion of the grid + 0.2 %", errors[1], dispersion + 2e-3)
    result.demand("order of the frequency", order(errors)[0], 1.7, at_least=True)
    result.demand("energy drift over one period, 20 cells", result.rows[1][3], 1e-3)
    return result
