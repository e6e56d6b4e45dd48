# SPDX-License-Identifier: BSD-3-Clause
"""What a jet did to its target: depth at a time, radius of the hole, energy that went between particles and grid."""
import numpy as np

HOLE = (20e-3, 60e-3)  # depths between which the hole's radius is a mean: behind the casing, deeper than the quick deck's jet at 20 us [m]
AROUND = 25e-3  # radius that no hole reaches [m]


def depth_at(run, time):
    """Depth of the tip [m] at a time [s], between rows of depth.csv."""
    table = run.table("depth.csv")
    return float(np.interp(time, table["time"], table["depth"]))


def share(middle, half, lower, upper):
    """Which part of [middle - half, middle + half] lies in [lower, upper]."""
    return np.clip((np.minimum(middle + half, upper) - np.maximum(middle - half, lower)) / (2.0 * half), 0.0, 1.0)


def hole_radius(run, time):
    """Mean radius [m] between the depths HOLE at the output nearest to a time [s], axisymmetric, the face at y = 0: of the
    cylinder whose volume the target lacks within AROUND. A particle is a square ring about its centre; its volume is the first
    one, of the box that it starts as, times its volume ratio."""
    start, now = run.particles(0), run.particles(int(np.argmin(np.abs(run.times() - time))))
    there = (start["status"] > 0.5) & (now["status"] > 0.5)  # the jet is not there at the start
    box = np.ptp(start["corners"][there], axis=1)
    volume = 2.0 * np.pi * start["x"][there] * box[:, 0] * box[:, 1] * now["volume_ratio"][there]
    x, y = now["x"][there], now["y"][there]
    half = 0.5 * np.sqrt(volume / (2.0 * np.pi * x))
    filled = np.sum(volume * share(x, half, 0.0, AROUND) * share(y, half, *HOLE))
    return float(np.sqrt(AROUND**2 - filled / (np.pi * (HOLE[1] - HOLE[0]))))


def between_particles_and_grid(run):
    """Energy that stress integration and transfer took, over all that was put in."""
    energy = run.summary["balances"]["energy"]
    return -(energy["stress_integration"] + energy["transfer"]) / energy["put_in"]


# Measured once, of perforation_quick.xml (to 40 us) and of perforation_120us.xml (to 120 us) with the cells named. The same program gives
# the same bits on any number of ranks; another compiler does not, and where a jet breaks up the last bit of a step decides where
# a piece of debris goes. Tolerances are at least 1.4 times what Courant Fractions of 0.8 (1 + 1e-10) and 0.80001 change: depth 0.2 %
# to 50 us, 0.9 % at 90 us, 0.3 % at the end; radius 0.2 % at 20 us, 1.4 % at 30 us, 6.5 % at the end (debris falls into the hole);
# energy 1.8 %.
# Of each: where (us), value (mm, or a part of the energy), tolerance.
END = "the end"
PINS = {
    "perforation_quick.xml": {
        "depth": [(10, 33.17, 5e-3), (20, 65.89, 5e-3), (30, 91.35, 5e-3), (END, 114.11, 5e-3)],
        "hole": [(20, 5.015, 1e-2), (30, 5.062, 3e-2), (END, 5.242, 0.08)],
        "energy": 0.0504,
    },
    "2.0 mm": {
        "depth": [(20, 65.89, 5e-3), (50, 132.90, 5e-3), (90, 182.65, 2e-2), (END, 200.35, 2e-2)],
        "hole": [(20, 5.015, 1e-2), (50, 5.053, 3e-2), (END, 4.674, 0.15)],
        "energy": 0.0771,
    },
    "1.0 mm": {
        "depth": [(20, 78.19, 5e-3), (50, 159.16, 5e-3), (90, 232.27, 2e-2), (END, 265.37, 2e-2)],
        "hole": [(20, 4.192, 1e-2), (50, 4.079, 3e-2), (END, 4.484, 0.15)],
        "energy": 0.0794,
    },
    "0.5 mm": {
        "depth": [(20, 85.33, 5e-3), (50, 181.02, 5e-3), (90, 268.20, 2e-2), (END, 317.85, 2e-2)],
        "hole": [(20, 5.308, 1e-2), (50, 5.328, 3e-2), (END, 5.283, 0.15)],
        "energy": 0.0393,
    },
}


def pinned(run, name):
    """(what, measured over pinned less 1, tolerance) for each pin of PINS[name], depths and radii in mm."""
    pins = PINS[name]
    end = run.summary["time"]
    for quantity, measure in (("depth", depth_at), ("hole", hole_radius)):
        for when, value, tolerance in pins[quantity]:
            words = f"radius of the hole at {when}" if quantity == "hole" else f"depth at {when}"
            found = 1e3 * measure(run, end if when == END else when * 1e-6)
            yield f"{name}: {words}{'' if when == END else ' us'} over {value} mm, less 1", found / value - 1.0, tolerance
    words = f"{name}: energy that stress_integration and transfer took, over {pins['energy']:.2%} of what was put in, less 1"
    yield words, between_particles_and_grid(run) / pins["energy"] - 1.0, 3e-2
