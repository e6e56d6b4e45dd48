# SPDX-License-Identifier: BSD-3-Clause
"""A quarter of a sandstone plug between glued platens: confined at the sides, then pressed. What both hosts solve."""

import pathlib

import barreno_library

CARD = "FINE_BEREA"
CELLS = (4, 4, 4)
LENGTHS = (12.7e-3, 11.0e-3, 25.4e-3)  # m, between three planes of symmetry
CONFINEMENT = 20e6  # Pa, on the sides

# (increments, displacement of the platen at the end [m], pressure on the sides at the end [Pa]): ramps one after
# the other, small strains, loads on the undeformed faces.
STEPS = ((5, -3e-5, CONFINEMENT), (24, -3e-4, CONFINEMENT))


def write_card(folder):
    """Berea sandstone with fine substeps: where a point changes their number its stress jumps by up to Tolerance, and
    Newton's method can circle around a jump."""
    text = (barreno_library.CARDS / "berea_sandstone.xml").read_text()
    fine = '  <Parameter name="Tolerance" type="double" value="1e-5"/>\n</ParameterList>'
    path = pathlib.Path(folder) / f"{CARD.lower()}.xml"
    path.write_text(text.replace("</ParameterList>", fine))
    return path


def increments():
    """(platen, pressure) at the end of each increment."""
    platen = pressure = 0.0
    for count, platen_end, pressure_end in STEPS:
        for i in range(1, count + 1):
            t = i / count
            yield platen + t * (platen_end - platen), pressure + t * (pressure_end - pressure)
        platen, pressure = platen_end, pressure_end
