# SPDX-License-Identifier: BSD-3-Clause
"""What tests say of calls that must be refused."""
from barreno.runs.faults import Fault


def refused(does, *said, kind=Fault):
    """A call ends with one sentence that has these parts."""
    try:
        found = does()
    except kind as fault:
        sentence = str(fault)
    else:
        raise AssertionError(f"not refused: {said}, but {found}")
    assert all(part in sentence for part in said) and "\n" not in sentence, f"{said}: {sentence}"
