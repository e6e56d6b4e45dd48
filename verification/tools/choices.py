# SPDX-License-Identifier: BSD-3-Clause
"""Words that a deck may say, as this build tells them: cases run over those that exist."""
import functools
import subprocess

from runs import mpi_environment


@functools.lru_cache(None)
def words(barreno, section, parameter):
    """Words of SECTION/PARAMETER in the order of `barreno describe SECTION`; none if it has no such parameter."""
    command = [str(barreno), "describe", section]
    text = subprocess.run(command, env=mpi_environment(), capture_output=True, text=True, check=True).stdout
    lines = iter(text.splitlines())
    for line in lines:
        if line.strip() == parameter:
            break
    for line in lines:
        if not line.startswith("      "):
            break
        if line.strip().startswith("one of: "):
            return tuple(word.strip() for word in line.strip()[len("one of: ") :].split(";")[0].split(","))
    return ()


def shape_functions(barreno):
    return words(barreno, "Step", "Shape Function")


def modes(barreno):
    return words(barreno, "Grid", "Mode")
