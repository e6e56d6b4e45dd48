#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""`check` predicts the work of a run and says what features cost; the run compares. Seconds depend on what else the machine does,
particle-steps do not.

    test_predictions.py BARRENO
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from tools.runs import DECKS, mpi_environment

CLOSE = 0.3
FORMATION = ("--set", "Grid/Cell Size=1 mm")  # coarse, so that it takes seconds
REFINED = ("--fidelity", "balanced", "--set", "Time/End Time=10 us")  # small cells along the path, steps in parts
SHOCK, JET, SHELL, BOX = "shock_copper", "perforation_quick", "shell_coasting", "manufactured_box"


def barreno(*words):
    result = subprocess.run([sys.argv[1], *map(str, words)], env=mpi_environment(), capture_output=True, text=True)
    assert result.returncode == 0, f"{words}: {result.returncode} {result.stderr}"
    return result.stdout


def compare(deck, folder, *words):
    plan = barreno("check", DECKS / f"{deck}.xml", *words)
    said = re.search(r"about (\d+) steps(?: of \d+ parts)?, (\S+) particle-steps\nCost      about \S+.* of computing on 1 rank, (\d+) ns",
        plan)
    assert said and float(said.group(3)) > 1.0, plan
    out = folder / "_".join([deck, *words[:2]])
    screen = barreno("run", DECKS / f"{deck}.xml", "--out", out, *words)
    summary = json.loads((out / "summary.json").read_text())
    predicted = summary["prediction"]
    assert abs(predicted["particle_steps"] / float(said.group(2))
        - 1.0) < 0.1, f"{deck}: check and run predict differently: {said.groups()}, {predicted}"
    for name in ("steps", "particle_steps"):
        off = predicted[name] / summary[name] - 1.0
        assert abs(off) < CLOSE, f"{deck}: {name} were predicted {off:+.0%} off"
    off = predicted["bytes"] / summary["peak_resident_bytes"] - 1.0
    assert abs(off) < CLOSE, f"{deck}: memory was predicted {off:+.0%} off"
    assert summary["cpu_seconds"] > 0.0 and predicted["wall_seconds"] > 0.0
    assert screen.count("\n  predicted: ") == 1, screen


def row(plan, feature):
    return re.search(rf"^  {feature} +(on|off) +(\S+) +(\S+)", plan, re.MULTILINE).groups()


def check_features():
    """XPIC keeps eleven numbers of a particle in two dimensions: seen in its bytes, and its time is not nothing."""
    xpic = barreno("check", DECKS / f"{SHELL}.xml", "--set", "Step/Transfer=XPIC", "--set", "Step/XPIC Order=3")
    on, size, share = row(xpic, "XPIC")
    assert (on, size) == ("on", "88") and 1.0 < float(share) < 100.0, xpic


def check_what_is_off(deck):
    """No byte of a particle, and less than a hundredth of the time."""
    plan = barreno("check", DECKS / f"{deck}.xml")
    off = re.findall(r"^  (.{22}) off +(\d+) +(\S+)", plan, re.MULTILINE)
    assert len(off) > 8, plan
    for name, size, share in off:
        assert size == "0" and (share == "-"
            or float(share) < 1.0), f"{deck}: {name.strip()} is off and costs {size} bytes, {share} % of the time"


def main():
    check_features()
    for deck in (BOX, JET):
        check_what_is_off(deck)
    with tempfile.TemporaryDirectory() as folder:
        for deck in (SHOCK, JET, SHELL):
            compare(deck, pathlib.Path(folder))
        compare(JET, pathlib.Path(folder), *REFINED)
        compare("jet_formation", pathlib.Path(folder), *FORMATION)


if __name__ == "__main__":
    main()
