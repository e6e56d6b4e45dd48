# SPDX-License-Identifier: BSD-3-Clause
"""A sweep as an array job of Slurm: one task for every run, and a command that collects afterwards."""

import os
import pathlib
import shlex
import sys

SCRIPT = """\
#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array={tasks}
#SBATCH --ntasks={ranks}
#SBATCH --chdir={folder}
#SBATCH --output={out}/task-%a.log
# {count} of the {total} runs of {deck}; give sbatch a --time that suits them (barreno check DECK predicts it).
# When all have ended:
#   {collect}
{exports}
exec {command} --only "$SLURM_ARRAY_TASK_ID"
"""
# What Open MPI needs of its surroundings, and where the program is.
PASSED = ("BARRENO_PROGRAM", "BARRENO_COMMAND", "PYTHONPATH")


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


def user_command(words):
    """As the user would write it."""
    start = os.environ.get("BARRENO_COMMAND", "/usr/bin/python3 -m barreno_sweep")
    return f"{start} {shlex.join(words)}"


def exports(binary):
    """@param binary  of the program, which may be on the path of this machine alone"""
    names = {**{name: os.environ[name] for name in PASSED if name in os.environ}, "BARRENO_PROGRAM": str(pathlib.Path(binary).absolute())}
    names.update({name: value for name, value in os.environ.items() if name.startswith("OMPI_")})
    return "\n".join(f"export {name}={shlex.quote(value)}" for name, value in sorted(names.items()))


def script(options, words, binary, points, out):
    """@param words  of the command, with --submit"""
    tasks, words = [i for i, point in enumerate(points, 1) if not point.how], without_submit(words)
    return SCRIPT.format(
        name=f"{pathlib.Path(options.deck).stem}-sweep".replace(" ", "_"),
        tasks=ranges_of(tasks),
        ranks=options.ranks,
        folder=shlex.quote(os.getcwd()),
        out=shlex.quote(str(out)),
        count=len(tasks),
        total=len(points),
        deck=options.deck,
        collect=user_command([*words, "--collect"]),
        exports=exports(binary),
        command=shlex.join([sys.executable, "-m", "barreno_sweep", *words]),
    )
