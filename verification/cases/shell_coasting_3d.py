# SPDX-License-Identifier: BSD-3-Clause
"""Coasting implosion of the thick shell in three dimensions: the octant between three symmetry planes."""
from tools.case import Result
from cases.shell_coasting import measure
from cases.shell_coasting import settings as flat_settings
from tools.octant import octant
from tools.runs import order

RATIO, STOP = 10.0, -0.08


def in_space(cells):
    flat = flat_settings(STOP, RATIO, cells)
    h = float(flat["Grid/Cell Size"])
    side = float(flat["Grid/Upper"].strip("{}").split(",")[0])
    return octant("Shell", side, h)


def run(barreno, full):
    result = Result(
        "Coasting implosion of a thick shell, in three dimensions",
        "Plastic work, inertia and curved free surfaces without axial symmetry: an octant of cubes.",
        "a one-dimensional shell of the same K/G = 10 (`verification/oracles/shell_motion.py`), and the axisymmetric run of the "
        "same cells. Lengths relative to the travel of the inner wall, pressures relative to Y, half-way.",
        ["mode", "cells in the wall", "travel", "against dense", "rms path error against dense", "order",
         "time of least kinetic energy, error", "spread of r^3 - R^3", "rms pressure error", "99 % of pressure errors",
         "plastic work / initial kinetic", "energy ledger remainder"],
        [],
    )  # fmt: skip
    levels = (3, 6, 12) if full else (3, 6)
    runs = {}
    for mode in ("axisymmetric", "3D"):
        for cells in levels:
            m = runs[mode, cells] = measure(barreno, STOP, RATIO, cells, in_space(cells) if mode == "3D" else None)
            rate = order([runs[mode, cells // 2]["path"], m["path"]])[0] if cells > levels[0] else float("nan")
            result.rows.append([mode, cells, m["stopped"], m["stopped"] - m["dense"], m["path"], rate, m["time"], m["spread"],
                                m["pressure"], m["pressure 99 %"], m["plastic"], m["remainder"]])  # fmt: skip
    fine, plane = runs["3D", levels[-1]], runs["axisymmetric", levels[-1]]
    name = f"{levels[-1]} cells"
    # 2 % at 32 cells and the first order of a surface that is a staircase of cells: so much more at fewer.
    allowed = 0.02 * 32 / levels[-1]
    result.demand(f"travel of the inner wall against the dense shell, {name}", abs(fine["stopped"] - fine["dense"]), allowed)
    result.demand("its order, minimum over all halvings", min(order([runs["3D", n]["path"] for n in levels])), 0.9, at_least=True)
    result.demand(f"travel in 3D less that in axisymmetry, {name}", abs(fine["stopped"] - plane["stopped"]), allowed)
    result.demand(f"plastic work in 3D over that in axisymmetry, less 1, {name}", abs(fine["plastic"] / plane["plastic"] - 1), 0.01)
    result.demand(f"instant of least kinetic energy, relative, {name}", abs(fine["time"]), allowed)
    result.demand(f"energy ledger remainder, {name}", fine["remainder"], 1e-3)
    return result
