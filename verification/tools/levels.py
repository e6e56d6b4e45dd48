#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/pictures/levels.png: cells and steps of the shot to 120 us, early in a run: levels.py BARRENO [PNG]."""
import pathlib
import sys
import tempfile

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import matplotlib

matplotlib.use("Agg")

from barreno.report.channel import draw_channel
from barreno.report.run import opened
from barreno.report.view import View
from tools.runs import run_deck

ROOT = pathlib.Path(__file__).resolve().parents[2]
SETTINGS = {"Fidelity": "balanced", "Time/End Time": "8 us", "Output/Field Interval": "0.5 us", "Output/Checkpoint Wall Interval": "0 s"}
BOX = (-70.0, 70.0, -12.0, 110.0)  # mm


def last_of_parts(run):
    """The last time that a step of several parts has met: what is left before a time of output may be too short for parts."""
    lengths = lambda step: len(set(run.file.frame(step).of_alive(["step_length"])))  # noqa: E731
    return run.file.frame(max(range(len(run.file.times)), key=lambda step: (min(lengths(step), 3), step)))


def draw(folder, png):
    with opened(folder) as run:
        figure = draw_channel(last_of_parts(run), run.deck, "cell_size", "step_length",
            View(box=BOX, title="perforation_120us.xml, balanced, "))
        figure.savefig(png, dpi=110, bbox_inches="tight")


def main():
    png = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs" / "pictures" / "levels.png"
    with tempfile.TemporaryDirectory() as scratch:
        draw(run_deck(sys.argv[1], "perforation_120us.xml", SETTINGS, folder=pathlib.Path(scratch) / "run").folder, png)


if __name__ == "__main__":
    main()
