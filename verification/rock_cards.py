#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each part of the rock's law changes in the main job: depth, hole, crushed rock, energy, time.

    rock_cards.py BARRENO [ROW ...]    all rows, or those named: verification/results/rock_cards.json, and docs/materials/arenisca.md

Runs of perforation.xml with --fidelity fast, one core each; some minutes a row.
"""
import sys

from tools import foreign_python  # noqa: F401
from tools.penetration import between_particles_and_grid
from tools.rock_cards_table import ROWS, STORED
from tools.runs import run_deck
from tools.stored_rows import measure_rows

KEPT = ("depth", "probed_depth", "channel_volume", "zones_in_body")


def measured(barreno, entries):
    """Answers of a run, and what it cost."""
    shot = {"Fidelity": "fast", "Time/End Time": "400 us", "Output/Field Interval": "0 us"}
    finished = run_deck(barreno, "perforation.xml", {**shot, **entries})
    summary = finished.summary
    found = {name: summary["penetration"][name] for name in KEPT}
    return {**found, "lost": between_particles_and_grid(finished), "steps": summary["steps"], "cpu_seconds": summary["cpu_seconds"]}


if __name__ == "__main__":
    sys.exit(measure_rows(__doc__, ROWS, STORED, measured))
