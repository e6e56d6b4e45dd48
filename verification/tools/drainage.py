#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pore pressure around a perforation, early and late, and what has drained: drainage.py RUN PNG.

For docs/pictures/perforation_drainage.png:

    ./barreno run input_xml/perforation_drainage.xml --out runs/drainage
    ./barreno python verification/tools/drainage.py runs/drainage docs/pictures/perforation_drainage.png
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

EARLY = 0.1e-3  # s, when the jet has stopped
MILLI, MEGA = 1e-3, 1e6
MOST = 40.0  # MPa at the end of the colours


def times_of(run):
    return [run.particles(step)["time"] for step in range(run.instants())]


def draw_half(axes, state, mirror):
    """Corners of the particles in mm, mirrored or not; dry materials grey."""
    alive = state["status"] > 0.5
    corners = state["corners"][alive] / MILLI * np.array([mirror, 1.0])
    pressure = state["pore_pressure"][alive] / MEGA
    wet = np.isfinite(pressure)
    axes.add_collection(PolyCollection(corners[~wet], facecolor="0.75", edgecolors="none", linewidths=0, antialiased=False))
    # Lines between neighbours would show through the gaps of antialiasing.
    shapes = PolyCollection(corners[wet], array=pressure[wet], cmap="viridis", edgecolors="none", linewidths=0, antialiased=False,
        rasterized=True)
    shapes.set_clim(0.0, MOST)
    axes.add_collection(shapes)
    return shapes


def main():
    run = Run(sys.argv[1])
    times = times_of(run)
    early = int(np.argmin(np.abs(np.array(times) - EARLY)))
    figure, (field, history) = plt.subplots(1, 2, figsize=(11.5, 6), width_ratios=(1.0, 1.1), layout="constrained")
    draw_half(field, run.particles(early), -1.0)
    shapes = draw_half(field, run.particles(-1), 1.0)
    field.set(xlim=(-60, 60), ylim=(155, -20), aspect="equal", xlabel="distance from the axis [mm]", ylabel="depth [mm]")
    field.axvline(0.0, color="k", lw=0.5, ls=(0, (8, 4)))
    field.set_title(f"left: {times[early] / MILLI:.2g} ms, right: {times[-1] / MILLI:.2g} ms (casing grey)", fontsize=11)
    figure.colorbar(shapes, ax=field, label="pore pressure [MPa]", extend="max", pad=0.02)
    table = run.table("history.csv")
    history.plot(table["time"] / MILLI, -1e6 * table["fluid_inflow"])
    history.set(xlabel="time [ms]", ylabel="fluid that has left the rock [ml]", title="drained into the open channel")
    history.grid(alpha=0.3)
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
