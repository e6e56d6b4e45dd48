# SPDX-License-Identifier: BSD-3-Clause
"""A perforation in which slow tiles take longer steps, against one step for all."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

DECK = "perforation_120us.xml"
MOST = 4  # parts of a step


def depth_at(run, time):
    depth = run.table("depth.csv")
    return 1e3 * float(np.interp(time, depth["time"], depth["depth"]))


def row(name, subcycles, end, run, instants):
    summary = run.summary
    depths = [depth_at(run, t) for t in instants]
    return [name, subcycles, 1e6 * end, *depths, summary["steps"], 1e-6 * summary["particle_steps"], summary["cpu_seconds"]]


def run(barreno, full):
    grids = {"1 mm": ({}, 120e-6 if full else 10e-6)}
    if full:
        grids["0.5 mm along the path"] = ({"Jet/Cells Per Radius": "2"}, 50e-6)
    result = Result(
        "Steps of several lengths",
        f"With `Step/Subcycles` = {MOST} the depth is that of one step for all tiles, and the balances close as exactly.",
        f"one step for all. `{DECK}` with cells of 1 mm everywhere, and of 0.5 mm along the jet's path (`Jet/Cells Per Radius` = 2).",
        ["cells", "Subcycles", "end [us]", "depth in the middle [mm]", "at the end [mm]", "steps", "particle-steps [10^6]",
            "processor time [s]"],
        [],
    )  # fmt: skip
    for name, (settings, end) in grids.items():
        common = {"Time/End Time": f"{1e6 * end:g} us", "Output/Field Interval": "0 us", "Output/History Interval": "0.25 us"}
        pair = [run_deck(barreno, DECK, {**common, **settings, "Step/Subcycles": str(n)}) for n in (1, MOST)]
        instants = (0.5 * end, end)
        rows = [row(name, n, end, one, instants) for n, one in zip((1, MOST), pair)]
        result.rows += rows
        for i, instant in enumerate(instants, 3):
            result.demand(f"{name}: difference of depth at {1e6 * instant:g} us", abs(rows[1][i] / rows[0][i] - 1.0), 0.005)
        balances = pair[1].table("history.csv")
        result.demand(f"{name}: axial momentum", np.abs(balances["momentum_error"]).max(), 1e-12)
        result.demand(f"{name}: energy balance", np.abs(balances["energy_error"]).max(), 1e-4)
        result.demand(f"{name}: particle-steps, subcycled over one step", rows[1][6] / rows[0][6], 0.6)
        if full:
            result.demand(f"{name}: processor time, one step over subcycled", rows[0][7] / rows[1][7], 1.8, at_least=True)
    result.notes = (
        "A tile takes the step that its fastest particle bears, so a tile that the jet shares with rock steps as the jet does. What does "
        "not depend on the steps of "
        "particles, as solving the nodes and finding the cells, is done in every part (docs/method.md 12)."
    )
    return result
