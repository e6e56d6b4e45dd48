# SPDX-License-Identifier: BSD-3-Clause
"""What ends a command, as one sentence and an exit code."""

import os
import sys

USAGE, FILE, NUMERICAL = 1, 2, 3
INTERRUPTED, UNREAD = 130, 141  # as a shell says of SIGINT and SIGPIPE


class Fault(Exception):
    """A whole sentence."""

    def __init__(self, sentence, code=USAGE):
        super().__init__(on_one_line(sentence))
        self.code = code


class BadRun(Exception):
    """What keeps a run folder from being read, as the part of a sentence that stands in brackets."""


class NothingToDraw(Exception):
    """Why a picture is left out, as a clause."""


def on_one_line(text):
    return " ".join(str(text).split())


def exit_code(run, words):
    """Of a command, whose faults are said.  @param run  words to exit code"""
    try:
        code = run(words)
        sys.stdout.flush()
        return code
    except Fault as fault:
        print(f"barreno: {fault}", file=sys.stderr)
        return fault.code
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # whoever read the lines has left (| head)
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return UNREAD
