#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a user does by mistake, or finds in a folder: odd names of decks, links that lie where a run writes, a folder that is
deleted during the run, help, a full disk behind the screen.

    test_user_faults.py BARRENO
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom

from tools.resumed import lines_of
from tools.runs import DECKS, mpi_environment

QUICK = DECKS / "perforation_quick.xml"
SHORT = ("--set", "Time/End Time=0.4 us")
NAMES = ["a--b.xml", "a\nb.xml", "x-->.xml", "\x1b[31m\x07.xml", "it's \"quoted\" & <so>.xml", "\udcff\udcfe.xml", "\u00e9\u20ac.xml",
    "a;b $HOME `x`.xml"]


def program(barreno, *words, ranks=1, **more):
    start = ["mpirun", "--quiet", "-n", str(ranks)] if ranks > 1 else []
    more = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
    return subprocess.run([*start, barreno, *map(str, words)], env=mpi_environment(ranks), check=False, errors="surrogateescape", **more)


def one_sentence(result, code, *said):
    """The program ended with this code and one line on stderr that holds these words."""
    lines = result.stderr.splitlines()
    assert result.returncode == code, f"exit {result.returncode}, not {code}: {result.stderr}"
    assert len(lines) == 1 and lines[0].startswith("barreno: ") and all(words in lines[0] for words in said), result.stderr


def check_odd_names(barreno, folder):
    """A run of a deck of any name leaves XML and JSON, and is resumed; its screen has no escape sequences of the name."""
    (folder / "jets").symlink_to(DECKS / "jets")
    for number, name in enumerate(NAMES):
        deck, run = folder / name, folder / f"odd{number}"
        shutil.copy(QUICK, deck)
        result = program(barreno, "run", name, "--out", run, *SHORT, cwd=folder)
        assert result.returncode == 0, f"{name!r}: {result.stderr}"
        assert "\x1b" not in result.stdout.split("\n", 1)[0], result.stdout
        xml.dom.minidom.parse(str(run / "deck.xml"))
        json.loads((run / "summary.json").read_text(encoding="utf-8"))
        result = program(barreno, "resume", run, "--until", "0.5 us")
        assert result.returncode == 0, f"{name!r}: {result.stderr}"


def check_links(barreno, folder):
    """Links that lie where files are written aside are taken away, what they name stays."""
    run, victim = folder / "links", folder / "victim"
    run.mkdir()
    victim.write_text("keep")
    names = [f"{name}.tmp" for name in ("deck.xml", "summary.json", "particles.e", "checkpoint.h5")] + [".barreno_probe"]
    for name in names:
        (run / name).symlink_to(victim)
    result = program(barreno, "run", QUICK, "--out", run, "--overwrite", *SHORT)
    assert result.returncode == 0, result.stderr
    assert victim.read_text() == "keep", victim.read_text()[:50]
    for name in ("deck.xml", "summary.json", "particles.e", "checkpoint.h5", "history.csv"):
        assert (run / name).is_file() and not (run / name).is_symlink(), name


def check_deleted_folder(barreno, folder, ranks):
    """A folder that is deleted, or moved, during the run ends it at the next row, not at the end."""
    for what in ("deleted", "moved"):
        run = folder / f"{what}{ranks}"
        start = ["mpirun", "--quiet", "-n", str(ranks)] if ranks > 1 else []
        words = [*start, barreno, "run", str(QUICK), "--out", str(run), "--set", "Time/End Time=10 ms", "--set",
            "Output/Field Interval=1 ms"]
        process = subprocess.Popen(words, env=mpi_environment(ranks), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and lines_of(run / "history.csv") < 5:
            time.sleep(0.01)
        if what == "moved":
            run.rename(folder / f"elsewhere{ranks}")
        else:
            shutil.rmtree(run)
        try:
            screen, said = process.communicate(timeout=60)
        except subprocess.TimeoutExpired as late:
            process.kill()
            raise AssertionError(f"{what} on {ranks} ranks: the run went on") from late
        lines = [line for line in said.splitlines() if not line.startswith("warning: ")]
        assert (
            process.returncode == 2 and len(lines) == 1 and "removed, moved or replaced" in lines[0]
        ), f"exit {process.returncode}: {said}"


def check_changed_lines(barreno, folder):
    """Line ends of another system in history.csv: a resume says so instead of tearing a row."""
    run = folder / "crlf"
    assert program(barreno, "run", QUICK, "--out", run, *SHORT).returncode == 0
    history = run / "history.csv"
    history.write_bytes(history.read_bytes().replace(b"\n", b"\r\n"))
    before = history.read_bytes()
    one_sentence(program(barreno, "resume", run, "--until", "0.5 us"), 2, "history.csv")
    assert history.read_bytes() == before


def check_help(barreno, folder):
    for words in (["-h"], ["--help"], ["help"],
            *([command, option] for command in ("run", "resume", "check", "drive", "describe") for option in ("-h", "--help"))):
        result = program(barreno, *words)
        assert result.returncode == 0 and "Exit codes" in result.stdout and not result.stderr, f"{words}: {result.stderr}"
        assert len(words) == 1 or f"barreno {words[0]} " in result.stdout, f"{words}: {result.stdout}"
    for word in ("--version", "version"):
        lines = program(barreno, word).stdout.splitlines()
        assert [line.split()[0] for line in lines] == ["barreno", "commit", "compiler", "Trilinos", "Kokkos", "MPI"], lines
        assert all(len(line.split()) >= 2 for line in lines), lines
    one_sentence(program(barreno, "report", folder), 1, "./barreno report")
    one_sentence(program(barreno, "run", ""), 1, "the deck file is missing")
    one_sentence(program(barreno, "resume", ""), 1, "the run folder, which holds the checkpoint, is missing")
    for option in ("--out", "--set", "--fidelity", "--ranks"):
        one_sentence(program(barreno, "run", QUICK, option, ""), 1, f"{option} needs a value")


def check_screen(barreno, folder):
    """A page that does not arrive is a failure; answers may go down a pipe."""
    with open("/dev/full", "w") as full:
        for words in (["describe"], ["check", QUICK], ["--help"]):
            one_sentence(program(barreno, *words, stdout=full), 2, "standard output")
    card, path = "copper", DECKS / "paths" / "uniaxial_berea.csv"
    for name in ("copper", "copper.xml"):
        result = program(barreno, "drive", "--material", name, "--path", path, "--out", folder / f"{name}.csv")
        assert result.returncode == 0, result.stderr
    result = program(barreno, "drive", "--material", card, "--path", path, "--out", "/dev/stdout")
    assert result.returncode == 0 and result.stdout == (folder / "copper.csv").read_text(), result.stdout[:300]
    assert os.path.islink("/dev/stdout")
    one_sentence(program(barreno, "drive", "--material", card, "--path", path, "--out", "/dev/full"), 2, "/dev/full")


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_help(barreno, folder)
        check_screen(barreno, folder)
        check_odd_names(barreno, folder)
        check_links(barreno, folder)
        check_changed_lines(barreno, folder)
        check_deleted_folder(barreno, folder, 1)
        check_deleted_folder(barreno, folder, 2)
    print("faults of users are said, and cost nothing")


if __name__ == "__main__":
    main()
