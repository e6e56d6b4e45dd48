# SPDX-License-Identifier: BSD-3-Clause
"""Wave from a cylindrical cavity whose wall takes a pressure: geometric spreading, a jump, and what it leaves behind."""

import numpy as np
from tools.case import Result
from tools.choices import shape_functions
from tools.manufactured_runs import centres
from tools.runs import order, run_deck

from oracles.cavity_waves import cylindrical

SPEED, MODULUS, PRESSURE = 1000.0, 1e9, 1e3  # of the deck; radius 1 m, density 1000 kg/m3
MILLI = 1e-3
FRONT = 0.25  # of the velocity and stress, this much on both sides of the front is left out [m]


def measure(barreno, shape, cells):
    """rms errors over space and the instants written: displacement, velocity and radial stress behind the front; over the
    displacement, velocity and pressure at the wall when it takes the pressure (p / M, p / rho c, p)."""
    h = 1.0 / cells
    settings = {
        "Grid/Cell Size": repr(h),
        "Grid/Upper": f"{{5.5, {2 * h!r}}}",
        "Bodies/Solid/Upper": f"{{5.0, {2 * h!r}}}",
        "Step/Shape Function": shape,
    }
    run = run_deck(barreno, "cylindrical_wave.xml", settings)
    start = run.particles(0)
    r = centres(start)[0]
    squares = [[], [], []]
    for step in range(1, run.instants()):
        now = run.particles(step)
        t = now["time"] / MILLI
        u, v, stress = cylindrical(r, t)
        away = np.abs(r - 1.0 - t) > FRONT
        squares[0].append(np.mean(((centres(now)[0] - r) * MODULUS / PRESSURE - u) ** 2))
        squares[1].append(np.mean((now["velocity_x"] * MODULUS / PRESSURE / SPEED - v)[away] ** 2))
        squares[2].append(np.mean((now["stress_xx"] / PRESSURE - stress)[away] ** 2))
    errors = [float(np.sqrt(np.mean(s))) for s in squares]
    return errors, run.summary["balances"]["energy"]["error"]


def run(barreno, full):
    result = Result(
        "Wave from a cylindrical cavity",
        "A pressure jump in axisymmetry: its arrival, its decay with radius and the motion behind it.",
        "Laplace transform of the linear solution, inverted numerically (`verification/oracles/cavity_waves.py`). rms errors "
        f"over all particles and six instants, velocity and stress at more than {FRONT} m from the front; relative to p a / (rho c^2), "
        "p / (rho c) and p.",
        ["shape function", "cells per radius", "displacement error", "order", "velocity error", "order", "stress error", "order",
         "energy ledger remainder"],
        [],
    )  # fmt: skip
    levels = (16, 32, 64, 128) if full else (16, 32)
    for shape in shape_functions(barreno):
        errors = []
        for cells in levels:
            found, remainder = measure(barreno, shape, cells)
            errors.append(found)
            rates = [order([a, b])[0] for a, b in zip(*errors[-2:])] if len(errors) > 1 else [float("nan")] * 3
            result.rows.append([shape, cells, *(x for pair in zip(found, rates) for x in pair), remainder])
        result.demand(f"{shape}: displacement error at 32 cells", errors[1][0], 1e-2)
        result.demand(f"{shape}: velocity error at 32 cells", errors[1][1], 2e-2)
        rate = order([errors[0][0], errors[-1][0]], ratio=2.0 ** (len(errors) - 1))[0]
        result.demand(f"{shape}: mean order of the displacement", rate, 0.8, at_least=True)
    result.notes = (
        "A jump spans a fixed number of cells: behind it, errors are of first order at best. A load present from the start acts for the "
        "whole first step on velocities that belong to the midpoint of that step. The load thus acts from half a step before the start, "
        "and the wave arrives half a step too early. This is also first order."
    )
    return result
