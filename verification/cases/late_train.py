# SPDX-License-Identifier: BSD-3-Clause
"""Late slugs of a jet dig into sandstone one after the other: the depth follows the number of particles in a slug."""
from barreno.runs.csv_table import read_csv
from tools.case import Result
from tools.penetration import between_particles_and_grid
from tools.runs import DECKS, run_deck

DECK = "perforation.xml"
TABLE = DECKS / "jets" / "tungsten_320.csv"
FASTEST, SLOWEST = 2200.0, 1500.0  # of the slugs [m/s]
FAR = 0.5  # the bottom that they reach in the shot, from the virtual origin [m]
END = {False: 60.0, True: 160.0}  # us
ROCK = {False: 90.0, True: 180.0}  # its rear [mm]
FREE = {  # the jet slides on the rock and leaves it; steps of several lengths know no contact
    "Contact/Jet on rock/Material": "Tungsten", "Contact/Jet on rock/Other Material": "Sandstone",
    "Contact/Jet on rock/Kind": "frictionless", "Step/Subcycles": "1",
}  # fmt: skip
KINDS = {
    "discrete": {"Jet/Kind": "discrete"}, "continuous": {"Jet/Kind": "continuous"},
    "discrete, contact": {"Jet/Kind": "discrete", **FREE},
}  # fmt: skip
CELLS = 3.6  # in the radius of a slug, as with 1.8 in the radius of the jet's tip
RUNS = {  # kind, cells, particles per cell, splits
    False: [("discrete", CELLS, 2, 0), ("discrete", CELLS, 8, 0), ("discrete", CELLS, 2, 4), ("continuous", CELLS, 2, 0),
        ("continuous", CELLS, 4, 0)],
    True: [*(("discrete", CELLS, particles, 0) for particles in (2, 4, 8, 16)), ("discrete", 2.0 * CELLS, 2, 0),
        ("discrete", CELLS, 2, 3), ("discrete", CELLS, 2, 4), ("discrete", CELLS, 4, 4), ("discrete", 2.0 * CELLS, 2, 4),
        ("discrete, contact", CELLS, 2, 4), *(("continuous", CELLS, particles, 0) for particles in (2, 4, 8)), ("continuous", CELLS, 2, 4)],
}  # fmt: skip


def late_slugs():
    """Rows time, velocity, radius, length, density; the times are those of arrival at FAR after free flight."""
    rows = read_csv(TABLE).to_numpy(float).tolist()
    late = [row for row in rows if SLOWEST <= row[1] <= FASTEST]
    first = FAR / late[0][1]
    return [[FAR / row[1] - first, *row[1:]] for row in late]


def settings_of(kind, cells, particles, splits, full):
    slugs = late_slugs()
    table = ",".join(f"{value:.9g}" for row in slugs for value in row)
    return {
        "Bodies/Casing": "", "Confinement/Bodies": "{Rock}",
        "Bodies/Rock/Upper": f"{{35 mm, {ROCK[full]:g} mm}}", "Grid/Upper": f"{{40 mm, {ROCK[full] + 20.0:g} mm}}", "Jet/Table": "",
        "Jet/Slugs": f"{len(slugs)}x5:{{{table}}}", "Jet/Launch Position": "-20 mm", "Jet/Cells Per Radius": f"{cells:g}",
        "Jet/Particles Per Cell": str(particles), "Jet/Splits": str(splits), "Time/End Time": f"{END[full]:g} us",
        "Output/Field Interval": "0 us", "Step/Return Losses": "false", **KINDS[kind],
    }  # fmt: skip


