#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Aims for the depth of a jet that take minutes and both cores of a machine on which nothing else runs.

    depth_runs.py BARRENO [WHAT ...]    those of reference, ranks, rod, or all: verification/results/depth_runs.json, and docs/trade.md

- reference: perforation_120us.xml at fidelity reference on two ranks, its time and the interval of its depth.
- ranks: perforation_refined.xml to 10 us on one rank and on two in turn, steps alone; the median of three rounds.
- rod: a rod of tungsten at 4 km/s goes 100 of its diameters deep into Berea sandstone, four cells per radius; its rate over every ten
  diameters.
"""
import argparse
import json
import pathlib
import statistics
import sys

from tools import foreign_python  # noqa: F401
from tools.runs import DECKS, run_deck
from performance.scaling import Problem, run_once, step_seconds
from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "results" / "depth_runs.json"
DIAMETER = 4e-3  # of the rod [m]
FIRST, LAST = 10, 100  # of the depths between which its rate is taken, in diameters
ROD = {
    "Materials/Rod/Card": "tungsten.xml", "Materials/Target/Card": "berea_sandstone.xml", "Materials/Target/A": "",
    "Materials/Target/B": "",
    "Grid/Lower": "{0 mm, -216 mm}", "Grid/Upper": "{96 mm, 464 mm}", "Bodies/Block/Upper": "{88 mm, 456 mm}",
    "Jet/Slugs": "1x5:{0, 4000, 2e-3, 205e-3, 17600}", "Jet/Launch Position": "-105 mm", "Jet/Cells Per Radius": "4", "Step/Subcycles": "4",
    "Time/End Time": "155 us", "Output/Field Interval": "0 us",
}  # fmt: skip


def reference(barreno):
    summary = run_deck(barreno, "perforation_120us.xml", {"Fidelity": "reference", "Output/Field Interval": "0 us"}, ranks=2).summary
    return {"depth": summary["penetration"]["depth"], **{name: summary[name] for name in ("wall_seconds", "cpu_seconds", "particle_steps")}}


def ranks(barreno):
    deck = DECKS / "perforation_refined.xml"
    rounds = []
    for _ in range(3):
        one, two = (step_seconds(run_once(barreno, Problem(deck.name, deck, "", "10 us"), n, "10 us")) for n in (1, 2))
        rounds.append({"one": one, "two": two})
    return {"rounds": rounds, "speedup": statistics.median(r["one"] / r["two"] for r in rounds)}


def rod(barreno):
    import numpy as np

    finished = run_deck(barreno, "steady_penetration.xml", ROD)
    table = finished.table("depth.csv")
    places = [n * DIAMETER for n in range(FIRST, LAST + 1, 10)]
    times = np.interp(places, np.maximum.accumulate(table["depth"]), table["time"])
    return {"depth": float(table["depth"].max()), "rates": [float(rate) for rate in 10 * DIAMETER / np.diff(times)],
        "cpu_seconds": finished.summary["cpu_seconds"]}


MEASURED = {"reference": reference, "ranks": ranks, "rod": rod}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("what", nargs="*", choices=[*MEASURED, []], metavar="WHAT")
    options = parser.parse_args()
    found = json.loads(STORED.read_text()) if STORED.exists() else {}
    for what in options.what or MEASURED:
        found[what] = MEASURED[what](options.barreno.resolve())
        print(what, found[what], flush=True)
        STORED.write_text(json.dumps({name: found[name] for name in MEASURED if name in found}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
