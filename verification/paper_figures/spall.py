# SPDX-License-Identifier: BSD-3-Clause
"""Figures 7, 8 and 10: what a spall stress of the jet's metal changes, until its spent metal comes near the end of the rock."""
import re

import matplotlib.pyplot as plt
import numpy as np
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS as DEFAULT_CELLS
from paper_figures.shots import DECK, measured, settings_of

SPALL = {"none": {}, "2 GPa": {"Materials/Tungsten/Spall Stress": "2 GPa"}}
PRESSURES = (0.0, 138.0)  # MPa
END = 60.0  # us
CELLS = {"none": (2.0, 1.0), "2 GPa": (2.0, 1.0, 0.5)}  # mm; without a spall stress those of 0.5 mm gain energy
PRESSURE, EARLY = "confinement [MPa]", "depth at 30 us [mm]"
FINAL, ENERGY = "depth at 60 us [mm]", "numerical energy"


def asked(form):
    """[(spall stress, confinement, cells)]"""
    if form == "quick":
        return [("none", PRESSURES[0], 2.0), *(("2 GPa", pressure, 2.0) for pressure in PRESSURES)]
    return [(spall, pressure, cells) for spall in SPALL for cells in CELLS[spall] for pressure in PRESSURES]


def measure(lab):
    wanted = asked(lab.form)
    runs = [(DECK, settings_of(h, p, {"Time/End Time": f"{END:g} us", **SPALL[spall]}), f"spall-{spall.replace(' ', '')}-{p:g}-{h:g}")
        for spall, p, h in wanted]
    rows = []
    for (spall, pressure, cells), folder in zip(wanted, lab.runs(runs)):
        shot = measured(folder)
        rows.append([spall, pressure, cells, shot.early, shot.depth, shot.volume, shot.radius, shot.lost])
    columns = ["spall stress", PRESSURE, "cells [mm]", EARLY, FINAL, "hole [cm3]", "mean radius [mm]", ENERGY]
    table = Table(f"Figure 7: input_xml/paper/{DECK}, to {END:g} us, without and with Spall Stress", columns, rows)
    if lab.form != "quick":
        draw(lab.picture("paper_7_spall"), table)
    return table


def compare(lab, number, confinement, cases):
    """Table of the same shots without and with a spall stress.  @param cases  {rock: settings}"""
    cells = DEFAULT_CELLS[lab.form]
    wanted = [(rock, stress, {"Time/End Time": f"{END:g} us", **SPALL[stress], **more}) for rock, more in cases.items() for stress in SPALL]
    names = [f"spall-{number}-" + re.sub(r"[^a-z0-9]+", "-", f"{rock} {stress}".lower()) for rock, stress, _ in wanted]
    folders = lab.runs([(DECK, settings_of(cells, confinement, more), name) for (*_, more), name in zip(wanted, names)])
    rows = []
    for (rock, stress, _), folder in zip(wanted, folders):
        shot = measured(folder)
        rows.append([rock, stress, shot.early, shot.depth, shot.volume, shot.radius, shot.lost])
    remark = (
        f"Figure {number}: input_xml/paper/{DECK}, cells of {cells:g} mm, {confinement:g} MPa of confinement, to {END:g} us, without and "
        "with Spall Stress"
    )
    return Table(remark, ["rock", "spall stress", EARLY, FINAL, "hole [cm3]", "mean radius [mm]", ENERGY], rows)


def ratio(table, column, spall, rock, other):
    """Of a column, of one rock over another."""
    return float(table.value(column, **{"spall stress": spall, "rock": rock}) / table.value(column,
        **{"spall stress": spall, "rock": other}))


def value_at(table, column, spall, cells, pressure):
    return float(table.value(column, **{"spall stress": spall, "cells [mm]": cells, PRESSURE: pressure}))


def change_of(table, column, spall, cells):
    """Of a column from the lowest to the highest confining pressure, relative."""
    low, high = (value_at(table, column, spall, cells, pressure) for pressure in PRESSURES)
    return high / low - 1.0


def falls_of(table):
    """What confinement does, without and with a spall stress: changes in percent."""
    columns = [EARLY, FINAL, "hole [cm3]"]
    heads = ["spall stress", "cells [mm]",
        *(f"{name.rsplit(' [', 1)[0]}: change from {PRESSURES[0]:g} to {PRESSURES[1]:g} MPa [%]" for name in columns)]
    rows = [[spall, cells, *(100.0 * change_of(table, name, spall, cells) for name in columns)] for spall in SPALL
        for cells in CELLS[spall]]
    return Table("", heads, rows)


def draw(file, table):
    figure, panels = plt.subplots(1, 2, figsize=(11.0, 4.2), layout="constrained")
    for axes, column, when in zip(panels, (EARLY, FINAL), ("after 30 µs", f"after {END:g} µs")):
        for spall, style in zip(SPALL, ("o--", "s-")):
            for cells in CELLS[spall]:
                depths = [value_at(table, column, spall, cells, pressure) for pressure in PRESSURES]
                words = "no spall stress" if spall == "none" else f"spall stress {spall}"
                axes.plot(PRESSURES, depths, style, color=f"C{round(np.log2(2.0 / cells))}", label=f"{words}, cells of {cells:g} mm")
        axes.set(xlabel="confining pressure [MPa]", ylabel="depth [mm]", title=when)
        axes.grid(alpha=0.3)
    panels[1].legend(fontsize=8.5, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def trends(table):
    lost = {spall: np.abs(table.column(ENERGY, **{"spall stress": spall})).max() for spall in SPALL}
    out = [most("7: spall stress: numerical energy over energy put in", lost["2 GPa"], 0.03)]
    for cells, deeper in ((2.0, 1.05), (1.0, 1.1)):
        if cells in table.column("cells [mm]"):
            depth = [value_at(table, FINAL, spall, cells, 0.0) for spall in SPALL]
            out.append(least(f"7: cells of {cells:g} mm: depth after 60 us, with a spall stress over without", depth[1] / depth[0], deeper))
    holes = [-change_of(table, "hole [cm3]", "2 GPa", cells)
        for cells in sorted(set(table.column("cells [mm]", **{"spall stress": "2 GPa"})))]
    out.append(least("7: spall stress, any cells, 0 to 138 MPa: fall of the hole's volume, relative", min(holes), 0.15))
    finest = min(CELLS["2 GPa"])
    if finest in table.column("cells [mm]"):
        fall = -change_of(table, FINAL, "2 GPa", finest)
        out.append(most(f"7: spall stress, cells of {finest:g} mm, {PRESSURES[0]:g} to {PRESSURES[1]:g} MPa (against the paper, hardly): "
            f"fall of the depth after {END:g} us, relative", fall, 0.02))
    return out
