# SPDX-License-Identifier: BSD-3-Clause
"""What a pulse that runs into smaller cells leaves behind, against the wake that a uniform grid leaves by itself."""
import numpy as np
from tools.case import Result
from tools.manufactured_runs import centres
from tools.runs import run_deck

DECK = "border_pulse.xml"
PEAK = 0.05  # of the pulse that runs upwards [m/s]
BEHIND, BEYOND = (0.9, 1.9), (2.4, 3.2)  # where what comes back is at the end, and around the pulse [m]
SIZE = 0.4  # of the pulse, which begins at BEYOND[0] at the end [m]
SHAPES = ("GIMP", "CPDI", "quadratic B-spline")
MOST = 2.0  # times the wake of the uniform grid
BORDERS = (2.0, 1.92)  # where the small cells begin [m]: splines leave more behind at one than at the other


def in_mode(mode):
    if mode != "3D":
        return {"Grid/Mode": mode}
    settings = {"Grid/Mode": mode, "Conditions/Front/Face": "z_lower", "Conditions/Front/Kind": "symmetry",
        "Conditions/Back/Face": "z_upper",
                "Conditions/Back/Kind": "symmetry", "Bodies/Pulse/Velocity": "{0 m/s, 0.1 m/s, 0 m/s}",
                "Bodies/Pulse/Velocity Wave Number": f"{{0 1/m, {np.pi / SIZE!r} 1/m, 0 1/m}}"}  # fmt: skip
    for name, lower, upper in (("Grid", -0.16, 4.16), ("Refinement/Upper half", 2.0, 4.16), ("Bodies/Below", 0.0, 0.8),
            ("Bodies/Pulse", 0.8, 1.2),
                               ("Bodies/Above", 1.2, 4.0)):  # fmt: skip
        settings |= {f"{name}/Lower": f"{{0 m, {lower} m, 0 m}}", f"{name}/Upper": f"{{0.04 m, {upper} m, 0.04 m}}"}
    return settings


def on_grid(grid, mode, border):
    """Of one size: the refined region begins above the bar."""
    lower = 4.15 if grid == "uniform" else border
    steps = {"Step/Subcycles": "2"} if grid == "refined, two parts" else {}
    return {"Refinement/Upper half/Lower": f"{{0 m, {lower} m, 0 m}}" if mode == "3D" else f"{{0 m, {lower} m}}", **steps}


def measure(barreno, mode, shape, grid, border):
    """Largest velocity behind the border and largest error around the pulse beyond it, relative to the pulse, and the ledger's
    remainder."""
    run = run_deck(barreno, DECK, {"Step/Shape Function": shape, **in_mode(mode), **on_grid(grid, mode, border)})
    now = run.particles()
    y, v = centres(now)[1], now["velocity_y"] / PEAK
    in_pulse = (y > BEYOND[0]) & (y < BEYOND[0] + SIZE)
    exact = np.where(in_pulse, np.sin(np.pi * (y - BEYOND[0]) / SIZE), 0.0)
    behind, beyond = (y > BEHIND[0]) & (y < BEHIND[1]), (y > BEYOND[0]) & (y < BEYOND[1])
    return float(np.abs(v[behind]).max()), float(np.abs(v - exact)[beyond].max()), abs(run.summary["balances"]["energy"]["error"])


def run(barreno, full):
    result = Result(
        "A pulse meets smaller cells",
        "A pulse of 20 cells runs into cells of half the size. It leaves at most twice as much behind as on a uniform grid, with one "
        "step for all and with steps of two lengths.",
        "d'Alembert: nothing behind the pulse. Largest velocity from 0.9 to 1.9 m, where the reflection is at 1.6 ms, and largest error "
        "of the velocity from 2.4 to 3.2 m. Both are relative to the pulse's peak. "
        "Two parts: `Step/Subcycles` = 2, which CPDI does not take.",
        ["mode", "shape function", "grid", "border [m]", "left behind", "over the uniform grid's", "error beyond",
            "energy ledger remainder"],
        [],
    )  # fmt: skip
    cases = [(mode, shape) for mode in ("plane strain", "axisymmetric")
        for shape in SHAPES] + [("3D", "GIMP")] if full else [("plane strain", "GIMP")]
    for mode, shape in cases:
        grids = ("uniform", "refined") if shape == "CPDI" else ("uniform", "refined", "refined, two parts")
        own = None
        for grid, border in [("uniform", "")] + [(grid, border) for grid in grids[1:] for border in BORDERS]:
            left, beyond, remainder = measure(barreno, mode, shape, grid, border)
            own = own or left
            result.rows.append([mode, shape, grid, border, left, left / own, beyond, remainder])
            name = f"{mode}, {shape}, {grid}" + (f" from {border:g} m on" if border else "")
            if grid != "uniform":
                result.demand(f"{name}: left behind over the uniform grid's", left / own, MOST)
            result.demand(f"{name}: energy ledger remainder", remainder, 1e-6)
    return result
