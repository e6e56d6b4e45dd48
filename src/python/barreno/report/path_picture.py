# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of stress paths: where the particles are in the pressure-shear map, and their paths in the meridional plane, in the octahedral
view and in the space of principal stresses, with the surfaces of their cards."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.ticker import MaxNLocator

from barreno.report.channel import draw_outlines, set_limits, set_up, time_text
from barreno.report.inks import draw_inks, colour_of
from barreno.report.legends import BELOW
from barreno.report.principal import ACROSS, AXIS, UP, lode_of_turn, revolved
from barreno.report.stress_paths import surface_now
from barreno.runs.plots import plt

MILLI, MEGA = 1e-3, 1e6
COLOURS = ("#7cb518", "#ff9f1c", "#2a9d8f", "#1f77b4", "#9467bd", "#8c564b", "#e377c2", "#17becf")  # without the red of the jet
CLOSE = 0.3  # of the largest pressure: where virgin rock is crushed below that, a second panel shows the paths up to there
VIEWS = ("meridional plane", "octahedral view, down the hydrostat", "space of principal stresses")
LINES = ("-", (0, (1, 1)), "-.")  # of the first surfaces of materials


def axis_names(deck):
    """Of the principal stresses, by their directions at the start."""
    return ("axial", "radial", "hoop") if deck.mode == "axisymmetric" else ("along y", "along x", "along z")


def draw_map(axes, frame, deck, paths, box):
    shapes, of = frame.shapes
    p = (frame.of_alive(["pressure"]) - np.nan_to_num(frame.of_alive(["pore_pressure"])))[of] / MEGA
    q = frame.of_alive(["shear_stress"])[of] / MEGA
    mirrors = (-1.0, 1.0) if deck.mirrored() else (1.0,)
    for mirror in mirrors:
        axes.add_collection(PolyCollection(shapes / MILLI * np.array([mirror, 1.0]), facecolors=colour_of(p, q), edgecolors="none",
            linewidths=0, antialiased=False, rasterized=True))
    set_up(axes, deck)
    handles = draw_outlines(axes, frame, deck, mirrors, 0.7)
    for path, colour in zip(paths, COLOURS):
        if path.times[0] <= frame.time <= path.times[-1]:
            axes.plot(*(path.places[path.at(frame.time)][:2] / MILLI), "o", color=colour, mec="k", ms=7)
    set_limits(axes, frame, deck, box)
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=2, fontsize=9, frameon=False)
    axes.set_title(f"t = {time_text(frame.time)}")


def surfaces_of(paths, surfaces):
    """[(material, its Strength)] of the paths, those with a surface."""
    return [(name, surfaces[name]) for name in dict.fromkeys(path.material for path in paths) if surfaces.get(name)]


def map_figure(frame, deck, paths, surfaces, box):
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 6.0), layout="constrained")
    draw_map(left, frame, deck, paths, box)
    draw_inks(right)
    for (name, strength), line in zip(surfaces_of(paths, surfaces), LINES):
        p, q = strength.curve(0.0, 3e9, 4000)
        right.plot(p / MEGA, q / MEGA, color="k", ls=line, lw=1.4, label=f"surface of virgin {name}")
    for path, colour in zip(paths, COLOURS):
        right.plot(path.pressure / MEGA, path.shear / MEGA, "-", color=colour, lw=1.2, marker=".", ms=4, label=f"particle {path.number}")
    right.legend(**BELOW, fontsize=8, ncols=2, frameon=False)  # the colours fill the axes
    return figure


def draw_meridians(axes, time, paths, surfaces, most):
    """Paths and surfaces up to a pressure."""
    highest = MEGA
    for (name, strength), line in zip(surfaces_of(paths, surfaces), LINES):
        p, q = strength.curve(0.0, 1.2 * most, 2000)
        axes.plot(p / MEGA, q / MEGA, color="k", ls=line, lw=1.4, label=f"{name}, initial")
    for path, colour in zip(paths, COLOURS):
        strength, last = surfaces.get(path.material), path.at(time)
        axes.plot(path.pressure / MEGA, path.shear / MEGA, "-", color=colour, lw=1.1, marker=".", ms=4, label=f"particle {path.number}")
        axes.plot(path.pressure[last] / MEGA, path.shear[last] / MEGA, "o", color=colour, mec="k", ms=7)
        if strength:
            own, e = surface_now(path, strength, last)
            p, q = own.curve(e, 1.2 * most, 2000)
            axes.plot(p / MEGA, q / MEGA, "--", color=colour, lw=1.0, label=f"surface of {path.number} at {time_text(path.times[last])}")
        highest = max(highest, float(path.shear[path.pressure <= 1.05 * most].max(initial=0.0)))
    lowest = min(0.0, min(float(path.pressure.min()) for path in paths))
    axes.set(xlim=((max(lowest, -0.15 * most) - 0.03 * most) / MEGA, 1.05 * most / MEGA), ylim=(0.0, 1.15 * highest / MEGA))
    axes.grid(alpha=0.3)


def ring(strength, p, e):
    """(across, up) of the surface in the octahedral plane at a pressure."""
    turn = np.linspace(0.0, 2.0 * np.pi, 361)
    out = np.sqrt(2.0) * strength.shear_at(p, e) * strength.shape(lode_of_turn(turn))
    return out * np.sin(turn), out * np.cos(turn)


