# SPDX-License-Identifier: BSD-3-Clause
"""A block pressed on a rigid floor that is accelerated along its surface: friction, sticking and frictionless sliding."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

FRICTION, PRESSURE, DENSITY, THICKNESS, LENGTH = 0.3, 100e3, 1000.0, 0.1, 0.2
START, END, MASS = 2e-3, 20e-3, 1000.0 * 0.1 * 0.2
LIMIT = FRICTION * PRESSURE / (DENSITY * THICKNESS)


def run(barreno, full):
    result = Result(
        "Block on an accelerated floor",
        "Contact with friction: sliding, sticking, and no shear without friction; the surfaces slide over several cells, edges included.",
        f"the floor's acceleration up to {LIMIT:g} m/s2 = friction * pressure / (density * thickness), and that value above it (an "
        "incline in the block's frame: g sin against friction * g cos).",
        ["cell [m]", "friction", "floor [m/s2]", "block [m/s2]", "exact [m/s2]", "friction work [J]", "exact [J]", "ledger remainder"],
        [],
    )
    levels = [0.02, 0.01] if full else [0.02]
    for h in levels:
        for friction, floor in ((FRICTION, 200.0), (FRICTION, 600.0), (0.0, 600.0)):
            settings = {
                "Grid/Cell Size": f"{h} m",
                "Contact/Sole/Friction Coefficient": str(friction),
                "Bodies/Floor/Motion": f"{{0 m/s, {floor * (END - START)} m/s}}",
            }
            finished = run_deck(barreno, "sliding_block.xml", settings)
            rows = finished.table("history.csv")
            velocity = rows["momentum"] / rows["mass"]
            sliding = rows["time"] > START
            measured = np.polyfit(rows["time"][sliding], velocity[sliding], 1)[0]
            exact = min(floor, LIMIT * friction / FRICTION)
            slip = 0.5 * (floor - exact) * (END - START) ** 2
            work = exact * MASS * slip
            remainder = finished.summary["balances"]["energy"]["error"]
            result.rows.append([h, friction, floor, measured, exact, rows["friction"][-1], work, remainder])
            name = f"friction {friction}, floor {floor:g} m/s2, {h} m"
            result.demand(f"{name}: acceleration over that of full friction", abs(measured - exact) / LIMIT, 0.01)
            if work > 0.0:
                result.demand(f"{name}: friction work against the exact one", abs(rows["friction"][-1] / work - 1.0), 0.02)
            lost = abs(finished.summary["balances"]["momentum"]["remainder"]) / (MASS * LIMIT * (END - START))
            result.demand(f"{name}: momentum lost over that of full friction", lost, 1e-12)
            result.demand(f"{name}: energy balance", abs(remainder), 1e-9)
    return result
