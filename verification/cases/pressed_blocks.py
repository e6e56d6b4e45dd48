# SPDX-License-Identifier: BSD-3-Clause
"""Two blocks of different materials with smooth surfaces, slowly pressed together: uniform uniaxial stress."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

PRESSURE = 1e6


def mean_stress(finished, name):
    """Over the last 0.4 ms, about a period of what still vibrates."""
    return np.mean([finished.particles(-step)[name] for step in range(1, 6)], axis=0) / PRESSURE


def run(barreno, full):
    result = Result(
        "Two blocks pressed together",
        "A plane contact carries a uniform pressure up to the edge, and no shear, although the blocks bulge differently.",
        "sigma_yy = -p in every particle, sigma_xx = sigma_xy = 0.",
        ["cell [m]", "mean sigma_yy / p", "largest error of sigma_yy / p", "largest sigma_xx / p", "largest sigma_xy / p", "gap [cells]"],
        [],
    )
    for h in [0.02, 0.01] if full else [0.02]:
        finished = run_deck(barreno, "pressed_blocks.xml", {"Grid/Cell Size": f"{h} m"})
        low = finished.particles(0)["y"] < 0.1
        stress = {name: mean_stress(finished, "stress_" + name) for name in ("xx", "yy", "xy")}
        y = finished.particles()["corners"][..., 1]
        gap = (y[~low].min() - y[low].max()) / h
        error = np.max(np.abs(stress["yy"] + 1.0))
        across, shear = (np.max(np.abs(stress[name])) for name in ("xx", "xy"))
        result.rows.append([h, stress["yy"].mean(), error, across, shear, gap])
        result.demand(f"error of sigma_yy over the pressure, {h} m", error, 0.03)
        result.demand(f"sigma_xy over the pressure, {h} m", shear, 0.01)
        result.demand(f"gap in cells, {h} m", abs(gap), 0.01)
    return result
