# SPDX-License-Identifier: BSD-3-Clause
"""Whether a measured figure holds, is known not to hold and is no worse than that, or fails.

A demand that is known not to hold stands in open_demands.toml with its reason and with the worst that it may measure, for
each form that measures it:

    [[CASE]]
    reason = "why it does not hold"
    cheap = { "the demand's name" = 0.012 }
    full = { "the demand's name" = 0.034, "another one" = 1.5 }

It fails beyond that, it fails when it begins to hold, and it fails when the case no longer measures it. What is no finite
number fails whether or not the demand is open.
"""
import dataclasses
import math
import pathlib
import tomllib

FILE = pathlib.Path(__file__).resolve().parents[1] / "open_demands.toml"
HOLDS, OPEN, FAILS = "holds", "open", "FAILS"
FORMS = ("cheap", "full")


@dataclasses.dataclass(frozen=True)
class Open:
    reason: str
    worst: float

    def __post_init__(self):
        if not str(self.reason).strip():
            raise ValueError("an open demand has no reason")
        if isinstance(self.worst, bool) or not isinstance(self.worst, (int, float)) or not math.isfinite(self.worst):
            raise ValueError(f"the worst value of an open demand is {self.worst!r}, not a finite number")


def read_open(file=FILE):
    """{(case, form): {demand: Open}} of the file; what is not complete is an error."""
    out = {}
    for case, entries in tomllib.loads(pathlib.Path(file).read_text()).items():
        for entry in entries:
            unknown = set(entry) - {"reason", *FORMS}
            if unknown or not any(entry.get(form) for form in FORMS):
                raise ValueError(f"{file}: [[{case}]] needs a reason and worst values under cheap, full or both"
                    + (f", not {sorted(unknown)}" if unknown else ""))
            for form in FORMS:
                for what, worst in entry.get(form, {}).items():
                    known = out.setdefault((case, form), {})
                    if what in known:
                        raise ValueError(f"{file}: {case}: '{what}' is twice under {form}")
                    known[what] = Open(entry.get("reason", ""), worst)
    return out


def open_demands(case, full, file=FILE):
    return read_open(file).get((case, "full" if full else "cheap"), {})


def met(value, limit, at_least):
    return value >= limit if at_least else value <= limit


def judge(value, limit, at_least, known=None):
    """(verdict, what to say of it); known: the demand's entry if it is open."""
    if value is None or not math.isfinite(value):
        return FAILS, "not a finite number"
    if met(value, limit, at_least):
        return (FAILS, "now holds: close it") if known else (HOLDS, "")
    if not known:
        return FAILS, "does not hold"
    if not met(value, known.worst, at_least):
        return FAILS, f"beyond its worst value {known.worst:.3g} ({known.reason})"
    return OPEN, known.reason


def judge_all(checks, known):
    """[(check, verdict, words)] of a case's checks, and what is wrong with the list of open demands itself."""
    judged = [(check, *judge(check["value"], check["limit"], check["at_least"], known.get(check["what"]))) for check in checks]
    measured = [check["what"] for check in checks]
    wrong = [f"'{what}' is declared open but was not measured" for what in known if what not in measured]
    wrong += [f"'{what}' is measured twice" for what in sorted({what for what in measured if measured.count(what) > 1})]
    return judged, wrong
