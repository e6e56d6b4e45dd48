# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a jet until its hole is at rest: a section of docs/trade.md, from verification/results/depth_at_rest.json."""
import json
import statistics

import slug_ways_table
from case_list import RESULTS

TIMES = (20, 60, 90, 120, 150, 200, 240, 280, 320, 360)  # us
WORDS = {
    "bounded": "the deck", "failing": "sandstone with associated flow", "published": "the same, metals that bear any tension",
    "bounded_unconfined": "no confinement", "unconfined": "sandstone with associated flow, no confinement", "continuous": "continuous jet",
    "long_slugs": "a quarter of the slugs, four times as long",
}  # fmt: skip
CONFINED = {"unconfined": "failing", "bounded_unconfined": "bounded"}
HEAD = """## Depth at rest

Depth of `input_xml/perforation_at_rest.xml` [mm], the jet of the main job with its slow tail, metals that fail and sandstone with bounded
dilatancy, at times [us]; and of variants of it. Cells per radius of the jet's tip, one particle per cell in casing and rock. Runs by `verification/depth_at_rest.py BARRENO`; the seconds are of a machine with
other work.
"""
SCATTER = """Scatter. Runs that should agree part, because each slug meets what the one before has left. Mean depth [mm] and standard deviation
of a single run [%], over runs whose Courant Fraction differs by 0.01:
"""
WAY = """What late slugs lose. A late slug flies hundreds of millimetres through the hole that earlier slugs have made. Velocity over launch
velocity at 200 us, the median of the slugs that free flight would have brought to a place (`verification/slug_ways.py BARRENO`):
"""
WHY = """![velocity over launch velocity, by place](pictures/slug_ways.png)

Single crumbs of casing, rock and spent metal float in the hole, less than two cells beside the slug, and share nodes with its rim. They
tear the rim off, and its pieces fly on more slowly in the way of the next slugs. Metal that bears any tension is glued to what it passes
instead: it shears, heats, and hands its momentum to the wall. Metal that fails lets go: what is torn bears no stress while its voids are
open, and the core of the slug flies on ([slug_train](verification/slug_train.md)). In free flight, and beside a wall that is two cells away,
a slug loses nothing ([slug_flight](verification/slug_flight.md)).

Why the depth at rest still grows with smaller cells is not known. Each of these was tried with 1.8 cells per radius, and none brings
the jet as deep as 2.4 cells do: longer slugs, and a continuous jet (above); a contact without friction between the jet and what it passes,
with one step for all; slugs that fly without the grid until something slow lies in their way; spent metal that is taken away. With long
slugs the depth grows with the cells as with short ones, and the cores of slugs lose no less with 2.4 cells than with 1.8. So neither the
flight nor the length of the slugs nor what lies at the bottom explains the growth. What is left is the rock at the bottom and along
the wall. Without confinement, where it closes the hole less, the depth grows less with the cells.

So the error at rest is "unknown" in check, screen and summary. The differences above are what is known of it: the depth has grown with
every smaller size of cells so far. Two single runs must differ by three times the standard deviation of one before the difference means
anything.
"""


def runs():
    """{(job, cells): what was measured}; and depths [mm] of runs that differ in the Courant Fraction, where at least four are"""
    found, scatter = {}, {}
    for name, one in json.loads((RESULTS / "depth_at_rest.json").read_text()).items():
        job, cells, *courant = name.split("/")
        of = job, float(cells)
        if not courant:
            found[of] = one
        scatter.setdefault(of, []).append([1e3 * depth for depth in one["depths"]])
    return found, {of: depths for of, depths in scatter.items() if len(depths) > 3}


def table(found):
    head = ["job", "cells per radius", *(f"{time} us" for time in TIMES), "lost by the method", "processor time [s]"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for (job, cells), one in found.items():
        depths = [f"{1e3 * depth:.0f}" for depth in one["depths"]]
        lines.append("| " + " | ".join([WORDS[job], f"{cells:g}", *depths, f"{100 * one['lost']:.1f} %", f"{one['cpu_seconds']:.0f}"])
            + " |")  # fmt: skip
    return lines


def growth(found, job, time):
    """By how much each size of cells changes the depth of the one before, in words."""
    at = TIMES.index(time)
    cells = [one for of, one in found if of == job]
    depths = [found[job, one]["depths"][at] for one in cells]
    return " and ".join(f"{100 * (b / a - 1.0):+.1f} % from {low:g} to {high:g}"
        for low, high, a, b in zip(cells, cells[1:], depths, depths[1:]))  # fmt: skip


def growths(found):
    """For each job of which several sizes of cells were run."""
    for job, words in WORDS.items():
        if sum(of == job for of, _ in found) > 1:
            early, late = (growth(found, job, time) for time in (120, 320))
            yield f"{words[0].upper()}{words[1:]}: by 120 us the depth changes by {early} cells per radius; by 320 us by {late}."


def falls(found):
    """What the confinement takes of the depth at rest, where both were run."""
    for job, confined in CONFINED.items():
        shares = [f"{100 * (1.0 - found[confined, cells]['depths'][-1] / one['depths'][-1]):.0f} % with {cells:g} cells per radius"
            for (of, cells), one in found.items() if of == job and (confined, cells) in found]  # fmt: skip
        if shares:
            yield f"From 0 to 69 MPa the depth at rest falls by {' and '.join(shares)} ({WORDS[confined]})."


def scatter_table(scatter):
    lines = ["| job | cells per radius | runs | " + " | ".join(f"{time} us" for time in TIMES) + " |", "|" + "---|" * (3 + len(TIMES))]
    for (job, cells), depths in scatter.items():
        times = [f"{statistics.mean(at):.0f}, {100 * statistics.stdev(at) / statistics.mean(at):.1f} %" for at in zip(*depths)]
        lines.append(f"| {WORDS[job]} | {cells:g} | {len(depths)} | " + " | ".join(times) + " |")
    return lines


def section():
    found, scatter = runs()
    lines = [HEAD, *table(found), "", *growths(found), *falls(found), "", SCATTER, *scatter_table(scatter), ""]
    return "\n".join([*lines, WAY, *slug_ways_table.table(), "", WHY])
