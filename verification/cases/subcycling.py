# SPDX-License-Identifier: BSD-3-Clause
"""A perforation in which slow tiles take longer steps, against one step for all."""
import numpy as np
from case import Result
from runs import run_deck

DECK = "perforation.xml"
MOST = 4  # parts of a step


def depth_at(run, time):
    depth = run.table("depth.csv")
    return 1e3 * float(np.interp(time, depth["time"], depth["depth"]))


def row(name, subcycles, run, instants):
    summary = run.summary
    depths = [depth_at(run, t) for t in instants]
    return [name, subcycles, *depths, summary["steps"], 1e-6 * summary["particle_steps"], summary["cpu_seconds"]]


def run(barreno, full):
    end = 50e-6 if full else 10e-6
    instants = (0.5 * end, end)
    result = Result(
        "Steps of several lengths",
        f"With `Step/Subcycles` = {MOST} the depth is that of one step for all tiles, and the balances close as exactly.",
        f"one step for all. `{DECK}` to {1e6 * end:g} us; cells of 1 mm everywhere, and of 0.5 mm along the jet's path (`Jet/Cells Per Radius` = 2).",
        ["cells", "Subcycles", *(f"depth at {1e6 * t:g} us [mm]" for t in instants), "steps", "particle-steps [10^6]", "processor time [s]"],
        [],
    )  # fmt: skip
    common = {"Time/End Time": f"{1e6 * end:g} us", "Output/Field Interval": "0 us", "Output/History Interval": "0.25 us"}
    grids = {"1 mm": {}, "0.5 mm along the path": {"Jet/Cells Per Radius": "2"}} if full else {"1 mm": {}}
    for name, settings in grids.items():
        pair = [run_deck(barreno, DECK, {**common, **settings, "Step/Subcycles": str(n)}) for n in (1, MOST)]
        rows = [row(name, n, one, instants) for n, one in zip((1, MOST), pair)]
        result.rows += rows
        for i, instant in enumerate(instants, 2):
            result.demand(f"{name}: difference of depth at {1e6 * instant:g} us", abs(rows[1][i] / rows[0][i] - 1.0), 0.005)
        balances = pair[1].table("history.csv")
        result.demand(f"{name}: axial momentum", np.abs(balances["momentum_error"]).max(), 1e-12)
        result.demand(f"{name}: energy balance", np.abs(balances["energy_error"]).max(), 1e-4)
        result.demand(f"{name}: particle-steps, subcycled over one step", rows[1][5] / rows[0][5], 0.6)
        if full:
            result.demand(f"{name}: processor time, one step over subcycled", rows[0][6] / rows[1][6], 1.8, at_least=True)
    result.notes = (
        "A tile takes the step that its fastest particle bears, so a tile that the jet shares with rock steps as the jet does. What does not depend on the steps of "
        "particles, as solving the nodes and finding the cells, is done in every part (docs/method.md 12)."
    )
    return result
