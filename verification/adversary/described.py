# SPDX-License-Identifier: BSD-3-Clause
"""The table of deck options, read from `barreno describe --markdown`: a new option is drawn without a line here."""
import dataclasses
import math
import re
import subprocess


@dataclasses.dataclass
class Option:
    section: str  # "Step", "Bodies/*", "Model Arenisca"; empty: the top of the deck
    name: str
    kind: str  # number, integer, text, file, flag, word, words, array, table
    unit: str
    words: list
    lower: float
    upper: float
    lower_open: bool
    upper_open: bool
    default: str  # "required", "optional", or the default itself

    @property
    def path(self):
        return f"{self.section}/{self.name}".lstrip("/")


def kind_of(text):
    """@return kind, unit, words of a cell like "number [m/s]", "array of: x_lower, x_upper" or "one of: on, off"."""
    for head, kind in (("one of: ", "word"), ("array of: ", "words")):
        if text.startswith(head):
            return kind, "", text[len(head) :].split(", ")
    if text == "array of names":
        return "words", "", []
    if text == "true or false":
        return "flag", "", []
    kind, _, unit = text.partition(" [")
    return ("table" if kind.startswith("table") else kind), unit.rstrip("]"), []


def bounds_of(text):
    bounds = [-math.inf, math.inf, False, False]
    for sign, value in re.findall(r"([<>]=?) ([-+.\deinf]+)", text):
        side = 0 if sign[0] == ">" else 1
        bounds[side], bounds[side + 2] = float(value), len(sign) == 1
    return bounds


def table_of(markdown):
    """All options, section by section."""
    options, section = {}, None
    for line in markdown.splitlines():
        if line.startswith("## "):
            section = line[3:] if line != "## Top of the deck" else ""
            options[section] = []
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if section is None or len(cells) != 5 or cells[0] in ("name", "---"):
            continue
        name, value, bounds, default, _ = cells
        options[section].append(Option(section, name, *kind_of(value), *bounds_of(bounds), default))
    return options


def described_options(barreno):
    text = subprocess.run([str(barreno), "describe", "--markdown"], capture_output=True, text=True, check=True).stdout
    options = table_of(text)
    if len(options) < 10 or not options.get("Step"):
        raise RuntimeError("barreno describe --markdown has no tables: its form has changed, and described.py must follow")
    return options
