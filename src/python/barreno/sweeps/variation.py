# SPDX-License-Identifier: BSD-3-Clause
"""What --vary says: a parameter of the deck and its values, or the range that they are drawn from."""

import dataclasses
import re

from barreno.runs.faults import Fault

EXAMPLE = 'write for example --vary "Confinement/Pressure=0,34,69 MPa"'
RANGE_EXAMPLE = 'write for example --vary "Confinement/Pressure=0..69 MPa"'
NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*")


@dataclasses.dataclass(frozen=True)
class Value:
    text: str  # as the deck gets it
    number: float | None = None  # of text that begins with one
    unit: str = ""


@dataclasses.dataclass
class Variation:
    path: str
    values: list  # of Value
    low: float | None = None  # of a range, which has no values of its own
    high: float | None = None
    unit: str = ""

    def name(self):
        return self.path.rpartition("/")[2]

    def where(self):
        return f'--vary "{self.path}"'

    def common_unit(self):
        """Of all values, None if they are not all numbers or have several."""
        units = {value.unit for value in self.values}
        return units.pop() if len(units) == 1 and all(value.number is not None for value in self.values) else None


def value_of(text):
    found = NUMBER.fullmatch(text)
    return Value(text.strip(), float(found.group(1)), found.group(2)) if found else Value(text.strip())


def split_values(text):
    """At commas, but for those inside of braces."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter == "{") - (letter == "}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def with_units(values):
    """A plain number has the unit of the next value that has one: 0,34,69 MPa."""
    out, unit = [], ""
    for value in reversed(values):
        if value.number is not None and not value.unit and unit:
            value = Value(f"{value.text} {unit}", value.number, unit)
        unit = value.unit
        out.append(value)
    return out[::-1]


def parts_of(word):
    """Path and text behind the equals sign."""
    path, equals, text = word.partition("=")
    path = "/".join(part.strip() for part in path.split("/"))
    if not equals or not path or "" in path.split("/"):
        raise Fault(f'--vary "{word}" names no parameter and its values (LIST/NAME=VALUE,VALUE... is expected); {EXAMPLE}.')
    return path, text


def read_list(word):
    path, text = parts_of(word)
    values = with_units([value_of(part) for part in split_values(text)])
    if any(not value.text for value in values):
        raise Fault(f'--vary "{word}" has an empty value (each of them makes a run); {EXAMPLE}.')
    if len(values) == 1 and is_range(text):
        raise Fault(f'--vary "{word}" is a range, from which --sample latin draws; list the values, or add --sample latin --samples 20.')
    texts = [value.text for value in values]
    double = next((text for text in texts if texts.count(text) > 1), None)
    return Variation(path, values), double


def is_range(text):
    low, dots, high = text.partition("..")
    return bool(dots and NUMBER.fullmatch(low) and NUMBER.fullmatch(high))


def read_range(word, drawn_by="--sample latin"):
    """@param drawn_by  that a sentence names"""
    path, text = parts_of(word)
    if not is_range(text) or "..." in text:
        raise Fault(f'--vary "{word}" is not a range ({drawn_by} draws between two numbers, LIST/NAME=LOW..HIGH UNIT); '
            f'{RANGE_EXAMPLE}.')
    low, high = (value_of(part) for part in text.split("..", 1))
    unit = high.unit or low.unit
    if low.unit not in ("", unit):
        raise Fault(f'--vary "{word}" has two units, {low.unit} and {high.unit} (a range has one); {RANGE_EXAMPLE}.')
    if not low.number < high.number:
        raise Fault(f'--vary "{word}" is an empty range ({low.number:g} is not below {high.number:g}); {RANGE_EXAMPLE}.')
    return Variation(path, [], low.number, high.number, unit)


def read_variations(words, sample):
    """@param sample  grid, list or latin"""
    if not words:
        raise Fault(f"sweep needs what to vary; {EXAMPLE}.")
    variations = []
    for word in words:
        if sample == "latin":
            variations.append(read_range(word))
            continue
        variation, double = read_list(word)
        if double and sample == "grid":
            raise Fault(f'--vary "{word}" has the value {double} twice (each makes a run of its own); leave one out.')
        variations.append(variation)
    refuse_twice(variations)
    return variations


def refuse_twice(variations, has="list of values", all_of="all of its values in one --vary"):
    paths = [variation.path for variation in variations]
    again = next((path for path in paths if paths.count(path) > 1), None)
    if again:
        raise Fault(f'--vary "{again}" is given twice (a parameter has one {has}); write {all_of}.')
