#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are interrupted, killed, damaged and resumed: test_resume.py BARRENO."""
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

from netCDF4 import Dataset
from tools.resumed import (
    at_previous, command, different_fields, different_files, different_sums, lines_of, must_work, program, stopped_run
)
from tools.runs import DECKS, mpi_environment

DECK = str(DECKS / "perforation_quick.xml")
SHORT = tuple(
    word
    for setting in ("Time/End Time=9 us", "Output/Field Interval=3 us", "Output/History Interval=0.25 us", "Output/Checkpoint Steps=90",
                    "Grid/Upper={80 mm, 130 mm}", "Bodies/Rock/Upper={50.8 mm, 112.7 mm}")
    for word in ("--set", setting)
)  # fmt: skip
# Its particles take more room than MPI's own files.
LARGE = ("--set", "Time/End Time=12 us", "--set", "Output/Field Interval=0.8 us", "--set", "Output/Checkpoint Steps=150")


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


def check_warnings(barreno, folder, plain):
    """What a terminal, a batch queue or a pipe sends ends the run with a checkpoint, and the last line says how to go on."""
    for name, kind in (("hup", signal.SIGHUP), ("usr1", signal.SIGUSR1), ("pipe", signal.SIGPIPE), ("xcpu", signal.SIGXCPU)):
        run = folder / f"{name} run"  # with a space, which the line must quote
        found = interrupted(barreno, 1, run, 12, kind)
        assert found == 128 + kind, f"{name}: exit {found}"
        assert f"Next: ./barreno resume '{run}'" in (run / "run.log").read_text(), name
        assert signal.Signals(kind).name in json.loads((run / "summary.json").read_text())["reason"], name
        assert lines_of(run / "history.csv") < lines_of(plain / "history.csv")
        resumed(barreno, 1, run)
        assert not different_fields(plain, run) and not different_files(plain, run), name
    two = folder / "usr1_two"
    found = interrupted(barreno, 2, two, 12, signal.SIGUSR1)  # mpirun passes it on
    assert found == 128 + signal.SIGUSR1, found
    resumed(barreno, 2, two)
    assert not different_fields(plain, two) and not different_files(plain, two)


def check_full_disk(barreno, folder, plain):
    """A file that cannot grow ends the run at once, behind a checkpoint; with room it goes on to the same answer."""
    whole, run = folder / "often", folder / "limited"
    must_work(program(barreno, 1, "run", DECK, "--out", whole, *LARGE))
    most = int(0.7 * (whole / "particles.e").stat().st_size)  # more than a checkpoint takes, and than MPI's own files
    assert most > max(1.5 * (whole / "checkpoint.h5").stat().st_size, 8e6)
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))  # noqa: E731
    words = [barreno, "run", DECK, "--out", str(run), *LARGE]
    result = subprocess.run(words, capture_output=True, text=True, env=mpi_environment(1), preexec_fn=limit, check=False)
    assert result.returncode == 128 + signal.SIGXFSZ and "particles.e" in result.stdout, f"exit {result.returncode}: {result.stdout}"
    assert result.stdout.rstrip().endswith(f"Next: ./barreno resume {run}"), result.stdout
    resumed(barreno, 1, run)
    assert not different_fields(whole, run) and not different_files(whole, run)


def check_two_processes(barreno, folder, plain):
    """A folder with a live run is refused to a second process, which names the first; the first ends as if alone."""
    run = folder / "live"
    words = ("run", DECK, "--out", str(run), *SHORT, "--set", "Output/Checkpoint Steps=20")
    first = subprocess.Popen(command(barreno, 1, *words), stdout=subprocess.DEVNULL, env=mpi_environment(1))
    while first.poll() is None and not (run / "checkpoint.h5").exists():
        time.sleep(0.005)
    first.send_signal(signal.SIGSTOP)
    try:
        second = [
            subprocess.Popen(command(barreno, 1, *more), stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
                env=mpi_environment(1))
            for more in (("resume", str(run)), (*words, "--overwrite"))
        ]
        said = [(process.communicate()[1], process.returncode) for process in second]
    finally:
        first.send_signal(signal.SIGCONT)
    for text, code in said:
        assert code == 2 and f"is in use (process {first.pid} on " in text.splitlines()[-1], f"exit {code}: {text}"
    assert first.wait() == 0 and not (run / "run.lock").exists()
    assert not different_fields(plain, run) and not different_files(plain, run)


