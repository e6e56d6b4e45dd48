# SPDX-License-Identifier: BSD-3-Clause
"""Runs that show why the depth at rest grew with smaller cells: verification/results/depth_at_rest_runs.md, from depth_at_rest.json."""
import json
import statistics

from scipy.optimize import brentq

from tools.case_list import RESULTS

TIMES = (20, 60, 90, 120, 150, 200, 240, 280, 320, 360, 420, 480, 560)  # us
COMMON = 360  # us: the end of the shortest runs
TIP = 1.0  # radius [mm]
WORDS = {
    "bounded": "the deck", "failing": "sandstone with associated flow", "published": "the same, metals that bear any tension",
    "bounded_unconfined": "no confinement", "unconfined": "sandstone with associated flow, no confinement", "continuous": "continuous jet",
    "long_slugs": "a quarter of the slugs, four times as long",
}  # fmt: skip
CONFINED = {"unconfined": "failing", "bounded_unconfined": "bounded"}
HEAD = """# Runs to rest

Every run behind "Why it follows the cells" of [trade.md](../../docs/trade.md#depth-at-rest). Depth of `input_xml/perforation.xml` [mm] at
times [us], and of variants of it; by `verification/depth_at_rest.py BARRENO`, do not edit by hand. Cells per radius of the jet's tip;
particles of the jet in a cell, along each direction, how often each may be divided in two (+4, `Jet/Splits`), and their size at launch; one
particle per cell in casing and rock. The seconds are of a machine with other work. Rows that end early had 750 mm of sandstone and an
earlier end. Rows with 1.2, 1.8 and 2.4 cells and divided particles were run with pressures that particles of one cell share
([method](../../docs/method.md#13-pressures-that-alternate)), the others before.
"""
TRIED = """## Tried

With two particles per cell, and no cure: longer slugs, and a continuous jet (above); a contact without friction between the jet and what it
passes, with one step for all; slugs that fly without the grid until something slow lies in their way; spent metal that is taken away. Nor,
in the experiment of [late_train](../../docs/verification/late_train.md), do the order of a step, its length, its Largest Strain or another
shape function matter: with two particles per cell none comes near the depth that eight have. With divided particles a contact makes the
hole of that experiment no deeper.
"""
SCATTER = """Scatter. Runs that should agree part, because each slug meets what the one before has left. Mean depth [mm] and standard deviation
of a single run [%], over runs whose Courant Fraction differs by 0.01:
"""


def runs():
    """{(job, cells, (particles, splits)): what was measured}; and depths [mm] of runs that differ in the Courant Fraction, where at least
    four are"""
    found, scatter = {}, {}
    for name, one in json.loads((RESULTS / "depth_at_rest.json").read_text()).items():
        job, cells, particles, *courant = name.split("/")
        per_cell, _, splits = particles.partition("+")
        of = job, float(cells), (int(per_cell), int(splits or 0))
        if not courant:
            found[of] = one
        scatter.setdefault(of, []).append([1e3 * depth for depth in one["depths"]])
    return found, {of: depths for of, depths in scatter.items() if len(depths) > 3}


def in_words(particles, splits):
    return f"{particles} + {splits}" if splits else str(particles)


def row(of, one):
    job, cells, (particles, splits) = of
    depths = [f"{1e3 * depth:.0f}" for depth in one["depths"]]
    depths += [""] * (len(TIMES) - len(depths))
    return [WORDS[job], f"{cells:g}", in_words(particles, splits), f"{TIP / cells / particles:.3f}", *depths, f"{100 * one['lost']:.1f} %",
        f"{one['cpu_seconds']:.0f}"]  # fmt: skip


def table(found):
    head = ["job", "cells per radius", "particles per cell", "their size [mm]", *(f"{time} us" for time in TIMES), "lost by the method",
        "processor time [s]"]  # fmt: skip
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    by_size = sorted(found, key=lambda of: (list(WORDS).index(of[0]), of[2][1], of[1] * of[2][0]))
    return lines + ["| " + " | ".join(row(of, found[of])) + " |" for of in by_size]


def at(one, time):
    return one["depths"][TIMES.index(time)]