def widest(strength, e, most):
    """Pressure at which the surface is widest, up to a pressure."""
    p, q = strength.curve(e, most, 4000)
    return float(p[np.where(p <= most, q, -1.0).argmax()])


def draw_octahedral(axes, time, deck, paths, surfaces, most):
    """Down the hydrostat: the paths up to a pressure, the first surfaces where they are widest, the present ones at the particles'
    pressure."""
    size = MEGA
    for (name, strength), line in zip(surfaces_of(paths, surfaces), LINES):
        rim = np.array(ring(strength, widest(strength, 0.0, most), 0.0))
        axes.plot(*(rim / MEGA), color="k", ls=line, lw=1.4)
        size = max(size, np.abs(rim).max())
    for path, colour in zip(paths, COLOURS):
        strength, last = surfaces.get(path.material), path.at(time)
        view = path.stress @ np.stack([ACROSS, UP], axis=-1)
        axes.plot(*(view.T / MEGA), "-", color=colour, lw=1.1, marker=".", ms=4)
        axes.plot(*(view[last] / MEGA), "o", color=colour, mec="k", ms=7)
        if strength:
            own, e = surface_now(path, strength, last)
            axes.plot(*(np.array(ring(own, path.pressure[last], e)) / MEGA), "--", color=colour, lw=1.0)
        size = max(size, np.abs(view[path.pressure <= most]).max(initial=0.0))
    reach = 1.12 * size / MEGA
    for angle, name in zip((90.0, -30.0, 210.0), axis_names(deck)):
        way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        axes.plot(*np.outer(way, [0.0, reach]), color="0.75", lw=0.8, zorder=0)
        axes.annotate(name, 1.03 * reach * way, ha="center", va="center", fontsize=9, color="0.3")
    axes.set(aspect="equal", xlim=(-1.12 * reach, 1.12 * reach), ylim=(-1.12 * reach, 1.12 * reach), xlabel="[MPa]", ylabel="[MPa]")


def draw_space(axes, deck, paths, surfaces, most):
    """Principal stress space: the first surfaces, and the paths while no principal stress is above what such a pressure may have."""
    for _, strength in surfaces_of(paths, surfaces):
        p, q = strength.curve(0.0, most, 120)
        axes.plot_surface(*revolved(p / MEGA, q / MEGA, 49, strength.shape), color="0.7", alpha=0.35, linewidth=0)
    end = MEGA
    for path, colour in zip(paths, COLOURS):
        seen = np.where((path.pressure <= most)[:, None], path.stress, np.nan)
        axes.plot(*(seen.T / MEGA), color=colour, lw=1.3)
        end = max(end, float(np.nanmax(seen, initial=0.0)))
    axes.plot(*np.outer(AXIS, [0.0, 1.3 * end / MEGA]), "k-.", lw=1.0)
    axes.set(**{f"{one}label": f"{name} [MPa]" for one, name in zip("xyz", axis_names(deck))})
    for one in (axes.xaxis, axes.yaxis, axes.zaxis):
        one.set_major_locator(MaxNLocator(3))
        one.set_tick_params(labelsize=8)
    axes.view_init(elev=20.0, azim=-62.0)
    axes.set_box_aspect(None, zoom=0.86)


def crushing(paths, surfaces):
    """Largest pressure that virgin rock bears before its pores are crushed; 0 where no card says it."""
    found = [-strength.hydrostatic_strength(0.0) / 3.0 for _, strength in surfaces_of(paths, surfaces)]
    return max((p for p in found if np.isfinite(p)), default=0.0)


def draw_row(figure, grid, time, deck, paths, surfaces, most, wet):
    """Three views of the paths up to a pressure. @return the first of them"""
    meridian = figure.add_subplot(grid[0])
    draw_meridians(meridian, time, paths, surfaces, most)
    meridian.set(xlabel="effective pressure p - pore pressure [MPa]" if wet else "pressure p [MPa]", ylabel="√J₂ [MPa]")
    draw_octahedral(figure.add_subplot(grid[1]), time, deck, paths, surfaces, most)
    draw_space(figure.add_subplot(grid[2], projection="3d"), deck, paths, surfaces, most)
    return meridian


def paths_figure(time, deck, paths, surfaces, wet):
    """Three views, and the same at low pressure.

    @param time  at which the present surfaces are drawn
    """
    most = max(max(float(path.pressure.max()) for path in paths), MEGA)
    low = crushing(paths, surfaces)
    figure = plt.figure(figsize=(17.0, 10.5), layout="constrained")
    upper, lower = figure.add_gridspec(2, 1)
    whole = draw_row(figure, upper.subgridspec(1, 3), time, deck, paths, surfaces, most, wet)
    draw_row(figure, lower.subgridspec(1, 3), time, deck, paths, surfaces, 1.3 * low if 0.0 < low < CLOSE * most else CLOSE * most, wet)
    for axes, title in zip(figure.axes,
            (*VIEWS, *(f"the same {'up to the crushing of virgin rock' if 0.0 < low < CLOSE * most else 'at low pressure'}",) * 3)):
        axes.set_title(title, fontsize=11)
    # Below the panels: pictures are cut to what is drawn.
    handles, labels = whole.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=min(4, len(labels)), fontsize=10, frameon=False)
    return figure
