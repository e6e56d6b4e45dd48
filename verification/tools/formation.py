#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How a jet forms and digs, at some times of an axisymmetric run with a Jet Monitor: formation.py RUN PNG MICROSECONDS ...

Gas by its burnt fraction, the liner by its velocity along the axis, what it hits in two greys. For docs/pictures/jet_formation.png:

    ./barreno run input_xml/jet_formation_penetration.xml --out runs/formation --set "Grid/Cell Size=2 mm" --set "Time/End Time=28 us" --set
    "Output/Field Interval=1 us" verification/tools/formation.py runs/formation docs/pictures/jet_formation.png 4 12 20 28
"""
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from tools.runs import Run

MILLI, MICRO, KILO = 1e-3, 1e-6, 1e3
FASTEST = 8.0  # km/s at the end of the colours
WIDTH = 30.0  # mm to either side of the axis
PLAIN = {"edgecolors": "none", "linewidths": 0, "antialiased": False, "rasterized": True}


def parts_of(run):
    """Which particles are gas, liner and target: by what burns, and by the side of the monitor's plane they start on."""
    start = run.particles(0)
    plane = run.summary["formed_jet"]
    behind = plane["direction"] * (start["y"] - plane["position"]) < 0.0
    gas = np.isfinite(start["burn"])
    return gas, ~gas & behind, ~gas & ~behind


def both_sides(corners):
    return np.concatenate([corners, corners * np.array([-1.0, 1.0])])


def draw(axes, state, parts):
    """One instant; what the colours of gas and liner are of."""
    gas, liner, target = (part & (state["status"] > 0.5) for part in parts)
    corners = state["corners"] / MILLI
    burnt = PolyCollection(both_sides(corners[gas]), array=np.tile(state["burn"][gas], 2), cmap="YlOrBr", **PLAIN)
    burnt.set_clim(0.0, 2.5)
    solid = np.isfinite(state["plastic_volume_strain"]) if "plastic_volume_strain" in state else np.zeros_like(target)
    for which, colour in ((target & ~solid, "0.45"), (target & solid, "0.8")):
        axes.add_collection(PolyCollection(both_sides(corners[which]), facecolor=colour, **PLAIN))
    axes.add_collection(burnt)
    metal = PolyCollection(both_sides(corners[liner]), array=np.tile(state["velocity_y"][liner] / KILO, 2), cmap="viridis", **PLAIN)
    metal.set_clim(0.0, FASTEST)
    axes.add_collection(metal)
    return metal


def main():
    run, file, wanted = Run(sys.argv[1]), sys.argv[2], [float(time) for time in sys.argv[3:]]
    times, parts = run.times() / MICRO, parts_of(run)
    steps = [int(np.argmin(np.abs(times - time))) for time in wanted]
    states = [run.particles(step) for step in steps]
    everything = np.concatenate([state["y"][state["status"] > 0.5] for state in states[:1]]) / MILLI
    figure, panels = plt.subplots(1, len(steps), figsize=(2.6 * len(steps) + 1.2, 7.5), sharey=True, layout="constrained")
    for axes, step, state in zip(panels, steps, states):
        shown = draw(axes, state, parts)
        axes.set(xlim=(-WIDTH, WIDTH), ylim=(everything.min() - 15.0, everything.max() + 5.0), aspect="equal", xlabel="mm")
        axes.set_title(f"{times[step]:.3g} µs", fontsize=11)
    panels[0].set_ylabel("along the axis [mm]")
    figure.colorbar(shown, ax=list(panels), label="velocity of the liner along the axis [km/s]", extend="max", pad=0.01)
    figure.savefig(file, dpi=110)


if __name__ == "__main__":
    main()
