#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a step costs on many ranks, by a model of its messages; `verification/pages.py --write` puts it into docs/performance.md.

Sizes of messages follow from the code (src/grid/patch.cpp, halo.cpp); what scaling.py has counted on two ranks is compared with
them. Memory and set-up of a rank are lines through what many_ranks.py has counted on 1 to 16 ranks, extrapolated. Speeds of the machine are
assumptions, stated in the table.
"""
import json
import math
import pathlib
import re

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
COUNTED = ROOT / "verification" / "results" / "scaling.json"
COUNTED_ON_MANY = ROOT / "verification" / "results" / "many_ranks.json"
SIZES = ROOT / "src" / "scene" / "scene_size.cpp"
GRID = ROOT / "src" / "deck" / "sections" / "grid_section.hpp"

NODE_BYTES = 8 * 8  # sum_components doubles
REACH = 1  # nodes beyond a tile's cells, of GIMP
NANOSECONDS = {2: 120.0, 3: 150.0}  # of a particle-step, all ranks of a node busy
LATENCY = 2e-6  # s, of a message and of a stage of a reduction
BANDWIDTH = 1e9  # bytes/s and rank, when all ranks of a node send
DISK = 0.9e9  # bytes/s that one rank packs, writes and checks: 0.5 to 1 in runs of checkpoint_cost.py
FILE_SYSTEM = 1e11  # bytes/s that the file system takes from all ranks
REDUCTIONS = 3  # per step: the step, the largest strain, and failures where a policy is to stop
STATE_BYTES = {2: 285.0, 3: 420.0}  # per particle, in a checkpoint about
MOST_VALUES = 2**31  # of one gathered field


TILE_CELLS = 8  # along each axis (src/scene/tile_size.hpp)


def size_constant(name):
    """A constant of src/scene/scene_size.cpp."""
    words = re.search(rf"constexpr double {name} = ([\d./ ]+);", SIZES.read_text()).group(1)
    over, _, under = words.partition("/")
    return float(over) / float(under or 1.0)


def parcels(tiles):
    """Parcels of a box of so many tiles (src/grid/parcels.hpp), at most."""
    shift = re.search(r"most_parcels = std::size_t\{1\} << (\d+)U;", GRID.read_text()).group(1)
    return min(tiles, 2 ** int(shift))


def box_bytes(tiles):
    """What every rank keeps of the whole box, of cells of one size."""
    return size_constant("bytes_per_parcel") * parcels(tiles) + size_constant("bytes_per_place") * tiles


def line_through(counts, quantity):
    """Least relative errors of a + b n over the ranks, n the particles of a rank. @return a, b, largest relative error"""
    n, counted = (np.array([row[name] for row in counts], dtype=float) for name in ("largest_rank_particles_made", quantity))
    b, a = np.polyfit(n, counted, 1, w=1.0 / counted)
    return a, b, np.max(np.abs((a + b * n) / counted - 1.0))


def lines_of_counts():
    """The counts of many_ranks.py, and the lines of memory and of places looked at through them."""
    counts = json.loads(COUNTED_ON_MANY.read_text())
    return counts, line_through(counts, "largest_rank_peak_bytes"), line_through(counts, "largest_rank_candidate_points")


PATCH_NODES = TILE_CELLS + 1 + 2 * REACH  # along an axis
SHARED = 1 + 2 * REACH  # of them, those that the patch of the tile beside it has too


def border_bytes(d):
    """Sums of the nodes that a tile shares with one across a face."""
    return SHARED * PATCH_NODES ** (d - 1) * NODE_BYTES


def particles_per_tile(d):
    return TILE_CELLS**d * 2**d


def halo_bytes(d, particles):
    """Of a cube of tiles inside many others: what it shares with tiles across its faces, edges and corners."""
    side = (particles / particles_per_tile(d)) ** (1.0 / d)
    return sum(
        2**k * math.comb(d, k) * side ** (d - k) * SHARED**k * PATCH_NODES ** (d - k) * NODE_BYTES for k in range(1, d + 1)
    )


def step(d, particles, ranks):
    """Parts of a step [s] on a rank with so many particles; one velocity field."""
    halo = halo_bytes(d, particles) if ranks > 1 else 0.0
    messages = min(ranks - 1, 3**d - 1)
    return {
        "bytes": halo,
        "messages": messages,
        "computing": 1e-9 * NANOSECONDS[d] * particles,
        "halo": messages * LATENCY + halo / BANDWIDTH,
        "reductions": REDUCTIONS * LATENCY * math.ceil(math.log2(ranks)) if ranks > 1 else 0.0,
    }


def seconds(parts):
    return parts["computing"] + parts["halo"] + parts["reductions"]


def row(d, particles, ranks, efficiency):
    _, memory, places = lines_of_counts()
    parts = step(d, particles, ranks)
    total = particles * ranks
    tiles = total / particles_per_tile(d)
    components = d * d + (1 if d == 2 else 0)  # of the deformation gradient, the widest field
    gathered = 8.0 * components * total
    of_box = box_bytes(tiles)
    of_rank = memory[0] + memory[1] * particles + of_box
    return (f"| {d}D | {ranks:,} | {particles:,.0f} | {total:.0e} | {1e-6 * parts['bytes']:.2f} | {parts['messages']} | "
        f"{1e3 * parts['computing']:.3f} "
            f"| {1e3 * parts['halo']:.3f} | {1e3 * parts['reductions']:.3f} | {efficiency:.2f} | {1e-9 * of_box:.2g} | "
            f"{1e-9 * of_rank:.2g} "
            f"| {1e-9 * gathered:.2g}{' (too many)' if components * total > MOST_VALUES else ''} | "
            f"{STATE_BYTES[d] * total / min(ranks * DISK, FILE_SYSTEM):.2g} "
            f"| {places[0] + places[1] * particles:.0e} | {tiles:.0e} | {parcels(tiles):.0e} |")  # fmt: skip


def predictions():
    lines = ["Columns with *rank* are per rank, halo and times per step. *Box, GB*: memory for the whole box on every rank. *Field, GB*: "
        "the widest field "
             "on rank 0. *Places*: places that a rank looks at during set-up.", "",
             "| mode | ranks | particles per rank | particles | halo per rank, MB | messages | computing, ms | halo, ms | reductions, ms | "
             "efficiency | box, GB "
             "| memory per rank, GB | field, GB | checkpoint, s | places | tiles of the box | parcels |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for d in (2, 3):
        for ranks in (1000, 100000):  # weak: as many on every rank
            particles = 1e6
            lines.append(row(d, particles, ranks, step(d, particles, 1)["computing"] / seconds(step(d, particles, ranks))))
    for d, total in ((2, 1e8), (3, 1e8)):  # strong: the same in all
        for ranks in (1000, 100000):
            particles = total / ranks
            lines.append(row(d, particles, ranks, step(d, particles, 1)["computing"] / seconds(step(d, particles, ranks))))
    return lines


def across(name):
    """Dimension, and tiles along the cuts between two ranks, of the runs that scaling.py counts: of the perforation one rank has a
    slab out of the middle, so there are two cuts."""
    if name.startswith("elastic block"):
        cells = [int(n) for n in name.split(",")[1].split()[0].split("x")]
        return 3, math.ceil(cells[0] / TILE_CELLS) * math.ceil(cells[2] / TILE_CELLS)
    return 2, 2 * math.ceil(50.8 / TILE_CELLS)


def comparison():
    lines = ["Model and counts on two ranks, per step and rank. The model has one more pair of reductions for each row of history.csv.", "",
             "| run | KB, model | KB, counted | messages, model | counted | reductions, model | counted |",
             "|---|---|---|---|---|---|---|"]  # fmt: skip
    for m in json.loads(COUNTED.read_text())["messages"]:
        d, tiles = across(m["name"])
        lines.append(f"| {m['name']} | {1e-3 * tiles * border_bytes(d):.1f} | {1e-3 * m['bytes']:.1f} | 1 | {m['messages']:.2f} "
                     f"| 2 (+ 2 per row) | {m['reductions']:.2f} |")  # fmt: skip
    return lines


def fits():
    """Lines through the counts of many_ranks.py, beside the counts."""
    counts, (a, b, worst), (c, d, off) = lines_of_counts()
    lines = ["Counts on 1 to 16 ranks (many_ranks.py, three dimensions), and lines through them. With n particles of a rank the lines are",
             f"{1e-6 * a:.0f} MB + {b:.0f} bytes n for the memory (within {100 * worst:.0f} %) and {c:,.0f} + {d:.2f} n for the places "
             f"looked at (within {100 * off:.0f} %).", "",
             "| ranks | particles of a rank | MB, line | MB, counted | places, line | places, counted |",
             "|---|---|---|---|---|---|"]  # fmt: skip
    for row in counts:
        n = row["largest_rank_particles_made"]
        lines.append(f"| {row['ranks']} | {n:,} | {1e-6 * (a + b * n):.0f} | {1e-6 * row['largest_rank_peak_bytes']:.0f} | "
            f"{c + d * n:,.0f} | {row['largest_rank_candidate_points']:,} |")
    return [*lines, ""]


def assumed():
    """What the model takes for given."""
    return ["| parameter | value | from |", "|---|---|---|",
            f"| t_p | {NANOSECONDS[2]:.0f} ns (2D), {NANOSECONDS[3]:.0f} ns (3D) per particle-step, all ranks of a node busy | assumed; a "
            "single rank needs less |",
            f"| alpha, beta | {1e6 * LATENCY:.0f} us; {1e-9 * BANDWIDTH:.0f} GB/s for each rank when all ranks of a node send | assumed, "
            "typical of a cluster |",
            f"| checkpoint | {1e-9 * DISK:.1f} GB/s from each rank, {1e-9 * FILE_SYSTEM:.0f} GB/s in all | assumed: the first of the order "
            "measured on two ranks (below), the second of a parallel file system |", ""]  # fmt: skip


def stored_part():
    return [*assumed(), *(comparison() if COUNTED.exists() else []), "", *fits(), *predictions()]


if __name__ == "__main__":
    print("\n".join(stored_part()))
