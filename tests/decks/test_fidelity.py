#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A fidelity is good for every deck of input_xml, is said once, and its effective deck runs again to the same bits.

    test_fidelity.py BARRENO SERVE_RUNS

The plans come from a server (verification/adversary/serve_runs.cpp), which starts MPI once for all of them.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from adversary.run_server import RunServer
from tools.runs import DECKS, mpi_environment

TESTS = pathlib.Path(__file__).resolve().parents[1]
NAMES = ("fast", "balanced", "reference")


def barreno(*words):
    result = subprocess.run([sys.argv[1], *map(str, words)], env=mpi_environment(), capture_output=True, text=True)
    assert result.returncode == 0, f"{words}: {result.returncode} {result.stderr}"
    return result.stdout


def check_every_deck(folder):
    server = RunServer(pathlib.Path(sys.argv[2]).resolve(), folder)
    for deck in sorted(DECKS.glob("*.xml")):
        for name in NAMES:
            ended = server.run("check", deck, "--fidelity", name, limit=120)
            plan = ended.out
            assert ended.text() == "exit 0", f"{deck.name}, {name}: {ended.text()} {ended.err}"
            assert plan.count(f"Note: Fidelity {name}: ") == 1, f"{deck.name}: the plan does not say what {name} means"
    server.end()


def check_metal_that_breaks():
    """A jet of metal that breaks gets fewer cells, particles that are divided and, but for fast, what each step loses; a deck that takes
    its strength away does not."""
    deck, sound = DECKS / "perforation.xml", ("Spall Stress=0", "Thermal Spall=off", *(f"D{i}=0" for i in range(1, 6)))
    for name, cells, others in (("fast", "1.2", "1.8"), ("balanced", "1.8", "2.4"), ("reference", "2.4", "4")):
        plan = barreno("check", deck, "--fidelity", name)
        assert f"Jet/Splits = 4, Jet/Cells Per Radius = {cells}" in plan, plan
        assert f"Step/Return Losses = {'false' if name == 'fast' else 'true'}" in plan, plan
        settings = [word for entry in sound for word in ("--set", f"Materials/Tungsten/{entry}")]
        plan = barreno("check", deck, "--fidelity", name, *settings)
        assert "Jet/Splits" not in plan and f"Jet/Cells Per Radius = {others}" in plan and "Step/Return Losses" not in plan, plan


def check_none(folder):
    """Takes the choices of a deck away: the deck without its Fidelity."""
    deck, bare = DECKS / "perforation.xml", folder / "bare.xml"
    same = ("Grid ", "Jet ", "Kind ", "Note: ")
    plans = [[line for line in barreno("check", deck, *words).splitlines() if line.startswith(same)]
        for words in (("--fidelity", "none"), ("--set", "Fidelity=none"), ("--set", "Fidelity="))]  # fmt: skip
    assert plans[0] == plans[1] == plans[2] and len(plans[0]) >= 3, plans
    said = "\n".join(plans[0])
    assert "Fidelity" not in said and "cells of 0.001 m" in said and "Cells Per Radius =" not in said, said
    bare.write_text(barreno("check", deck, "--fidelity", "none", "--print-deck"))
    assert "cells of 0.001 m" in barreno("check", bare)


def check_losses_that_stay_lost():
    """Where another word of the deck leaves no way to know them a fidelity does not ask for them."""
    for entry in ("Transfer=APIC", "Order=modified stress last", "Damping=1", "PIC Fraction=0.1"):
        words = [word for one in (entry, "Subcycles=1") for word in ("--set", f"Step/{one}")]
        plan = barreno("check", DECKS / "perforation.xml", "--fidelity", "balanced", *words, "--set", "Jet/Cells Per Radius=1")
        assert "Step/Return Losses" not in plan, plan


def run_again(folder):
    """perforation_quick.xml has output intervals of its own; --set comes before a fidelity like the deck."""
    words = ("--fidelity", "fast", "--set", "Step/Courant Fraction=0.7", "--set", "Time/End Time=3 us")
    barreno("run", DECKS / "perforation_quick.xml", *words, "--out", folder / "first")
    log = (folder / "first" / "run.log").read_text()
    assert log.count("Fidelity fast: Step/Shape Function = GIMP, ") == 1, log
    kept = re.findall("The deck's own values take precedence over fidelity fast: (.*)", log)
    assert len(kept) == 1 and "Step/Courant Fraction = 0.7 (fast: 0.8)" in kept[0] and "Field Interval = 5 us" in kept[0], kept
    barreno("run", folder / "first" / "deck.xml", "--out", folder / "again")
    barreno("run", DECKS / "perforation_quick.xml", "--set", "Time/End Time=3 us", "--out", folder / "plain")
    compare = [sys.executable, TESTS / "scripts" / "exodiff_lite.py", "-f", TESTS / "scripts" / "same.exodiff"]
    for other, same in (("again", True), ("plain", False)):
        command = [*compare, folder / "first" / "particles.e", folder / other / "particles.e"]
        code = subprocess.run(command, capture_output=True, text=True).returncode
        assert (code == 0) == same, f"first and {other} run: exodiff_lite.py says {code}"


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_every_deck(folder)
        check_metal_that_breaks()
        check_losses_that_stay_lost()
        check_none(pathlib.Path(folder))
        run_again(pathlib.Path(folder))


if __name__ == "__main__":
    main()
