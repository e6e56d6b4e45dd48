# SPDX-License-Identifier: BSD-3-Clause
"""What ends a fit."""

import os
import pathlib
import traceback

ARGUMENTS, FILE, NUMERICAL, INTERNAL = 1, 2, 3, 4  # exit codes, those of the other commands


class Fault(Exception):
    """One sentence for the user, and the exit code."""

    def __init__(self, sentence, code=ARGUMENTS):
        super().__init__(sentence)
        self.code = code


def internal(error):
    """A sentence on what nobody foresaw; BARRENO_TRACEBACK=1 prints all of it."""
    if os.environ.get("BARRENO_TRACEBACK"):
        traceback.print_exc()
    lines = traceback.extract_tb(error.__traceback__)
    own = ([line for line in lines if "barreno_" in line.filename] or lines)[-1]
    what = " ".join(f"{type(error).__name__}: {error}".split())[:300]
    where = f"{'/'.join(pathlib.Path(own.filename).parts[-2:])}, line {own.lineno}"
    return (
        f"internal error at {where} ({what}); please report it with the command and the files that it reads (BARRENO_TRACEBACK=1 prints "
        "all of it)."
    )


class Rejected(Exception):
    """The library refuses a card or a step that the optimiser tries."""
