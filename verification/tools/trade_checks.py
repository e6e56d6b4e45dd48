# SPDX-License-Identifier: BSD-3-Clause
"""What must hold in the trade between error and cost."""
import numpy as np
from tools.demands import judge_all, open_demands

FIDELITIES = ("fast", "balanced", "reference")
NEAR = 2.5  # errors of a fidelity over the least that any choice has at its cost
LEVELS = {"box": (8, 16), "shock": (1.0, 0.5), "depth": (2.0, 1.0)}  # over which errors must fall


def front(points, problem, cost):
    """Least error of any choice that costs no more."""
    return min(p["error"] for p in points if p["problem"] == problem and "error" in p and p["work"] <= cost)


def demands(points, tiny, said):
    """The checks, as verification cases store them. Cost is counted in particle-steps here, which do not depend on the machine."""
    at = {(p["problem"], p["name"], p["level"]): p for p in points if "error" in p}
    checks = []

    def demand(what, value, limit, at_least=False):
        checks.append({"what": what, "value": float(value), "limit": limit, "at_least": at_least})

    for problem, (coarse, fine) in LEVELS.items():
        if (problem, "fast", coarse) not in at:
            continue
        for name in FIDELITIES:
            one, two = at[problem, name, coarse], at[problem, name, fine]
            demand(f"{problem}, {name}: error ratio after halving the cells", two["error"] / one["error"], 0.95)
            demand(f"{problem}, {name}: error relative to the smallest of any choice at its particle-steps",
                two["error"] / front(points, problem, two["work"]), NEAR)
        costs = [at[problem, name, fine]["work"] for name in FIDELITIES]
        demand(f"{problem}: particle-steps of fast over balanced", costs[0] / costs[1], 1.0)
        demand(f"{problem}: particle-steps of balanced over reference", costs[1] / costs[2], 1.0)
    for (name, problem, level), error in said.items():
        if (problem, name, level) in at and not tiny:
            off = abs(error / at[problem, name, level]["error"] - 1.0)
            demand(f"{problem}, {name}: error quoted by check over that measured, minus 1", off, 0.1)
    smooth = [at["box", name, 16]["error"] for name in FIDELITIES]
    demand("box, 16 cells: error of balanced over fast", smooth[1] / smooth[0], 1.0)
    demand("box, 16 cells: error of reference over balanced", smooth[2] / smooth[1], 1.0)
    finest = 16 if tiny else 32  # beyond, the error of the time shows: a Courant Fraction of 0.8, 0.2 in verification.md
    cpdi = at["box", "CPDI", 8]["error"] / at["box", "CPDI", finest]["error"]
    demand(f"box, CPDI: order from 8 to {finest} cells", np.log2(cpdi) / np.log2(finest / 8), 1.8, at_least=True)
    return checks


def verdict_lines(checks, tiny=False):
    """A line for each check: figure, limit, verdict."""
    judged, _ = judge_all(checks, open_demands("trade", not tiny))
    return [f"{check['what']}: {check['value']:.3g} {'>=' if check['at_least'] else '<='} {check['limit']:.3g}, {verdict}"
        + (f" ({words})" if words else "")
            for check, verdict, words in judged]  # fmt: skip
