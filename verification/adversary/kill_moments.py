# SPDX-License-Identifier: BSD-3-Clause
"""When a run gets a signal: at one of its checkpoints (tools/kill_at.c), or after a time.

All is drawn before the run starts, so that the draws of a seed do not depend on what the kills meet."""
import dataclasses
import json
import pathlib
import signal
import subprocess

from deck_tree import Deck

TOOLS = pathlib.Path(__file__).resolve().parents[1] / "tools"
KINDS = [9, 9, 9, 9, int(signal.SIGTERM), int(signal.SIGINT), int(signal.SIGHUP), int(signal.SIGUSR1)]
# Of the kills: while a checkpoint is written, and right after one has got its name; the others come after a time.
WHILE, AFTER = 0.5, 0.4
CALLS = 60  # a few more than write a checkpoint of one material


@dataclasses.dataclass
class Moment:
    kind: int  # the signal
    place: str  # "while" a checkpoint is written, "after" one, or at a "time"
    share: float  # of the run's checkpoints, or of its time
    call: int  # of those that write the checkpoint
    wait: float  # after a checkpoint, a share of the time between two; mostly none


def drawn_moment(rng, kinds=tuple(KINDS)):
    """Always as many draws."""
    place = rng.random()
    name = "while" if place < WHILE else "after" if place < WHILE + AFTER else "time"
    kind, share, call = int(rng.choice(kinds)), float(rng.random()), int(rng.integers(1, CALLS))
    return Moment(kind, name, share, call, max(0.0, float(rng.uniform(-0.4, 0.4))))


def built_library(folder, name):
    """tools/NAME.c, to be preloaded."""
    library = folder / f"{name}.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-pthread", "-o", library, TOOLS / f"{name}.c", "-ldl"], check=True)
    return library


def checkpoints_of(straight):
    """About how many checkpoints a finished run wrote before its end."""
    steps = json.loads((straight / "summary.json").read_text())["steps"]
    every = int(float(Deck(straight / "deck.xml").value("Output/Checkpoint Steps") or 0))
    return max(1, (steps - 1) // every if every else 1)


def checkpoint_of(moment, checkpoints):
    """The checkpoint that a moment is at or behind, from 1 on, with steps still to come: a run looks for signals between them."""
    last = checkpoints - (1 if moment.kind == signal.SIGKILL else 2)
    return 1 + int(moment.share * max(last, 1))


def run_to(barreno, words, folder, moment, seconds, checkpoints):
    """A command that gets its signal. @param checkpoints  that the run has before it; @param seconds  that it takes without a signal"""
    if moment is None:
        return barreno.run(*words)
    if moment.place == "time":
        return barreno.run(*words, signal=moment.kind, after=moment.share * seconds)
    variables = {"FOLDER": pathlib.Path(folder).resolve(), "SIGNAL": moment.kind, "CHECKPOINT": checkpoint_of(moment, checkpoints)}
    if moment.place == "while":
        variables["CALL"] = moment.call
    else:
        variables["DELAY"] = round(1e6 * moment.wait * seconds / max(checkpoints, 1))
    return barreno.run(*words, variables={f"BARRENO_KILL_{name}": value for name, value in variables.items()})
