# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5: stress of the target in pressure-shear space, with the two-dimensional legend; paths of particles near the tip in principal
stress space, octahedral and in space, with the yield surface; how much rock is under which Lode angle."""
import contextlib

import matplotlib.pyplot as plt
import numpy as np
from barreno.report.inks import PRESSURES, colour_of, draw_inks
from barreno.report.principal import ACROSS, AXIS, UP, along_path, lode_angle, pressure_and_shear, principal, revolved, tensors
from barreno.report.run import Run
from barreno.report.strength import Strength
from matplotlib.collections import PolyCollection
from paper_figures.figure_3 import CARD
from paper_figures.lab import MEGA, MICRO, MILLI, Table, least
from paper_figures.surface import card_numbers

TABLES = ("paper_5", "paper_5_paths")
DECK = "tip.xml"
TIPS = (6.0, 8.0, 10.0)  # mm: distances from the axis of the particles whose paths are drawn
DEPTH = 12.0  # mm, of these particles
BAND = 5.0  # degrees
SHEARED = 20.0  # MPa of sqrt(J2), below which the Lode angle says little
NEAR = 12.0  # mm from the tip: rock that is counted
STRESSES = ("stress_xx", "stress_yy", "stress_zz", "stress_xy")
CLOSE = 460.0  # MPa, of the closer octahedral view
COLOURS = ("#d62728", "#ff9f1c", "#2a9d8f")


def stresses(frame):
    """Principal stresses of the particles that exist, MPa, compression positive."""
    return principal(*(frame.of_alive([name]) / MEGA for name in STRESSES))


def is_rock(frame):
    return np.isfinite(frame.of_alive(["plastic_volume_strain"]))


def tip_of(run, time):
    table = run.depth_table()
    return float(np.interp(time, table["time"], table["depth"]))


def count_lode(run):
    """Volume of sheared rock near the tip by its Lode angle, summed over the times of the file."""
    edges = np.arange(0.0, 60.0 + 0.5 * BAND, BAND)
    volume, start = np.zeros(len(edges) - 1), run.file.frame(0)
    first = np.ptp(start.corners, axis=1).prod(axis=1) * start.centres[:, 0]
    whole = np.zeros(len(start.alive))
    whole[start.alive] = first
    for step in range(1, len(run.file.times)):
        frame = run.file.frame(step)
        tip = tip_of(run, frame.time)
        if tip <= 5.0 * MILLI:
            continue  # the crater
        near = np.hypot(frame.centres[:, 0], frame.centres[:, 1] - tip) < NEAR * MILLI
        stress = stresses(frame)
        keep = near & is_rock(frame) & (pressure_and_shear(stress)[1] > SHEARED)
        volume += np.histogram(lode_angle(stress[keep]), edges, weights=(whole[frame.alive])[keep])[0]
    return edges, volume / volume.sum()


def followed(run):
    """{distance: element} of rock particles at a depth."""
    frame = run.file.frame(0)
    rock = np.flatnonzero(frame.alive & (run.file.block == run.file.block_names.index("Sandstone")))
    centre = frame.centres[np.searchsorted(np.flatnonzero(frame.alive), rock)] / MILLI
    return {distance: int(rock[np.argmin(np.hypot(centre[:, 0] - distance, centre[:, 1] - DEPTH))]) for distance in TIPS}


def axial_radial_hoop(components):
    """Principal stresses along a path, MPa: each that whose direction is nearest to the one before."""
    return along_path(tensors(*components.T))[:, [1, 0, 2]] / MEGA


def paths(run, elements):
    """{distance: (times, principal stresses)} while the particle exists."""
    collected = {distance: [] for distance in elements}
    for step, time in enumerate(run.file.times):
        frame = run.file.frame(step)
        values = [frame.variable(name) for name in STRESSES]
        for distance, element in elements.items():
            if frame.alive[element]:
                collected[distance].append((time, *(float(v[element]) for v in values)))
    return {distance: (np.array(rows)[:, 0], axial_radial_hoop(np.array(rows)[:, 1:])) for distance, rows in collected.items()}


def measure(lab):
    settings = lab.of_form({"Grid/Cell Size": "2 mm", "Time/End Time": "8 us"}, {}, {"Grid/Cell Size": "0.25 mm"})
    folder = lab.run(DECK, settings, "tip")
    with contextlib.ExitStack() as stack:
        run = Run(folder, stack)
        edges, shares = count_lode(run)
        lines = paths(run, followed(run))
        draw(lab.picture("paper_5"), run, edges, shares, lines)
    rows = [[float(low), float(low + BAND), float(share)] for low, share in zip(edges, shares)]
    path_rows = [[distance, float(t / MICRO), *map(float, stress)] for distance, (times, found) in lines.items()
        for t, stress in zip(times, found)]
    cells = lab.of_form("2", "0.5", "0.25")
    remark = (
        f"Figure 5: input_xml/paper/{DECK}, cells of {cells} mm; share of the volume of rock within {NEAR:g} mm of the tip under sqrt(J2) "
        f"> {SHEARED:g} MPa, over all times"
    )
    of_paths = ["distance [mm]", "time [us]", "axial [MPa]", "radial [MPa]", "hoop [MPa]"]
    return {
        "paper_5": Table(remark, ["from [degrees]", "to [degrees]", "share"], rows),
        "paper_5_paths": Table(f"Figure 5: principal stresses of particles at a depth of {DEPTH:g} mm, compression positive",
            of_paths, path_rows),
    }


def draw(file, run, edges, shares, lines):
    figure = plt.figure(figsize=(14.5, 9.0), layout="constrained")
    grid = figure.add_gridspec(2, 3)
    draw_map(figure.add_subplot(grid[0, 0]), run)
    draw_legend(figure.add_subplot(grid[0, 1]))
    draw_shares(figure.add_subplot(grid[0, 2]), edges, shares)
    whole, near = figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1])
    for axes, size, title in ((whole, octahedral_size(lines), "octahedral view (down the hydrostat)"), (near, CLOSE, "the same, closer")):
        draw_octahedral(axes, lines, size)
        axes.set_title(title)
    draw_space(figure.add_subplot(grid[1, 2], projection="3d"), lines)
    handles, labels = whole.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=len(labels), frameon=False)
    figure.savefig(file, dpi=100, bbox_inches="tight")  # the legend is below the panels
    plt.close(figure)


def map_time(run):
    """When the tip passes the particles."""
    return float(np.interp(DEPTH * MILLI, run.depth_table()["depth"], run.depth_table()["time"]))


def draw_map(axes, run):
    frame = run.frame(min(map_time(run) + 2.0 * MICRO, run.file.times[-1]))
    pressure, shear = pressure_and_shear(stresses(frame))
    rock = is_rock(frame)
    plain = {"edgecolors": "none", "linewidths": 0, "antialiased": False, "rasterized": True}
    for mirror in (-1.0, 1.0):
        shapes = frame.corners / MILLI * np.array([mirror, 1.0])
        axes.add_collection(PolyCollection(shapes[~rock], facecolors="0.35", **plain))
        axes.add_collection(PolyCollection(shapes[rock], facecolors=colour_of(pressure[rock], shear[rock]), **plain))
    alive = np.cumsum(frame.alive) - 1
    for element, colour in zip(followed(run).values(), COLOURS):
        if frame.alive[element]:
            axes.plot(*(frame.centres[alive[element]] / MILLI), "o", color=colour, mec="k", ms=6)
    axes.set(xlim=(-26.0, 26.0), ylim=(38.0, -14.0), aspect="equal", xlabel="r [mm]", ylabel="y [mm]",
        title=f"stress of the rock at {frame.time / MICRO:.3g} µs (jet grey)")
    axes.set_facecolor("#d9d9d9")


def draw_legend(axes):
    draw_inks(axes)
    numbers = card_numbers(CARD)
    strength = Strength(lambda name: numbers.get(name, float("nan")))
    for plastic, style, label in ((0.0, "k-", "yield surface of virgin rock"), (-np.inf, "k--", "pores closed")):
        p, q = strength.curve(plastic, PRESSURES[1] * MEGA, 4000)
        axes.plot(p / MEGA, q / MEGA, style, lw=1.4, label=label)
    axes.legend(fontsize=8, loc="upper left")


def draw_shares(axes, edges, shares):
    axes.bar(edges[:-1], 100.0 * shares, width=BAND, align="edge", color="0.6", edgecolor="k", linewidth=0.6)
    axes.axhline(100.0 / len(shares), color="C0", ls="--", lw=1.2, label="all angles alike")
    axes.set(xlim=(0.0, 60.0), xlabel="Lode angle [degrees]", ylabel="share of the sheared rock [%]",
        title=f"stress states within {NEAR:g} mm of the tip")
    axes.set_xticks(np.arange(0, 61, 15), ["0\ntriaxial\ncompression", "15", "30\npure\nshear", "45", "60\ntriaxial\nextension"])
    axes.legend(fontsize=8)


def radius_of(plastic, most):
    """Largest sqrt(2 J2) of the surface up to a pressure, MPa."""
    numbers = card_numbers(CARD)
    p, q = Strength(lambda name: numbers.get(name, float("nan"))).curve(plastic, most * MEGA, 4000)
    return np.sqrt(2.0) * float(q[p <= most * MEGA].max()) / MEGA


def highest_of(lines):
    return max(float(stress.mean(axis=1).max()) for _, stress in lines.values())


def octahedral_size(lines):
    """Of a view that holds the widest surface and all paths [MPa]."""
    return 1.15 * max(radius_of(-np.inf, highest_of(lines)),
        max(np.abs([stress @ ACROSS, stress @ UP]).max() for _, stress in lines.values()))


def draw_octahedral(axes, lines, size):
    turn, highest = np.linspace(0.0, 2.0 * np.pi, 200), highest_of(lines)
    closed = f"pores closed, at {1e-3 * highest:.2g} GPa"
    for radius, style, label in ((radius_of(0.0, 1e4), "k-", "virgin rock, widest section"), (radius_of(-np.inf, highest), "k--", closed)):
        axes.plot(radius * np.cos(turn), radius * np.sin(turn), style, lw=1.2, label=label)
    for (distance, (_, stress)), colour in zip(lines.items(), COLOURS):
        axes.plot(stress @ ACROSS, stress @ UP, "-", color=colour, lw=1.2, marker=".", ms=3,
            label=f"particle from r = {distance:g} mm, y = {DEPTH:g} mm")
    for angle, name in ((90.0, "axial"), (-30.0, "radial"), (210.0, "hoop")):
        way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        axes.plot(*np.outer(way, [0.0, size]), color="0.75", lw=0.8, zorder=0)
        axes.annotate(name, 1.02 * size * way, ha="center", va="center", fontsize=9, color="0.3")
    axes.set(aspect="equal", xlim=(-1.1 * size, 1.1 * size), ylim=(-1.1 * size, 1.1 * size), xlabel="[MPa]", ylabel="[MPa]")


def draw_space(axes, lines):
    numbers = card_numbers(CARD)
    p, q = Strength(lambda name: numbers.get(name, float("nan"))).curve(0.0, np.inf, 120)
    axes.plot_surface(*revolved(p / MEGA, q / MEGA, 49), color="0.7", alpha=0.35, linewidth=0)
    end = max(float(stress.max()) for _, stress in lines.values())
    for (_, (_, stress)), colour in zip(lines.items(), COLOURS):
        axes.plot(*stress.T, color=colour, lw=1.4)
    axes.plot(*np.outer(AXIS, [0.0, 1.4 * end]), "k-.", lw=1.0)
    axes.set(xlabel="axial [MPa]", ylabel="radial [MPa]", zlabel="hoop [MPa]", title="the same paths in principal stress space")
    for one in (axes.xaxis, axes.yaxis, axes.zaxis):
        one.set_major_locator(plt.MaxNLocator(3))
        one.set_tick_params(labelsize=8)
    axes.view_init(elev=20.0, azim=-62.0)
    axes.set_box_aspect(None, zoom=0.86)


def trends(tables):
    share, paths_of = tables["paper_5"], tables["paper_5_paths"]
    low, part = share.column("from [degrees]"), share.column("share")
    spans = []
    for distance in TIPS:
        stress = np.stack([paths_of.column(name, **{"distance [mm]": distance}) for name in ("axial [MPa]", "radial [MPa]", "hoop [MPa]")],
            axis=-1)
        ordered = -np.sort(-stress, axis=-1)
        sheared = pressure_and_shear(ordered)[1] > SHEARED
        spans.append(np.ptp(lode_angle(ordered[sheared])))
    return [
        least("5: Lode angle below 20 degrees (a third if all are alike): share of triaxial compression",
            part[low < 20.0].sum(), 1.0 / 2.0),
        least("5: path of a particle beside the hole: range of Lode angles [degrees]", max(spans), 45.0),
    ]
