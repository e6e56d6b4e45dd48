#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reports on runs whose files were cut off, changed or laid there: one sentence or a report, never a traceback.

    test_report.py BARRENO [--random N]    N more files, cut and changed at random places
"""
import argparse
import contextlib
import io
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

from barreno.report.build import make_report
from barreno.report.numbers import depth_text
from barreno.runs.faults import BadRun
from tools.runs import run_deck

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "verification" / "tools"
FILES = ("history.csv", "depth.csv", "summary.json", "particles.e", "deck.xml")


def cut(share):
    return lambda data: data[: int(share * len(data))]


def replaced(old, new):
    def change(data):
        assert old in data
        return data.replace(old, new, 1)

    return change


def in_line(number, text):
    """One more text at the end of a line, from 1."""

    def change(data):
        lines = data.split(b"\n")
        lines[number - 1] += text
        return b"\n".join(lines)

    return change


# file, what is done to it, part of the sentence; None: there is a report.
CASES = [
    ("history.csv", cut(0.0), "history.csv contains no row"),
    ("history.csv", lambda data: b"\n".join(data.split(b"\n")[:2]) + b"\n", "history.csv contains no row"),
    ("history.csv", cut(0.8), None),
    ("history.csv", lambda data: data.replace(b"\n", b"\r\n"), None),
    ("history.csv", in_line(5, b"," + b"0," * 20 + b"1"), "line 5 of history.csv has"),
    ("history.csv", in_line(4, b"abc"), "line 4 of history.csv contains something that is not a number"),
    ("history.csv", replaced(b",plastic,", b",plstic,"), "history.csv lacks the column 'plastic'"),
    ("history.csv", lambda data: b"\xff\xfe\x00" + data, "history.csv is truncated or was changed"),
    ("depth.csv", cut(0.0), "depth.csv contains no row"),
    ("depth.csv", replaced(b",channel_depth", b",x"), "depth.csv lacks the column 'channel_depth'"),
    ("summary.json", cut(0.5), "summary.json is truncated or was changed"),
    ("summary.json", cut(0.0), "summary.json is truncated or was changed"),
    ("summary.json", lambda data: b"[1, 2]", "summary.json is truncated or was changed: it is not a JSON object"),
    ("summary.json", lambda data: b'{"balances": 3}', "truncated or was changed"),
    ("summary.json", lambda data: b'{"penetration": 3}', "truncated or was changed"),
    ("summary.json", lambda data: b'{"penetration": {"convergence": {"low": 1}}}', "truncated or was changed"),
    ("summary.json", replaced(b'"ranks": 1', b'"rank": 1'), "summary.json is truncated or was changed: 'ranks'"),
    ("particles.e", cut(0.0), "particles.e cannot be read"),
    ("particles.e", lambda data: b"CDF\x02" + b"\xff" * 200, "particles.e "),
    ("particles.e", cut(0.01), "particles.e "),
    ("deck.xml", cut(0.5), "deck.xml is truncated or was changed"),
    ("deck.xml", replaced(b'name="Cell Size" type="double" value="0.002"', b'name="Cell Size" type="double" value="two"'),
        "truncated or was changed"),
]


def sentence_of(run):
    """What a report says, "" if it is made; anything but a BadRun goes through."""
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            make_report(run)
    except BadRun as fault:
        return str(fault) or "nothing"
    return ""


def changed(whole, folder, file, change):
    run = pathlib.Path(shutil.copytree(whole, folder / "run", dirs_exist_ok=False))
    (run / file).write_bytes(change((run / file).read_bytes()))
    return run


def check_case(whole, folder, file, change, said):
    run = changed(whole, folder, file, change)
    got = sentence_of(run)
    shutil.rmtree(run)
    if (said is None) != (got == "") or (said or "") not in got or "\n" in got:
        return [f"{file}: expected {said!r}, got {got!r}"]
    return []


def random_change(rng):
    """Cut, or some bytes changed, left out or doubled."""

    def change(data):
        data = bytearray(data)
        kind = rng.randrange(4)
        for _ in range(1 if kind == 0 else rng.randrange(1, 6)):
            at = rng.randrange(max(len(data), 1))
            if kind == 0:
                del data[at:]
            elif kind == 1 and data:
                data[at] = rng.randrange(256)
            elif kind == 2:
                del data[at : at + rng.randrange(1, 50)]
            else:
                data[at:at] = data[at : at + rng.randrange(1, 50)]
        return bytes(data)

    return change


def check_random(whole, folder, count):
    problems = []
    for seed in range(count):
        rng = random.Random(seed)
        file = FILES[seed % len(FILES)]
        run = changed(whole, folder, file, random_change(rng))
        try:
            got = sentence_of(run)
            if "\n" in got or len(got) > 600:
                problems.append(f"seed {seed}, {file}: {got!r}")
        except Exception as error:  # noqa: BLE001  any is a finding
            problems.append(f"seed {seed}, {file}: {type(error).__name__}: {error}")
        shutil.rmtree(run)
    return problems


def check_links(whole, folder):
    """What somebody laid where a report is written is not written through."""
    run = pathlib.Path(shutil.copytree(whole, folder / "run"))
    victim = folder / "victim"
    victim.write_text("keep")
    (run / "report").mkdir()
    for name in ("fields.png", "index.md", "index.html", "profile.csv", ".index.md.tmp.md", ".energy.png.tmp.png"):
        (run / "report" / name).symlink_to(victim)
    got = sentence_of(run)
    kept = victim.read_text() == "keep" and not (run / "report" / "index.md").is_symlink()
    shutil.rmtree(run)
    return [] if kept and got == "" else [f"links: {got!r}, {victim.read_text()[:20]!r}"]


DEPTH = {"depth": 0.0234}
ERROR = {"value": -0.074, "low": -0.15, "high": -0.03, "cells_per_radius": 1.0, "source": "measured"}
STUDY = {"cells": [5e-4, 1e-3, 2e-3], "low": 0.021, "high": 0.026, "extrapolated": 0.025}
DEPTHS = [  # what a summary holds, words of the line
    ({"depth_error": ERROR}, "23.40 mm; error from the size of the cells -7 % (-15 to -3 %) at 1 cell per jet radius, as measured"),
    ({"depth_error": {**ERROR, "cells_per_radius": 0.5}}, "at 0.5 cells per jet radius"),
    ({"depth_error": {"unknown": "of plane jets nothing was measured"}},
        "23.40 mm; error from the size of the cells unknown (of plane jets"),
    ({"depth_error": {"unknown": "it was measured until 90 us only", "advice": "barreno converge compares"}},
        "(it was measured until 90 us only); barreno converge compares"),
    ({"convergence": STUDY}, "23.40 mm; 21.0 to 26.0 mm by cells of 2, 1, 0.5 mm (grid convergence index)"),
    ({"convergence": {**STUDY, "extrapolated": None}}, "(spread, without an order)"),
    ({}, "23.40 mm"),
]  # fmt: skip


def check_depths(whole):
    """The depth stands with its interval, or with what was measured of its cells; the run's own summary has the latter."""
    problems = [f"{found}: {depth_text(DEPTH, found)}" for found, words in DEPTHS if words not in depth_text(DEPTH, found)]
    make_report(whole)
    page = (whole / "report" / "index.md").read_text()
    shutil.rmtree(whole / "report")
    wanted = ("at 0.5 cells per jet radius, as measured with tungsten jets",
        "| cells per radius of the jet at impact | 0.5 to 1.1 (tip 0.5, tail 1.1) |")
    return problems + [f"the page lacks: {words}" for words in wanted if words not in page]


def check_command(folder):
    """As a user calls it: the exit code and one line."""
    (folder / "empty").mkdir()
    words = [sys.executable, str(TOOLS / "report.py"), str(folder / "empty")]
    result = subprocess.run(words, capture_output=True, text=True, check=False)
    fine = result.returncode == 2 and result.stderr.startswith("barreno: cannot report on") and result.stderr.count("\n") == 1
    return [] if fine else [f"an empty folder: exit {result.returncode}, {result.stderr}"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("barreno", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--random", type=int, default=0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        whole = folder / "whole"
        run_deck(options.barreno, "perforation_quick.xml", {"Time/End Time": "1 us", "Output/Checkpoint Wall Interval": "0 s"},
            folder=whole)
        problems = check_command(folder) + check_links(whole, folder) + check_depths(whole)
        for case in CASES:
            problems += check_case(whole, folder, *case)
        problems += check_random(whole, folder, options.random)
        print("\n".join([*problems, f"{len(CASES) + options.random} changed files: {len(problems)} problems"]))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
