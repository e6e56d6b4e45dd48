# SPDX-License-Identifier: BSD-3-Clause
"""The words of a command: what is wrong with them is one sentence, and how quantities are written in them."""

import argparse
import re

from barreno.runs.faults import Fault
from barreno.runs.units import UNITS

LENGTH_UNITS = UNITS["length"]
TIME_UNITS = {**UNITS["time"], "": 1.0}
PRESSURE_UNITS = UNITS["stress"]
GRADIENT_UNITS = {f"{stress}/{length}": per / along for stress, per in UNITS["stress"].items() for length, along in UNITS["length"].items()}


class Words(argparse.ArgumentParser):
    """@param example  behind "write for example" in a sentence  @param page  of docs"""

    def __init__(self, command, example, page, **more):
        self.example, self.page = example, page
        super().__init__(prog=f"barreno {command}", allow_abbrev=False, formatter_class=argparse.RawDescriptionHelpFormatter, **more)

    def error(self, message):
        raise Fault(f"{message}; {self.example} (docs/{self.page}).")


def quantity_of(text, units):
    """A number with a unit in SI. @raises ValueError"""
    found = re.fullmatch(r"\s*([0-9.eE+-]+)\s*(\S*)\s*", text)
    if not found or found.group(2) not in units:
        raise ValueError(text)
    return float(found.group(1)) * units[found.group(2)]
