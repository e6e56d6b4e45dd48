#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The main job with and without cement between casing and rock, both with fidelity fast to 120 us: depth and entrance.

    cement_shot.py BARRENO    verification/results/cement_shot.json, and the table of input_xml/README.md

A minute or two of one core.
"""
import argparse
import json
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools.cement_table import DECKS, STORED
from tools.runs import run_deck
from tools.write_pages import write_pages

KEPT = ("depth", "probed_depth", "depth_in_body", "channel_depth_in_body", "entrance_diameter_in_body", "channel_volume")
SETTINGS = {"Fidelity": "fast", "Time/End Time": "120 us", "Output/Field Interval": "0 us"}


def measured(barreno, deck):
    summary = run_deck(barreno, deck, SETTINGS).summary
    return {**{name: summary["penetration"][name] for name in KEPT}, "end": summary["time"], "seconds": summary["cpu_seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    barreno = parser.parse_args().barreno.resolve()
    STORED.write_text(json.dumps({deck: measured(barreno, deck) for deck in DECKS}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
