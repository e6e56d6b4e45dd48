# SPDX-License-Identifier: BSD-3-Clause
"""A quarter of a sandstone plug between glued platens: confined at the sides, then pressed. What both hosts solve."""

import pathlib

import barreno_library
from getfem_plug import CELLS, CONFINEMENT, LENGTHS, STEPS, increments  # noqa: F401

CARD = "FINE_BEREA"


def write_card(folder):
    """Berea sandstone with fine substeps: where a point changes their number its stress jumps by up to Tolerance, and
    Newton's method can circle around a jump."""
    text = (barreno_library.CARDS / "berea_sandstone.xml").read_text()
    fine = '  <Parameter name="Tolerance" type="double" value="1e-5"/>\n</ParameterList>'
    path = pathlib.Path(folder) / f"{CARD.lower()}.xml"
    path.write_text(text.replace("</ParameterList>", fine))
    return path
