# SPDX-License-Identifier: BSD-3-Clause
"""What an experiment of docs/validation.md returns: quantities that were measured, each with its mark and source, and ours beside them."""
import dataclasses
import math

from tools.demands import judge_all, open_demands

SEEN, DERIVED, RECALLED, ASSUMED = "seen", "from seen ones", "recalled", "assumed"
MAY_BE_REQUIRED = (SEEN, DERIVED)
# In the order of the page; files of verification/experiments.
EXPERIMENTS = ("pore_closure", "bar_test", "sphere", "taylor_bars", "spall_plate", "rods", "water_shock")
CHEAP = ("pore_closure", "bar_test")  # with every run of the tests
FORM = "validation/"  # before the name of an experiment in open_demands.toml


@dataclasses.dataclass(slots=True)
class Experiment:
    title: str
    claim: str  # one sentence
    set_up: str
    notes: str = ""
    cells: list = dataclasses.field(default_factory=list)  # [mm], the largest first; none: one material point
    rows: list = dataclasses.field(default_factory=list)
    profiles: dict = dataclasses.field(default_factory=dict)  # {label: points (x, y) [mm]} of the picture

    def compare(self, what, measured, mark, source, ours):
        """A quantity without a verdict. @param ours  for each of the cells, the largest first"""
        self.rows.append({"what": what, "measured": measured, "mark": mark, "source": source, "ours": [float(value) for value in ours],
            "check": None})  # fmt: skip
        return self.rows[-1]

    def require(self, row, value, limit, at_least=False):
        """What the quantity must be: a figure of the smallest cells against a limit. Only what was seen may be required."""
        if row["mark"] not in MAY_BE_REQUIRED:
            raise ValueError(f"'{row['what']}' is {row['mark']}: only what was seen may be required")
        row["check"] = {"what": row["what"], "value": float(value), "limit": float(limit), "at_least": at_least}

    def within(self, row, measured, share):
        """Ours must lie within a share of the measured value."""
        self.require(row, abs(row["ours"][-1] / measured - 1.0), share)


def checks_of(data):
    return [row["check"] for row in data["rows"] if row["check"]]


def judged(name, data, full):
    """(what judge_all gives, what is wrong with the list of open demands)."""
    return judge_all(checks_of(data), open_demands(FORM + name, full))


def spread(values):
    """Half of the interval of the cells: what halving them changed, as much as all further halvings do at first order; nan: one size."""
    return abs(values[-1] - values[-2]) if len(values) > 1 else math.nan