def run(barreno, full):
    result = Result(
        "Late slugs in their hole",
        "Slugs that arrive late dig a hole hardly wider than themselves, one on top of what is left of the other. A slug that is cut into "
        "enough particles flows aside; the depth then no longer depends on them.",
        f"The finest particles. The slugs of perforation.xml from {FASTEST:g} to {SLOWEST:g} m/s, 0.26 to 0.31 mm thick and 2.0 to "
        f"2.2 mm in radius, reach fresh sandstone under 69 MPa as they reach the bottom at {1e3 * FAR:g} mm in the shot; {END[full]:g} us.",
        ["kind", "cells per radius", "particles per cell", "splits", "their size [mm]", "depth [mm]", "volume of the hole [cm3]",
         "energy lost by the method", "steps",
         "processor time [s]"],
        [],
    )  # fmt: skip
    depths, volumes, losses = {}, {}, {}
    for kind, cells, particles, splits in RUNS[full]:
        finished = run_deck(barreno, DECK, settings_of(kind, cells, particles, splits, full))
        summary, lost = finished.summary, between_particles_and_grid(finished)
        if cells == CELLS:
            losses[kind, particles, splits] = lost
        depth = depths[kind, cells, particles, splits] = 1e3 * summary["penetration"]["depth"]
        volume = volumes[kind, cells, particles, splits] = 1e6 * summary["penetration"]["channel_volume"]
        size = 1e3 * late_slugs()[0][2] / cells / particles
        result.rows.append([kind, cells, particles, splits, size, depth, volume, lost, summary["steps"], summary["cpu_seconds"]])
    change = lambda kind, few, many: abs(depths[kind, CELLS, many, 0] / depths[kind, CELLS, few, 0] - 1.0)  # noqa: E731
    divided = lambda cells, particles, splits, finest: abs(  # noqa: E731
        depths["discrete", cells, particles, splits] / depths["discrete", *finest] - 1.0)
    if full:
        result.demand("discrete, from 8 to 16 particles per cell: change of the depth", change("discrete", 8, 16), 0.03)
        result.demand("continuous, from 4 to 8 particles per cell: change of the depth", change("continuous", 4, 8), 0.03)
        half = divided(2.0 * CELLS, 2, 0, (CELLS, 4, 0))
        result.demand("discrete, the same particles in cells of half the size: change of the depth", half, 0.05)
        finest = CELLS, 16, 0
        for particles, limit in ((2, 0.1), (4, 0.05)):
            result.demand(f"discrete, divided up to 4 times, {particles} particles per cell against 16 whole ones: depth",
                divided(CELLS, particles, 4, finest), limit)
        result.demand("discrete, divided up to 4 times, cells of half the size: change of the depth",
            divided(2.0 * CELLS, 2, 4, (CELLS, 4, 4)), 0.03)
        fine, coarse = volumes["discrete", 2.0 * CELLS, 2, 4], volumes["discrete", CELLS, 2, 4]
        result.demand("discrete, divided up to 4 times, cells of half the size: change of the hole's volume",
            abs(fine / coarse - 1.0), 0.05)
    else:
        result.demand("continuous, from 2 to 4 particles per cell: change of the depth", change("continuous", 2, 4), 0.03)
    whole = losses["discrete", 2, 0]
    result.demand("discrete: energy lost with 8 particles per cell over that with 2", losses["discrete", 8, 0] / whole, 0.6)
    result.demand("discrete: energy lost with 2 particles per cell that are divided over that with 2",
        losses["discrete", 2, 4] / whole, 0.75)  # fmt: skip
    result.notes = (
        "A disc of one layer of particles folds into needles many cells long, which collide as lumps: the method loses energy and the pile "
        "at the bottom stops what comes later. Four layers, and columns as fine, flow past each other. So do particles that are "
        "divided in two where they have become wider than half a cell (`Jet/Splits`), at a fraction of the price. A continuous jet of the "
        "same mass needs fewer particles. In smaller cells the hole is deeper and thinner: its volume is the same. The energy of the jet "
        "decides the volume; how far metal reaches into the rock beside it, about a cell, decides how long it is. A contact without "
        "friction between jet and rock costs several times the steps and makes the hole no deeper: it is no default."
    )
    return result
