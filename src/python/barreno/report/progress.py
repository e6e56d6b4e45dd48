# SPDX-License-Identifier: BSD-3-Clause
"""How far a film is: a bar on a terminal, else a line at every tenth."""

import sys

WIDE = 40


class Progress:
    def __init__(self, what, stream=None):
        self.what, self.stream = what, stream or sys.stderr
        self.tenth = 0

    def __call__(self, number, count):
        if self.stream.isatty():
            done = WIDE * number // count
            end = "\n" if number == count else ""
            self.stream.write(f"\r{self.what} [{'#' * done}{'.' * (WIDE - done)}] {number} of {count}{end}")
        elif 10 * number // count > self.tenth:
            self.tenth = 10 * number // count
            self.stream.write(f"{self.what}: {number} of {count}\n")
        self.stream.flush()
