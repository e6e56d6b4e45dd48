# SPDX-License-Identifier: BSD-3-Clause
"""What ends the command, as one sentence and an exit code."""

USAGE, FILE, NUMERICAL = 1, 2, 3


class Fault(Exception):
    def __init__(self, sentence, code=USAGE):
        super().__init__(" ".join(str(sentence).split()))
        self.code = code
