# SPDX-License-Identifier: BSD-3-Clause
"""What a verification case returns: rows of a table, and the figures that must hold."""
import dataclasses


@dataclasses.dataclass
class Result:
    title: str
    proves: str  # one sentence: what this case shows
    reference: str  # where the exact answer comes from
    columns: list
    rows: list
    checks: list = dataclasses.field(default_factory=list)
    notes: str = ""
    # What is known not to hold and why, by a part of the demand's name. The page says so; only other demands fail the case.
    open: dict = dataclasses.field(default_factory=dict)

    def demand(self, what, value, limit, at_least=False):
        """The measured value must not exceed the limit (or not fall below it)."""
        passed = value >= limit if at_least else value <= limit
        why = "" if passed else next((reason for part, reason in self.open.items() if part in what), "")
        self.checks.append(
            {"what": what, "value": float(value), "limit": float(limit), "at_least": at_least, "passed": bool(passed), "open": why}
        )
