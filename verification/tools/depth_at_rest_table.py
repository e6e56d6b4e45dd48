# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a jet until its hole is at rest: a section of docs/trade.md, from verification/results/depth_at_rest.json."""
import json
import statistics

from case_list import RESULTS

TIMES = (20, 60, 90, 120, 150, 200, 240, 280, 320, 360)  # us
WORDS = {"failing": "that fail", "published": "that bear any tension"}
HEAD = """## Depth at rest

Depth of `input_xml/perforation_at_rest.xml` [mm], the jet of the main job with its slow tail, at times [us]; cells per radius of the jet's
tip, one particle per cell in casing and rock. Single runs by `verification/depth_at_rest.py BARRENO`; the seconds are of a machine with
other work.
"""
SCATTER = """Scatter. Runs that should agree part, because each slug meets what the one before has left. Mean depth [mm] and standard deviation
of a single run [%], over runs whose Courant Fraction differs by 0.01:
"""
WHY = """What is lost, and to what. A late slug flies hundreds of millimetres through the hole that earlier slugs have made. Their spent
metal and grains of rock line this hole, less than two cells beside the slug, and share nodes with it. Metal that bears any tension is
then glued to them: it shears, heats, and hands its momentum to the wall long before it reaches the bottom, the more so the larger the
cells. In free flight, and beside a wall that is two cells away, a slug loses nothing ([slug_flight](verification/slug_flight.md)). Metal
that fails lets go: what is torn bears no stress while its voids are open, and the rest of the slug flies on
([slug_train](verification/slug_train.md)).

What is left. The depth at rest still grows with smaller cells. Rock is not torn: beside a wall less than two cells away a slug still
loses a part of its velocity. A contact of the jet takes this loss away, but then single particles of spent metal slide into solid rock.
So the error at rest is "unknown" in check, screen and summary. The differences above are what is known of it: the depth has grown with
every smaller size of cells so far. Two single runs must differ by three times the standard deviation of one before the difference means
anything.
"""


def runs():
    """{(metals, cells): what was measured}; and depths [mm] of runs that differ in the Courant Fraction, where at least four are"""
    found, scatter = {}, {}
    for name, one in json.loads((RESULTS / "depth_at_rest.json").read_text()).items():
        metals, cells, *courant = name.split("/")
        of = metals, float(cells)
        if not courant:
            found[of] = one
        scatter.setdefault(of, []).append([1e3 * depth for depth in one["depths"]])
    return found, {of: depths for of, depths in scatter.items() if len(depths) > 3}


def table(found):
    head = ["metals", "cells per radius", *(f"{time} us" for time in TIMES), "lost by the method", "processor time [s]"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for (metals, cells), one in found.items():
        depths = [f"{1e3 * depth:.0f}" for depth in one["depths"]]
        lines.append("| " + " | ".join([WORDS[metals], f"{cells:g}", *depths, f"{100 * one['lost']:.1f} %", f"{one['cpu_seconds']:.0f}"])
            + " |")  # fmt: skip
    return lines


def growth(found, metals, time):
    """By how much each size of cells changes the depth of the one before, in words."""
    at = TIMES.index(time)
    cells = [one for of, one in found if of == metals]
    depths = [found[metals, one]["depths"][at] for one in cells]
    return " and ".join(f"{100 * (b / a - 1.0):+.1f} % from {low:g} to {high:g}"
        for low, high, a, b in zip(cells, cells[1:], depths, depths[1:]))  # fmt: skip


def growths(found):
    """For each kind of metal of which several sizes of cells were run."""
    for metals, words in WORDS.items():
        if sum(of == metals for of, _ in found) > 1:
            yield (f"Metals {words}: by 120 us the depth changes by {growth(found, metals, 120)} cells per radius; by 320 us by "
                f"{growth(found, metals, 320)}.")  # fmt: skip


def scatter_table(scatter):
    lines = ["| metals | cells per radius | runs | " + " | ".join(f"{time} us" for time in TIMES) + " |", "|" + "---|" * (3 + len(TIMES))]
    for (metals, cells), depths in scatter.items():
        times = [f"{statistics.mean(at):.0f}, {100 * statistics.stdev(at) / statistics.mean(at):.1f} %" for at in zip(*depths)]
        lines.append(f"| {WORDS[metals]} | {cells:g} | {len(depths)} | " + " | ".join(times) + " |")
    return lines


def section():
    found, scatter = runs()
    return "\n".join([HEAD, *table(found), "", *growths(found), "", SCATTER, *scatter_table(scatter), "", WHY])
