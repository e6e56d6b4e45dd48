# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: depth against confining pressure in dry rock, with cells of several sizes, and a cross-section that shows radial cracks."""
import itertools

import matplotlib.pyplot as plt
import numpy as np
from paper_figures import cracks
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS, DECK, draw_channels, measured, settings_of, sound

TABLES = ("paper_7", "paper_7_cracks")
PRESSURES = (0.0, 17.0, 34.0, 69.0, 138.0)  # MPa
CONVERGED_AT, QUICK = (34.0, 138.0), (0.0, 138.0)


def wanted(form):
    """[(confinement, cells)]"""
    if form == "quick":
        return [(pressure, CELLS[form]) for pressure in QUICK]
    own = CELLS[form]
    others = sorted({2.0, 1.0, 0.5} - {own}, reverse=True)
    return [(pressure, own) for pressure in PRESSURES] + [(pressure, cells) for cells in others for pressure in CONVERGED_AT]


def name_of(pressure, cells):
    return f"confined-{pressure:g}-{cells:g}"


def measure(lab):
    asked = wanted(lab.form)
    folders = lab.runs([(DECK, settings_of(cells, pressure), name_of(pressure, cells)) for pressure, cells in asked])
    rows = []
    for (pressure, cells), folder in zip(asked, folders):
        shot = measured(folder)
        rows.append([pressure, cells, shot.early, shot.depth, shot.growth, shot.volume, shot.radius, shot.lost])
    columns = ["confinement [MPa]", "cells [mm]", "depth at 30 us [mm]", "depth [mm]", "growth in the last 20 us", "hole [cm3]", "mean radius [mm]", "numerical energy"]
    table = Table(f"Figure 7: input_xml/paper/{DECK}; depth: the greatest of 100 us", columns, rows)
    if lab.form != "quick":
        main = [(f"{p:g} MPa: {row[3]:.1f} mm", folder) for (p, cells), row, folder in zip(asked, rows, folders) if cells == CELLS[lab.form]]
        fields, limits = ("pressure", "plastic_volume_strain"), ((0.0, 300.0), (-0.2, 0.2))
        draw_channels(lab.picture("paper_7"), main, fields, limits, (22.0, -8.0, 60.0), "confining pressure: depth")
        draw_depths(lab.picture("paper_7_depth"), table)
    return {"paper_7": table, "paper_7_cracks": cracks.measure(lab)}


def draw_depths(file, table):
    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for i, cells in enumerate(sorted(set(table.column("cells [mm]")), reverse=True)):
        pressure, depth = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", "depth [mm]"))
        axes.plot(pressure, depth, "o-", color=f"C{i}", label=f"cells of {cells:g} mm, {2.0 / cells:g} per jet radius")
    axes.set(xlabel="confining pressure [MPa]", ylabel="depth [mm]")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(tables):
    table = tables["paper_7"]
    out = []
    for cells in sorted(set(table.column("cells [mm]"))):
        pressure, depth = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", "depth [mm]"))
        order = np.argsort(pressure)
        steps = [a - b for a, b in itertools.pairwise(depth[order])]
        out.append(least(f"7: cells of {cells:g} mm: depth falls from each confining pressure to the next, by so many mm", min(steps), 0.1))
        out.append(most(f"7: cells of {cells:g} mm: depth at the highest confining pressure over that at none", depth[order][-1] / depth[order][0], 0.98))
    out.append(most("7: shots are over: growth of the depth in the last 20 us", table.column("growth in the last 20 us").max(), 0.01))
    out.append(sound(table, 7))
    return out + cracks.trends(tables["paper_7_cracks"])
