#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Short runs of decks that together use most of the code, with output and checkpoints, resumed on another number of
ranks, under the sanitizers: any finding ends the program, and with it this test.

    test_runs.py BARRENO_SANITIZED
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from tools.runs import DECKS, mpi_environment

# Deck, time of the run, time to which it is resumed, checkpoints every so many steps, ranks of the run, other settings.
RUNS = (
    ("perforation_quick.xml", "2 us", "3 us", 10, 1),  # jet, Arenisca, torn faces
    ("perforation_quick.xml", "2 us", "3 us", 10, 2),
    # A strain at the start of a step that finds particles bad: the step goes on with them.
    ("perforation_quick.xml", "12 us", "14 us", 5, 1,
     "Grid/Cell Size=5 mm", "Step/Order=stress first", "Step/Largest Expansion=1.01"),
    ("perforation_drainage.xml", "8 us", "10 us", 5, 2),  # pore flow
    ("perforation_3d.xml", "0.25 us", "0.35 us", 2, 2),
    ("taylor_bar.xml", "0.8 us", "1 us", 5, 1),  # Johnson-Cook
    ("contact_disks.xml", "30 us", "50 us", 2, 2),
    ("perforation_plane_cpdi.xml", "0.3 us", "0.4 us", 2, 2),
    ("spinning_bar.xml", "20 ms", "25 ms", 20, 1),
)


def must_work(command, ranks):
    words = ["mpirun", "--quiet", "-n", str(ranks)] if ranks > 1 else []
    result = subprocess.run(words + [str(word) for word in command], env=mpi_environment(), capture_output=True, text=True)
    assert result.returncode == 0, f"{command} ended with {result.returncode}:\n{result.stderr[-20000:]}"
    return result.stdout


def steps_of(run):
    return json.loads((run / "summary.json").read_text())["steps"]


def main():
    barreno = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        for number, (deck, end, later, often, ranks, *more) in enumerate(RUNS):
            run = pathlib.Path(scratch) / str(number)
            settings = (f"Time/End Time={end}", f"Output/Checkpoint Steps={often}", *more)
            must_work([barreno, "run", DECKS / deck, "--out", run] + [x for s in settings for x in ("--set", s)], ranks)
            assert (run / "checkpoint.h5").exists(), f"{deck} left no checkpoint"
            first = steps_of(run)
            must_work([barreno, "resume", run, "--until", later], 3 - ranks)
            last = steps_of(run)
            assert last > first > often, f"{deck}: {first} steps, {last} after the resumption"
            print(f"{deck}: {first} steps on {ranks} ranks, to {last} on {3 - ranks}", flush=True)


if __name__ == "__main__":
    main()
