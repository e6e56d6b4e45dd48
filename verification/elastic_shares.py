#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Elastic energy of the main job by material, and why it is below zero: what is stored, what heat and moduli have given.

    elastic_shares.py BARRENO [ROW ...]    all rows, or those named: verification/results/elastic_shares.json, and docs/output.md

Runs of perforation.xml with --fidelity fast, one core each; some minutes a row, and ten gigabytes of fields that are removed again.
"""
import sys

from tools import foreign_python  # noqa: F401
from tools.depth_shots import FORMER
from tools.elastic_shares_table import INTERVAL, ROWS, STORED, WORD
from tools.elastic_shares_table import ROCK as ROCK_ENTRY
from tools.plug import card_numbers
from tools.runs import ROOT, run_deck
from tools.stored_energy import RockEnergy, Rows, metal, rock_history
from tools.stored_rows import measure_rows

CARDS = {"Tungsten": "tungsten_alloy", "Steel": "steel_4340_fracture", "Sandstone": "berea_sandstone_bounded"}
ROCK = "Sandstone"
SHARES = ("kinetic", "elastic", "plastic", "viscous", "put_in", "error")


def numbers_of(material, entries):
    """Of a card with the values that a row changes, in SI."""
    numbers = card_numbers(ROOT / "materials" / "cards" / f"{CARDS[material]}.xml")
    begin = f"Materials/{material}/"
    own = {name.removeprefix(begin): value for name, value in entries.items() if name.startswith(begin)}
    return {**numbers, **{name: float(value) for name, value in own.items() if name != WORD}}


def measured(barreno, entries):
    softens = entries.get(ROCK_ENTRY + WORD, "constant") == "constant"
    fields = {"Output/Field Interval": f"{INTERVAL if softens else 0} us"}
    finished = run_deck(barreno, "perforation.xml", {"Fidelity": "fast", "Time/End Time": "400 us", **FORMER, **fields, **entries})
    energy = finished.summary["balances"]["energy"]
    found = {name: energy[name] for name in SHARES}
    found["materials"] = energy["materials"]
    for index, material in enumerate(CARDS):
        card = numbers_of(material, entries)
        own = found["materials"][material]
        if material != ROCK:
            own.update(metal(finished, index, card))
            continue
        law = RockEnergy(card, softens)
        own["stored"] = law.stored(Rows(finished, index, card["Density"]))
        if softens:
            own.update(rock_history(finished, index + 1, law, card["Density"]))
    penetration = finished.summary["penetration"]
    return {**found, **{name: penetration[name] for name in ("depth", "probed_depth", "channel_volume")}}


if __name__ == "__main__":
    sys.exit(measure_rows(__doc__, ROWS, STORED, measured))
