# SPDX-License-Identifier: BSD-3-Clause
"""The shot to 120 us: balances, jet audit, rank counts, depth under refinement."""
import numpy as np
from tools.case import Result
from tools.penetration import between_particles_and_grid, depth_at, hole_radius, pinned
from tools.runs import run_deck
from tools.uniform_cells import REFERENCE, depth_of

CELLS = (2.0, 1.0, 0.5)  # mm
BACK = 312.7  # mm, of the rock in the deck
TIMES = (20, 50, 90)  # us; at the end the jet of the finest cells has left the rock (300 mm)

# Depths [mm] at TIMES with uniform cells of 0.25 mm. No depth is published for this shot.
FINE = tuple(depth_of(REFERENCE, time) for time in TIMES)


def row(name, run):
    balances = run.summary["balances"]
    jet = run.summary["jet"]
    return [
        name,
        *(depth_at(run, time * 1e-6) * 1e3 if time * 1e-6 < run.summary["time"] else "" for time in TIMES),
        run.summary["penetration"]["depth"] * 1e3,
        hole_radius(run, run.summary["time"]) * 1e3,
        between_particles_and_grid(run),
        balances["mass"]["error"],
        balances["momentum"]["error"],
        balances["energy"]["error"],
        max(abs(jet[k]["launched"] / jet[k]["table"] - 1.0) for k in ("mass", "momentum", "kinetic")),
    ]


def compare_ranks(barreno, deck, settings, result):
    """Final particles on several rank counts, bit for bit."""
    first, runs = None, {}
    for ranks in (1, 2, 4):
        runs[ranks] = finished = run_deck(barreno, deck, settings, ranks=ranks)
        result.rows.append(row(f"{deck}, {ranks} ranks", finished))
        particles = finished.particles()
        values = np.stack([particles[k] for k in ("x", "y", "velocity_x", "velocity_y", "pressure")])
        if first is None:
            first = values
        else:
            same = np.array_equal(first, values, equal_nan=True)
            result.demand(f"fields on {ranks} ranks differ from those on 1 (0: same bits)", 0.0 if same else 1.0, 0.0)
    return runs[2]


def demand_pins(run, name, result):
    """The answer is what it was (penetration.py)."""
    for what, off, tolerance in pinned(run, name):
        result.demand(what, abs(off), tolerance)


def compare_depths(depths):
    """Depths at 2, 1 and 0.5 mm, each at TIMES and at the end, in words."""
    parts = []
    for i, when in enumerate([*(f"{time} us" for time in TIMES), "the end"]):
        coarse, middle, fine = (level[i] for level in depths)
        parts.append(f"{middle - coarse:.1f} and {fine - middle:.1f} mm at {when}")
    gone = [str(h) for h, level in zip(CELLS, depths) if level[-1] > BACK]
    passed = f"At the end the jet has passed the rear face of the rock at {BACK} mm with cells of {', '.join(gone)} mm." if gone else ""
    return (
        "From 2 to 1 and from 1 to 0.5 mm the depth grows by " + ", ".join(parts) + ". The jet's radius is 1.0 mm at its tip and "
        "2.2 mm at its tail, half a cell to one cell of the coarsest grid. Cells that jet and target share slow down the jet's outer "
        f"layer, which is a cell thick. {passed}"
    )


def run(barreno, full):
    result = Result(
        "Perforation",
        "The shot to 120 us on 1, 2 and 4 ranks and at three cell sizes.",
        "balances are identities, and the number of ranks must not matter. The depth has no exact answer. It is compared with its "
        "earlier value (to detect changes) and with the depth of cells of 0.25 mm.",
        ["run", *(f"depth at {time} us [mm]" for time in TIMES), "final depth [mm]",
         "final radius of the hole, 20 to 60 mm deep [mm]", "energy that stress_integration and transfer took, over what was put in",
         "mass", "axial momentum", "energy ledger", "launched against table"],
        [],
    )  # fmt: skip
    two_ranks = compare_ranks(barreno, "perforation_120us.xml" if full else "perforation_quick.xml", {}, result)
    if not full:
        demand_pins(two_ranks, "perforation_quick.xml", result)
    if full:
        depths = []
        for h in CELLS:
            settings = {"Grid/Cell Size": f"{h} mm"}
            finished = two_ranks if h == 1.0 else run_deck(barreno, "perforation_120us.xml", settings, ranks=2)
            result.rows.append(row(f"{h} mm", finished))
            depths.append(result.rows[-1][1 : 2 + len(TIMES)])
            demand_pins(finished, f"{h} mm", result)
            off = max(abs(depth / fine - 1.0) for depth, fine in zip(depths[-1], FINE))
            result.demand(f"{h} mm: depths against those with cells of 0.25 mm at {', '.join(map(str, TIMES))} us, the greatest difference",
                off, 0.02)
        result.notes = compare_depths(depths)
    result.demand("mass", max(abs(r[-4]) for r in result.rows), 1e-12)
    result.demand("axial momentum", max(abs(r[-3]) for r in result.rows), 1e-12)
    result.demand("energy ledger", max(abs(r[-2]) for r in result.rows), 1e-2)
    result.demand("launched jet against its table", max(abs(r[-1]) for r in result.rows), 1e-3)
    return result
