# SPDX-License-Identifier: BSD-3-Clause
"""The main job at each fidelity: depth against that of fine cells everywhere, and what it costs."""
import numpy as np
from case import Result
from runs import run_deck
from uniform_cells import REFERENCE, depth_of

DECK = "perforation.xml"
TIMES = (10, 20, 30, 50, 70, 90)  # us
# name -> greatest error of the depth, seconds of the run on the ranks of the last column
DEMANDS = {"fast": (0.08, 30.0, 1), "balanced": (0.03, 90.0, 1), "reference": (0.02, 600.0, 2)}


def depths_of(run, times):
    depth = run.table("depth.csv")
    return [1e3 * float(np.interp(1e-6 * time, depth["time"], depth["depth"])) for time in times]


def run(barreno, full):
    times = TIMES if full else TIMES[:1]
    result = Result(
        "Fidelities of the main job",
        "`--fidelity` trades the error of the depth for seconds, with cells and steps of several sizes.",
        f"uniform cells of {REFERENCE:g} mm, one step for all (`verification/results/perforation_cells.csv`). `{DECK}`, all else as in the deck.",
        ["fidelity", "ranks", *(f"depth at {time} us [mm]" for time in TIMES), "greatest error of the depth", "particle-steps [10^6]",
         "processor time [s]", "wall time [s]"],
        [],
    )  # fmt: skip
    exact = [depth_of(REFERENCE, time) for time in times]
    for name, (worst, seconds, ranks) in DEMANDS.items():
        if not full and name == "reference":
            continue
        settings = {"Fidelity": name, "Output/Field Interval": "0 us"}
        if not full:
            settings["Time/End Time"] = f"{times[-1]} us"
        finished = run_deck(barreno, DECK, settings, ranks=ranks if full else 1)
        depths, summary = depths_of(finished, times), finished.summary
        error = max(abs(depth / true - 1.0) for depth, true in zip(depths, exact))
        wall = summary["wall_seconds"]
        shown = [*depths, *[""] * (len(TIMES) - len(depths))]
        result.rows.append([name, summary["ranks"], *shown, error, 1e-6 * summary["particle_steps"], summary["cpu_seconds"], wall])
        when = f"{', '.join(map(str, times))} us"
        result.demand(f"{name}: depths against those with cells of {REFERENCE:g} mm at {when}, the greatest difference", error, worst)
        if full:
            cost = summary["cpu_seconds"] if ranks == 1 else wall
            result.demand(f"{name}: {'processor' if ranks == 1 else 'wall'} time on {ranks} rank{'s' if ranks > 1 else ''} [s]", cost, seconds)
        balances = finished.table("history.csv")
        result.demand(f"{name}: axial momentum", np.abs(balances["momentum_error"]).max(), 1e-12)
        result.demand(f"{name}: energy balance", np.abs(balances["energy_error"]).max(), 1e-4)
    result.notes = (
        "*fast* keeps the deck's cells of 1 mm, as wide as the radius of the jet's tip. *balanced* refines them along the jet's path to two per radius, "
        "*reference* to four, and in all of them slow tiles take longer steps than the jet (docs/method.md 11, 12)."
    )
    return result
