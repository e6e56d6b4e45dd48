# SPDX-License-Identifier: BSD-3-Clause
"""Pressure with streamlines on one side of the hole, permeability on the other, and the flow into each depth."""

import numpy as np

from barreno.runs.plots import plt


def velocity_of(rings, flow):
    """Darcy's velocity at the middles of cells, for streamlines: 0 where nothing flows."""
    r, z = (0.5 * (edges[1:] + edges[:-1]) for edges in (rings.radii, rings.depths))
    pressure = np.where(rings.hole, 0.0, np.nan_to_num(flow.pressure, nan=0.0))
    down, outward = np.gradient(pressure, z, r)
    there = np.isfinite(flow.pressure)
    return r, z, np.where(there, -rings.permeability * outward, np.nan), np.where(there, -rings.permeability * down, np.nan)


def draw(file, rings, flow, boundary, former=None):
    """The hole lies along the page, from left to right.  @param former  the rings before a surge, whose wall is dashed"""
    r, z, outward, down = velocity_of(rings, flow)
    long = rings.depths[-1] - rings.depths[0]
    high = 2.0 * rings.radii[-1] / long
    figure, (field, shares) = plt.subplots(2, 1, figsize=(11.0, 11.0 * min(0.6, max(0.15, high)) + 2.6), sharex=True,
        height_ratios=(max(0.15, min(0.6, high)) * 11.0, 1.8), layout="constrained")
    mm = 1e3
    x, y = mm * rings.depths, mm * rings.radii
    shown = field.pcolormesh(x, y, flow.pressure.T, cmap="viridis", vmin=0.0, vmax=1.0)
    figure.colorbar(shown, ax=field, label="pressure over that outside", pad=0.01, location="right")
    inside = np.ma.masked_where(rings.permeability <= 0.0, np.log10(np.where(rings.permeability > 0.0, rings.permeability, 1.0)))
    other = field.pcolormesh(x, -y, inside.T, cmap="RdBu", vmin=-2.0, vmax=2.0)
    bar = figure.colorbar(other, ax=field, label="permeability / virgin", pad=0.01, location="right", ticks=[-2, -1, 0, 1, 2],
        extend="both")
    bar.ax.set_yticklabels(["0.01", "0.1", "virgin", "10", "100"])
    even = np.linspace(r[0], r[-1], len(r)), np.linspace(z[0], z[-1], len(z))
    field.streamplot(mm * even[1], mm * even[0], down.T, outward.T, color="w", linewidth=0.6, density=1.1, arrowsize=0.7)
    if former is not None:
        for side in (1.0, -1.0):
            field.step(mm * z, side * mm * former.wall, where="mid", color="k", linewidth=0.8, linestyle="--")
    field.set_aspect("equal" if high > 0.15 else "auto")
    field.set_xlim(x[0], x[-1])
    field.set_ylim(-y[-1], y[-1])
    field.set_ylabel("radius [mm]: pressure above,\npermeability below")
    surge = "" if former is None else " after a surge (dashed: before)"
    field.set_title(f"{boundary} flow through the rock into the hole{surge}", fontsize=10)
    shares.step(mm * z, 0.1 * flow.into_hole / flow.rate / np.diff(rings.depths), where="mid", color="C0")
    shares.set_xlabel("depth [mm]")
    shares.set_ylabel("share of flow\n[% per mm]")
    shares.set_ylim(bottom=0.0)
    figure.savefig(file, dpi=120, format="png")
    plt.close(figure)
