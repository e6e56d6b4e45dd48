# SPDX-License-Identifier: BSD-3-Clause
"""One row for each extreme: what was set up, the figure and its criterion, and whether it holds, stops with its sentence or neither."""
import dataclasses

HOLDS, STOPS, RED = "holds", "stops", "RED"


@dataclasses.dataclass
class Row:
    extreme: str
    setup: str
    criterion: str
    found: str
    verdict: str
    note: str = ""


class Table:
    def __init__(self):
        self.rows = []

    def add(self, extreme, setup, criterion, found, good, verdict=HOLDS, why=""):
        """`why`: the known reason of a row that is red; a red row without one fails the table."""
        self.rows.append(Row(extreme, setup, criterion, found, verdict if good else RED, "" if good and verdict == HOLDS else why))

    def within(self, extreme, setup, what, value, limit, at_least=False, why=""):
        value = float(value)
        good = value >= limit if at_least else value <= limit  # false for what is no number
        self.add(extreme, setup, f"{what} {'>=' if at_least else '<='} {limit:.3g}", f"{value:.3g}", good, why=why)

    def finishes(self, extreme, setup, outcome, what, value, limit, at_least=False, why=""):
        """The run ends by itself and a figure of it, value(run), is within its limit."""
        if not outcome.finished:
            found = f"exit {outcome.code}: {outcome.sentence}"
            self.add(extreme, setup, f"finishes; {what} {'>=' if at_least else '<='} {limit:.3g}", found, False, why=why)
            return
        self.within(extreme, setup, what, value(outcome.run), limit, at_least, why)

    def stops(self, extreme, setup, outcome, code, *words, why=""):
        """The run ends with this exit code and a sentence that has all these words."""
        good = outcome.code == code and all(word in outcome.sentence for word in words)
        criterion = f"exit {code}, a sentence with " + ", ".join(f"'{word}'" for word in words)
        found = f"exit {outcome.code}" if good else f"exit {outcome.code}: {outcome.sentence}"
        self.add(extreme, setup, criterion, found, good, STOPS, outcome.sentence if good else why)

    def holds_or_stops(self, extreme, setup, outcome, what, value, limit, *words, at_least=False, why=""):
        """Either of the two: what must not be is a wrong number without a word."""
        if outcome.finished:
            self.finishes(extreme, setup, outcome, what, value, limit, at_least, why)
        else:
            self.stops(extreme, setup, outcome, 3, *words, why=why)

    def count(self, verdict):
        return sum(row.verdict == verdict for row in self.rows)

    def unexplained(self):
        return [row for row in self.rows if row.verdict == RED and not row.note]
