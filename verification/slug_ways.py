#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What late slugs lose on their way through the hole: velocity over launch velocity of their cores and rims, by place.

    slug_ways.py BARRENO [RUN ...]    all, or those: verification/results/slug_ways.json, a picture, and docs/trade.md

A run is CELLS/PARTICLES, as 1.8/2 or 1.8/2+4: cells in the radius of the jet's tip, particles of the jet in a cell, along each direction,
and how often each may be divided in two. The deck is perforation.xml, to 205 us. Two to ten minutes of one core each.
"""
import argparse
import json
import math
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from barreno.runs.csv_table import read_csv
from tools.depth_shots import FORMER
from tools.runs import DECKS, run_deck
from tools.slug_ways_table import BINS, PICTURE, TIMES
from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "results" / "slug_ways.json"
RUNS = {"1.8/2": (1.8, 2, 0), "2.4/2": (2.4, 2, 0), "1.8/8": (1.8, 8, 0), "1.8/2+4": (1.8, 2, 4)}  # cells, particles, divisions
TIP, LAUNCH = 1e-3, -5e-3  # the tip's radius, and the launch plane [m]


def jet_table():
    """Rows time, velocity, radius, length, density."""
    return read_csv(DECKS / "jets" / "tungsten_320.csv").to_numpy(float).tolist()


def parts(length, cell, particles):
    """Into how many particles a length is cut, as src/state/bodies/box_divisions.cpp does."""
    return max(1, math.ceil(length / cell - 1e-9), math.floor(length / (cell / particles) + 0.5))


def slugs_of_particles(table, cell, particles):
    """For each particle of the jet, in the order of the ids: launch velocity, launch time, and its column over the number of columns."""
    import numpy as np

    rows = []
    for time, velocity, radius, length, _ in table:
        columns = parts(radius, cell, particles)
        rows += [(velocity, time, (i % columns + 0.5) / columns) for i in range(columns * parts(length, cell, particles))]
    return np.array(rows).T


def ways(finished, cells, particles, splits):
    """{time [us]: rows of place [mm], core, rim, number of particles in the core}, medians."""
    import numpy as np

    # Files keep a place for all parts of a particle, one after the other.
    velocity, launched, across = (np.repeat(of, 2**splits) for of in slugs_of_particles(jet_table(), TIP / cells, particles))
    if finished.count_of_block(1) != len(velocity):
        raise RuntimeError(f"the jet has {finished.count_of_block(1)} particles, not {len(velocity)}: slugs are cut in another way")
    times, found = finished.times(), {}
    for time in TIMES:
        now = finished.particles(int(np.argmin(np.abs(times - 1e-6 * time))), only=("status", "velocity_y"))
        count = int(np.sum(launched <= times[-1]))  # the jet's block is the first one
        here, ratio = now["status"][:count] > 0.5, now["velocity_y"][:count] / velocity[:count]
        # Where the slug would be: what digs at the bottom or lies there is not in flight.
        free = 1e3 * (LAUNCH + velocity[:count] * (1e-6 * time - launched[:count]))
        found[str(time)] = rows = []
        for low, high in zip(BINS, BINS[1:]):
            inside = here & (free >= low) & (free < high)
            core, rim = inside & (across[:count] < 0.5), inside & (across[:count] > 0.75)
            rows.append([low, high, *(float(np.median(ratio[part])) for part in (core, rim)), int(core.sum())])
    return found


def measure(barreno, cells, particles, splits):
    settings = {
        **FORMER, "Jet/Cells Per Radius": f"{cells:g}", "Jet/Particles Per Cell": str(particles), "Jet/Splits": str(splits),
        "Step/Return Losses": "false", "Output/Field Interval": "40 us", "Time/End Time": "205 us",
    }  # fmt: skip
    return ways(run_deck(barreno, "perforation.xml", settings), cells, particles, splits)


def draw(found):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7.0, 3.6))
    for k, (name, times) in enumerate(found.items()):
        cells, _, particles = name.partition("/")
        rows = times[str(TIMES[-1])]
        middle = [0.5 * (low + high) for low, high, *_ in rows]
        axes.plot(middle, [row[2] for row in rows], f"C{k}o-", label=f"core, {cells} cells per radius, {particles} particles per cell")
        axes.plot(middle, [row[3] for row in rows], f"C{k}s--", label=f"rim, {cells}, {particles}")
    axes.set(xlabel="place that free flight would have brought the slug to [mm]", ylabel="velocity over launch velocity", ylim=(0.0, 1.05))
    axes.legend(fontsize=7)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("what", nargs="*", metavar="RUN")
    options = parser.parse_args()
    unknown = [what for what in options.what if what not in RUNS]
    if unknown:
        parser.error(f"there is no {unknown[0]}; there are {', '.join(RUNS)}")
    for name in options.what or RUNS:
        found = json.loads(STORED.read_text()) if STORED.exists() else {}
        found[name] = one = measure(options.barreno.resolve(), *RUNS[name])
        print(name, one, flush=True)
        STORED.write_text(json.dumps({of: found[of] for of in RUNS if of in found}, indent=1) + "\n")
    draw(json.loads(STORED.read_text()))
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
