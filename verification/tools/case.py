# SPDX-License-Identifier: BSD-3-Clause
"""What a verification case returns: rows of a table, and the figures that must hold."""
import dataclasses


@dataclasses.dataclass(slots=True)
class Result:
    title: str
    proves: str  # one sentence: what this case shows
    reference: str  # where the exact answer comes from
    columns: list
    rows: list
    checks: list = dataclasses.field(default_factory=list)
    notes: str = ""
    curves: dict = dataclasses.field(default_factory=dict)  # label -> [[x, y]], of a picture whose points are too many for rows

    def demand(self, what, value, limit, at_least=False):
        """The measured value must not exceed the limit (or not fall below it). What is known not to hold is in open_demands.toml."""
        self.checks.append({"what": what, "value": float(value), "limit": float(limit), "at_least": at_least})
