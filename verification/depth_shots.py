#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How deep the hole is as wide as the jet, for shots unlike each other, with several sizes of cells.

    depth_shots.py BARRENO [--cells N ...] [SHOT ...]    all shots, or those named; 1.2 and 1.8 cells in the radius of the jet's tip
                                                         or those given: verification/results/depth_shots.json, and docs/trade.md
    depth_shots.py BARRENO --courant [FRACTION ...] [--cells N ...]
                                                         the deck with steps a little shorter or longer (eight, or those given), for
                                                         the scatter of runs that should agree: verification/results/
                                                         depth_scatter.json, and docs/trade.md

Decks: perforation.xml with divided particles of the jet, and what tools/depth_shots.py changes in it, until the hole as wide as the
jet no longer grows. Minutes of one core each with 1.2 cells, half an hour with 2.4.
"""
import argparse
import json
import os
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools import shot_stress
from tools.depth_shots import PICTURE, SHOTS, STEP, TIMES, settings_of, widest_slug
from tools.flow_efficiency import efficiency_of_run
from tools.penetration import between_particles_and_grid
from tools.runs import run_deck
from tools.write_pages import write_pages

RESULTS = pathlib.Path(__file__).resolve().parent / "results"
STORED = RESULTS / "depth_shots.json"
SCATTER = RESULTS / "depth_scatter.json"
KEPT = ("depth", "probed_depth", "channel_volume", "efficiency", "profile", "lost", "cpu_seconds")
COURANT = ("0.8", "0.795", "0.79", "0.785", "0.78", "0.775", "0.77", "0.765")
# The losses of a step stay lost, so that they can be seen.
DIVIDED = {"Jet/Particles Per Cell": "2", "Jet/Splits": "4", "Step/Return Losses": "false", "Output/Field Interval": "0 us"}


def profile_of(hole):
    """Radius of the hole [mm], every STEP along its depth."""
    import numpy as np

    depths = np.arange(STEP, 1e3 * hole.length, STEP)
    return [round(float(radius), 3) for radius in np.interp(depths, 1e3 * hole.depth, 1e3 * hole.radius)]


def draw(shots):
    """The hole of the deck with each size of cells."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7.0, 3.2))
    for cells, one in shots["the deck"].items():
        radii = one["profile"]
        axes.plot([STEP * (i + 1) for i in range(len(radii))], radii, label=f"{cells} cells per radius of the tip")
    axes.axhline(1e3 * widest_slug(), color="k", lw=0.8, ls="--", label="radius of the widest slug")
    axes.set(xlabel="depth [mm]", ylabel="radius of the hole [mm]", xlim=(0.0, None), ylim=(0.0, 8.0))
    axes.legend(fontsize=7)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=100)


def measured(finished, scale):
    """Depths at TIMES of a jet that is slower by `scale`, how far its hole is as wide as its widest slug at the end (as the run says it),
    and what else is kept of a run."""
    import barreno
    import numpy as np

    summary, table = finished.summary, finished.table("depth.csv")
    penetration = summary["penetration"]
    reached = [time for time in TIMES if 1e-6 * scale * time <= table["time"][-1] * (1.0 + 1e-9)]
    depths = np.interp([1e-6 * scale * time for time in reached], table["time"], table["depth"])
    return {
        "depth": [round(float(depth), 6) for depth in depths], "tip": round(penetration["depth"], 6), "end": summary["time"],
        "probed_depth": round(penetration["probed_depth"], 6), "channel_volume": penetration["channel_volume"],
        "zones_in_body": penetration.get("zones_in_body"), "efficiency": round(efficiency_of_run(finished.folder), 6),
        "profile": profile_of(barreno.open(finished.folder).hole),
        "lost": between_particles_and_grid(finished), "steps": summary["steps"], "cpu_seconds": summary["cpu_seconds"],
    }  # fmt: skip


def keep(shot, cells, one):
    """Beside what is stored of other runs."""
    print(shot, cells, one, flush=True)
    found = json.loads(STORED.read_text()) if STORED.exists() else {}
    found.setdefault(shot, {})[cells] = one
    runs = {name: dict(sorted(found[name].items(), key=lambda of: float(of[0]))) for name in SHOTS if name in found}
    STORED.write_text(json.dumps(runs, indent=1) + "\n")


def keep_scatter(cells, courant, one):
    """Depths of one of several runs that should agree."""
    print(cells, courant, one["probed_depth"], flush=True)
    found = json.loads(SCATTER.read_text()) if SCATTER.exists() else {}
    found.setdefault(cells, {})[courant] = {name: one[name] for name in KEPT}
    SCATTER.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--cells", nargs="+", default=["1.2", "1.8"])
    parser.add_argument("--courant", nargs="*", choices=COURANT, metavar="FRACTION")
    parser.add_argument("what", nargs="*", metavar="SHOT")
    options = parser.parse_args()
    unknown = [what for what in options.what if what not in SHOTS]
    if unknown:
        parser.error(f"there is no shot '{unknown[0]}'; there are {', '.join(SHOTS)}")
    os.environ["BARRENO_PROGRAM"] = str(options.barreno.resolve())  # which solves the flow
    scattered = options.courant is not None
    for courant in options.courant or COURANT if scattered else ():
        for cells in options.cells:
            settings = {**DIVIDED, **settings_of("the deck")[0], "Jet/Cells Per Radius": cells, "Step/Courant Fraction": courant}
            keep_scatter(cells, courant, measured(run_deck(options.barreno.resolve(), "perforation.xml", settings), 1.0))
    for shot in options.what or (() if scattered else SHOTS):
        for cells in options.cells:
            entries, scale = settings_of(shot)
            settings = {**DIVIDED, **entries, "Jet/Cells Per Radius": cells}
            keep(shot, cells, measured(run_deck(options.barreno.resolve(), "perforation.xml", settings), scale))
    draw(json.loads(STORED.read_text()))
    shot_stress.draw()
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
