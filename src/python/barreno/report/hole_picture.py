# SPDX-License-Identifier: BSD-3-Clause
"""The hole in its rock: wall and zones against depth, porosity and permeability against radius."""

import numpy as np
from matplotlib.colors import TwoSlopeNorm
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullLocator

from barreno.report.legends import BELOW, place_legends
from barreno.report.wall import MEASURED, smooth_wall
from barreno.runs.plots import plt

MILLI = 1e-3
SPREAD = 0.5  # of the virgin porosity, at the ends of the colours


def draw_wall(axes, hole, zones, mark):
    """Wall as measured, and smooth; around it the porosity of rings, where the rock has one."""
    drawn = draw_porosity(axes, hole, zones)
    rows = hole.open_rows
    depth = np.concatenate([[0.0], hole.depth[:rows]]) / MILLI
    radius = np.concatenate([hole.radius[:1], hole.radius[:rows]])
    radius = np.where(np.isfinite(radius), radius, np.nan) / MILLI
    axes.plot(radius, depth, "-", color="0.45", lw=0.6, label="wall of the hole in rows of half a cell")
    axes.plot(*(np.array(smooth_wall(hole))[::-1] / MILLI), "k-", lw=1.4, label="its running median")
    if mark:
        axes.plot([mark[1] / MILLI], [mark[0] / MILLI], "C1D", ms=6, label="half depth, in whole cells (depth.csv)")
    axes.set(xlabel="radius [mm]" if not hole.plane else "half width [mm]", ylabel="depth [mm]", xlim=(0.0, None),
        ylim=(depth[-1] + 6.0 * hole.cell / MILLI, 0.0))
    axes.set_title("hole, and porosity around it" if drawn is not None else "hole", fontsize=10)
    return drawn


def draw_porosity(axes, hole, zones):
    """@return what a colour bar needs; None without rock that has pores"""
    drawn = None
    for ring, below in zip(zones, [*zones[1:], None]):
        step = (below.depth - ring.depth) if below else 2.0 * hole.cell
        y = np.array([ring.depth - 0.5 * step, ring.depth + 0.5 * step]) / MILLI
        values = (ring.porosity / ring.virgin)[None, :]
        drawn = axes.pcolormesh(ring.edges / MILLI, y, values, cmap="RdBu", norm=TwoSlopeNorm(1.0, 1.0 - SPREAD, 1.0 + SPREAD),
            rasterized=True)
    return drawn


def draw_rings(porosity, permeability, rings):
    for n, ring in enumerate(rings):
        label = f"depth {ring.depth / MILLI:.1f} mm, skin {ring.skin:+.2f}"
        porosity.step(ring.edges / MILLI, np.append(100.0 * ring.porosity, np.nan), where="post", color=f"C{n}", label=label)
        permeability.step(ring.edges / MILLI, np.append(ring.permeability, np.nan), where="post", color=f"C{n}")
        for axes in (porosity, permeability):
            axes.axvline(ring.edges[0] / MILLI, color=f"C{n}", lw=0.8, ls=":")
    porosity.axhline(100.0 * rings[0].virgin, color="k", lw=0.8, ls="--", label="virgin")
    permeability.axhline(1.0, color="k", lw=0.8, ls="--")
    permeability.set_yscale("log")
    permeability.yaxis.set_major_locator(LogLocator(10.0, (1.0, 2.0, 5.0)))
    permeability.yaxis.set_major_formatter(FormatStrFormatter("%g"))
    permeability.yaxis.set_minor_locator(NullLocator())
    porosity.set_ylabel("porosity [%]")
    porosity.set_title("rings around the hole (dotted: its wall)", fontsize=10)
    permeability.set(xlabel="radius [mm]", ylabel="permeability / virgin")
    porosity.set_ylim(bottom=0.0)
    for axes in (porosity, permeability):
        axes.grid(alpha=0.3)
        axes.set_xlim(left=0.0)


def hole_figure(hole, zones, rings, mark, measured=None):
    """@param zones  rings of all rows; @param rings  those of chosen depths; @param mark  (depth, radius) of depth.csv, or None;
    @param measured  report.measured.Measured"""
    figure = plt.figure(figsize=(11.0 if rings else 5.5, 6.5), layout="constrained")
    grid = figure.add_gridspec(2, 2 if rings else 1)
    wall = figure.add_subplot(grid[:, 0])
    drawn = draw_wall(wall, hole, zones, mark)
    if measured is not None:
        wall.plot(measured.radius / MILLI, measured.depth / MILLI, color=MEASURED, lw=1.4, ls=(0, (4, 2)),
            label=f"measured ({measured.name})")
        wall.set_ylim(bottom=max(wall.get_ylim()[0], 1.03 * measured.end / MILLI))
    if drawn is not None:
        figure.colorbar(drawn, ax=wall, label="porosity / virgin value: crushed < 1 < dilated", extend="both", aspect=35)
    for ring in rings:
        wall.axhline(ring.depth / MILLI, color="0.4", lw=0.6, ls=":")
    wall.legend(**{**BELOW, "bbox_to_anchor": (0.5, -0.09)}, fontsize=8, frameon=False)  # rings fill the axes
    if rings:
        upper = figure.add_subplot(grid[0, 1])
        draw_rings(upper, figure.add_subplot(grid[1, 1], sharex=upper), rings)
        place_legends(upper, fontsize=8)
    return figure
