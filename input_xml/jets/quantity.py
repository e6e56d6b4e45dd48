# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with units in the words of the tools in this folder, written as decks have them: "90 us", "50 mm", "200 MPa"; a plain number is
in SI."""

import argparse
import decimal
import math
import re

PSI = 6894.757293168361  # pound-force per square inch, exact by definition
UNITS = {  # of decks (docs/deck.md), those that these tools have a use for
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9},
    "length": {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "in": 0.0254, "ft": 0.3048},
    "speed": {"m/s": 1.0, "km/s": 1e3, "mm/us": 1e3, "cm/us": 1e4},
    "stress": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "bar": 1e5, "psi": PSI, "ksi": 1e3 * PSI},
    "density": {"kg/m3": 1.0, "g/cm3": 1e3},
}
EXAMPLES = {"time": "90 us", "length": "50 mm", "speed": "110 m/s", "stress": "200 MPa", "density": "2.3 g/cm3"}
NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S*)\s*")


def value_of(text, kind):
    """In SI.  @raises ValueError  with what is wrong, as a clause"""
    found = NUMBER.fullmatch(text)
    if not found or not math.isfinite(float(found.group(1))):
        raise ValueError(f'"{text}" is not a {kind}; write for example "{EXAMPLES[kind]}"')
    unit = found.group(2)
    if unit and unit not in UNITS[kind]:
        raise ValueError(f'"{text}" has the unit "{unit}", which is none of a {kind} ({", ".join(UNITS[kind])}); write for example '
            f'"{EXAMPLES[kind]}"')
    factor = UNITS[kind][unit] if unit else 1.0
    return float(decimal.Decimal(found.group(1)) * decimal.Decimal(repr(factor)))  # 90 us is 90e-6 to the last bit, as in a deck


def quantity(kind):
    """A type of argparse."""

    def convert(text):
        try:
            return value_of(text, kind)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    return convert
