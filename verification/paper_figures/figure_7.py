# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: depth against confining pressure in dry rock, with cells of several sizes, and a cross-section that shows radial cracks."""
import matplotlib.pyplot as plt
import numpy as np
from paper_figures import cracks
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS, DECK, draw_channels, measured, settings_of, sound

TABLES = ("paper_7", "paper_7_cracks")
PRESSURES = (0.0, 17.0, 34.0, 69.0, 138.0)  # MPa
DEPTHS = ("depth at 30 us [mm]", "depth [mm]")
NOISE = 0.5  # mm: final depths differ by as much between seeds of figure 10
CONVERGED_AT, QUICK = (34.0, 138.0), (0.0, 138.0)


def wanted(form):
    """[(confinement, cells)]"""
    if form == "quick":
        return [(pressure, CELLS[form]) for pressure in QUICK]
    own = CELLS[form]
    coarser = [(pressure, 2.0 * own) for pressure in CONVERGED_AT]
    return [(pressure, own) for pressure in PRESSURES] + coarser + [(CONVERGED_AT[-1], 0.5 * own)]


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
    figure, panels = plt.subplots(1, 2, figsize=(11.0, 4.2), layout="constrained")
    for axes, column, title in zip(panels, DEPTHS, ("after 30 µs", "greatest")):
        for i, cells in enumerate(sorted(set(table.column("cells [mm]")), reverse=True)):
            pressure, depth = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", column))
            axes.plot(pressure, depth, "o-", color=f"C{i}", label=f"cells of {cells:g} mm, {2.0 / cells:g} per jet radius")
        axes.set(xlabel="confining pressure [MPa]", ylabel="depth [mm]", title=title, ylim=(0.93 * axes.get_ylim()[0], 1.03 * axes.get_ylim()[1]))
        axes.grid(alpha=0.3)
    panels[0].legend(fontsize=9, loc="lower left")
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(tables):
    table = tables["paper_7"]
    out = []
    for cells in sorted(set(table.column("cells [mm]"))):
        pressure, early, final = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", *DEPTHS))
        if len(pressure) < 2:
            continue
        order = np.argsort(pressure)
        steps = [-np.diff(depth[order]) for depth in (early, final)]
        out += [
            least(f"7: cells of {cells:g} mm: the depth after 30 us falls from each confining pressure to the next, by so many mm", steps[0].min(), 0.1),
            least(f"7: cells of {cells:g} mm: the greatest depth falls likewise, or rises by less than the noise, in mm", steps[1].min(), -NOISE),
            most(f"7: cells of {cells:g} mm: greatest depth at the highest confining pressure over that at the lowest", final[order][-1] / final[order][0], 0.98),
        ]
    out.append(most("7: shots are nearly over: growth of the depth in the last 20 us", table.column("growth in the last 20 us").max(), 0.03))
    out.append(sound(table, 7))
    return out + cracks.trends(tables["paper_7_cracks"])
