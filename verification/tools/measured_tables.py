# SPDX-License-Identifier: BSD-3-Clause
"""The files of src/measured that say what cells do to the depth of a jet: measured numbers in the units of the program, installed with it.

Digits are those of the results files: a power of ten moves the point, nothing is computed anew.
"""
import json
from decimal import Decimal

from tools import depth_shots_table, range_effects_table
from tools.case_list import RESULTS
from tools.uniform_cells import read

FINEST = "0.125"  # mm: so small for parts of the path alone, what the comparison is worth
TARGET = "Berea sandstone"
LENGTH_CELLS = (1, 2)  # per radius, whose errors are kept

HEAD = "# Made by `verification/pages.py --write` from {}; do not edit.\n"


def table(head, columns, rows):
    """Text of a file as src/files/measured_table.hpp reads it."""
    lines = [",".join(map(str, row)) for row in rows]
    return "\n".join([*head.splitlines(), ",".join(columns), *lines, f"# end of {len(lines)} rows"]) + "\n"


def moved(text, digits):
    """A decimal number with its point moved."""
    value = Decimal(text).scaleb(digits)
    return f"{value.normalize():f}" if value else "0"


def depths_of_cells():
    head = (
        "# Depth of the jet of perforation_120us.xml [m] at a time [s]: of runs with cells of a size [m], of `finest` cells that only\n"
    )
    head += "# parts of the path had, and by the hydrodynamic estimate.\n" + HEAD.format(
        "perforation_cells.csv and estimated_depths.csv of verification/results")
    runs = [("finest" if row["cells_mm"] == FINEST else "run", moved(row["cells_mm"], -3), moved(row["time_us"], -6),
        moved(row["depth_mm"], -3))
            for row in read("perforation_cells.csv")]  # fmt: skip
    estimates = [("estimate", 0, moved(row["time_us"], -6), moved(row["depth_mm"], -3)) for row in read("estimated_depths.csv")]
    return table(head, ("what", "cell", "time", "depth"), runs + estimates)


def steady_errors():
    head = "# Range of the relative error of the rate of steady penetration with so many cells per radius of the rod.\n"
    head += HEAD.format("verification/results/steady_penetration.csv")
    rows = [(row["target"], row["cells_per_radius"], moved(row["low"], -2), moved(row["high"], -2))
            for row in read("steady_penetration.csv") if row["target"] == TARGET]  # fmt: skip
    return table(head, ("target", "cells_per_radius", "low", "high"), rows)


def length_errors():
    head = (
        "# Relative error of the depth of perforation_120us.xml to 10 us, of jets of the same mass and momentum whose slugs are shorter or "
        "longer.\n"
    )
    head += HEAD.format("verification/results/slug_length.json (the case slug_length)")
    data = json.loads((RESULTS / "slug_length.json").read_text())
    rows = [dict(zip(data["columns"], row)) for row in data["rows"]]
    kept = [(row["slugs"], f"{row['length over radius of the tip']:.8f}", row["cells per radius"], f"{row['error']:.4f}")
            for row in rows if row["cells per radius"] in LENGTH_CELLS]  # fmt: skip
    return table(head, ("slugs", "length_over_radius", "cells_per_radius", "error"), sorted(kept, key=lambda row: float(row[1])))


def divided_errors():
    head = (
        "# Relative error of the depth, of the depth of the hole that is as wide as the jet, of the hole's volume, and of the core flow\n"
        "# efficiency, of perforation.xml with divided particles of the jet and so many cells per radius of its tip.\n"
    )
    head += HEAD.format("depth_shots.json and depth_scatter.json of verification/results")
    rows = [(what, f"{cells:g}", *(f"{number:.4f}" for number in error))
            for cells, errors in depth_shots_table.errors().items() for what, error in errors.items()]  # fmt: skip
    return table(head, ("what", "cells_per_radius", "value", "low", "high"), rows)


def range_effects():
    head = (
        "# What the range of one parameter of a card changes in perforation.xml: depth, depth of the hole as wide as the jet, and volume,\n"
        "# over those of the card less 1, at both ends; of each card, those that change the volume most first.\n"
    )
    head += HEAD.format("range_effects.json of verification/results")
    columns = ["range", *(f"{name}_at_{end}" for name in ("depth", "probed_depth", "volume") for end in ("low", "high"))]
    rows = []
    for card, found in range_effects_table.cards().items():
        for row in found["rows"]:
            name = "; ".join((card, row["parameter"], f"{row['low']} to {row['high']}", row["known"], found["until"]))
            changes = [range_effects_table.changes(row, found["middle"], of) for of in ("depth", "probed_depth", "channel_volume")]
            rows.append([name, *(f"{change:.4f}" for pair in changes for change in pair)])
    return table(head, columns, rows)


def files():
    """{file: text}"""
    makers = (depths_of_cells, steady_errors, length_errors, divided_errors, range_effects)
    return {f"src/measured/{make.__name__}.csv": make() for make in makers}
