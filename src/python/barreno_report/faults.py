# SPDX-License-Identifier: BSD-3-Clause
"""What ends the command, as one sentence and an exit code."""

USAGE, FILE = 1, 2


class Fault(Exception):
    """What keeps a report from being made, as the part of a sentence in brackets."""


class Refusal(Exception):
    """What the words of the command ask for and cannot have, as a whole sentence."""

    def __init__(self, sentence, code=USAGE):
        super().__init__(" ".join(str(sentence).split()))
        self.code = code


def on_one_line(text):
    return " ".join(str(text).split())
