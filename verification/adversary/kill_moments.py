# SPDX-License-Identifier: BSD-3-Clause
"""When a run gets a signal: at one of its checkpoints (tools/kill_at.c), or after a time.

All is drawn before the run starts, so that the draws of a seed do not depend on what the kills meet."""
import dataclasses
import json
import pathlib
import signal
import subprocess

import h5py
from adversary.deck_tree import Deck

TOOLS = pathlib.Path(__file__).resolve().parents[1] / "tools"
KINDS = [9, 9, 9, 9, int(signal.SIGTERM), int(signal.SIGINT), int(signal.SIGHUP), int(signal.SIGUSR1)]
# Of the kills: while a checkpoint is written, and right after one has got its name; the others come after a time.
WHILE, AFTER = 0.5, 0.4
CALLS = 18  # that write a checkpoint, but for its tables of particles: one call each


@dataclasses.dataclass
class Moment:
    kind: int  # the signal
    place: str  # "while" a checkpoint is written, "after" one, or at a "time"
    share: float  # of the run's checkpoints, or of its time
    call: float  # a share of those that write the checkpoint
    wait: float  # after a checkpoint, a share of the time between two; mostly none


@dataclasses.dataclass
class Whole:
    """A run that was left alone."""

    seconds: float
    steps: int
    every: int  # steps from checkpoint to checkpoint
    calls: int  # that write one of them


def drawn_moment(rng, kinds=tuple(KINDS)):
    """Always as many draws."""
    place = rng.random()
    name = "while" if place < WHILE else "after" if place < WHILE + AFTER else "time"
    kind, share, call = int(rng.choice(kinds)), float(rng.random()), float(rng.random())
    return Moment(kind, name, share, call, max(0.0, float(rng.uniform(-0.4, 0.4))))


def built_library(folder, name):
    """tools/NAME.c, to be preloaded."""
    library = folder / f"{name}.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-pthread", "-o", library, TOOLS / f"{name}.c", "-ldl"], check=True)
    return library


def whole_run(straight, seconds):
    """@param straight  the folder of a finished run"""
    steps = json.loads((straight / "summary.json").read_text())["steps"]
    every = int(float(Deck(straight / "deck.xml").value("Output/Checkpoint Steps") or 0))
    with h5py.File(straight / "checkpoint.h5", "r") as file:
        tables = sum(len(material) - 1 for material in file["particles"].values() if material["id"].size)  # without rank_counts
    return Whole(seconds, steps, every or steps, CALLS + tables)


def checkpoints_left(whole, folder):
    """About how many checkpoints a run will write before its end. @param folder  of the run, which may have one"""
    found = [file for file in (folder / "checkpoint.h5", folder / "checkpoint_previous.h5") if file.exists()]
    step = 0
    if found:
        with h5py.File(found[0], "r") as file:
            step = int(file["run/step"][0, 0])
    return (whole.steps - step - 1) // whole.every


def checkpoint_of(moment, checkpoints):
    """The checkpoint that a moment is at or behind, from 1 on, with steps still to come: a run looks for signals between them."""
    last = checkpoints - (1 if moment.kind == signal.SIGKILL else 2)
    return 1 + int(moment.share * max(last, 1))


def run_to(barreno, words, folder, moment, whole):
    """A command that gets its signal, if any."""
    if moment is None:
        return barreno.run(*words)
    if moment.place == "time":
        return barreno.run(*words, signal=moment.kind, after=moment.share * whole.seconds)
    checkpoint = checkpoint_of(moment, checkpoints_left(whole, folder))
    variables = {"FOLDER": folder.resolve(), "SIGNAL": moment.kind, "CHECKPOINT": checkpoint}
    if moment.place == "while":
        variables["CALL"] = 1 + int(moment.call * whole.calls)
    else:
        variables["DELAY"] = round(1e6 * moment.wait * whole.seconds * min(1.0, whole.every / whole.steps))
    return barreno.run(*words, variables={f"BARRENO_KILL_{name}": value for name, value in variables.items()})
