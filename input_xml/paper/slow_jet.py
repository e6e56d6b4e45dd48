#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The slow end of the jet of perforation_120us.xml, for decks that follow a shot to its end with few cells.

    slow_jet.py > slow_jet.csv

The cylinders of ../jets/tungsten_154.csv that are slower than 2500 m/s, the first one launched near time 0. Their radii are 2.0 to 2.2 mm,
twice that of the whole jet's tip, so that cells of 1 mm are half a radius. They are 0.3 to 0.5 mm long, far less than a cell, so six each
are made into one of their mass and momentum, 1.2 to 3 mm long: with the thin ones cells of 2 and 1 mm give depths that differ by a third,
with these by a tenth. Merging takes the energy of the velocity differences within a group, which main() prints.
"""
import csv  # not pandas: needs Python alone
import math
import pathlib

WHOLE = pathlib.Path(__file__).resolve().parents[1] / "jets" / "tungsten_154.csv"
FASTEST = 2500.0  # m/s
GROUP = 6
FIELDS = ("time", "velocity", "radius", "length", "density")


def slow_rows():
    """Rows of FIELDS, SI, the first at time 0."""
    with open(WHOLE, newline="") as file:
        table = list(csv.DictReader(line for line in file if not line.startswith("#")))
    slow = [[float(row[name]) for name in FIELDS] for row in table if float(row["velocity"]) < FASTEST]
    return [[time - slow[0][0], *rest] for time, *rest in slow]


def mass_of(row):
    _, _, radius, length, density = row
    return density * math.pi * radius**2 * length


def merged(rows):
    """One cylinder of the mass and momentum of several; radius and time are means by mass."""
    mass = [mass_of(row) for row in rows]
    mean = lambda values: sum(m * v for m, v in zip(mass, values)) / sum(mass)  # noqa: E731
    radius, density = math.sqrt(mean([row[2] ** 2 for row in rows])), rows[0][4]
    return [mean([row[0] for row in rows]), mean([row[1] for row in rows]), radius, sum(mass) / (density * math.pi * radius**2), density]


def energy(rows):
    return sum(0.5 * mass_of(row) * row[1] ** 2 for row in rows)


def main():
    slow = slow_rows()
    rows = [merged(slow[i : i + GROUP]) for i in range(0, len(slow), GROUP)]
    print("# units: SI")
    print(f"# Made by slow_jet.py: the cylinders of ../jets/tungsten_154.csv slower than {FASTEST:g} m/s, {GROUP} made into one")
    print(f"# mass {sum(map(mass_of, rows)):.9g} kg, kinetic energy {energy(rows):.9g} J, {energy(rows) / energy(slow) - 1.0:.2e} of it by "
        "merging")
    print(",".join(FIELDS))
    for row in rows:
        print(",".join(f"{value:.9g}" for value in row))


if __name__ == "__main__":
    main()
