#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a jet until its hole is at rest, against the size of the cells, with several materials and confinements.

    depth_at_rest.py BARRENO [RUN ...]    all, or those named: verification/results/depth_at_rest.json, and docs/trade.md

A run is JOB/CELLS/PARTICLES, as failing/2.4/2: cells in the radius of the jet's tip, and particles of the jet in a cell, along each
direction; with particles that are divided JOB/CELLS/PARTICLES+SPLITS, as bounded/2.4/2+4; or, for the scatter between runs that should
agree, JOB/CELLS/PARTICLES/COURANT, as failing/1.8/2/0.75. The deck is perforation.xml, with what fidelity balanced chooses but for these.
Jobs: "bounded", the deck as it is; "failing", with the sandstone of perforation_120us.xml, whose flow is associated; "published", with its
metals too; "bounded_unconfined" and "unconfined", the first two without the pressure of 69 MPa; "continuous", the jet dispersed and without
gaps; "long_slugs", the jet in a quarter of the slugs, four times as long. Minutes to an hour of one core each.
"""
import argparse
import json
import pathlib
import subprocess
import sys

from tools import foreign_python  # noqa: F401
from tools.depth_at_rest_runs import TIMES
from tools.depth_shots import CONTINUOUS, FORMER
from tools.penetration import between_particles_and_grid
from tools.runs import DECKS, run_deck, scratch_folder
from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "results" / "depth_at_rest.json"
CELLS = (1.2, 1.8, 2.4, 3.2, 4.0)  # in the radius of the tip
PARTICLES = ("2", "4", "8", "2+4", "4+4")  # of the jet, in a cell along each direction + how often each may be divided
ASSOCIATED = {"Materials/Sandstone/Card": "berea_sandstone.xml"}
UNCONFINED = {"Confinement": ""}
JOBS = {
    "bounded": FORMER,
    "failing": ASSOCIATED,
    "published": {**ASSOCIATED, "Materials/Tungsten/Card": "tungsten.xml", "Materials/Steel/Card": "steel_4340.xml"},
    "bounded_unconfined": {**FORMER, **UNCONFINED},
    "unconfined": {**ASSOCIATED, **UNCONFINED},
    "continuous": {**FORMER, **CONTINUOUS},
    "long_slugs": FORMER,
}
SCATTER = {  # cells and particles with which the Courant Fraction is changed a little
    "failing": ((1.8, "2"), (2.4, "2")),
    "bounded": ((1.8, "2"),),
}
COURANT = (0.79, 0.78, 0.77, 0.76, 0.75, 0.74, 0.73)


def long_slugs():
    """A jet table of 80 slugs instead of 320."""
    table = pathlib.Path(scratch_folder()) / "tungsten_80.csv"
    words = [sys.executable, str(DECKS / "jets" / "make_jet.py"), "--tail", "--slugs", "80"]
    table.write_text(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return table


def measure(barreno, job, cells, particles, courant=None):
    per_cell, _, splits = particles.partition("+")
    settings = {
        **JOBS[job], "Jet/Cells Per Radius": f"{cells:g}", "Jet/Particles Per Cell": per_cell, "Jet/Splits": splits or "0",
        "Output/Field Interval": "0 us", "Time/End Time": f"{TIMES[-1]} us",
    }  # fmt: skip
    if courant is not None:
        settings["Step/Courant Fraction"] = f"{courant:g}"
    if job == "long_slugs":
        settings["Jet/Table"] = long_slugs()
    return measured(run_deck(barreno, "perforation.xml", settings))


def measured(finished):
    """What is stored of a run."""
    import numpy as np

    summary, table = finished.summary, finished.table("depth.csv")
    times = [1e-6 * time for time in TIMES if 1e-6 * time < 1.001 * summary["time"]]
    return {
        "depths": [float(depth) for depth in np.interp(times, table["time"], table["depth"])],
        "lost": between_particles_and_grid(finished), "steps": summary["steps"], "cpu_seconds": summary["cpu_seconds"],
        "volume": summary["penetration"]["channel_volume"],
        "removed": {cause: what["mass"] for cause, what in summary["removed_particles"].items() if what["count"]},
    }  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("what", nargs="*", metavar="RUN")
    options = parser.parse_args()
    names = {f"{job}/{cells:g}/{particles}": (job, cells, particles) for job in JOBS for cells in CELLS for particles in PARTICLES}
    names |= {f"{job}/{cells:g}/{particles}/{courant:g}": (job, cells, particles, courant)
        for job, sizes in SCATTER.items() for cells, particles in sizes for courant in COURANT}  # fmt: skip
    unknown = [what for what in options.what if what not in names]
    if unknown:
        parser.error(f"there is no {unknown[0]}; there are {', '.join(names)}")
    for what in options.what or names:
        one = measure(options.barreno.resolve(), *names[what])
        print(what, one, flush=True)
        found = json.loads(STORED.read_text()) if STORED.exists() else {}
        found[what] = one
        STORED.write_text(json.dumps({name: found[name] for name in names if name in found}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
