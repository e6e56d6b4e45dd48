#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of the depth against seconds of one core: cells of one size everywhere, and the fidelities.

    error_seconds.py BARRENO [ROW ...]    all rows, or those named: verification/results/error_seconds.json, and docs/trade.md

Runs of perforation_120us.xml to 90 us on one core; the smallest cells take minutes. Nothing else should run.
"""
import sys

import numpy as np

from tools import foreign_python  # noqa: F401
from tools.error_seconds_table import ROWS, STORED, TIMES
from tools.runs import run_deck
from tools.stored_rows import measure_rows

DECK = "perforation_120us.xml"


def measured(barreno, entries):
    """Depths, and what they cost."""
    finished = run_deck(barreno, DECK, {"Time/End Time": f"{TIMES[-1]} us", "Output/Field Interval": "0 us", **entries})
    depth, summary = finished.table("depth.csv"), finished.summary
    depths = [1e3 * float(np.interp(1e-6 * time, depth["time"], depth["depth"])) for time in TIMES]
    return {"depths": depths, "particle_steps": summary["particle_steps"], "skipped": summary["skipped_particle_steps"],
        "cpu_seconds": summary["cpu_seconds"]}


if __name__ == "__main__":
    sys.exit(measure_rows(__doc__, ROWS, STORED, measured))
