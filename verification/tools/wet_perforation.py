# SPDX-License-Identifier: BSD-3-Clause
"""A short coarse perforation into saturated sandstone, from undrained to drained: settings of input_xml/perforation_quick.xml."""
from tools.runs import run_deck

CELL = 4.0  # mm
WET = {"Materials/Sandstone/fluid_B0": "2.25 GPa", "Bodies/Rock/Pore Pressure": "0 Pa"}


def short_target(end, cell=CELL):
    """A plug of 24 mm radius and 60 mm of rock, as heavy as if its pores were full, to `end` microseconds."""
    return {
        "Grid/Cell Size": f"{cell!r} mm",
        "Grid/Lower": "{0 mm, -40 mm}",
        "Grid/Upper": "{32 mm, 88 mm}",
        "Bodies/Casing/Upper": "{24 mm, 12.7 mm}",
        "Bodies/Rock/Upper": "{24 mm, 72.7 mm}",
        "Materials/Sandstone/Density": "2320 kg/m3",
        "Time/End Time": f"{end!r} us",
        "Output/Field Interval": "0 us",
        # Pore flow keeps all tiles awake: what it is compared with must take the same steps.
        "Step/Skip Dormant Tiles": "false",
        "Step/Rest Motion": "0",
    }


def drained_everywhere(permeability):
    """Pores full at no pressure, and none outside: what is open drains."""
    return {
        **WET,
        "Pore Flow/Drainage": "on",
        "Pore Flow/Viscosity": "1 mPa s",
        "Pore Flow/Rocks/Sandstone/Permeability": f"{{{permeability!r} m2}}",
        "Pore Flow/Conditions/Open/Kind": "drained",
        "Pore Flow/Conditions/Open/Open Faces": "{x_lower, x_upper, y_lower, y_upper}",
        "Pore Flow/Conditions/Open/Pressure": "0 Pa",
    }


def dry(barreno, end, cell=CELL):
    return run_deck(barreno, "perforation_quick.xml", short_target(end, cell))


def undrained(barreno, end, cell=CELL):
    return run_deck(barreno, "perforation_quick.xml", {**short_target(end, cell), **WET})


def with_flow(barreno, permeability, end, cell=CELL, more=None):
    settings = {**short_target(end, cell), **drained_everywhere(permeability), **(more or {})}
    return run_deck(barreno, "perforation_quick.xml", settings)
