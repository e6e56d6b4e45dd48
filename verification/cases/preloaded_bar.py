# SPDX-License-Identifier: BSD-3-Clause
"""A pulse runs through a preloaded bar and leaves it through a non-reflecting face."""
import math

import numpy as np
from tools.case import Result
from tools.choices import shape_functions
from tools.manufactured_runs import centres
from tools.runs import order, run_deck

MODULUS, BULK, DENSITY, PRELOAD = 1e9, 0.6e9, 1000.0, 1e6
SPEED0, LENGTH, DURATION = 0.1, 1.0, 4e-4
TRAVEL = 0.5 * SPEED0 * DURATION  # of the moved end
GONE = 1.8e-3  # the pulse has left: 1 ms for the bar, 0.4 ms for its own length, and as much again


def settings(mode, shape, cells):
    h = LENGTH / cells
    times = np.arange(0, 41) * DURATION / 40
    factors = np.sin(np.pi * times / DURATION) ** 2
    return {
        "Grid/Mode": mode,
        "Grid/Cell Size": repr(h),
        "Grid/Upper": f"{{{2 * h!r}, {LENGTH + 4 * h!r}}}",
        "Bodies/Bar/Upper": f"{{{2 * h!r}, {LENGTH!r}}}",
        "Conditions/Moved end/Times": "{" + ", ".join(map(repr, map(float, times))) + "}",
        "Conditions/Moved end/Factors": "{" + ", ".join(map(repr, map(float, factors))) + "}",
        "Step/Shape Function": shape,
    }


def exact(y, t, density):
    """Velocity, and stress without the preload, of the wave that runs upwards."""
    speed = math.sqrt(MODULUS / density)
    tau = t - y / speed
    v = np.where((tau > 0.0) & (tau < DURATION), SPEED0 * np.sin(np.pi * tau / DURATION) ** 2, 0.0)
    return v, -density * speed * v


def measure(barreno, mode, shape, cells):
    run = run_deck(barreno, "preloaded_bar.xml", settings(mode, shape, cells))
    history = run.table("history.csv")
    start = run.particles(0)
    y0 = centres(start)[1]
    volume = math.exp(-PRELOAD / BULK)  # under the preload; the log or the linear strain, alike to 1e-6
    density = DENSITY / volume
    impedance = density * math.sqrt(MODULUS / density) * SPEED0
    passing, left, drift = [], [], []
    for step in range(1, run.instants()):
        now = run.particles(step, only=("velocity_y", "stress_yy"))
        if now["time"] < 0.95e-3:
            v, stress = exact(y0, now["time"], density)
            passing.append(np.mean(((now["velocity_y"] - v) / SPEED0) ** 2 + ((now["stress_yy"] + PRELOAD - stress) / impedance) ** 2))
        if now["time"] > GONE:
            bar = y0 > LENGTH / cells  # the row at the moved end keeps a stress: the end has moved, the nodes that move it have not
            v, stress = now["velocity_y"][bar] / SPEED0, (now["stress_yy"][bar] + PRELOAD) / impedance
            left.append(max(np.max(np.abs(v)), np.max(np.abs(stress))))
            drift.append(np.mean(centres(now)[1] - y0))
    late = history["time"] > GONE
    return {
        "wave": float(np.sqrt(np.mean(passing))),
        "peak": max(left),
        "energy": float(np.max(history["kinetic"][late]) / np.max(history["kinetic"])),
        "moved": abs(drift[-1] / TRAVEL - 1.0),
        "drift": abs(drift[-1] - drift[0]) / TRAVEL,
        "remainder": abs(run.summary["balances"]["energy"]["error"]),
    }


def run(barreno, full):
    result = Result(
        "A pulse leaves a preloaded bar",
        "Non-reflecting faces under a confining pressure, and a wall moved by a table.",
        "d'Alembert: a wave in one direction, then rest under the preload, displaced by as much as the wall. Wave: rms errors of "
        "velocity and stress relative to the peaks while it passes. Reflection: largest velocity or stress of any particle "
        f"more than a cell from the moved end, relative to the same, from {1e3 * GONE:g} ms to 4 ms. Drift: mean motion from then on "
        "relative to that of the wall.",
        ["mode", "shape function", "cells", "wave error", "order", "reflected amplitude", "order", "reflected kinetic energy",
         "final position", "drift", "energy ledger remainder"],
        [],
    )  # fmt: skip
    levels = (25, 50, 100) if full else (25, 50)
    for mode in ("plane strain", "axisymmetric"):
        for shape in shape_functions(barreno) or ("GIMP",):
            found = []
            for cells in levels:
                found.append(measure(barreno, mode, shape, cells))
                m = found[-1]
                rates = [order([found[-2][k], m[k]])[0] if len(found) > 1 else float("nan") for k in ("wave", "peak")]
                result.rows.append([mode, shape, cells, m["wave"], rates[0], m["peak"], rates[1], m["energy"], m["moved"], m["drift"],
                                    m["remainder"]])  # fmt: skip
            m = found[1]
            name = f"{mode}, {shape}, 50 cells"
            result.demand(f"{name}: reflected amplitude", m["peak"], 0.02)
            result.demand(f"{name}: reflected kinetic energy", m["energy"], 4e-4)
            result.demand(f"{name}: final position", m["moved"], 1e-2)
            result.demand(f"{name}: drift under the preload", m["drift"], 1e-3)
            result.demand(f"{name}: wave error", m["wave"], 0.05)
            result.demand(f"{name}: energy ledger remainder", m["remainder"], 1e-3)
    return result
