# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: what a spall stress of the jet's metal changes, until its spent metal comes near the end of the rock."""
import numpy as np
from paper_figures.lab import Table, least, most
from paper_figures.shots import DECK, measured, settings_of

SPALL = {"none": {}, "2 GPa": {"Materials/Tungsten/Spall Stress": "2 GPa"}}
PRESSURES = (0.0, 138.0)  # MPa
END = 60.0  # us
CELLS = {"none": (2.0, 1.0), "2 GPa": (2.0, 1.0, 0.5)}  # mm; without a spall stress those of 0.5 mm gain energy
FINAL, ENERGY = "depth at 60 us [mm]", "numerical energy"


def asked(form):
    """[(spall stress, confinement, cells)]"""
    if form == "quick":
        return [(spall, 0.0, 2.0) for spall in SPALL]
    return [(spall, pressure, cells) for spall in SPALL for cells in CELLS[spall] for pressure in PRESSURES]


def measure(lab):
    wanted = asked(lab.form)
    runs = [(DECK, settings_of(h, p, {"Time/End Time": f"{END:g} us", **SPALL[spall]}), f"spall-{spall.replace(' ', '')}-{p:g}-{h:g}") for spall, p, h in wanted]
    rows = []
    for (spall, pressure, cells), folder in zip(wanted, lab.runs(runs)):
        shot = measured(folder)
        rows.append([spall, pressure, cells, shot.early, shot.depth, shot.volume, shot.radius, shot.lost])
    columns = ["spall stress", "confinement [MPa]", "cells [mm]", "depth at 30 us [mm]", FINAL, "hole [cm3]", "mean radius [mm]", ENERGY]
    return Table(f"Figure 7: input_xml/paper/{DECK}, to {END:g} us, without and with Spall Stress", columns, rows)


def trends(table):
    lost = {spall: np.abs(table.column(ENERGY, **{"spall stress": spall})).max() for spall in SPALL}
    out = [most("7: with a spall stress: energy that the method adds or loses, over what was put in", lost["2 GPa"], 0.03)]
    if 1.0 in table.column("cells [mm]"):
        depth = [table.value(FINAL, **{"spall stress": spall, "cells [mm]": 1.0, "confinement [MPa]": 0.0}) for spall in SPALL]
        out.append(least("7: with a spall stress, cells of 1 mm: the depth after 60 us over that without", depth[1] / depth[0], 1.1))
    return out
