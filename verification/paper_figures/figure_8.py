# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: depth in drained and in undrained rock without initial pore pressure; with it, at equal effective stress and at equal
confinement."""
import matplotlib.pyplot as plt
import numpy as np
from paper_figures import spall
from paper_figures.lab import Table, least, most
from paper_figures.shots import CELLS, DECK, draw_channels, measured, settings_of, sound

TABLES = ("paper_8", "paper_8_spall")
WATER = {"Materials/Sandstone/fluid_B0": "2.25 GPa", "Materials/Sandstone/Density": "2320 kg/m3"}  # pores full: 0.20 of 1000 kg/m3 more
DRY = None  # pore pressure of drained rock: none, whatever happens
EFFECTIVE = 34.0  # MPa
DEPTHS = ("depth at 30 us [mm]", "depth [mm]")
# (confinement, initial pore pressure) in MPa
UNLOADED = [(0.0, DRY), (0.0, 0.0)]
EQUAL_EFFECTIVE = [(34.0, 0.0), (69.0, 35.0), (103.0, 69.0)]
EQUAL_CONFINEMENT = [(69.0, DRY), (69.0, 0.0), (69.0, 35.0), (69.0, 60.0)]
QUICK_END = "40 us"  # of the short form: all is judged at 30 us and then
HEAVY = {"Materials/Sandstone/Density": "2320 kg/m3"}  # dry rock as heavy as wet one: what the mass alone does


def words(pore):
    return {} if pore is DRY else {**WATER, "Bodies/Rock/Pore Pressure": f"{pore:g} MPa"}


def cases(form):
    """[(rock, confinement, pore pressure, settings)]"""
    pairs = list(dict.fromkeys([*UNLOADED, *EQUAL_EFFECTIVE, *EQUAL_CONFINEMENT]))
    out = [("drained" if pore is DRY else "undrained", confinement, pore, words(pore)) for confinement, pore in pairs]
    until = {"Time/End Time": QUICK_END} if form == "quick" else {}
    return [(*what, {**settings, **until}) for *what, settings in [*out, ("drained, as heavy as undrained", 0.0, DRY, HEAVY)]]


def measure(lab):
    cells, asked = CELLS[lab.form], cases(lab.form)
    runs = [(DECK, settings_of(cells, confinement, more), f"fluid-{rock.replace(', ', '-').replace(' ', '-')}-{confinement:g}-{pore}")
        for rock, confinement, pore, more in asked]
    folders, rows = lab.runs(runs), []
    for (rock, confinement, pore, _), folder in zip(asked, folders):
        shot = measured(folder)
        rows.append([rock, confinement, float("nan") if pore is DRY else pore, shot.early, shot.depth, shot.volume, shot.radius, shot.lost])
    remark = f"Figure 8: input_xml/paper/{DECK}, cells of {cells:g} mm; pore pressure of the start; depth: the greatest of 100 us"
    table = Table(remark, ["rock", "confinement [MPa]", "pore pressure [MPa]", "depth at 30 us [mm]", "depth [mm]", "hole [cm3]",
        "mean radius [mm]", "numerical energy"], rows)
    if lab.form != "quick":
        channels = [(f"{rock}\n{rows[i][4]:.1f} mm deep", folders[i]) for i, rock in ((0, "drained"), (1, "undrained"))]
        fields, limits = ("pressure", "plastic_volume_strain"), ((0.0, 200.0), (-0.2, 0.2))
        draw_channels(lab.picture("paper_8"), channels, fields, limits, (24.0, -16.0, 64.0))
        draw_depths(lab.picture("paper_8_pore"), table)
        return {"paper_8": table, "paper_8_spall": spall.compare(lab, 8, *spall_cases())}
    return {"paper_8": table}


def spall_cases():
    """(confinement, {rock: settings}) of the first pair."""
    return UNLOADED[0][0], {"drained": words(UNLOADED[0][1]), "undrained": words(UNLOADED[1][1])}


def depth_of(table, confinement, pore, column="depth [mm]"):
    rows = [row for row in table.rows if row[1] == confinement and (np.isnan(row[2]) if pore is DRY else row[2] == pore)
        and row[0] in ("drained", "undrained")]
    return rows[0][table.columns.index(column)]


def draw_depths(file, table):
    figure, panels = plt.subplots(2, 2, figsize=(10.0, 6.6), layout="constrained", sharey="row", sharex=True)
    titles = (f"equal effective stress, {EFFECTIVE:g} MPa", f"equal confining pressure, {EQUAL_CONFINEMENT[0][0]:g} MPa")
    for row, column, when in zip(panels, DEPTHS, ("after 30 µs", "at its greatest")):
        for axes, pairs in zip(row, (EQUAL_EFFECTIVE, EQUAL_CONFINEMENT[1:])):
            varied = len({confinement for confinement, _ in pairs}) > 1
            depths = [depth_of(table, *pair, column) for pair in pairs]
            axes.plot([pore for _, pore in pairs], depths, "o-", label="undrained")
            for (confinement, pore), depth in zip(pairs if varied else (), depths):
                axes.annotate(f"confined by {confinement:g} MPa", (pore, depth), (0, 9), textcoords="offset points",
                    ha="center", fontsize=8)
            axes.grid(alpha=0.3)
        row[1].axhline(depth_of(table, *EQUAL_CONFINEMENT[0], column), color="0.4", ls="--", label="drained")
        row[0].set_ylabel(f"depth {when} [mm]")
        low, high = row[1].get_ylim()
        row[1].set_ylim(low - 0.05 * (high - low), high + 0.15 * (high - low))
    for axes, title in zip(panels[0], titles):
        axes.set(title=title, xlim=(-14.0, 84.0))
    for axes in panels[1]:
        axes.set_xlabel("initial pore pressure [MPa]")
    panels[1, 1].legend(fontsize=9, loc="center right")
    figure.savefig(file, dpi=110)
    plt.close(figure)


DRAWN = {"paper_8_pore": lambda file, tables: draw_depths(file, tables["paper_8"])}  # of the tables alone


def trends(tables):
    table = tables["paper_8"]
    out = [least(f"8: no confinement, no initial pore pressure: {column.removesuffix(' [mm]')}, undrained over drained",
        ratio_of(table, UNLOADED, column), 1.005) for column in DEPTHS]
    heavy = table.value(DEPTHS[0], rock="drained, as heavy as undrained")
    out.append(most("8: mass of the fluid alone: depth at 30 us, heavier over lighter drained rock",
        heavy / depth_of(table, *UNLOADED[0], DEPTHS[0]), 1.0))
    for column, spread, step in zip(DEPTHS, (0.01, 0.03), (0.05, 0.1)):
        alike, rising = ([depth_of(table, *pair, column) for pair in pairs] for pairs in (EQUAL_EFFECTIVE, EQUAL_CONFINEMENT))
        name = column.removesuffix(" [mm]")
        out.append(most(f"8: equal effective stress: {name}, largest over smallest less 1", max(alike) / min(alike) - 1.0, spread))
        out.append(least(f"8: equal confinement, from drained rock to higher pore pressures: least growth of {name} [mm]",
            np.diff(rising).min(), step))
    if "paper_8_spall" in tables:
        depth = spall.ratio(tables["paper_8_spall"], spall.FINAL, "2 GPa", "undrained", "drained")
        out.append(least("8: spall stress, no confinement, no initial pore pressure: depth after 60 us, undrained over drained",
            depth, 1.005))
    return [*out, sound(table, 8)]


def ratio_of(table, pairs, column):
    """Depth of the second over that of the first."""
    return depth_of(table, *pairs[1], column) / depth_of(table, *pairs[0], column)
