# SPDX-License-Identifier: BSD-3-Clause
"""The main job at each fidelity: depth against that of fine cells everywhere, and what it costs."""
import numpy as np
from case import Result
from runs import run_deck
from uniform_cells import REFERENCE, depth_of

DECK = "perforation.xml"
TIMES = (10, 20, 30, 50, 70, 90)  # us
# name -> greatest error of the depth, seconds of the processor. *reference* takes tens of minutes and is not run here.
DEMANDS = {"fast": (0.08, 30.0), "balanced": (0.03, 90.0)}


def depths_of(run, times):
    depth = run.table("depth.csv")
    return [1e3 * float(np.interp(1e-6 * time, depth["time"], depth["depth"])) for time in times]


def run(barreno, full):
    times = TIMES if full else TIMES[:1]
    result = Result(
        "Fidelities of the main job",
        "`--fidelity` trades the error of the depth for seconds, with cells and steps of several sizes.",
        f"uniform cells of {REFERENCE:g} mm, one step for all (`verification/results/perforation_cells.csv`). `{DECK}`, all else as in the deck.",
        ["fidelity", *(f"depth at {time} us [mm]" for time in TIMES), "greatest error of the depth", "particle-steps [10^6]",
         "processor time [s]", "wall time [s]"],
        [],
    )  # fmt: skip
    exact = [depth_of(REFERENCE, time) for time in times]
    for name, (worst, seconds) in DEMANDS.items():
        settings = {"Fidelity": name, "Output/Field Interval": "0 us"}
        if not full:
            settings["Time/End Time"] = f"{times[-1]} us"
        finished = run_deck(barreno, DECK, settings)
        depths, summary = depths_of(finished, times), finished.summary
        error = max(abs(depth / true - 1.0) for depth, true in zip(depths, exact))
        shown = [*depths, *[""] * (len(TIMES) - len(depths))]
        result.rows.append([name, *shown, error, 1e-6 * summary["particle_steps"], summary["cpu_seconds"], summary["wall_seconds"]])
        when = f"{', '.join(map(str, times))} us"
        result.demand(f"{name}: depths against those with cells of {REFERENCE:g} mm at {when}, the greatest difference", error, worst)
        if full:
            result.demand(f"{name}: processor time [s]", summary["cpu_seconds"], seconds)
        balances = finished.table("history.csv")
        result.demand(f"{name}: axial momentum", np.abs(balances["momentum_error"]).max(), 1e-12)
        result.demand(f"{name}: energy balance", np.abs(balances["energy_error"]).max(), 1e-4)
    result.notes = (
        "The deck leaves Grid/Cell Size open, so each fidelity chooses it. *fast* takes cells of 1.43 mm, and of 0.71 mm along the jet's path: 1.4 in the "
        "radius of its tip. *balanced* takes 1 mm, and 0.5 mm along the path, two per radius. With both slow tiles take longer steps than the jet (docs/method.md 11, 12)."
    )
    return result
