#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A jet that meets no target has no depth: `check` and the run say so, and no file holds one.

    test_jet_targets.py BARRENO
"""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "verification" / "tools"))
from runs import DECKS, Run, mpi_environment  # noqa: E402

COARSE = ("Grid/Cell Size=5 mm", "Time/End Time=3 us")


def barreno(command, *settings):
    words = [sys.argv[1], *command, *[x for s in COARSE + settings for x in ("--set", s)]]
    result = subprocess.run(words, env=mpi_environment(), capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stderr}"
    return result.stdout + result.stderr


def check_case(folder, words, met, *settings):
    """`words` of the note of `check` and of the run, or None where there is none; whether the jet met its target."""
    deck = DECKS / "perforation_quick.xml"
    for text in (barreno(["check", deck], *settings), barreno(["run", deck, "--out", folder], *settings)):
        notes = [line for line in text.splitlines() if "no depth will be computed" in line]
        if words is None:
            assert not notes, notes
        else:
            assert len(notes) == 1 and words in notes[0], text
    assert ("no depth: the jet has hit no target" in text) == (not met), text
    penetration = json.loads((folder / "summary.json").read_text())["penetration"]
    depths = Run(folder).table("depth.csv")
    assert penetration["met_target"] == met, penetration
    if met:
        assert penetration["depth"] == depths["depth"][-1] > 0.0, penetration
        return
    assert penetration["depth"] is None and penetration["channel_depth"] == penetration["jet_mass_inside"] == 0.0, penetration
    assert depths["tip_velocity"][-1] > 1000.0, "the jet does not fly"
    for name in ("depth", "channel_depth", "channel_radius_mid", "jet_mass_inside"):
        assert (depths[name] == 0.0).all(), f"{name}: {depths[name]}"


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_case(folder / "down", None, True)
        check_case(folder / "up", "hits no body (none lies in its path along -y", False, "Jet/Direction=-y")
        check_case(folder / "late", "not before Time/End Time", False, "Jet/Launch Position=-35 mm")


if __name__ == "__main__":
    main()
