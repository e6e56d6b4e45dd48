#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are interrupted, killed, damaged and resumed: test_resume.py BARRENO."""
import pathlib
import re
import shutil
import signal
import sys
import tempfile

import numpy as np

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "verification" / "tools")]

from netCDF4 import Dataset  # noqa: E402
from resumed import at_previous, different_fields, different_files, different_sums, lines_of, must_work, program, stopped_run  # noqa: E402
from runs import DECKS  # noqa: E402

DECK = str(DECKS / "perforation_quick.xml")
SHORT = ("--set", "Time/End Time=15 us", "--set", "Output/Field Interval=5 us", "--set", "Output/Checkpoint Steps=150")


def straight(barreno, folder):
    must_work(program(barreno, 1, "run", DECK, "--out", folder, *SHORT))
    return folder


def interrupted(barreno, ranks, folder, wanted, kind, *more):
    """A run that got a signal when its history had so many rows. @return its exit code"""
    words = ("run", DECK, "--out", folder, *SHORT, *more)
    return stopped_run(barreno, ranks, words, kind, lambda: lines_of(folder / "history.csv") >= wanted)


def resumed(barreno, ranks, folder, *words):
    must_work(program(barreno, ranks, "resume", folder, *words))
    return folder


def check_signals(barreno, folder, plain):
    """After Ctrl-C, SIGTERM or SIGKILL the resumed run has the files of the straight one, byte for byte; checkpoints change nothing."""
    often = ("--set", "Output/Checkpoint Steps=20")
    for name, kind, code in (("int", signal.SIGINT, 130), ("term", signal.SIGTERM, 143), ("kill", signal.SIGKILL, -9)):
        run = folder / name
        found = interrupted(barreno, 1, run, 12, kind, *often)
        assert found == code, f"{name}: exit {found}"
        resumed(barreno, 1, run)
        assert not different_fields(plain, run), f"{name}: {different_fields(plain, run)}"
        assert not different_files(plain, run), f"{name}: {different_files(plain, run)}"


def check_ranks(barreno, folder, plain):
    """From 2 ranks to 1, 2 and 3: fields, tables and balances to the bit, as on one rank."""
    whole = folder / "two"
    must_work(program(barreno, 2, "run", DECK, "--out", whole, *SHORT))
    for ranks in (1, 2, 3):
        run = at_previous(pathlib.Path(shutil.copytree(whole, folder / f"on{ranks}")))
        resumed(barreno, ranks, run)
        wrong = different_fields(plain, run) + different_files(plain, run) + different_sums(plain, run)
        assert not wrong, f"2 ranks, then {ranks}: {wrong}"


def check_damage(barreno, folder, plain):
    """One flipped bit or a cut: the checkpoint before is taken, and the answer is the same; nothing whole: exit 2."""
    size = (plain / "checkpoint.h5").stat().st_size
    rng = np.random.default_rng(1)
    for turn in range(4):
        run = folder / f"damaged{turn}"
        shutil.copytree(plain, run)
        data = bytearray((run / "checkpoint.h5").read_bytes())
        if turn % 2 == 0:
            data[int(rng.integers(size))] ^= 1 << int(rng.integers(8))
        else:
            del data[int(rng.integers(size)) :]
        (run / "checkpoint.h5").write_bytes(data)
        resumed(barreno, 1, run)
        assert "passed over" in (run / "run.log").read_text()
        assert not different_fields(plain, run) and not different_files(plain, run)
    last = folder / "lost"
    shutil.copytree(plain, last)
    for name in ("checkpoint.h5", "checkpoint_previous.h5"):
        (last / name).write_bytes(b"nothing")
    before = (last / "history.csv").read_bytes()
    result = program(barreno, 1, "resume", last)
    assert result.returncode == 2 and result.stderr.count("\n") == 1 and "cannot resume" in result.stderr, result.stderr
    assert (last / "history.csv").read_bytes() == before


def check_refusals(barreno, folder, plain):
    """What cannot be resumed, and what to do: one sentence each."""
    changed = folder / "changed"
    shutil.copytree(plain, changed)
    deck = changed / "deck.xml"
    text = deck.read_text()
    deck.write_text(re.sub(r'(name="Courant Fraction" type="double" value=")[^"]*', r"\g<1>0.7", text))
    assert deck.read_text() != text
    short = folder / "short"
    shutil.copytree(plain, short)
    (short / "history.csv").write_text("# nothing\n")
    for words, code, said in (
        ((str(plain),), 1, "--until"),
        ((str(changed), "--until", "17 us"), 1, "Courant Fraction"),
        ((str(short), "--until", "17 us"), 2, "shorter"),
        ((str(folder / "nowhere"),), 2, "no checkpoint"),
        ((), 1, "no run is named"),
        ((str(plain), "--until", "17 kg"), 1, "End Time"),
    ):
        result = program(barreno, 1, "resume", *words)
        assert result.returncode == code and said in result.stderr, f"{words}: exit {result.returncode}: {result.stderr}"
        assert result.stderr.count("\n") == 1, result.stderr


def check_longer(barreno, folder, plain):
    """A finished run goes on to a later end: times only grow, and the last is the new end."""
    run = folder / "longer"
    shutil.copytree(plain, run)
    resumed(barreno, 1, run, "--until", "18 us")
    with Dataset(run / "particles.e") as data:
        times = np.asarray(data["time_whole"][:])
    assert abs(times[-1] - 18e-6) < 1e-12 and np.all(np.diff(times) > 0.0), times
    resumed(barreno, 1, run, "--until", "19 us")


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plain = straight(barreno, folder / "plain")
        for check in (check_signals, check_damage, check_refusals, check_longer, check_ranks):
            check(barreno, folder, plain)
            print(check.__name__, "holds")


if __name__ == "__main__":
    main()
