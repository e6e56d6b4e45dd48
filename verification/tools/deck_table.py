# SPDX-License-Identifier: BSD-3-Clause
"""The table of input_xml/README.md: every deck once, what it shows (decks.toml) and what it took (results/decks.json)."""
import json
import tomllib

from tools.case_list import RESULTS, VERIFICATION

STORED = RESULTS / "decks.json"
FOLDER = VERIFICATION.parent / "input_xml"


def decks():
    """{file: what it shows}; every file of the folder is in the list, and the other way round."""
    listed = tomllib.loads((VERIFICATION / "decks.toml").read_text())
    there = {file.name for file in FOLDER.glob("*.xml")}
    if set(listed) != there:
        raise SystemExit(f"verification/decks.toml and input_xml differ in {sorted(set(listed) ^ there)}; list each deck once, with what "
            "it shows")
    return listed


def lines():
    times = json.loads(STORED.read_text())
    missing = [name for name in decks() if name not in times]
    if missing:
        raise SystemExit(f"verification/results/decks.json lacks {missing}; measure: verification/deck_times.py BARRENO "
            f"{' '.join(missing)}")
    return ["| deck | what it shows | seconds on one core | particles | steps |", "|---|---|---|---|---|",
            *(f"| [{name}]({name}) | {shows} | {times[name]['seconds']:.2g} | {times[name]['particles']:,} | {times[name]['steps']:,} |"
                for name, shows in decks().items())]  # fmt: skip
