# SPDX-License-Identifier: BSD-3-Clause
"""Words that a deck may say, as this build tells them: cases run over those that exist."""
import functools

from tools.runs import call


@functools.lru_cache(None)
def words(barreno, section, parameter):
    """Words of SECTION/PARAMETER in the order of `barreno describe SECTION`; none if it has no such parameter."""
    described = call(barreno, ["describe", section])
    described.check_returncode()
    lines = iter(described.stdout.splitlines())
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
