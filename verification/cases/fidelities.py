# SPDX-License-Identifier: BSD-3-Clause
"""The shot to 120 us at each fidelity: depth against that of fine cells everywhere, and what it costs."""
import re

import numpy as np
from tools.case import Result
from tools.runs import run_deck
from tools.uniform_cells import REFERENCE, depth_of

DECK = "perforation_120us.xml"
TIMES = (10, 20, 30, 50, 70, 90)  # us
# name -> greatest error of the depth, seconds of the processor. *reference* takes tens of minutes and is not run here.
DEMANDS = {"fast": (0.08, 30.0), "balanced": (0.03, 90.0)}
# (particles per cell and direction in casing and rock, cells per radius of the jet): what else *fast* might choose.
OTHERS = ((2, 1.0), (2, 1.4), (2, 2.0), (1, 1.4), (1, 1.6), (1, 2.0))


def depths_of(run, times):
    depth = run.table("depth.csv")
    return [1e3 * float(np.interp(1e-6 * time, depth["time"], depth["depth"])) for time in times]


def greatest_error(depths, exact):
    return max(abs(depth / true - 1.0) for depth, true in zip(depths, exact))


def settings_of(per_cell, cells):
    """Two sizes of cells as in the fidelities; one where the coarse ones have the jet's radius."""
    bodies = {f"Bodies/{body}/Particles Per Cell": str(per_cell) for body in ("Casing", "Rock")}
    size = {"Grid/Cell Size": f"{2.0 / cells!r} mm" if cells > 1.0 else "1 mm", "Jet/Cells Per Radius": repr(cells)}
    return {"Fidelity": "fast", "Output/Field Interval": "0 us", **bodies, **size}


def add_row(result, name, finished, depths, error):
    summary, deck = finished.summary, (finished.folder / "deck.xml").read_text()
    per_cell = int(re.search('"Rock">.*?"Particles Per Cell" type="int" value="([0-9]+)"', deck, re.DOTALL).group(1))
    shown = [*depths, *[""] * (len(TIMES) - len(depths))]
    result.rows.append(
        [name, per_cell, summary["penetration"]["cells_per_radius"]["tip"], *shown, error, 1e-6 * summary["particle_steps"],
            summary["cpu_seconds"], summary["wall_seconds"]]
    )


def run(barreno, full):
    times = TIMES if full else TIMES[:1]
    result = Result(
        "Fidelities of the shot to 120 us",
        "`--fidelity` trades the error of the depth for seconds, with cells and steps of several sizes.",
        f"uniform cells of {REFERENCE:g} mm, one step for all (`verification/results/perforation_cells.csv`). `{DECK}`, all else as in the "
        "deck.",
        ["fidelity", "particles per cell", "cells per radius", *(f"depth at {time} us [mm]" for time in TIMES),
            "greatest error of the depth", "particle-steps [10^6]",
         "processor time [s]", "wall time [s]"],
        [],
    )  # fmt: skip
    exact = [depth_of(REFERENCE, time) for time in times]
    for name, (worst, seconds) in DEMANDS.items():
        settings = {"Fidelity": name, "Output/Field Interval": "0 us"}
        if not full:
            settings["Time/End Time"] = f"{times[-1]} us"
        finished = run_deck(barreno, DECK, settings)
        depths = depths_of(finished, times)
        error = greatest_error(depths, exact)
        add_row(result, name, finished, depths, error)
        when = f"{', '.join(map(str, times))} us"
        result.demand(f"{name}: depths against those with cells of {REFERENCE:g} mm at {when}, the greatest difference", error, worst)
        if full:
            result.demand(f"{name}: processor time [s]", finished.summary["cpu_seconds"], seconds)
        balances = finished.table("history.csv")
        result.demand(f"{name}: axial momentum", np.abs(balances["momentum_error"]).max(), 1e-12)
        result.demand(f"{name}: energy balance", np.abs(balances["energy_error"]).max(), 1e-4)
    for per_cell, cells in OTHERS if full else ():
        finished = run_deck(barreno, DECK, settings_of(per_cell, cells))
        depths = depths_of(finished, times)
        add_row(result, f"fast, {per_cell} per cell, {cells:g} per radius", finished, depths, greatest_error(depths, exact))
    result.notes = (
        "The deck leaves Grid/Cell Size open, so each fidelity chooses it. *fast* takes cells of 1.11 mm, and of 0.56 mm along the jet's "
        "path: 1.8 in the "
        "radius of its tip. *balanced* takes 0.83 mm, and 0.42 mm along the path, 2.4 per radius. Casing and rock start with one particle "
        "per cell, which divides where it is stretched wider "
        "than a cell. With both slow tiles take longer steps than the jet (docs/method.md 11, 12)."
    )
    return result
