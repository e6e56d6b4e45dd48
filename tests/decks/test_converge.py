#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`barreno converge` from the outside: what it writes, that it takes finished runs and no others, goes on after an interruption, finds the
order of a smooth motion and an interval that holds its exact answer, refuses a jet that its cells do not resolve, and has a sentence for
every bad input.

    test_converge.py BARRENO
"""
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time

import numpy
from barreno.runs.csv_table import WORDS, read_csv

from cases import shell_coasting
from python_commands import process_of, said_by
from tools.runs import DECKS

QUICK = DECKS / "perforation_quick.xml"
TARGET = ("--set", "Bodies/Rock/Upper={50.8 mm, 112.7 mm}")
SHORT = (*TARGET, "--set", "Time/End Time=2 us")


def converge(*words, code=0):
    return said_by("barreno.converge", *words, code=code)


def results_of(folder, stem="converge"):
    return json.loads((folder / f"{stem}.json").read_text())


def check_jet(folder):
    """Cells of 4, 2 and 1 mm do not resolve a tip of 1 mm: no limit, and the spread. Then the runs are there."""
    out = folder / "jet"
    said = converge(QUICK, *SHORT, "--out", out)
    assert "Grid/Upper is moved out to {0.08 m, 0.332 m} on all levels" in said and said.count("computing in") == 3, said
    assert 'The same command with --set "Grid/Cell Size=0.001 m" adds a level of smaller cells' in said, said
    assert (
        "wider than the radius of the jet" in said
        and "Error of the depth at the end with the smallest cells, which are 1 per jet radius" in said
    ), said
    found = results_of(out)
    assert [level["cells"] for level in found["levels"]] == [0.001, 0.002, 0.004] and len(found["results"]) == 4, found
    last = found["results"][-1]
    width = max(last["values"]) - min(last["values"])
    assert last["verdict"] == "unresolved" and last["extrapolated"] is None and last["values"][0] > last["values"][2] > 0.0, last
    assert abs(last["high"] - last["low"] - 2.0 * width) < 1e-12, last
    rows = read_csv(out / "converge.csv", cells=WORDS).to_dict("records")
    assert [float(row["cells_0.001"]) for row in rows] == [one["values"][0] for one in found["results"]], rows
    assert (out / "converge.png").read_bytes()[:4] == b"\x89PNG" and not list(out.glob(".*")), list(out.iterdir())
    depth = json.loads((out / "cells-1mm" / "summary.json").read_text())["penetration"]
    assert (
        depth["depth"] == last["values"][0] and depth["convergence"]["low"] == last["low"] and depth["convergence"]["extrapolated"] is None
    ), depth
    return out


def check_reuse(out, folder):
    """A run is taken if its effective deck is the same, wherever it lies beside; a changed value, or a run that has not finished, is
    not."""
    before = {file: file.stat().st_mtime_ns for file in out.glob("*/particles.e")}
    said = converge(QUICK, *SHORT, "--out", out, "--quantity", "kinetic", "--times", "1 us")
    assert said.count("finished run in") == 3 and "computing" not in said, said
    assert {file: file.stat().st_mtime_ns for file in out.glob("*/particles.e")} == before
    assert [round(1e6 * one["time"], 6) for one in results_of(out, "converge_kinetic")["results"]] == [1.0, 2.0]
    said = converge(QUICK, *SHORT, "--out", folder / "beside", "--levels", "2", "--set", "Grid/Upper={80 mm, 332 mm}")
    assert said.count("computing") == 2, said  # other runs lie two folders away
    (folder / "beside" / "cells-2mm").rename(folder / "by_hand")
    said = converge(QUICK, *SHORT, "--out", folder / "again", "--levels", "2", "--set", "Grid/Upper={80 mm, 332 mm}")
    assert f"finished run in {folder / 'by_hand'}" in said and said.count("computing") == 1, said
    assert "two levels show no order" in said, said
    said = converge(QUICK, *SHORT, "--out", folder / "again", "--levels", "2", "--set", "Grid/Upper={80 mm, 332 mm}", "--set",
        "Step/Courant Fraction=0.7")
    assert said.count("computing") == 2, said


def wait_for(condition, what):
    until = time.monotonic() + 120
    while not condition():
        assert time.monotonic() < until, f"waited in vain for {what}"
        time.sleep(0.02)


def check_interruption(out, folder):
    """A signal ends the run behind a checkpoint; the same words go on and come to the same numbers."""
    other = folder / "cut"
    words = (QUICK, *SHORT, "--out", other)
    log = other / "cells-1mm" / "run.log"
    with subprocess.Popen(**process_of("barreno.converge", *words), stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        wait_for(lambda: log.exists() and " % " in log.read_text(), "progress of the third run")
        os.kill(child.pid, signal.SIGINT)
        _, said = child.communicate(timeout=60)
    assert child.returncode == 130 and said.startswith("barreno: interrupted; the same command continues"), f"{child.returncode}: {said}"
    (other / "cells-4mm" / "summary.json").unlink()  # as after a kill behind the last checkpoint
    summary = json.loads((other / "cells-1mm" / "summary.json").read_text())
    assert not summary["finished"] and not (other / "converge.csv").exists(), summary["finished"]
    converge(*words)
    found = results_of(other)
    assert [level["how"] for level in found["levels"]] == ["resumed", "reused", "resumed"], found["levels"]
    assert found["results"] == results_of(out)["results"]


def check_smooth(folder):
    """The coasting shell: second order, and an interval that holds the radius of the one-dimensional shell."""
    settings = shell_coasting.settings(-0.08, 10.0, 14)
    words = [x for path, value in settings.items() if path.startswith(("Materials", "Bodies")) for x in ("--set", f"{path}={value}")]
    converge(DECKS / "shell_coasting.xml", *words, "--set", "Time/End Time=10 us", "--quantity", "Shell_inner_radius", "--times", "5 us",
        "--out", folder / "shell")
    (times, _, radii, _), _ = shell_coasting.dense(-0.08, 10.0)
    for one in results_of(folder / "shell", "converge_Shell_inner_radius")["results"]:
        exact = float(numpy.interp(one["time"], times, radii))
        assert one["verdict"] == "converges" and 1.5 < one["order"] < 3.5, one
        assert one["low"] < exact < one["high"] and one["high"] - one["low"] < 1e-3 * exact, f"{exact}: {one}"


BAD = [  # words, exit code, sentence
    (["nowhere.xml"], 2, "nowhere.xml does not exist (needed as the deck)"),
    ([], 1, "the following arguments are required: DECK; write for example barreno converge"),
    ([QUICK, "--levels", "1"], 1, "--levels 1 is not a number of cell sizes from 2 to 6"),
    ([QUICK, "--levels", "three"], 1, "invalid int value"),
    ([QUICK, "--refine", "1"], 1, "--refine 1 is not a ratio from 1.1 to 4"),
    ([QUICK, "--ranks", "0"], 1, "--ranks 0 is not a number of ranks"),
    ([QUICK, "--formal-order", "0"], 1, "--formal-order 0 is not an order"),
    ([QUICK, "--times", "soon"], 1, '--times has "soon", which is not a time'),
    ([QUICK, "--times", "10 us, 90 us"], 1, "--times has 9e-05 s, which is not in the run (0 to 4e-05 s)"),
    ([QUICK, "--set", "Time/End Tim=2 us"], 1, "Time/End Tim"),
    ([QUICK, "--fidelity", "best"], 1, "best"),
    ([DECKS / "bar_wave.xml"], 1, "--quantity depth needs a jet, and the deck has none"),
    ([DECKS / "bar_wave.xml", "--quantity", "kinetic"], 1, "Grid/Cell Size = 0.04 m does not divide the box along y"),
]  # fmt: skip


def check_bad_words(folder):
    for words, code, said in BAD:
        out = folder / "nothing"
        found = converge(*words, "--out", out, code=code)
        assert found.count("\n") == 1 and found.startswith("barreno: ") and said in found, f"{words}: {found}"
        assert not out.exists(), f"{words} leaves {list(out.rglob('*'))}"
    (folder / "file").write_text("")
    found = converge(QUICK, *SHORT, "--out", folder / "file" / "x", code=2)
    assert "cannot be made" in found and found.count("\n") == 1, found


def check_bad_quantity(out):
    found = converge(QUICK, *SHORT, "--out", out, "--quantity", "kinetik", code=1)
    assert "did you mean kinetic?" in found and found.count("\n") == 1, found
    found = converge(QUICK, *SHORT, "--out", out, "--quantity", "error", code=1)
    assert "stands for several numbers of summary.json" in found and "balances.mass.error" in found, found


def check_no_depth(folder):
    found = converge(QUICK, *TARGET, "--set", "Time/End Time=0.2 us", "--levels", "2", "--out", folder / "early", code=1)
    assert "the jet has met no target by the end of the runs" in found and found.count("\n") == 1, found


def check_through(folder):
    thin = ("--set", "Bodies/Rock/Upper={50.8 mm, 14.7 mm}", "--set", "Time/End Time=8 us")
    found = converge(QUICK, *thin, "--levels", "2", "--out", folder / "thin", code=1)
    assert "the jet has come out of the rear of the target in 2 of the 2 runs" in found and found.count("\n") == 1, found


def check_summary_number(out):
    """A number of summary.json has one time, the end."""
    converge(QUICK, *SHORT, "--out", out, "--quantity", "balances.energy.transfer_share")
    (one,) = results_of(out, "converge_balances_energy_transfer_share")["results"]
    summary = json.loads((out / "cells-2mm" / "summary.json").read_text())
    assert one["values"][1] == summary["balances"]["energy"]["transfer_share"] != 0.0, one


def check_failure(folder):
    """A run that fails ends the command with its code and its reason."""
    found = converge(QUICK, *SHORT, "--out", folder / "failed", "--set", "Materials/Tungsten/Bad Particles=stop", "--set",
        "Step/Largest Expansion=1.001", code=3)
    assert (
        "the run with cells of 0.004 m ended with exit code 3" in found and "its policy is to stop" in found and found.count("\n") == 1
    ), found


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_bad_words(folder)
        out = check_jet(folder)
        check_bad_quantity(out)
        check_no_depth(folder)
        check_through(folder)
        check_summary_number(out)
        check_reuse(out, folder)
        check_interruption(out, folder)
        check_smooth(folder)
        check_failure(folder)
    print("barreno converge does as its page says")


if __name__ == "__main__":
    main()
