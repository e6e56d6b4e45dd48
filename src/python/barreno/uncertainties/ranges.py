# SPDX-License-Identifier: BSD-3-Clause
"""Ranges of inputs: as users, files and cards give them, and as numbers in SI that the program accepts."""

import csv
import dataclasses
import io

from barreno.runs.csv_table import WORDS, BadTable, read_csv
from barreno.runs.effective_deck import value_in
from barreno.runs.faults import FILE, Fault
from barreno.runs.units import UNITS
from barreno.sweeps.variation import read_range, value_of
from barreno.uncertainties.decks import FACTORS, tied_settings

MARKS = ("seen", "recalled", "derived", "assumed", "fitted", "given")
NEEDED = ("parameter", "low", "high")
WIDE = 3.0  # ratio of the ends from which on a range is one of magnitudes


@dataclasses.dataclass
class Range:
    path: str
    low_text: str
    high_text: str
    known: str = "given"  # one of MARKS
    source: str = ""
    given_by: str = ""  # as a sentence begins
    low: float = 0.0  # SI
    high: float = 0.0
    own: float | None = None  # the deck's value

    def name(self):
        """As the results have it, one for each path."""
        return self.path.removeprefix("Materials/")

    def where(self):
        return self.given_by

    def text(self):
        return f"{self.low_text} to {self.high_text}"

    def is_wide(self):
        """Whether values are drawn evenly in their logarithm."""
        return self.low * self.high > 0.0 and max(self.high / self.low, self.low / self.high) >= WIDE

    def value_at(self, share):
        """@param share  of the range, from 0 to 1"""
        if self.is_wide():
            return self.low * (self.high / self.low) ** share
        return self.low + share * (self.high - self.low)

    def share_of_own(self):
        """Where the deck's value lies in the range; the middle if it lies outside."""
        if self.own is None or not self.low <= self.own <= self.high:
            return 0.5
        low, high, own = self.low, self.high, self.own
        if not self.is_wide():
            return (own - low) / (high - low)
        from math import log

        return log(own / low) / log(high / low)


def read_word(word):
    found = read_range(word, "uncertainty")
    _, _, text = word.partition("=")
    low, high = (value_of(end) for end in text.split("..", 1))
    unit = f" {found.unit}" if found.unit and not low.unit else ""
    return Range(found.path, f"{low.text}{unit}", high.text, source="--vary", given_by=found.where())


def read_file(file, owner=""):
    """Ranges of a CSV file.  @param owner  list of the deck that its parameters belong to"""
    try:
        rows = read_csv(file, cells=WORDS).to_dict("records")
    except BadTable as error:
        raise Fault(f"{file} is not a table of ranges ({error}); give it the columns parameter,low,high,known,source.", FILE) from None
    missing = [name for name in NEEDED if rows and name not in rows[0]]
    if missing or not rows:
        raise Fault(f"{file} has no {f'column {missing[0]}' if missing else 'ranges'} (a row is parameter,low,high,known,source); add it.",
            FILE)
    return [range_of(row, file, owner) for row in rows]


def range_of(row, file, owner):
    path = "/".join(part.strip() for part in f"{owner}/{row['parameter']}".strip("/").split("/"))
    where, known = f'{file}, "{row["parameter"]}"', row.get("known", "").strip() or "given"
    for end in ("low", "high"):
        if value_of(row[end]).number is None:
            raise Fault(f'{where}: {end} is "{row[end]}", which is no number; write for example 5 MPa.', FILE)
    if known not in MARKS:
        raise Fault(f'{where}: "{known}" does not say how the range is known; write one of {", ".join(MARKS)}.', FILE)
    return Range(path, row["low"].strip(), row["high"].strip(), known, row.get("source", "").strip(), where)


def as_csv(ranges):
    """A file that --ranges reads."""
    out = io.StringIO()
    out.write("# Ranges of barreno uncertainty; SI where no unit stands (docs/uncertainty.md)\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([*NEEDED, "known", "source"])
    for one in ranges:
        writer.writerow([one.path, one.low_text, one.high_text, one.known, one.source])
    return out.getvalue()


def number_in(deck, one):
    text = value_in(deck, one.path)
    try:
        return None if text is None else float(text)
    except ValueError:
        raise Fault(f'{one.where()}: its value in the deck is "{text[:40]}", which is no number; ranges are of numbers.') from None


def si_of(text):
    """Of a stress, or of a number without a unit. The program reads all units; what follows from a value must be set beside it."""
    value = value_of(text)
    return value.number * UNITS["stress"].get(value.unit, 1.0)


def settle_end(one, text, base, effective):
    """An end in SI.  @param effective  the effective deck with settings; refuses what leaves the bounds of a parameter"""
    if one.path in FACTORS:
        number = value_of(text)
        if number.unit or not number.number > 0.0:
            raise Fault(f'{one.where()}: {text} is no factor of the jet (a plain number above 0); write for example '
                f'--vary "{one.path}=0.98..1.02".')
        return number.number
    try:
        return number_in(effective([f"{one.path}={text}", *tied_settings(base, {one.path: si_of(text)})]), one)
    except Fault as fault:
        raise Fault(f"{one.where()}: the end {text} of the range is refused ({str(fault).rstrip('.')}); narrow the range, or leave it out.",
            fault.code) from None


def settle(one, base, effective):
    """Numbers of a range, each end as the program reads it."""
    one.own = 1.0 if one.path in FACTORS else number_in(base, one)
    one.low, one.high = (settle_end(one, text, base, effective) for text in (one.low_text, one.high_text))
    if not one.low < one.high:
        raise Fault(f"{one.where()}: the range {one.text()} is empty (its low end is not below its high end); exchange or correct them.")
