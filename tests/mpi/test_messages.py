#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run on two ranks with a jet, pore flow and checkpoints, and its resumption, leave nothing in MPI: no message
unmatched, no request open, no communicator but those that the libraries keep for themselves.

    test_messages.py BARRENO COUNT_MESSAGES LEAVE_MESSAGES
"""
import pathlib
import subprocess
import sys
import tempfile

from tools.runs import DECKS, mpi_environment

SHORT = ("--set", "Time/End Time=30 us", "--set", "Output/Checkpoint Steps=20", "--set", "Output/Field Interval=10 us")


def counted(library, scratch, *words):
    """What a program of two ranks leaves over, as count_messages tells it."""
    told = scratch / "told"
    told.unlink(missing_ok=True)
    preload = ["-x", f"LD_PRELOAD={library}", "-x", f"BARRENO_MESSAGES={told}"]
    command = ["mpirun", "--quiet", "-n", "2", *preload, *map(str, words)]
    result = subprocess.run(command, env=mpi_environment(), capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, f"{words}: exit {result.returncode}\n{result.stdout}{result.stderr}"
    line = told.read_text().split()
    return {name: int(value) for name, value in zip(line[::2], line[1::2])}


def main():
    barreno, library, leave = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        found = counted(library, scratch, leave)
        assert found == {"ranks": 2, "messages": 2, "unmatched": 1, "requests_left": 1, "communicators_left": 2}, found
        run = scratch / "run"
        found = counted(library, scratch, barreno, "run", DECKS / "perforation_drainage.xml", "--out", run, *SHORT)
        print("run:", found)
        assert found["messages"] > 1000, found
        assert found["unmatched"] == 0 and found["requests_left"] == 0, found
        assert found["communicators_left"] == 0, found
        (run / "checkpoint.h5").unlink()
        found = counted(library, scratch, barreno, "resume", run)
        print("resumed:", found)
        assert found["messages"] > 20, found
        assert found["unmatched"] == 0 and found["requests_left"] == 0, found
        assert found["communicators_left"] == 0, found


if __name__ == "__main__":
    main()
