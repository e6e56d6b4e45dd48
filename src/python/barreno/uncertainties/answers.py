# SPDX-License-Identifier: BSD-3-Clause
"""Answers of the runs, and what their cells may have done to them."""

import dataclasses
import re

import numpy

from barreno.sweeps.flows import EFFICIENCY
from barreno.uncertainties import spread
from barreno.uncertainties.words import LATIN

DEPTH, PROBED = "penetration.depth", "penetration.probed_depth"
KINDS = (  # what is looked at without being asked for: name in summary.json, words, unit, what a number in SI is multiplied by
    (re.escape(DEPTH), "depth", "mm", 1e3),
    (re.escape(PROBED), "probed depth", "mm", 1e3),
    (re.escape(EFFICIENCY), "core flow efficiency", "", 1.0),
    (r"penetration\.entrance_diameter_in_body\.(?P<body>.+)", "entrance diameter in {body}", "mm", 1e3),
    (r"penetration\.channel_volume", "volume of the hole", "cm3", 1e6),
    (r"penetration\.zones_in_body\.(?P<body>.+)\.skin", "skin of {body}", "", 1.0),
)
VOLUME = "penetration.channel_volume"
ERRORS = {DEPTH: "penetration.depth_error", PROBED: "penetration.probed_depth_error", VOLUME: "penetration.channel_volume_error",
    EFFICIENCY: "penetration.core_flow_efficiency_error"}
THROUGH = "penetration.through"
NOT_MEASURED = "it was measured for depths, volumes and core flow efficiencies alone"
ENDS = ("high", "value", "low")  # of an error, as they make the true answer larger


@dataclasses.dataclass
class Answer:
    name: str  # in summary.json
    words: str
    unit: str
    factor: float
    values: list  # of the runs that have finished, SI
    runs: spread.Spread | None = None  # from the runs alone
    whole: spread.Spread | None = None  # with the error of their cells
    cells_unknown: str = ""  # why there is no whole

    def best(self):
        return self.whole or self.runs


def kind_of(name):
    for pattern, words, unit, factor in KINDS:
        found = re.fullmatch(pattern, name)
        if found:
            return words.format(**found.groupdict()), unit, factor
    return None


def wanted_names(rows, quantities):
    """Names of the summaries, in the order of KINDS, then those that were asked for."""
    known = list(dict.fromkeys(name for row in rows for name in row.scalars))
    found = [name for pattern, *_ in KINDS for name in known if re.fullmatch(pattern, name)]
    return found + [name for name in dict.fromkeys(quantities) if name not in found]


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and numpy.isfinite(value)


def reason_to_leave(name, rows):
    """Why an answer cannot be looked at; empty where it can."""
    values = [row.scalars.get(name) for row in rows]
    missing = sum(not is_number(value) for value in values)
    if missing:
        return f"{missing} of {len(rows)} runs have no such number (docs/output.md lists the names)"
    if name in ERRORS and any(row.scalars.get(THROUGH) is True for row in rows):
        return "the jet has come out of the rear of the target, whose length is no depth: make the target thicker, or end earlier"
    return "it is the same in all runs" if max(values) == min(values) else ""


def answers_of(rows, quantities):
    """Answers of finished runs, and remarks on those that are left out."""
    found, remarks = [], []
    for name in wanted_names(rows, quantities):
        words, unit, factor = kind_of(name) or (name, "", 1.0)
        why = reason_to_leave(name, rows)
        if why:
            remarks.append(f"{words} is left out: {why}.")
        else:
            found.append(Answer(name, words, unit, factor, [float(row.scalars[name]) for row in rows]))
    return found, remarks


def cell_errors(name, rows, flow):
    """([(high, value, low) of each run], why they are unknown)  @param flow  --flow"""
    head = ERRORS.get(name)
    if head is None:
        return [], NOT_MEASURED
    if name == EFFICIENCY and flow != "radial":
        return [], "it was measured for radial flow alone"
    errors = [tuple(row.scalars.get(f"{head}.{end}") for end in ENDS) for row in rows]
    lacking = [row for row, error in zip(rows, errors) if not all(map(is_number, error)) or min(error) <= -1.0]
    if not lacking:
        return errors, ""
    why = lacking[0].scalars.get(f"{head}.unknown", "these runs do not say it")
    return [], why if len(lacking) == len(rows) else f"{why} ({len(lacking)} of {len(rows)} runs)"


def at_least_zero(found, answer):
    """No length, volume or efficiency is below 0, however wide a fit makes the interval."""
    if answer.unit or answer.name == EFFICIENCY:
        found.low, found.median = max(found.low, 0.0), max(found.median, 0.0)
    return found


def with_cells(answer, errors, analyse):
    """The true answer is the computed one over 1 + error: each run has three of them, and the interval is from the low end of the smallest
    to the high end of the largest."""
    small, best, large = (analyse([value / (1.0 + error[i]) for value, error in zip(answer.values, errors)]) for i in range(len(ENDS)))
    best.low, best.high = min(small.low, best.low), max(large.high, best.high)
    return best


def analyse_all(answers, design, shares, rows, flow=None):
    """@param shares  of the ranges, of the runs that have finished  @param flow  --flow"""
    way = spread.of_hypercube if design == LATIN else spread.one_at_a_time
    for answer in answers:
        analyse = lambda values: at_least_zero(way(shares, values), answer)  # noqa: E731, B023
        answer.runs = analyse(answer.values)
        errors, answer.cells_unknown = cell_errors(answer.name, rows, flow)
        answer.whole = with_cells(answer, errors, analyse) if errors else None
