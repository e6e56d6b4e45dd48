# SPDX-License-Identifier: BSD-3-Clause
"""One row for each extreme: what was set up, the figure and its criterion, and whether it holds, stops with its sentence or neither."""
import dataclasses

from tools.demands import FAILS, HOLDS, judge

STOPS, RED = "stops", "RED"


@dataclasses.dataclass
class Row:
    extreme: str
    setup: str
    criterion: str
    found: str
    verdict: str
    note: str = ""
    what: str = ""  # the figure's name and value, where the row has one
    value: float = None
    failure: str = ""  # why the table fails; empty also for a red row that is open (open_demands.toml) and no worse than known

    @property
    def name(self):
        return f"{self.extreme}: {self.setup}: {self.what or self.criterion}"


class Table:
    def __init__(self):
        self.rows = []
        self.known = {}  # the open demands of the rows that are being added

    def add(self, extreme, setup, criterion, found, good, verdict=HOLDS, note=""):
        """A row without a figure cannot be open."""
        self.rows.append(Row(extreme, setup, criterion, found, verdict if good else RED, note if good else "",
            failure="" if good else "does not hold"))

    def within(self, extreme, setup, what, value, limit, at_least=False):
        row = Row(extreme, setup, f"{what} {'>=' if at_least else '<='} {limit:.3g}", f"{float(value):.3g}", RED, what=what,
            value=float(value))
        verdict, words = judge(row.value, limit, at_least, self.known.get(row.name))
        if verdict == HOLDS:
            row.verdict = HOLDS
        elif verdict == FAILS:
            row.failure = words
        else:
            row.note = words
        self.rows.append(row)

    def finishes(self, extreme, setup, outcome, what, value, limit, at_least=False):
        """The run ends by itself and a figure of it, value(run), is within its limit."""
        if outcome.finished:
            self.within(extreme, setup, what, value(outcome.run), limit, at_least)
        else:
            self.add(extreme, setup, f"finishes; {what} {'>=' if at_least else '<='} {limit:.3g}",
                f"exit {outcome.code}: {outcome.sentence}", False)

    def stops(self, extreme, setup, outcome, code, *words):
        """The run ends with this exit code and a sentence that has all these words."""
        good = outcome.code == code and all(word in outcome.sentence for word in words)
        criterion = f"exit {code}, a sentence with " + ", ".join(f"'{word}'" for word in words)
        found = f"exit {outcome.code}" if good else f"exit {outcome.code}: {outcome.sentence}"
        self.add(extreme, setup, criterion, found, good, STOPS, outcome.sentence if good else "")

    def holds_or_stops(self, extreme, setup, outcome, what, value, limit, *words, at_least=False):
        """Either of the two: what must not be is a wrong number without a word."""
        if outcome.finished:
            self.finishes(extreme, setup, outcome, what, value, limit, at_least)
        else:
            self.stops(extreme, setup, outcome, 3, *words)

    def count(self, verdict):
        return sum(row.verdict == verdict for row in self.rows)

    def failures(self):
        return [f"{row.name}: {row.found}: {row.failure}" for row in self.rows if row.failure]

    def unmeasured(self, first):
        """Open demands that no row from `first` on measured."""
        names = {row.name for row in self.rows[first:]}
        return [f"'{name}' is declared open but was not measured" for name in self.known if name not in names]