def growth(found, job, splits, time):
    """By how much smaller particles of the jet change the depth, in words."""
    sizes = sorted(((TIP / cells / how[0], cells, how) for of, cells, how in found if of == job and how[1] == splits), reverse=True)
    depths = [at(found[job, cells, how], time) for _, cells, how in sizes]
    return ", ".join(f"{100 * (b / a - 1.0):+.1f} % from {coarse[0]:.3f} to {fine[0]:.3f} mm"
        for coarse, fine, a, b in zip(sizes, sizes[1:], depths, depths[1:]))  # fmt: skip


def growths(found):
    """For each job that was run with several sizes of the jet's particles."""
    for job, splits in sorted({(job, how[1]) for job, _, how in found}, key=lambda of: (list(WORDS).index(of[0]), of[1])):
        if sum(of == job and how[1] == splits for of, _, how in found) > 1:
            early, late = (growth(found, job, splits, time) for time in (120, COMMON))
            job_words = WORDS[job][0].upper() + WORDS[job][1:] + (f", divided up to {splits} times" if splits else "")
            yield f"{job_words}, with smaller particles: by 120 us the depth changes by {early}; by {COMMON} us by {late}."


def order(sizes, depths):
    """Order p and limit D of depths D - C h^p of three sizes h, coarse to fine; nothing where they do not approach a limit."""
    (a, b, c), (first, second, third) = sizes, depths
    ratio = (second - first) / (third - second)
    off = lambda p: (a**p - b**p) / (b**p - c**p) - ratio  # noqa: E731
    if not off(0.1) * off(8.0) < 0.0:
        return None
    p = brentq(off, 0.1, 8.0)
    return p, third + (third - second) * c**p / (b**p - c**p)


def limits(found):
    """What depths at the end tend to with smaller cells, where particles are divided and at least three sizes of cells were run."""
    for job, how in sorted({(job, how) for job, _, how in found if how[1]}, key=lambda of: (list(WORDS).index(of[0]), of[1])):
        cells = sorted(size for of, size, particles in found if (of, particles) == (job, how))
        ends = [1e3 * found[job, size, how]["depths"][-1] for size in cells]
        if len(cells) < 3 or any(len(found[job, size, how]["depths"]) < len(TIMES) for size in cells):
            continue
        rows = ", ".join(f"{end:.0f} mm with {size:g}" for size, end in zip(cells, ends))
        approach = order([1.0 / size for size in cells[-3:]], ends[-3:])
        tends = "the last three do not tend to a limit" if approach is None else (
            f"the last three tend with order {approach[0]:.1f} to {approach[1]:.0f} mm, of which the smallest cells lack "
            f"{100 * (1.0 - ends[-1] / approach[1]):.1f} %")  # fmt: skip
        words = f"{WORDS[job][0].upper()}{WORDS[job][1:]}, {in_words(*how)} particles per cell"
        yield f"**{words}: by {TIMES[-1]} us {rows} cells per radius; {tends}.**"


def falls(found):
    """What the confinement takes of the depth, where both were run."""
    for job, confined in CONFINED.items():
        shares = [f"{100 * (1.0 - at(found[confined, *how], COMMON) / at(one, COMMON)):.0f} % with {how[0]:g} cells per radius and "
            f"{in_words(*how[1])} particles per cell"
            for (of, *how), one in found.items() if of == job and (confined, *how) in found]  # fmt: skip
        if shares:
            yield f"From 0 to 69 MPa the depth at {COMMON} us falls by {' and '.join(shares)} ({WORDS[confined]})."


def scatter_table(scatter):
    head = ["job", "cells per radius", "particles per cell", "runs", *(f"{time} us" for time in TIMES)]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for (job, cells, particles), depths in scatter.items():
        times = [f"{statistics.mean(at):.0f}, {100 * statistics.stdev(at) / statistics.mean(at):.1f} %" for at in zip(*depths)]
        times += [""] * (len(TIMES) - len(times))
        lines.append(f"| {WORDS[job]} | {cells:g} | {in_words(*particles)} | {len(depths)} | " + " | ".join(times) + " |")
    return lines


def page():
    found, scatter = runs()
    lines = [HEAD, *table(found), "", *growths(found), *falls(found), "", *limits(found), "", "## Scatter", "", SCATTER,
        *scatter_table(scatter), "", TRIED]
    return "\n".join(lines)
