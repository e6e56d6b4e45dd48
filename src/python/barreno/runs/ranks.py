# SPDX-License-Identifier: BSD-3-Clause
"""How many processes can be started: the rule of the launcher (too_many in commands.sh)."""

import subprocess

from barreno import places
from barreno.runs.faults import Fault


def check_ranks(ranks, option=None):
    """@param option  that asks for them, --ranks N if it is not said  @raises Fault"""
    if ranks < 1:
        raise Fault(f"--ranks {ranks} is not a number of ranks (1 or more); write for example --ranks 2.")
    words = ["bash", "-c", '. "$1" && too_many "$2" "$3"', "bash", str(places.commands()), option or f"--ranks {ranks}", str(ranks)]
    try:
        sentence = subprocess.run(words, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:  # no bash, and so no launcher either
        return
    if sentence:
        raise Fault(sentence)
