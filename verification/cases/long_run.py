# SPDX-License-Identifier: BSD-3-Clause
"""An elastic bar that swings for 100,000 steps: its energy and its memory."""
import pathlib
import subprocess
import time

import numpy as np
from tools.case import Result
from tools.resumed import command
from tools.runs import DECKS, Run, mpi_environment, scratch_folder

PERIOD, ROWS = 4e-3, 20  # s; rows of the history in a period


def resident(pid):
    """Pages of memory in bytes, 0 once the process has ended."""
    try:
        return 4096 * int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1])
    except (FileNotFoundError, ProcessLookupError, IndexError):
        return 0


def watched_run(words, history):
    """Run to the end.

    The share comes from the history, not from the clock: on a busy machine the start takes half of the seconds.
    @return share of the history that is written, resident memory [B]; a row for each look
    """
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, env=mpi_environment(1))
    seen = []
    while run.poll() is None:
        written = history.stat().st_size if history.exists() else 0
        seen.append((written, resident(run.pid)))
        time.sleep(0.02)
    assert run.returncode == 0, run.returncode
    written, memory = np.array([row for row in seen if row[1] > 0], dtype=float).T
    return written / history.stat().st_size, memory


def measure(barreno, order, steps):
    """A row of the table."""
    folder = pathlib.Path(scratch_folder()) / "run"
    end = 9.5e-6 * steps  # s
    share, memory = watched_run(command(barreno, 1, "run", DECKS / "bar_wave.xml", "--out", folder, "--set", f"Time/End Time={end!r} s",
                                 "--set", f"Step/Order={order}", "--set", f"Output/Checkpoint Steps={steps // 20}",
                                 "--set", f"Output/History Interval={PERIOD / ROWS!r} s", "--set", "Output/Field Interval=0 s"),
                                 folder / "history.csv")  # fmt: skip
    done = Run(folder)
    table = done.table("history.csv")
    energy = (table["kinetic"] + table["elastic"])[1:]
    means = energy[: len(energy) // ROWS * ROWS].reshape(-1, ROWS).mean(axis=1)
    late = memory[share >= 0.25] / 1e6
    return [order, done.summary["steps"], float(np.max(np.abs(means / means[0] - 1.0))), float(late[0]), float(late.max())]


def run(barreno, full):
    steps = 100000 if full else 40000
    result = Result(
        "A long run",
        "Over very many steps energy is conserved and memory stays constant.",
        "kinetic and elastic energy, which no process dissipates. Means over a period (velocities lag stresses by half a step) are "
        "compared with the first; so is the memory of the process from a quarter of the run on, with twenty checkpoints.",
        ["order of the step", "steps", "worst error of the energy", "memory at a quarter [MB]", "largest later [MB]"],
        [],
    )
    for order in ("stress last", "modified stress last") if full else ("modified stress last",):
        row = measure(barreno, order, steps)
        result.rows.append(row)
        name = "default order" if order == "stress last" else order
        result.demand(f"{name}: steps", row[1], steps, at_least=True)
        result.demand(f"{name}: energy", row[2], 1e-3)
        result.demand(f"{name}: growth of memory", row[4] / row[3] - 1.0, 0.01)
    return result
