# SPDX-License-Identifier: BSD-3-Clause
"""Cryer's ball: the pressure at its centre rises before it falls, though nothing but draining goes on."""
import functools

import numpy as np
from tools.case import Result
from tools.columns import DIFFUSIVITY, ROCK, exact, permeability
from tools.manufactured_runs import centres
from tools.runs import missing_fluid, order, run_deck

LOAD, RAMP = 1e6, 0.5e-3  # Pa, s: of the deck; its ball has a radius of 1 m
SLOWER = 4.0  # than the deck, for waves to matter less
RAMP_T = RAMP * DIFFUSIVITY / SLOWER
INSTANTS, LAST = 15, 0.15  # c t / R^2
FIRST = 0.02  # before it waves of the load are still about
BALL = exact.Cryer(ROCK)


@functools.lru_cache(None)
def centre(T, parts=40):
    """Exact pressure in the middle over that around, under the ramp: the mean of the answers to its parts."""
    begun = T - (np.arange(parts) + 0.5) / parts * RAMP_T
    return float(np.mean([BALL.centre(t) for t in begun]))


def measured_centre(particles, h):
    """A parabola through the pressures near the middle."""
    r = np.hypot(*centres(particles))
    near = r < 3.2 * h
    terms = np.stack([np.ones(near.sum()), r[near] ** 2], axis=1)
    return float(np.linalg.lstsq(terms, particles["pore_pressure"][near] / LOAD, rcond=None)[0][0])


def history(barreno, h):
    """c t / R^2, and the pressure in the middle over that around, measured and exact."""
    settings = {"Grid/Cell Size": repr(h), "Pore Flow/Rocks/Rock/Permeability": f"{{{permeability(SLOWER)!r} m2}}",
                "Time/End Time": repr(LAST * SLOWER / DIFFUSIVITY), "Step/Damping": "4000 1/s",
                "Output/Field Interval": repr(LAST / INSTANTS * SLOWER / DIFFUSIVITY)}  # fmt: skip
    finished = run_deck(barreno, "cryer.xml", settings)
    rows = []
    for instant in range(1, finished.instants()):
        particles = finished.particles(instant)
        T = round(particles["time"] * DIFFUSIVITY / SLOWER, 9)
        rows.append((T, measured_centre(particles, h), centre(T)))
    return np.array(rows), missing_fluid(finished)


def run(barreno, full):
    result = Result(
        "Cryer's ball",
        "Rock that has drained at the surface squeezes the rock that has not: the pressure at the centre rises above its initial value.",
        "the series of the ball (compressible grains and fluid), with the load ramp by superposition. Errors relative to the exact peak, "
        f"largest and rms over the instants c t / R^2 = {FIRST:g} ... {LAST:g}.",
        ["cells in the radius", "peak, p / P", "exact", "error of the peak", "largest error", "rms", "order", "missing fluid"],
        [],
    )
    found = []
    for h in (0.1, 0.05, 0.025, 0.0125) if full else (0.1, 0.05):
        rows, missing = history(barreno, h)
        late = rows[rows[:, 0] > FIRST - 1e-9]
        measured, wanted = np.max(late[:, 1]), np.max(late[:, 2])
        error = np.abs(late[:, 1] - late[:, 2]) / wanted
        found.append(float(np.sqrt(np.mean(error**2))))
        rate = order(found[-2:])[0] if len(found) > 1 else float("nan")
        result.rows.append([round(1.0 / h), measured, wanted, measured / wanted - 1.0, float(error.max()), found[-1], rate, missing])
        result.demand(f"{round(1.0 / h)} cells: missing fluid", missing, 1e-12)
        result.demand(f"{round(1.0 / h)} cells: the pressure rises above the first one", measured / ROCK.skempton, 1.03, at_least=True)
    result.demand("error of the peak at the finest mesh", abs(result.rows[-1][3]), 1e-2 if full else 4e-2)
    result.demand("largest error at the finest mesh", result.rows[-1][4], 1e-2 if full else 5e-2)
    result.demand("mean order", order([found[0], found[-1]], 2.0 ** (len(found) - 1))[0], 0.8, at_least=True)
    return result