def check_killed_group(barreno, folder, plain):
    """mpirun's group is killed, its ranks live on for a moment, and the run is resumed at once: the answer is the same."""
    words = ("run", DECK, *SHORT, "--set", "Output/Checkpoint Steps=25")
    for turn in range(2):
        run = folder / f"group{turn}"
        first = subprocess.Popen(
            command(barreno, 2, *words, "--out", str(run)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=mpi_environment(2),
            start_new_session=True
        )
        while first.poll() is None and lines_of(run / "history.csv") < 10 + 7 * turn:
            time.sleep(0.005)
        os.killpg(first.pid, signal.SIGKILL)
        first.wait()
        result = program(barreno, 2, "resume", run)
        # On a busy machine the ranks may live on to the end of the run.
        assert result.returncode == 0 or "has reached its end time" in result.stderr, f"exit {result.returncode}: {result.stderr}"
        assert not different_fields(plain, run) and not different_files(plain, run), f"turn {turn}"


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
    for turn in range(2):
        run = folder / f"damaged{turn}"
        shutil.copytree(plain, run)
        data = bytearray((run / "checkpoint.h5").read_bytes())
        if turn == 0:
            data[int(rng.integers(size))] ^= 1 << int(rng.integers(8))
        else:
            del data[int(rng.integers(size)) :]
        (run / "checkpoint.h5").write_bytes(data)
        resumed(barreno, 1, run)
        assert "skipped" in (run / "run.log").read_text()
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
        ((str(changed), "--until", "11 us"), 1, "Courant Fraction"),
        ((str(short), "--until", "11 us"), 2, "shorter"),
        ((str(folder / "nowhere"),), 2, "no checkpoint"),
        ((), 1, "the run folder, which holds the checkpoint, is missing"),
        ((str(plain), "--until", "11 kg"), 1, "End Time"),
    ):
        result = program(barreno, 1, "resume", *words)
        assert result.returncode == code and said in result.stderr, f"{words}: exit {result.returncode}: {result.stderr}"
        assert result.stderr.count("\n") == 1, result.stderr


def check_longer(barreno, folder, plain):
    """A finished run goes on to a later end: times only grow, and the last is the new end."""
    run = folder / "longer"
    shutil.copytree(plain, run)
    resumed(barreno, 1, run, "--until", "10 us")
    with Dataset(run / "particles.e") as data:
        times = np.asarray(data["time_whole"][:])
    assert abs(times[-1] - 10e-6) < 1e-12 and np.all(np.diff(times) > 0.0), times
    resumed(barreno, 1, run, "--until", "11 us")


def check_start(barreno, folder, plain):
    """What the files know of t = 0, of which no particle is made on a resume, goes on: radii of points, and those of a hollow ball; on
    other ranks too."""
    words = {"Grid/Cell Size": "3 mm", "Time/End Time": "10 us", "Output/Checkpoint Steps": 5, "Output/Field Interval": "4 us",
        "Output/Particle Glyph": "point"}
    whole = folder / "ball"
    must_work(program(barreno, 1, "run", DECKS / "shell_squeezed.xml", "--out", whole,
        *(word for item in words.items() for word in ("--set", "=".join(map(str, item))))))
    for ranks in (1, 2):
        run = resumed(barreno, ranks, at_previous(pathlib.Path(shutil.copytree(whole, folder / f"ball_on_{ranks}"))))
        assert not different_fields(whole, run), different_fields(whole, run)
        assert not different_files(whole, run, ("history.csv", "radii.csv", "cavities.csv")), ranks


def check_divided(barreno, folder, _plain):
    """Particles of the jet that are divided, before the checkpoint and after it, are those of the straight run; on other ranks too."""
    divided = ("--set", "Jet/Splits=3", "--set", "Jet/Particles Per Cell=2")
    whole, undivided = folder / "divided", folder / "undivided"
    must_work(program(barreno, 1, "run", DECK, "--out", whole, *SHORT, *divided))
    must_work(program(barreno, 1, "run", DECK, "--out", undivided, *SHORT, *divided, "--set", "Jet/Splits=0"))
    count, before = (json.loads((run / "summary.json").read_text())["particles"] for run in (whole, undivided))
    assert count > before + 100, (count, before)
    for ranks in (1, 2):
        run = resumed(barreno, ranks, at_previous(pathlib.Path(shutil.copytree(whole, folder / f"divided_on_{ranks}"))))
        wrong = different_fields(whole, run) + different_files(whole, run)
        assert not wrong, f"{ranks}: {wrong}"


def check_broken_grains(barreno, folder, _plain):
    """Breakage of the rock's grains goes on as it was, on other ranks too."""
    card = ("--set", "Materials/Sandstone/Card=berea_sandstone_damage.xml")
    whole = folder / "broken"
    must_work(program(barreno, 1, "run", DECK, "--out", whole, *SHORT, *card))
    most = json.loads((whole / "summary.json").read_text())["penetration"]["zones_in_body"]["Rock"]["greatest_breakage"]
    assert most > 0.5, most
    for ranks in (1, 2):
        run = resumed(barreno, ranks, at_previous(pathlib.Path(shutil.copytree(whole, folder / f"broken_on_{ranks}"))))
        wrong = different_fields(whole, run) + different_files(whole, run) + different_sums(whole, run)
        assert not wrong, f"{ranks}: {wrong}"


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plain = straight(barreno, folder / "plain")
        for check in (check_signals, check_warnings, check_full_disk, check_two_processes, check_killed_group, check_damage, check_refusals,
                check_longer, check_ranks, check_start, check_divided, check_broken_grains):
            check(barreno, folder, plain)
            print(check.__name__, "holds")


if __name__ == "__main__":
    main()
