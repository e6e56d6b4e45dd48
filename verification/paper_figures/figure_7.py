# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: depth against confining pressure in dry rock, with cells of several sizes, and a cross-section that shows radial cracks."""
import matplotlib.pyplot as plt
import numpy as np
from paper_figures import cracks, spall
from paper_figures.figure_3 import CARD
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS, DECK, draw_channels, measured, settings_of, sound
from paper_figures.surface import card_numbers

TABLES = ("paper_7", "paper_7_strength", "paper_7_cracks", "paper_7_spall")
PRESSURES = (0.0, 17.0, 34.0, 69.0, 138.0)  # MPa
DEPTHS = ("depth at 30 us [mm]", "depth [mm]")
STRENGTHS, UNCONFINED = (0.5, 1.0, 2.0), 56.0  # factors of the card; MPa, of the card (docs/materials/berea_fit.md)
NOISE = 0.5  # mm: final depths differ by as much between seeds of figure 10
CONVERGED_AT, QUICK = (34.0, 138.0), (0.0, 138.0)


def wanted(form):
    """[(confinement, cells)]"""
    if form == "quick":
        return [(pressure, CELLS[form]) for pressure in QUICK]
    own = CELLS[form]
    return [(pressure, own) for pressure in PRESSURES] + [(pressure, factor * own) for factor in (2.0, 0.5) for pressure in CONVERGED_AT]


def name_of(pressure, cells):
    return f"confined-{pressure:g}-{cells:g}"


def measure(lab):
    asked = wanted(lab.form)
    folders = lab.runs([(DECK, settings_of(cells, pressure), name_of(pressure, cells)) for pressure, cells in asked])
    rows = []
    for (pressure, cells), folder in zip(asked, folders):
        shot = measured(folder)
        rows.append([pressure, cells, shot.early, shot.depth, shot.growth, shot.volume, shot.radius, shot.lost])
    columns = ["confinement [MPa]", "cells [mm]", "depth at 30 us [mm]", "depth [mm]", "growth in the last 20 us", "hole [cm3]",
        "mean radius [mm]", "numerical energy"]
    table = Table(f"Figure 7: input_xml/paper/{DECK}; depth: the greatest of 100 us", columns, rows)
    if lab.form != "quick":
        main = [(f"confining pressure {p:g} MPa\n{row[3]:.1f} mm deep", folder)
            for (p, cells), row, folder in zip(asked, rows, folders) if cells == CELLS[lab.form]]
        fields, limits = ("pressure", "plastic_volume_strain"), ((0.0, 300.0), (-0.2, 0.2))
        draw_channels(lab.picture("paper_7"), main, fields, limits, (22.0, -8.0, 60.0))
        draw_depths(lab.picture("paper_7_depth"), table)
    return {"paper_7": table, "paper_7_strength": strengths(lab), "paper_7_cracks": cracks.measure(lab),
        "paper_7_spall": spall.measure(lab)}


def strengths(lab):
    """Shots at no confinement into rock of several strengths: PEAKI1 and STREN in proportion, and with them the strength in every test
    without the cap."""
    card, cells, rows = card_numbers(CARD), max(CELLS[lab.form], 2.0), []
    factors = STRENGTHS if lab.form != "quick" else STRENGTHS[1:]
    words = [{} if f == 1.0 else {f"Materials/Sandstone/{name}": f"{f * card[name]:g}" for name in ("PEAKI1", "STREN")} for f in factors]
    folders = lab.runs([(DECK, settings_of(cells, 0.0, more), f"strength-{f:g}") for f, more in zip(factors, words)])
    for factor, folder in zip(factors, folders):
        shot = measured(folder)
        rows.append([factor * UNCONFINED, shot.early, shot.depth, shot.lost])
    remark = (
        f"Figure 7: input_xml/paper/{DECK}, cells of {cells:g} mm, no confinement; the card's PEAKI1 and STREN times "
        f"{', '.join(f'{f:g}' for f in factors)}"
    )
    return Table(remark, ["unconfined strength [MPa]", *DEPTHS, "numerical energy"], rows)


def slope(x, depth):
    """Of the logarithm of the depth."""
    return float(np.polyfit(x, np.log(depth), 1)[0])


def draw_depths(file, table):
    figure, panels = plt.subplots(1, 2, figsize=(11.0, 4.2), layout="constrained")
    for axes, column, title in zip(panels, DEPTHS, ("after 30 µs", "greatest")):
        for i, cells in enumerate(sorted(set(table.column("cells [mm]")), reverse=True)):
            pressure, depth = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", column))
            axes.plot(pressure, depth, "o-", color=f"C{i}", label=f"cells of {cells:g} mm, {2.0 / cells:g} per jet radius")
        axes.set(xlabel="confining pressure [MPa]", ylabel="depth [mm]", title=title,
            ylim=(0.93 * axes.get_ylim()[0], 1.03 * axes.get_ylim()[1]))
        axes.grid(alpha=0.3)
    panels[0].legend(fontsize=9, loc="lower left")
    figure.savefig(file, dpi=110)
    plt.close(figure)


def experiments(table, strength):
    """Signs that laboratory shots have."""
    cells = table.rows[0][1]
    pressure, depth = (table.column(name, **{"cells [mm]": cells}) for name in ("confinement [MPa]", "depth [mm]"))
    return [
        most("7: over effective confining pressure (experiments, negative): slope of ln(depth) per MPa", slope(pressure, depth), -2e-4),
        most("7: over unconfined strength (experiments, negative): slope of ln(depth) per MPa",
            slope(strength.column("unconfined strength [MPa]"), strength.column("depth [mm]")), -1e-3),
        sound(strength, 7, "strengths: "),
    ]


def fall_of(table, cells):
    low, high = (table.value("depth [mm]", **{"cells [mm]": cells, "confinement [MPa]": pressure}) for pressure in CONVERGED_AT)
    return high / low


DRAWN = {"paper_7_depth": lambda file, tables: draw_depths(file, tables["paper_7"]), "paper_7_spall": lambda file,
    tables: spall.draw(file, tables["paper_7_spall"])}  # of the tables alone


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
            least(f"7: cells of {cells:g} mm, after 30 us: fall of the depth from one confining pressure to the next [mm]",
                steps[0].min(), 0.1),
            least(f"7: cells of {cells:g} mm (noise allowed): fall of the greatest depth from one confining pressure to the next [mm]",
                steps[1].min(), -NOISE),
            most(f"7: cells of {cells:g} mm: greatest depth, highest over lowest confining pressure",
                final[order][-1] / final[order][0], 0.98),
        ]
    own = table.rows[0][1]
    growth = table.column("growth in the last 20 us", **{"cells [mm]": own}).max()
    out.append(most(f"7: cells of {own:g} mm, last 20 us: growth of the depth", growth, 0.03))
    falls = [fall_of(table, cells) for cells in set(table.column("cells [mm]"))
        if cells in table.column("cells [mm]", **{"confinement [MPa]": CONVERGED_AT[0]})]
    if len(falls) > 1:
        out.append(most("7: all cell sizes: difference of the ratio of greatest depths, 138 MPa over 34 MPa",
            max(falls) - min(falls), 0.02))
    out.append(sound(table, 7))
    strength = tables["paper_7_strength"]
    if len(strength.rows) > 1:
        out += experiments(table, strength)
    return out + cracks.trends(tables["paper_7_cracks"]) + spall.trends(tables["paper_7_spall"])
