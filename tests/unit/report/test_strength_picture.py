#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The report's picture of strength on runs that were laid by hand: the surface of the card, triaxial extension where it differs, and rock
whose surface a report does not know."""
import pathlib
import re
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from barreno.report.deck import read_deck
from barreno.report.run import opened
from barreno.report.sections import strength_section
from barreno.report.strength import strength_of, surface_of
from synthetic_run import CELL, jet, lattice, rock, write_run


def shared(folder):
    """A jet at the bottom of a hole in rock."""
    wall = rock(np.concatenate([lattice(3 * CELL, 14 * CELL, 0.0, 20 * CELL), lattice(0.0, 14 * CELL, 20 * CELL, 30 * CELL)]))
    return write_run(folder, [jet(np.array([[0.25 * CELL, CELL]]), np.array([5000.0])), wall])


def check_strength(run):
    """The surface at its vertex, under low pressure, on the cap and beyond."""
    card = strength_of(read_deck(run / "deck.xml"), "Sandstone")
    assert strength_of(read_deck(run / "deck.xml"), "Tungsten") is None
    p, q = card.curve(0.0, 1e9)
    assert abs(p[0] + 9.36e6 / 3.0) < 1.0 and abs(q[0]) < 1.0 and abs(p[-1] - 1.2244e9 / 3.0) < 1.0 and abs(q[-1]) < 1.0, (p[[0, -1]],
        q[[0, -1]])
    x = -3.0 * 1e8
    a2 = (0.549 - 0.0724) / (128.5e6 - 0.0724 * 9.36e6)
    by_hand = 128.5e6 - (128.5e6 - 0.0724 * 9.36e6) * np.exp(a2 * (x - 9.36e6)) - 0.0724 * x
    assert abs(np.interp(1e8, p, q) - by_hand) < 1e-3 * by_hand, (np.interp(1e8, p, q), by_hand)
    assert (
        card.hydrostatic_strength(-0.2231) == -np.inf and card.hydrostatic_strength(-0.1) < -1.2244e9 < card.hydrostatic_strength(0.1) < 0.0
    )


def with_entry(run, name, value):
    """Rewrites the entry of the rock in the deck of a run, or adds it."""
    text = (run / "deck.xml").read_text()
    without = re.sub(f'<Parameter name="{name}"[^>]*>', "", text)
    rock_list = '<ParameterList name="Sandstone">'
    (run / "deck.xml").write_text(without.replace(rock_list, f'{rock_list}<Parameter name="{name}" value="{value}"/>'))


def strength_of_page(run):
    """(words, labels of the picture's legend) of the section on strength."""
    with opened(run) as whole:
        part = strength_section(whole, whole.frame(), whole.depth_table())
    labels = part.pictures[0].figure.axes[-2].get_legend_handles_labels()[1]
    plt.close(part.pictures[0].figure)
    return " ".join(part.words), labels


def check_other_surfaces(folder):
    """Rock with a shear limit of another part has no surface, and words and picture say so; at 0 that part is off. A third invariant
    draws triaxial extension too."""
    run = shared(folder / "other")
    words, labels = strength_of_page(run)
    assert "is not drawn" not in words and "yield surface of virgin rock" in labels and len(labels) == 3, (words, labels)
    with_entry(run, "J3_type", "Gudehus")
    with_entry(run, "J3_psi", "0.8")
    assert "the same in triaxial extension" in strength_of_page(run)[1]
    with_entry(run, "Lundborg strength", "0")
    assert surface_of(read_deck(run / "deck.xml"), "Sandstone")[1] == ""
    with_entry(run, "Lundborg strength", "4e8")
    words, labels = strength_of_page(run)
    assert len(labels) == 1 and "its surface is not drawn" in labels[0], labels
    assert ("Sandstone: its card has Lundborg strength, and a report knows the published shear limit and crush curve alone, so its surface "
        "is not drawn.") in words, words
    with_entry(run, "Lundborg strength", "0")
    with_entry(run, "fluid_B0", "2e9")
    with_entry(run, "Backstress strain", "plastic")
    assert "Backstress strain" in strength_of_page(run)[0]


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        check_strength(shared(folder / "run"))
        check_other_surfaces(folder)
    print("the picture of strength has the surface of the card, or says that it has none")


if __name__ == "__main__":
    main()
