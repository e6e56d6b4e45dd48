#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The deck that docs/finite_elements.md hands to users runs as it stands, and what that page says of cards is so.

    test_example.py LIBRARY FOLDER_OF_CCX
"""

import pathlib
import sys
import tempfile

import barreno_library
import calculix

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECK = ROOT / "input_xml" / "calculix" / "sandstone_plug.inp"
PAGE = ROOT / "docs" / "finite_elements.md"


def check_deck(ccx, library):
    with tempfile.TemporaryDirectory() as folder:
        code, said, printed = calculix.run(ccx, library, folder, DECK.read_text(), name="sandstone_plug")
    calculix.assert_job(code, said, "BEREA_SANDSTONE")
    force = {time: rows[0][2] for time, rows in printed["total force"].items()}
    print(f"platen force of the example {force[1.0]:.5e} N when confined, {force[2.0]:.5e} N at the end")
    # What the page shows.
    for time in (1.0, 2.0):
        assert f"{force[time] / 1e3:.1f} kN" in PAGE.read_text(), f"docs/finite_elements.md: force at time {time:g}"


def check_page(library):
    """Each card's model has its row of state variables in the page."""
    page = PAGE.read_text()
    library = barreno_library.load(library)
    cards = sorted(barreno_library.CARDS.glob("*.xml"))
    assert cards
    for card in cards:
        material = barreno_library.Material(card, library)
        model = library.barreno_material_model(material.handle).decode()
        row = f"| {model} | {material.state_count} | " + ", ".join(material.state_names) + " |"
        assert row in page, f"docs/finite_elements.md lacks the row\n{row}"
        material.close()


def main():
    check_page(sys.argv[1])
    check_deck(calculix.program(sys.argv[2]), sys.argv[1])


if __name__ == "__main__":
    main()
