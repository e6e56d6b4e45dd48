#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each part of the rock's law changes in the main job: depth, hole, crushed rock, energy, time.

    rock_cards.py BARRENO [ROW ...]    all rows, or those named: verification/results/rock_cards.json, and docs/materials/arenisca.md

Runs of perforation.xml with --fidelity fast, one core each; some minutes a row.
"""
import argparse
import json
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools.penetration import between_particles_and_grid
from tools.rock_cards_table import ROWS, STORED
from tools.runs import run_deck
from tools.write_pages import write_pages

KEPT = ("depth", "probed_depth", "channel_volume", "zones_in_body")


def measured(barreno, entries):
    """Answers of a run, and what it cost."""
    finished = run_deck(barreno, "perforation.xml", {"Fidelity": "fast", "Output/Field Interval": "0 us", **entries})
    summary = finished.summary
    found = {name: summary["penetration"][name] for name in KEPT}
    return {**found, "lost": between_particles_and_grid(finished), "steps": summary["steps"], "cpu_seconds": summary["cpu_seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("rows", nargs="*", metavar="ROW")
    options = parser.parse_args()
    unknown = [row for row in options.rows if row not in ROWS]
    if unknown:
        parser.error(f"there is no row '{unknown[0]}'; there are {', '.join(ROWS)}")
    for row in options.rows or ROWS:
        one = measured(options.barreno.resolve(), ROWS[row])
        print(row, one, flush=True)
        found = json.loads(STORED.read_text()) if STORED.exists() else {}
        STORED.write_text(json.dumps({name: {**found, row: one}[name] for name in ROWS if name in {**found, row: one}}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
