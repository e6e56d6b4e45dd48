# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7, what axisymmetry cannot show: radial bands of dilation in a cross-section of scattered strength, without and with
confinement."""
import contextlib

import matplotlib.pyplot as plt
import numpy as np
from barreno.report.run import Run
from matplotlib.collections import PolyCollection
from paper_figures.lab import MICRO, MILLI, Table, least
from scipy.spatial import cKDTree

DECK = "cross_section.xml"
PRESSURES = (0.0, 69.0)  # MPa
CELLS = {"quick": 2.0, "default": 1.0, "fine": 0.5}  # mm
OPEN = 0.05  # plastic volume strain of a crack
RING = (10.0, 30.0)  # mm, in which bands are looked for
LAG = 3.0  # mm


def dilation(folder):
    """Centres, corners [mm] and plastic volume strain at the end, and the time [us]."""
    with contextlib.ExitStack() as stack:
        frame = Run(folder, stack).frame()
        return frame.centres / MILLI, frame.corners / MILLI, frame.of_alive(["plastic_volume_strain"]), frame.time / MICRO


def correlations(centres, strain):
    """Of the dilation at two points a distance LAG apart, along the radius and across it, its mean at each radius taken off."""
    radius, angle = np.hypot(*centres.T), np.arctan2(centres[:, 1], centres[:, 0])
    bins = np.clip((radius / 2.0).astype(int), 0, None)
    mean = np.bincount(bins, strain) / np.maximum(np.bincount(bins), 1)
    off = strain - mean[bins]
    tree = cKDTree(centres)
    ring = (radius > RING[0]) & (radius < RING[1])
    r, a = radius[ring], angle[ring]
    found = []
    for more_r, more_a in ((LAG, 0.0), (0.0, LAG / r)):
        there = np.stack([(r + more_r) * np.cos(a + more_a), (r + more_r) * np.sin(a + more_a)], axis=-1)
        found.append(float(np.corrcoef(off[ring], off[tree.query(there)[1]])[0, 1]))
    return found


def measure(lab):
    cells, rows, drawn = CELLS[lab.form], [], []
    settings = [{"Grid/Cell Size": f"{cells:g} mm", "Confinement/Pressure": f"{pressure:g} MPa"} for pressure in PRESSURES]
    folders = lab.runs([(DECK, words, f"section-{pressure:g}") for words, pressure in zip(settings, PRESSURES)])
    for pressure, folder in zip(PRESSURES, folders):
        centres, corners, strain, time = dilation(folder)
        rows.append([pressure, cells, float(np.mean(strain > OPEN)), *correlations(centres, strain)])
        drawn.append((corners, strain))
    if lab.form != "quick":
        draw(lab.picture("paper_7_cracks"), drawn, time)
    columns = ["confinement [MPa]", "cells [mm]", "share dilated by more than 0.05", "correlation along the radius", "across the radius"]
    return Table(f"Figure 7: input_xml/paper/{DECK}, {time:g} us; correlation of the dilation {LAG:g} mm apart", columns, rows)


def draw(file, drawn, time):
    figure, panels = plt.subplots(1, len(PRESSURES), figsize=(11.0, 4.9), layout="constrained", sharey=True)
    for axes, pressure, (corners, strain) in zip(panels, PRESSURES, drawn):
        shapes = PolyCollection(corners, array=strain, cmap="magma_r", clim=(0.0, 0.1), edgecolors="none", linewidths=0, antialiased=False,
            rasterized=True)
        axes.add_collection(shapes)
        axes.set(xlim=(-44.0, 44.0), ylim=(-44.0, 44.0), aspect="equal", xlabel="x [mm]",
            title=f"confining pressure {pressure:g} MPa, {time:g} µs")
    panels[0].set_ylabel("y [mm]")
    figure.colorbar(shapes, ax=panels, label="plastic volume strain (dilation)", extend="max")
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(table):
    share, along, across = (table.column(name)
        for name in ("share dilated by more than 0.05", "correlation along the radius", "across the radius"))
    out = [least("7: cross-section: dilated rock, unconfined over confined", share[0] / max(share[1], 1e-6), 5.0)]
    if table.column("cells [mm]")[0] <= 1.0:  # with coarser ones bands are no longer than LAG
        out.append(least("7: cross-section, bands along radii: correlation of the dilation along radii less across",
            along[0] - across[0], 0.1))
    return out
