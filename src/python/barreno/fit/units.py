# SPDX-License-Identifier: BSD-3-Clause
"""Units that laboratory files are written in."""

import difflib
import math
import re
from barreno.runs.faults import Fault

PSI = 6894.757293168361  # pound-force per square inch, exact by definition
UNITS = {
    "stress": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "bar": 1e5, "kbar": 1e8, "atm": 101325.0, "psi": PSI, "ksi": 1e3 * PSI,
        "N/mm2": 1e6, "N/mm^2": 1e6, "N/mm²": 1e6, "MN/m2": 1e6, "kN/m2": 1e3},
    "compliance": {"1/Pa": 1.0, "1/kPa": 1e-3, "1/MPa": 1e-6, "1/GPa": 1e-9},
    "strain": {"-": 1.0, "1": 1.0, "%": 1e-2, "percent": 1e-2, "permille": 1e-3, "millistrain": 1e-3, "microstrain": 1e-6, "mm/mm": 1.0,
        "m/m": 1.0, "mm/m": 1e-3, "um/m": 1e-6, "µm/m": 1e-6, "μm/m": 1e-6, "ustrain": 1e-6, "‰": 1e-3},
    "ratio": {"-": 1.0, "1": 1.0, "%": 1e-2},
    "force": {"N": 1.0, "kN": 1e3, "MN": 1e6, "lbf": 4.4482216152605, "kgf": 9.80665},
    "length": {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "in": 0.0254, "inch": 0.0254},
    "time": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
    "density": {"kg/m3": 1.0, "g/cm3": 1e3},
}


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
