# SPDX-License-Identifier: BSD-3-Clause
"""Mandel's slab: the pressure in the middle rises before it falls, far from the loaded end of a long block."""
import functools

import numpy as np
from tools.case import Result
from tools.columns import DIFFUSIVITY, ROCK, exact
from tools.manufactured_runs import centres
from tools.runs import missing_fluid, order, run_deck

LOAD, RAMP = 1e6, 4e-3  # Pa, s; the slab is 1 m wide to its open side
RATE = DIFFUSIVITY / 4.0  # m2/s: of the deck, T = RATE t
SLAB = exact.Mandel(ROCK, terms=400)
INSTANTS, LAST, FIRST = 10, 0.2, 0.04  # c t / width^2; before FIRST waves of the load are still about
SECTION = 0.5  # m of the 3 m of the block, by its middle: the end's disturbance falls as exp(-2.1 y)


@functools.lru_cache(None)
def profile(T, parts=40):
    """Exact pressures over LOAD under the ramp, at 200 places: the mean of the answers to its parts."""
    x = (np.arange(200) + 0.5) / 200.0
    begun = T - (np.arange(parts) + 0.5) / parts * RAMP * RATE
    return x, np.mean([SLAB.pressure(x, t) for t in begun], axis=0)


def measure(barreno, h):
    """At each instant: T, mean pressure within a tenth of the middle, exact, worst particle of the section."""
    settings = {"Grid/Cell Size": repr(h), "Time/End Time": repr(LAST / RATE), "Output/Field Interval": repr(LAST / INSTANTS / RATE)}
    finished = run_deck(barreno, "mandel.xml", settings)
    rows = []
    for instant in range(1, finished.instants()):
        particles = finished.particles(instant)
        x, y = centres(particles)
        inside = y < SECTION
        T = round(particles["time"] * RATE, 9)
        pressure, wanted = particles["pore_pressure"][inside] / LOAD, np.interp(x[inside], *profile(T))
        middle = x[inside] < 0.1
        rows.append((T, pressure[middle].mean(), wanted[middle].mean(), np.max(np.abs(pressure - wanted))))
    return np.array(rows), missing_fluid(finished)


def run(barreno, full):
    result = Result(
        "Mandel's slab",
        "Flow across the slab, stress along it: the middle takes over the load that the sides shed, and its pore pressure rises.",
        "the series of the slab between rigid plates, with the ramp by superposition; the block is long enough for its sections to stay "
        f"plane. Mean over the inner tenth; errors relative to the exact peak, at the instants c t / width^2 = {FIRST:g} ... {LAST:g}.",
        ["cells in the width", "peak, p / P", "exact", "error of the peak", "largest error in the middle", "worst particle",
            "rms in the middle", "order",
         "missing fluid"],
        [],
    )  # fmt: skip
    found = []
    for h in (0.1, 0.05, 0.025) if full else (0.1, 0.05):
        rows, missing = measure(barreno, h)
        late = rows[rows[:, 0] > FIRST - 1e-9]
        measured, wanted = late[:, 1].max(), late[:, 2].max()
        error = np.abs(late[:, 1] - late[:, 2]) / wanted
        found.append(float(np.sqrt(np.mean(error**2))))
        rate = order(found[-2:])[0] if len(found) > 1 else float("nan")
        result.rows.append([round(1.0 / h), measured, wanted, measured / wanted - 1.0, float(error.max()), float(late[:, 3].max() / wanted),
                            found[-1], rate, missing])  # fmt: skip
        result.demand(f"{round(1.0 / h)} cells: missing fluid", missing, 1e-12)
        result.demand(f"{round(1.0 / h)} cells: the peak over the first pressure", measured / (0.5 * SLAB.factor), 1.02, at_least=True)
    limit = 1e-2 if full else 2e-2
    result.demand("error of the peak at the finest mesh", abs(result.rows[-1][3]), limit)
    result.demand("largest error in the middle at the finest mesh", result.rows[-1][4], limit)
    return result
