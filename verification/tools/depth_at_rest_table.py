# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a jet until its hole is at rest: a section of docs/trade.md, from verification/results/depth_at_rest.json."""
import json
import statistics

from scipy.optimize import brentq
from tools import depth_shots_table, slug_ways_table
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
HEAD = """## Depth at rest

Depth of `input_xml/perforation.xml` [mm], the jet of perforation_120us.xml with its slow tail, metals that fail and sandstone with bounded
dilatancy, at times [us]; and of variants of it. Cells per radius of the jet's tip; particles of the jet in a cell, along each direction, how
often each may be divided in two (+4, `Jet/Splits`), and their size at launch; one particle per cell in casing and rock. Runs by `verification/depth_at_rest.py BARRENO`; the seconds are of a machine
with other work. Rows that end early had 750 mm of sandstone and an earlier end.
"""
SCATTER = """Scatter. Runs that should agree part, because each slug meets what the one before has left. Mean depth [mm] and standard deviation
of a single run [%], over runs whose Courant Fraction differs by 0.01:
"""
WAY = """What late slugs lose on their way. A late slug flies hundreds of millimetres through the hole that
earlier slugs have made. Velocity over launch velocity at 200 us, the median of the slugs that free flight would have brought to a place
(`verification/slug_ways.py BARRENO`):
"""
WHY = """![velocity over launch velocity, by place](pictures/slug_ways.png)

Single crumbs of casing, rock and spent metal float in the hole, less than two cells beside the slug, and share nodes with its rim. They
tear the rim off, and its pieces fly on more slowly. Metal that bears any tension is glued to what it passes instead: it shears, heats, and
hands its momentum to the wall. In free flight, and beside a wall that is two cells away, a slug loses nothing
([slug_flight](verification/slug_flight.md)). With eight particles per cell crumbs and
what they tear off are small, and nearly the whole slug arrives as it was launched.

**The depth at rest follows the size of the jet's particles.** Without change of the cells it grows with the particles per cell, and rows of
particles of about one size agree although their cells differ by a factor of two. The mechanism, in an experiment of a minute
([late_train](verification/late_train.md)): the slugs of this jet are discs, 0.16 to 0.55 mm thick and 1 to 2.4 mm in radius. After 120 us the
hole is hardly wider than the slugs that dig it. A disc digs, spreads and lies at the bottom, and the next one must throw it aside. It
can do so if it is cut into layers and columns that flow past each other. A disc of one layer cannot: it folds into needles many cells long,
whose particles lose touch with each other and share nodes with whatever comes next. These collide as lumps. They heat, the motion that the
grid cannot represent is lost as energy of the method, and the pile stops what comes later. In the experiment a
continuous jet ([jets](jets.md)) depends less on its particles, since its metal arrives all the time; in the whole shot it depends on them
as much.

So a jet whose hole must come to rest needs late slugs of three layers of particles or more, or particles that are divided where they are
drawn out: `check` and runs say so where there are neither. Eight particles per cell cut slugs of 1.5 to 2.2 km/s into four layers. `Jet/Splits` ([method](method.md#15-particles-that-are-divided)) keeps the film whole instead: a particle of the jet is divided in
two where it has become wider than half a cell. In the experiment two particles per cell, divided up to four times, dig nearly as deep as
sixteen whole ones, in a fifth of the seconds. In the whole shot (rows with "+ 4") the depth then hardly depends on the cells while the jet
arrives, and far less than without division at rest.

That is not the end yet. Where particles are divided, the cells decide how deep the hole comes at last. To 280 us, when seven
tenths of it are dug, each smaller size from 1.8 cells per radius on adds 1 to 3 per cent. After that the hole goes on, and the smaller the cells, the longer: by 560 us there are 561, 654, 704 and 770 mm
with 1.2, 1.8, 2.4 and 3.2 cells per radius, and the last row still grows. The hole is thinner by as much: with 1.8 and 2.4 cells its volume
is 44.5 and 44.2 cm3, and in the experiment cells of half the size dig by three tenths deeper, with a volume that is the same within a
fortieth. The energy of the jet decides the volume. The metal that lies in the hole moves on along the axis and draws itself out; with rock
it shares about a cell beside it, which it drags along. In large cells the hole is wider and shorter for that, and the deeper part of it is
no more than two or three cells in radius. A contact without friction between jet and rock does not change it, with divided particles
neither: the rock beside the metal is as wide as the cells. In axisymmetry nothing pushes this thread of spent metal off the axis. So what the depth at rest of such a jet is
worth: to 280 us, with divided particles, the rows from 1.8 cells per radius on agree within 4 %; the volume of the hole is known; what the
hole grows after that depends on cells a fraction of the radius to which it narrows, and is not known. Before 60 us nothing of this shows: the early hole is much wider than its slugs.
"""
REST = """What divided particles cost. A part of a particle is small beside its cell and hardly resists the motion of the nodes, so that some were
squeezed to five times the density of tungsten. Their wave speed then made the step of all a fiftieth, for ten microseconds and more. Particles of such a
cell now come nearer to one pressure ([method](method.md#13-pressures-that-alternate)), which saves a quarter of the steps and more. The
rows with 1.2, 1.8 and 2.4 cells and divided particles were run with it; those with 3.2 cells, of the continuous jet and without confinement
were run before.

Theory does not bound it. By its length this jet digs 317 mm (`./barreno jet input_xml/perforation.xml`, hydrodynamic, without
strength), less than half of what is computed: its slugs are discs with gaps of a dozen lengths, each of which digs a crater of its own, and
spent metal goes on. A continuous jet of the same mass, momentum and energy, 1.8 cells per radius and divided particles, digs deeper still.

Tried before, with two particles per cell, and no cure: longer slugs, and a continuous jet (above); a contact without friction between the
jet and what it passes, with one step for all; slugs that fly without the grid until something slow lies in their way; spent metal that is
taken away. Nor, in the experiment, do the order of a step, its length, its Largest Strain or another shape function matter: with two
particles per cell none comes near the depth that eight have.

With divided particles `check`, screen, summary and report give the depth with an interval until 300 us, and that of the hole as wide as the
jet at rest. Of other jets, and of the depth later, the error is still "unknown". Two single runs must differ by three times
the standard deviation of one before the difference means anything.
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


def section():
    found, scatter = runs()
    lines = [HEAD, *table(found), "", *growths(found), *falls(found), "", *limits(found), "", SCATTER, *scatter_table(scatter), ""]
    return "\n".join([*lines, WAY, *slug_ways_table.table(), "", WHY, depth_shots_table.section(), "", REST])
