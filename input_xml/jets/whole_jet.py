#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The whole part of a formed jet's table: without what flies ahead of it.

    python3 whole_jet.py TABLE --thinnest "0.125 mm" > whole.csv

The first rows of a table that a Jet Monitor has written are single particles, thrown ahead of the jet. Launched as a thinned jet they are
filaments far thinner than a cell, which take short steps. In the faster half of the table, the rows are left out
up to the last one whose metal has a radius below --thinnest (half a cell is a good choice), and those before a gap.
What they had of mass, momentum and kinetic energy is written into the table.

Tables are in SI. Only the standard library is used.
"""

import argparse
import math
import sys

from move_jet import HEADER, TableError, read_table, totals
from quantity import quantity


def metal_radius(row, density):
    """Of the row's mass as a rod of the full density over its length [m]."""
    return row[2] * math.sqrt(row[4] / density)


def first_of_whole(rows, thinnest):
    """Index of the first row of the whole jet."""
    density = max(row[4] for row in rows)
    interval = min(b[0] - a[0] for a, b in zip(rows, rows[1:]))
    first = 0
    for i, row in enumerate(rows[: len(rows) // 2]):
        if metal_radius(row, density) < thinnest:
            first = i + 1
        elif i > 0 and row[0] - rows[i - 1][0] > 1.5 * interval:
            first = max(first, i)
    return first


def main(given=None):
    parser = argparse.ArgumentParser(description="The whole part of a formed jet's table.", allow_abbrev=False)
    parser.add_argument("table")
    parser.add_argument("--thinnest", type=quantity("length"), required=True,
        help='radius of the metal below which a row is no part of the jet, "0.125 mm"')
    asked = parser.parse_args(given)
    try:
        with open(asked.table, encoding="utf-8") as stream:
            rows = read_table(stream, asked.table)
        if not asked.thinnest > 0.0:
            raise TableError(f"--thinnest = {asked.thinnest:g} m is not above 0; give half the size of a cell, for instance.")
        first = first_of_whole(rows, asked.thinnest)
        if first >= len(rows) // 2:
            raise TableError(
                f"the metal of {asked.table} is thinner than {asked.thinnest:g} m in radius through half of its rows; "
                "make the cells smaller, or launch the table as a discrete jet."
            )
    except (TableError, OSError) as error:
        raise SystemExit(f"whole_jet.py: {error}") from None
    print("# units: SI")
    print(f"# Made by whole_jet.py: {asked.table.rsplit('/', 1)[-1]} without {first} of its {len(rows)} rows, those before the whole jet")
    for name, unit, gone, all_of_it in zip(("mass", "momentum", "kinetic energy"), ("kg", "kg m/s", "J"), totals(rows[:first]),
            totals(rows)):
        print(f"# {name} {gone:.6g} of {all_of_it:.6g} {unit} left out")
    print(HEADER)
    for row in rows[first:]:
        print(",".join(f"{value:.9g}" for value in row))


if __name__ == "__main__":
    sys.exit(main())
