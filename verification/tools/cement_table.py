# SPDX-License-Identifier: BSD-3-Clause
"""The table of input_xml/README.md on cement behind the casing."""
import json

from tools.case_list import RESULTS
from tools.verification_pages import table

STORED = RESULTS / "cement_shot.json"
DECKS = {"perforation.xml": "casing and rock", "perforation_cement.xml": "casing, cement and rock"}


def lines():
    found = json.loads(STORED.read_text())
    end = found["perforation_cement.xml"]["end"]
    said = f"Both to {1e6 * end:.0f} us with fidelity *fast*, one run each (`verification/cement_shot.py`):"
    rows = []
    for deck, target in DECKS.items():
        one = found[deck]
        entrance = one["entrance_diameter_in_body"]
        rows.append([target, *(f"{1e3 * value:.0f}" for value in (one["depth"], one["depth_in_body"]["Rock"], one["probed_depth"])),
            *(f"{1e3 * entrance[body]:.1f}" if body in entrance else "-" for body in ("Casing", "Cement", "Rock")),
            f"{1e6 * one['channel_volume']:.1f}"])  # fmt: skip
    return [said, "", *table(["target", "depth [mm]", "depth in rock [mm]", "as wide as the jet, to [mm]", "entrance in casing [mm]",
        "in cement [mm]", "in rock [mm]", "volume of the hole [cm3]"], rows)]  # fmt: skip
