# SPDX-License-Identifier: BSD-3-Clause
"""Wave from a spherical cavity whose wall takes a pressure (Blake), on a surface that cuts the cells."""

import numpy as np
from tools.case import Result
from tools.choices import shape_functions
from tools.manufactured_runs import centres
from tools.octant import along, radial_stress, radii
from tools.runs import order, run_deck

from oracles.cavity_waves import blake

SPEED, MODULUS, PRESSURE = 1000.0, 1e9, 1e3  # of the deck; radius 1 m, density 1000 kg/m3
MILLI = 1e-3
FRONT = 0.25  # of the velocity and stress, this much on both sides of the front is left out [m]


def measure(barreno, settings, by_volume=False):
    """rms errors over the particles (by_volume: over the volume) behind the front and the instants written: displacement, velocity, radial
    stress; over p a / M, p / (rho c) and p. And the relative error of the wall's displacement at the end, the remainder of the energy
    ledger, the particles."""
    run = run_deck(barreno, "spherical_wave.xml", settings)
    start = run.particles(0)
    X = np.array(centres(start))
    R, n = radii(start)
    cell = 1.0 / round(1.0 / float(settings["Grid/Cell Size"]))
    weight = X[0] if by_volume and len(X) == 2 else np.ones_like(R)  # rings
    squares = [[], [], []]
    mean = lambda error, where: np.average(error[where] ** 2, weights=weight[where])  # noqa: E731
    for step in range(1, run.instants()):
        now = run.particles(step)
        t = now["time"] / MILLI
        u, v, stress = blake(R, t)
        moved = np.sum((np.array(centres(now)) - X) * n, 0)
        reached = R < 1.0 + t
        away = reached & (np.abs(R - 1.0 - t) > FRONT)
        squares[0].append(mean(moved * MODULUS / PRESSURE - u, reached))
        squares[1].append(mean(along(now, n) * MODULUS / PRESSURE / SPEED - v, away))
        squares[2].append(mean(radial_stress(now, n) / PRESSURE - stress, away))
    errors = [float(np.sqrt(np.mean(s))) for s in squares]
    wall = R < 1.0 + cell
    return errors, float(np.mean(moved[wall] * MODULUS / PRESSURE / u[wall])) - 1.0, run.summary["balances"]["energy"]["error"], len(R)


def run(barreno, full):
    result = Result(
        "Wave from a spherical cavity",
        "A pressure on a moving curved surface that cuts the cells: arrival, decay with radius, ringing of the wall.",
        "Blake (`verification/oracles/cavity_waves.py`). rms errors over the particles behind the front and six instants, velocity "
        f"and stress at more than {FRONT} m from the front; relative to p a / (rho c^2), p / (rho c) and p. Wall: mean final "
        "displacement of the particles within a cell of it.",
        ["shape function", "cells per radius", "displacement error", "order", "velocity error", "order", "stress error", "order",
         "displacement of the wall", "energy ledger remainder"],
        [],
    )  # fmt: skip
    levels = (8, 16, 32) if full else (8, 16)
    for shape in shape_functions(barreno):
        errors = []
        for cells in levels:
            found, wall, remainder, _ = measure(barreno, {"Grid/Cell Size": repr(1.0 / cells), "Step/Shape Function": shape})
            errors.append(found)
            rates = [order([a, b])[0] for a, b in zip(*errors[-2:])] if len(errors) > 1 else [float("nan")] * 3
            result.rows.append([shape, cells, *(x for pair in zip(found, rates) for x in pair), wall, remainder])
        result.demand(f"{shape}: displacement error at 16 cells", errors[1][0], 1e-2)
        result.demand(f"{shape}: velocity error at 16 cells", errors[1][1], 5e-2)
        result.demand(f"{shape}: stress error at 16 cells", errors[1][2], 5e-2)
        result.demand(f"{shape}: order of the displacement", order([e[0] for e in errors])[-1], 0.8, at_least=True)
    result.notes = (
        "A jump spans a fixed number of cells, and a load present from the start acts half a step early (see the wave from a cylindrical "
        "cavity): first order."
    )
    return result
