# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a jet whose hole is at rest: a section of docs/trade.md, from results files."""
from tools import depth_at_rest_runs, depth_shots_table, slug_ways_table

COMMON = depth_at_rest_runs.COMMON
STAGES = (  # what was changed one after the other: words, job, particles of the jet per cell and divisions
    ("metal that bears any tension, two particles of the jet in a cell along each direction", "published", (2, 0)),
    ("metal that breaks, the same particles", "bounded", (2, 0)),
    ("metal that breaks, four particles", "bounded", (4, 0)),
    ("metal that breaks, two particles, each divided up to four times", "bounded", (2, 4)),
)
WHY = f"""### Why it follows the cells

Depth [mm] of the former rock at {COMMON} us, by what was changed ([all runs](../verification/results/depth_at_rest_runs.md)):
"""
WAY = """The first {low:g} us are the same in all rows. Late slugs make the difference. Each flies hundreds of millimetres through the hole that
earlier slugs have made, which is hardly wider than it is, and then digs at a bottom where spent metal lies. Velocity over launch velocity at
200 us, the median of the slugs that free flight would have brought to a place (`verification/slug_ways.py BARRENO`):
"""
CAUSES = """![velocity over launch velocity, by place](pictures/slug_ways.png)

Three things take depth from late slugs, in the order in which they were found:

1. *Metal that bears any tension.* It is glued to what it passes, less than two cells beside it: it shears, heats, and hands its momentum to
   the wall. Metal that breaks tears there. In free flight, and beside a wall that is two cells away, a slug loses nothing
   ([slug_flight](verification/slug_flight.md)).
2. *Discs of one layer of particles.* The slugs are discs, 0.16 to 0.55 mm thick and 1 to 2.4 mm in radius. A disc digs, spreads and lies at
   the bottom, and the next one must throw it aside. It can do so if it is cut into layers and columns that flow past each other. A disc of
   one layer cannot: it folds into needles many cells long, whose particles lose touch with each other and share nodes with whatever comes
   next. These collide as lumps, and the pile stops what comes later ([late_train](verification/late_train.md)). So the depth followed the
   size of the jet's particles, whatever the cells. `Jet/Splits` ([method](method.md#15-particles-that-are-divided)) keeps the film whole: a
   particle is divided in two where it has become wider than half a cell.
3. *The cells.* Spent metal draws itself out along the axis into a thread two or three cells in radius, and drags along the rock beside it,
   about a cell wide. In smaller cells the thread is longer and thinner: by {end} us the tip is at {ends} mm with {cells} cells per
   radius. In axisymmetry nothing pushes it off the axis. The volume of the hole, which the energy of the jet decides, stays.

The first two are cured by the cards of metals that fail and by the fidelities, which divide particles: with 1.8 cells per radius and
particles divided up to four times (2+4) nearly the whole slug arrives as it was launched, as it does with eight particles. The third is a limit of cells that
jet and rock share: the thread's length is not known, and the answers above leave it out.

*No contact by default.* A contact gives the jet a velocity field of its own. With metal that bears any tension it cured the loss in flight.
With divided particles it makes the hole no deeper and takes several times the steps, because steps of several lengths know no contact
(late_train, row *discrete, contact*). So a deck with a jet has none unless it asks for one.
"""
END = """### What theory says

Theory does not bound this depth. By its length the jet digs 317 mm (`./barreno jet input_xml/perforation.xml`, hydrodynamic, without
strength), about half of what is computed: its slugs have gaps of a dozen lengths, each digs a crater of its own, and spent metal
goes on. Rods of metal show the same: ten rods with gaps dig half as deep again as one of the same length
([rod_train](verification/rod_train.md)).

With divided particles `check`, screen, summary and report give the depth with an interval until {rest} us and at rest. Of other jets, and
of a run that goes on after {rest} us and does not come to rest, the error is "unknown". Two single runs must differ by three times the
standard deviation of one before the difference means anything.
"""


def stages():
    """Depths of each stage with every size of cells, and what the last smaller size adds."""
    found, _ = depth_at_rest_runs.runs()
    sizes = sorted({cells for job, cells, how in found if (job, how) in {(job, how) for _, job, how in STAGES}})
    lines = ["| what | " + " | ".join(f"{size:g} cells per radius" for size in sizes) + " | with the last smaller cells |",
        "|---|" + "---|" * (len(sizes) + 1)]  # fmt: skip
    for words, job, how in STAGES:
        depths = {size: 1e3 * depth_at_rest_runs.at(found[job, size, how], COMMON) for size in sizes if (job, size, how) in found}
        *_, before, last = [None, *depths.values()]
        change = f"{100 * (last / before - 1.0):+.0f} %" if before else ""
        lines.append(f"| {words} | " + " | ".join(f"{depths[size]:.0f}" if size in depths else "" for size in sizes) + f" | {change} |")
    return lines


def causes():
    """With the ends of threads whose particles are divided."""
    found, _ = depth_at_rest_runs.runs()
    _, job, how = STAGES[-1]
    ends = {cells: found[job, cells, how]["depths"] for of, cells, particles in sorted(found) if (of, particles) == (job, how)}
    whole = {cells: f"{1e3 * depths[-1]:.0f}" for cells, depths in ends.items() if len(depths) == len(depth_at_rest_runs.TIMES)}
    return CAUSES.format(end=depth_at_rest_runs.TIMES[-1], ends=depth_shots_table.listed(list(whole.values())),
        cells=depth_shots_table.listed([f"{cells:g}" for cells in whole]))  # fmt: skip


def section():
    lines = [depth_shots_table.answer(), WHY, *stages(), "", WAY.format(low=60), *slug_ways_table.table(), "", causes()]
    return "\n".join([*lines, depth_shots_table.trials_section(), END.format(rest=depth_shots_table.REST)])
