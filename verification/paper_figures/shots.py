# SPDX-License-Identifier: BSD-3-Clause
"""Shots of input_xml/paper/penetration.xml: their settings, what is measured of them, and their channels side by side."""
import contextlib
import dataclasses
import pathlib
import textwrap

import matplotlib.pyplot as plt
import numpy as np
from barreno.report.channel import Half, draw_half, draw_outlines, set_up
from barreno.report.hole import face_of, measure_hole
from barreno.report.run import Run
from paper_figures.lab import MICRO, MILLI, most, summary_of

DECK = "penetration.xml"
CELLS = {"quick": 2.0, "default": 1.0, "fine": 0.5}  # mm; the jet's radius is 2.0 to 2.2 mm
LONGEST_LABEL = 38  # letters beside a bar of colours
SETTLED = 20.0  # us at the end of a run: a depth that grows by less than 1 % then is final


@dataclasses.dataclass
class Shot:
    depth: float  # greatest of the run [mm]
    early: float  # after 30 us [mm]
    growth: float  # of the depth in the last SETTLED us, over the depth
    volume: float  # of the hole [cm3]
    radius: float  # of the hole, mean over its length by volume [mm]
    lost: float  # numerical energy error over the energy put in, stress integration and transfer together


def settings_of(cells, confinement, more=None):
    """@param cells [mm]  @param confinement [MPa]"""
    return {"Grid/Cell Size": f"{cells:g} mm", "Confinement/Pressure": f"{confinement:g} MPa", **(more or {})}


def measured(folder):
    with contextlib.ExitStack() as stack:
        run = Run(folder, stack)
        table, frame = run.depth_table(), run.frame()
        hole = measure_hole(frame, run.deck, face_of(table, run.file, run.deck))
        energy = run.summary["balances"]["energy"]
    time, depth = table["time"], table["depth"] / MILLI
    greatest = float(depth.max())
    before = float(depth[time <= time[-1] - SETTLED * MICRO].max())
    length = max(hole.length, 1e-9)
    radius = float(np.sqrt(hole.volume / (np.pi * length))) / MILLI
    lost = energy["stress_integration_share"] + energy["transfer_share"]
    return Shot(greatest, float(np.interp(30.0 * MICRO, time, depth)), greatest / before - 1.0, hole.volume * 1e6, radius, lost)


def sound(table, number, of=""):
    """A run that has become unstable shows in its energy; its depth means nothing."""
    return most(f"{number}: {of}numerical energy over energy put in", np.abs(table.column("numerical energy")).max(), 0.12)


def end_of(folder):
    return summary_of(pathlib.Path(folder))["time"] / MICRO


def draw_channels(file, channels, fields, limits, box, edges=False):
    """Channels side by side with one range of colours for each field.

    @param channels  [(title, folder)]
    @param fields    of the left and the right half; the same twice: one bar
    @param box       (r, y, y) in mm
    @param edges     borders of particles, which show how each is deformed
    """
    count = len(channels)
    wide = 11.0 / max(count, 3)
    high = wide * (box[2] - box[1]) / (2.0 * box[0]) + 1.0
    figure, panels = plt.subplots(1, count, figsize=(count * (wide + 0.15) + 2.6, high), layout="constrained", sharey=True, squeeze=False)
    halves = []
    for axes, (name, folder) in zip(panels[0], channels):
        with contextlib.ExitStack() as stack:
            run = Run(folder, stack)
            frame = run.frame()
            halves = [draw_half(axes, frame, run.deck, Half(field, mirror, limit), edges=edges)
                for field, mirror, limit in zip(fields, (-1.0, 1.0), limits)]
            set_up(axes, run.deck)
            draw_outlines(axes, frame, run.deck, (-1.0, 1.0), 0.7)
        axes.set(xlim=(-box[0], box[0]), ylim=(box[2], box[1]), title=name)
        axes.title.set_fontsize(9.5)
        axes.label_outer()
    add_bars(figure, panels, halves, fields)
    figure.savefig(file, dpi=120, bbox_inches="tight")
    plt.close(figure)


def add_bars(figure, panels, halves, fields):
    sides = ("left", "right") if fields[0] != fields[1] else ("right",)
    for (quads, label), side in reversed(list(zip(halves, sides))):  # each bar is put between the panels and the others
        words = f"{side} half: {label}" if len(sides) > 1 else label
        bar = figure.colorbar(quads, ax=panels, location="right", label=textwrap.fill(words, LONGEST_LABEL), shrink=0.8, aspect=30,
            pad=0.01, extend="both")
        bar.solids.set_edgecolor("face")
