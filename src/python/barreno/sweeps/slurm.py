# SPDX-License-Identifier: BSD-3-Clause
"""A sweep, or another study of many runs, as an array job of Slurm: one task for every run, and a command that collects afterwards. The
script holds the user's command and nothing of the machine that wrote it: Slurm hands the environment of sbatch on, and the command itself
knows what MPI needs (docs/cluster.md)."""

import os
import pathlib
import re
import shlex
import typing

from barreno.runs.faults import Fault, printable

SCRIPT = """\
#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array={tasks}
#SBATCH --ntasks={ranks}
#SBATCH --output={out}/task-%a.log
#SBATCH --signal=B:TERM@120
# {count} of the {total} runs of {deck}; give sbatch a --time that suits them (barreno check DECK predicts it).
# Paths are seen from the folder in which sbatch is called. When all have ended:
#   {collect}
exec {command} --only "$SLURM_ARRAY_TASK_ID"
"""
OWN_START = "/usr/bin/python3 -m"  # without the launcher; it needs PYTHONPATH and BARRENO_PROGRAM where sbatch is called
CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]")


class Study(typing.NamedTuple):
    command: str  # whose runs they are
    package: str  # its module


SWEEP = Study("sweep", "barreno.sweeps")


def ranges_of(numbers):
    """1-3,5"""
    parts = []
    for number in numbers:
        if parts and parts[-1][1] == number - 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ",".join(str(low) if low == high else f"{low}-{high}" for low, high in parts)


def without_submit(words):
    """The words of the command, but for what asks for a script."""
    out, skipped = [], False
    for word in words:
        if skipped or word.startswith("--submit="):
            skipped = False
        elif word == "--submit":
            skipped = True
        else:
            out.append(word)
    return out


def start_of_command(study):
    """As the user has called it; the launcher says it, quoted."""
    return os.environ.get("BARRENO_COMMAND", f"{OWN_START} {study.package}")


def user_command(study, words):
    """As the user would write it."""
    return f"{start_of_command(study)} {shlex.join(words)}"


def refuse_control_characters(texts):
    """A line end in a name would end a line of the script, and what follows it would be a command.  @param texts  {what: text}"""
    for what, text in texts.items():
        if CONTROL.search(text):
            raise Fault(f'{what} is "{printable(text)}", which has a line end or another control character (a script has one command in a '
                'line); rename it.')


def script(study, options, words, points, out):
    """@param words  of the command, with --submit"""
    tasks, words = [i for i, point in enumerate(points, 1) if not point.how], without_submit(words)
    named = {"the deck": str(options.deck), "--out": str(out), "the path of barreno": start_of_command(study)}
    refuse_control_characters({**named, **{f"word {i} of the command": word for i, word in enumerate(words, 1)}})
    return SCRIPT.format(
        name=re.sub(r"[^\w.+-]", "_", f"{pathlib.Path(options.deck).stem}-{study.command}"),
        tasks=ranges_of(tasks),
        ranks=options.ranks,
        out=shlex.quote(str(out)),
        count=len(tasks),
        total=len(points),
        deck=options.deck,
        collect=user_command(study, [*words, "--collect"]),
        command=user_command(study, words),
    )
