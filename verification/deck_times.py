#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the shipped decks take, each as it is, on one rank.

    deck_times.py BARRENO [DECK ...]    those decks, or all: verification/results/decks.json, and the pages that show it

Seconds are those of the processor (user and system time), which other work on the machine changes little.
"""
import argparse
import json
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools.deck_table import STORED, decks
from tools.runs import run_deck
from tools.write_pages import write_pages

KEPT = {"cpu_seconds": "seconds", "steps": "steps", "particles": "particles", "particle_steps": "particle_steps",
        "skipped_particle_steps": "skipped_particle_steps", "peak_resident_bytes": "bytes"}  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("decks", nargs="*", metavar="DECK")
    options = parser.parse_args()
    found = json.loads(STORED.read_text()) if STORED.exists() else {}
    for deck in options.decks or decks():
        summary = run_deck(options.barreno.resolve(), deck).summary
        found[deck] = {ours: summary[theirs] for theirs, ours in KEPT.items()}
        print(deck, found[deck], flush=True)
        STORED.write_text(json.dumps({name: found[name] for name in decks() if name in found}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
