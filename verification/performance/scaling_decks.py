# SPDX-License-Identifier: BSD-3-Clause
"""The runs by which ranks are compared: a block in three dimensions, and the perforation."""
import dataclasses
import pathlib

from tools.runs import DECKS
from tools.small_decks import write_deck

SPEED = 100.0  # of waves in the block [m/s]
CELL = 1e-3


@dataclasses.dataclass
class Problem:
    name: str
    deck: pathlib.Path
    short: str  # end times, the longer one for the measurement
    end: str


def write_block(file, cells):
    """An elastic block of so many cells along x, y, z, eight particles each, that runs into symmetry planes: all of it is awake."""
    size = [n * CELL for n in cells]
    box = [f"{1e3 * length:g} mm" for length in size]
    write_deck(file, {
        "Title": "Elastic block",
        "Grid": {"Mode": "3D", "Lower": "{0 mm, 0 mm, 0 mm}",
                 "Upper": [f"{1e3 * (length + 4 * CELL):g} mm" for length in size], "Cell Size": f"{1e3 * CELL:g} mm"},
        "Materials": {"Elastic": {"Model": "Linear Elastic", "Density": "1000 kg/m3", "Bulk Modulus": "6 MPa", "Shear Modulus": "3 MPa"}},
        "Bodies": {"Block": {"Material": "Elastic", "Lower": "{0 mm, 0 mm, 0 mm}", "Upper": box, "Velocity": "{-1 m/s, -1 m/s, -1 m/s}"}},
        "Conditions": {name: {"Face": f"{name}_lower", "Kind": "symmetry"} for name in "xyz"},
        "Time": {"End Time": "1 ms"},
    })  # fmt: skip
    return pathlib.Path(file)


def block(folder, cells, steps):
    name = "x".join(map(str, cells))
    deck = write_block(pathlib.Path(folder) / f"block_{name}.xml", cells)
    step = 0.25 * CELL / SPEED  # about; only the difference of two runs counts
    return Problem(f"elastic block, {name} cells", deck, f"{0.4e6 * steps * step:g} us", f"{1e6 * steps * step:g} us")


def perforation():
    return Problem("perforation_120us.xml to 20 us", DECKS / "perforation_120us.xml", "10 us", "20 us")
