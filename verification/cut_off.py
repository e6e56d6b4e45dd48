#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which slugs no longer dig: those that arrive when the hole as wide as the jet has stopped growing, with two cards of rock.

    cut_off.py BARRENO [ROW ...]    all rows, or those named: verification/results/cut_off.json, and docs/jets.md

Runs of perforation.xml with --fidelity fast to 600 us, one core each; some minutes a row.
"""
import sys

from tools import foreign_python  # noqa: F401
from tools.cut_off_table import END, GROWTH, ROWS, STORED
from tools.depth_shots import TABLE
from tools.runs import run_deck
from tools.stored_rows import measure_rows

from barreno.runs.csv_table import arrays_of, read_csv

STAND_OFF = 5e-3  # of perforation.xml [m]


def settled(times, values):
    """The first time at which a size that only grows is within GROWTH of its end."""
    most = values[0] + 0.0 * values
    for i in range(1, len(values)):
        most[i] = max(most[i - 1], values[i])
    return float(times[(most >= (1.0 - GROWTH) * most[-1]).argmax()]), float(most[-1])


def arriving(time, depth):
    """Velocity of the slug that free flight brings to a depth at a time [m/s]."""
    jet = arrays_of(read_csv(TABLE))
    arrivals = jet["time"] + (STAND_OFF + depth) / jet["velocity"]
    return float(jet["velocity"][arrivals <= time].min())


def measured(barreno, entries):
    finished = run_deck(barreno, "perforation.xml", {"Fidelity": "fast", "Output/Field Interval": "0 us", "Time/End Time": END, **entries})
    table = finished.table("depth.csv")
    times = table["time"]
    (wide, depth), (full, volume) = (settled(times, table[name]) for name in ("probed_depth", "probed_volume"))
    tip, tip_depth = settled(times, table["depth"])
    return {
        "probed_depth": depth, "probed_volume": volume, "depth": tip_depth, "time_of_probed_depth": wide, "time_of_probed_volume": full,
        "time_of_depth": tip, "slug": arriving(max(wide, full), depth), "fastest": float(max(read_csv(TABLE)["velocity"])),
    }  # fmt: skip


if __name__ == "__main__":
    sys.exit(measure_rows(__doc__, ROWS, STORED, measured))
