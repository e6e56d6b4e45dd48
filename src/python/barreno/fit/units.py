# SPDX-License-Identifier: BSD-3-Clause
"""Units that laboratory files are written in."""

import difflib
import math
import re

from barreno.runs.faults import Fault
from barreno.runs.units import UNITS


def is_unit(text):
    return any(text in known for known in UNITS.values())


def factor(unit, dimension, where):
    """What a number in this unit is multiplied by to be SI."""
    known = UNITS[dimension]
    if unit in known:
        return known[unit]
    near = difflib.get_close_matches(unit.lower(), [name.lower() for name in known], 1, 0.6)
    advice = next((f"did you mean {name}?" for name in known if near and name.lower() == near[0]), f"use one of {', '.join(known)}.")
    raise Fault(f"{where} has the unit '{unit}', which is none of a {dimension}; {advice}")


def quantity(text, dimension, where, plain=False):
    """A number with its unit, "40 MPa", in SI.

    @param plain  whether a number without a unit is taken as SI
    """
    found = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(\S*)\s*", text)
    try:
        value = float(found.group(1)) if found else math.nan
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Fault(f"{where} is '{text.strip()}', which is not a number with a unit; write for example 40 MPa or 20 %.")
    unit = found.group(2)
    if not unit:
        if plain or dimension == "ratio":
            return value
        raise Fault(f"{where} is '{text.strip()}', without a unit; add one of {', '.join(UNITS[dimension])}.")
    return value * factor(unit, dimension, where)
