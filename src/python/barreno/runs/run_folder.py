# SPDX-License-Identifier: BSD-3-Clause
"""What a run folder holds (docs/output.md)."""

import json
import pathlib
import re

import barreno
from barreno.runs.csv_table import BadTable, arrays_of, read_csv
from barreno.runs.faults import FILE, Fault, on_one_line
from barreno.runs.program import body_of
from barreno.runs.regular_file import open_regular, read_text


DEEPEST = 40  # objects in objects; a summary has four
MOST_DIGITS = 18  # of a whole number
NUMBER, LIST = (int, float), dict
KINDS = {  # what commands reckon with, where a summary has it: a number, an object, or the word that says so
    "time": NUMBER, "wall_seconds": NUMBER, "steps": NUMBER, "exit_code": NUMBER, "reason": str, "version": str, "penetration": LIST,
    "penetration.depth": NUMBER,
    "penetration.channel_depth": NUMBER, "penetration.probed_depth": NUMBER,
    "penetration.cells_per_radius": LIST, "penetration.cells_per_radius.tip": NUMBER,
    "penetration.rest": LIST, "penetration.rest.sentence": str, "penetration.depth_error": LIST,
    "penetration.depth_error.value": NUMBER, "penetration.depth_error.low": NUMBER, "penetration.depth_error.high": NUMBER,
    "penetration.depth_error.cells_per_radius": NUMBER,
    "penetration.depth_error.source": str, "penetration.depth_error.unknown": str, "penetration.depth_error.advice": str,
    "penetration.probed_depth_error": LIST,
    "penetration.channel_volume_error": LIST, "penetration.core_flow_efficiency_error": LIST,
    "penetration.least_certain": LIST, "penetration.least_certain.sentence": str,
    **{f"penetration.{of}_error.{name}": NUMBER for of in ("probed_depth", "channel_volume", "core_flow_efficiency")
       for name in ("value", "low", "high", "cells_per_radius")},
    **dict.fromkeys((f"penetration.{of}_error.{name}" for of in ("probed_depth", "channel_volume", "core_flow_efficiency")
       for name in ("source", "unknown", "advice")), str),
    "balances": LIST, "balances.energy": LIST, "balances.energy.error": NUMBER,
}  # fmt: skip
WORDS = {NUMBER: "a number", LIST: "an object", str: "a text"}


def check_depth(tree, left=DEEPEST):
    if left == 0:
        raise ValueError(f"it is nested more than {DEEPEST} times")
    for value in tree.values() if isinstance(tree, dict) else tree:
        if isinstance(value, (dict, list)):
            check_depth(value, left - 1)


def check_kinds(summary):
    """A file that was changed by hand may have a text where a number belongs."""
    for path, kind in KINDS.items():
        value = summary
        for name in path.split("."):
            value = value.get(name) if isinstance(value, dict) else None
        if value is not None and (not isinstance(value, kind) or isinstance(value, bool)):
            raise ValueError(f"{path} is {json.dumps(value)[:60]}, where {WORDS[kind]} belongs")


def whole_number(text):
    return int(text) if len(text) <= MOST_DIGITS else float(text)


def read_summary(folder):
    file = pathlib.Path(folder) / "summary.json"
    try:
        found = json.loads(read_text(file), parse_int=whole_number)
        if not isinstance(found, dict):
            raise ValueError("it is not a JSON object")
        check_depth(found)
        check_kinds(found)
    except (OSError, ValueError, RecursionError) as error:
        raise Fault(f"{file} cannot be read ({error}); remove the folder, so that the run is made again.", FILE) from None
    return found


def read_table(file):
    """Columns of a CSV file as arrays; a line that was cut off is left out."""
    try:
        return arrays_of(read_csv(file, cut=True))
    except (OSError, BadTable) as error:
        raise Fault(f"{file} cannot be read as a table of numbers ({on_one_line(error)[:200]}); make the run again.", FILE) from None


def scalars_of(tree, path=""):
    """{dotted path: text, number or truth} of a JSON object."""
    found = {}
    for name, value in tree.items():
        whole = f"{path}.{name}" if path else name
        if isinstance(value, dict):
            found.update(scalars_of(value, whole))
        elif isinstance(value, (int, float, str)):
            found[whole] = value
    return found


def numbers_of(tree):
    """{dotted path: number} of a JSON object."""
    return {path: float(value) for path, value in scalars_of(tree).items() if isinstance(value, (int, float))
        and not isinstance(value, bool)}


def deck_in(folder):
    """The effective deck of a run, without the comment that names its file; None where there is none."""
    try:
        return body_of(read_text(folder / "deck.xml"))
    except (OSError, UnicodeDecodeError):
        return None


def state_of(folder):
    """(finished, version) as a run says; (False, "") of one that was killed."""
    try:
        summary = read_summary(folder)
    except Fault:
        return False, ""
    return summary.get("finished") is True, summary.get("version", "")


def other_version(folder, version):
    """A sentence where another version of Barreno made a run; nothing else."""
    if not version or version == barreno.__version__:
        return ""
    return (f"{folder} was made by Barreno {version}, and this is {barreno.__version__}; names and meanings of its files may differ "
        "(CHANGELOG.md).")


def progress_of(folder):
    """Share of a run that is done, as the last line of progress in its run.log has it."""
    try:
        with open_regular(folder / "run.log", "rb") as stream:
            stream.seek(0, 2)
            stream.seek(max(0, stream.tell() - 4096))
            found = re.findall(rb"^ *(\d+) %  t ", stream.read(), re.MULTILINE)
    except OSError:
        return 0.0
    return min(1.0, int(found[-1]) / 100.0) if found else 0.0
