# SPDX-License-Identifier: BSD-3-Clause
"""How many processes can be started: the rule of the launcher (too_many in commands.sh)."""

import subprocess

from barreno import places
from barreno.runs.faults import Fault


def with_mpi_environment(command):
    """A command that starts mpirun, with what the launcher sets for it (mpi_environment of commands.sh)."""
    file = places.commands()
    return ["bash", "-c", '. "$0" && mpi_environment && exec "$@"', str(file), *command] if file.is_file() else command


def cores():
    """Ranks that a run has unless it is told otherwise: the rule of the launcher (cores of commands.sh)."""
    words = ["bash", "-c", '. "$0" && cores', str(places.commands())]
    said = subprocess.run(words, capture_output=True, text=True, check=False).stdout.strip()
    return int(said) if said.isdigit() and int(said) > 0 else 1


def check_ranks(ranks, option=None):
    """@param option  that asks for them, --ranks N if it is not said  @raises Fault"""
    if ranks < 1:
        example = "--ranks 2" if option is None else "ranks=2"
        raise Fault(f"{option or f'--ranks {ranks}'} is not a number of ranks (1 or more); write for example {example}.")
    words = ["bash", "-c", '. "$1" && too_many "$2" "$3"', "bash", str(places.commands()), option or f"--ranks {ranks}", str(ranks)]
    try:
        sentence = subprocess.run(words, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:  # no bash, and so no launcher either
        return
    if sentence:
        raise Fault(sentence)
