#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What late slugs lose on their way through the hole: velocity over launch velocity of their cores and rims, by place.

    slug_ways.py BARRENO [CELLS ...]    all, or those: verification/results/slug_ways.json, a picture, and docs/trade.md

The deck is perforation_at_rest.xml with one particle per cell in casing and rock, to 205 us. Two to ten minutes of one core each.
"""
import argparse
import json
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / folder) for folder in ("tools", "performance", "")]
import foreign_python  # noqa: E402, F401
from depth_at_rest import ONE_PARTICLE  # noqa: E402
from runs import DECKS, run_deck  # noqa: E402
from slug_ways_table import BINS, PICTURE, TIMES  # noqa: E402
from write_pages import write_pages  # noqa: E402

STORED = HERE / "results" / "slug_ways.json"
CELLS = (1.8, 2.4, 3.2)  # in the radius of the tip
TIP, PER_CELL, LAUNCH = 1e-3, 2, -5e-3  # the tip's radius [m], particles per cell and direction, launch plane [m]


def jet_table():
    """Rows time, velocity, radius, length, density."""
    rows = (line.split(",") for line in (DECKS / "jets" / "tungsten_320.csv").read_text().splitlines() if line[:1].isdigit())
    return [[float(word) for word in row] for row in rows]


def parts(length, cell):
    """Into how many particles a length is cut, as src/state/bodies/box_divisions.cpp does."""
    return max(1, math.ceil(length / cell - 1e-9), math.floor(length / (cell / PER_CELL) + 0.5))


def slugs_of_particles(table, cell):
    """For each particle of the jet, in the order of the ids: launch velocity, launch time, and its column over the number of columns."""
    import numpy as np

    rows = []
    for time, velocity, radius, length, _ in table:
        columns = parts(radius, cell)
        rows += [(velocity, time, (i % columns + 0.5) / columns) for i in range(columns * parts(length, cell))]
    return np.array(rows).T


def ways(finished, cells):
    """{time [us]: rows of place [mm], core, rim, number of particles in the core}, medians."""
    import numpy as np

    velocity, launched, across = slugs_of_particles(jet_table(), TIP / cells)
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


def measure(barreno, cells):
    settings = {**ONE_PARTICLE, "Jet/Cells Per Radius": f"{cells:g}", "Output/Field Interval": "40 us", "Time/End Time": "205 us"}
    return ways(run_deck(barreno, "perforation_at_rest.xml", settings), cells)


def draw(found):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7.0, 3.6))
    for k, (cells, times) in enumerate(found.items()):
        rows = times[str(TIMES[-1])]
        middle = [0.5 * (low + high) for low, high, *_ in rows]
        axes.plot(middle, [row[2] for row in rows], f"C{k}o-", label=f"core, {float(cells):g} cells per radius")
        axes.plot(middle, [row[3] for row in rows], f"C{k}s--", label=f"rim, {float(cells):g}")
    axes.set(xlabel="place that free flight would have brought the slug to [mm]", ylabel="velocity over launch velocity", ylim=(0.0, 1.05))
    axes.legend(fontsize=7)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("cells", nargs="*", type=float, choices=CELLS, default=CELLS)
    options = parser.parse_args()
    for cells in options.cells:
        found = json.loads(STORED.read_text()) if STORED.exists() else {}
        found[f"{cells:g}"] = one = measure(options.barreno.resolve(), cells)
        print(cells, one, flush=True)
        STORED.write_text(json.dumps({f"{size:g}": found[f"{size:g}"] for size in CELLS if f"{size:g}" in found}, indent=1) + "\n")
    draw(json.loads(STORED.read_text()))
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
