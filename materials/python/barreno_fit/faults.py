# SPDX-License-Identifier: BSD-3-Clause
"""What ends a fit."""

ARGUMENTS, FILE, NUMERICAL = 1, 2, 3  # exit codes, those of the other commands


class Fault(Exception):
    """One sentence for the user, and the exit code."""

    def __init__(self, sentence, code=ARGUMENTS):
        super().__init__(sentence)
        self.code = code


class Rejected(Exception):
    """The library refuses a card or a step that the optimiser tries."""
