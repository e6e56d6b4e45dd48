#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Penetration channels of two runs of a half, side by side: channels.py LEFT_RUN RIGHT_RUN PNG.

Deformed particles, the left run mirrored; rock and plates by their plastic strain, the jet in one colour. For
docs/pictures/plane_channels.png:

    ./barreno run input_xml/perforation_plane_gimp.xml --out runs/plane_gimp
    ./barreno run input_xml/perforation_plane_cpdi.xml --out runs/plane_cpdi
    ./barreno python verification/tools/channels.py runs/plane_gimp runs/plane_cpdi docs/pictures/plane_channels.png
"""
import json
import pathlib
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

from barreno.report.channel import MICRO, MILLI, draw_quads
from barreno.report.fields import PLASTIC_STRAIN
from barreno.report.files import read_columns
from barreno.report.particles import ParticleFile

MOST = 1.0  # plastic strain at the end of the colours


def words_of(run):
    """Shape function, depth and steps of a run."""
    depth = read_columns(run / "depth.csv")
    deck = (run / "deck.xml").read_text(encoding="utf-8")
    shape = deck.split('name="Shape Function"')[1].split('value="')[1].split('"')[0]
    return shape, depth["depth"][-1] / MILLI


def draw_side(axes, run, mirror):
    frame = ParticleFile(run / "particles.e").frame()
    corners = frame.corners / MILLI * np.array([mirror, 1.0])
    plastic = np.nan_to_num(frame.of_alive(PLASTIC_STRAIN))
    jet = frame.block == 0
    quads = draw_quads(axes, corners[~jet], plastic[~jet], "viridis", (0.0, MOST))
    axes.add_collection(PolyCollection(corners[jet], facecolors="C3", edgecolors="none", antialiased=False))
    return quads, frame.time


def main():
    left, right, picture = (pathlib.Path(word) for word in sys.argv[1:4])
    figure, axes = plt.subplots(figsize=(7.0, 8.5), layout="constrained")
    draw_side(axes, left, -1.0)
    shapes, time = draw_side(axes, right, 1.0)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.invert_yaxis()  # the jet flies down
    axes.axvline(0.0, color="k", lw=0.6)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
    titles = ["{}: {:.0f} mm deep".format(*words_of(run)) for run in (left, right)]
    axes.set_title(f"{titles[0]}      |      {titles[1]}      (t = {time / MICRO:.3g} µs)", fontsize=10)
    figure.colorbar(shapes, ax=axes, label="plastic strain (jet: red)", shrink=0.5, extend="max")
    figure.savefig(picture, dpi=110)
    print(json.dumps(dict(zip((str(left), str(right)), titles))))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main()
