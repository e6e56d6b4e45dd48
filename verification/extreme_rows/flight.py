# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a particle or two in free flight: nothing happens to them."""
import numpy as np
from choices import shape_functions
from extreme_rows.stable_step import CONTROL
from small_decks import BARE, attempt, elastic

NO_STEP = "linear functions have no stable step where a particle is near a node line (docs/method.md 4); `check` says so"
MODES = {"plane strain": 2, "axisymmetric": 2, "3D": 3}


def flying(mode, shape, per_cell, fraction, shear, across=1, speed=1.0, near_axis=False):
    """`across` particles each way, slow against c = 100 m/s: hundreds of steps at every place in a cell."""
    n = MODES[mode]
    size = across / per_cell
    begin = [1.03, 1.03, 1.03][:n]
    velocity = [0.0 if mode == "axisymmetric" else 0.37 * speed, speed, 0.21 * speed][:n]
    if mode == "axisymmetric":
        begin[0] = 0.0 if near_axis else 3.3
    modulus = 1e7
    deck = {
        "Grid": {"Mode": mode, "Lower": [0] * n, "Upper": [5, 8, 5][:n], "Cell Size": 1.0},
        "Materials": {"Elastic": elastic(modulus - 4.0 * shear / 3.0, shear)},
        "Bodies": {
            "Crumb": {
                "Material": "Elastic", "Lower": begin, "Upper": [b + size for b in begin], "Particles Per Cell": per_cell, "Velocity": velocity,
            }
        },
        "Step": {"Shape Function": shape, "Courant Fraction": fraction, **BARE},
        "Time": {"End Time": 4.0 / speed},
        "Output": {"History Interval": 0.1 / speed},
    }  # fmt: skip
    if near_axis:
        deck["Conditions"] = {"Axis": {"Face": "x_lower", "Kind": "symmetry"}}
    return deck


def stray_energy(run):
    """What has become of the kinetic energy, over it."""
    table = run.table("history.csv")
    return float((np.abs(table["kinetic"] - table["kinetic"][0]) + np.abs(table["elastic"])).max() / table["kinetic"][0])


SHEARS = {"nu = 0.3": 1e7 / 3.5, "nu = 0.49": 1e7 / 51.0}  # M = lambda + 2 G = G (2 - 2 nu) / (1 - 2 nu)


def run(barreno, full, table):
    title = "A particle alone in free flight"
    for shape in shape_functions(barreno):
        for mode, near_axis in (("plane strain", False), ("axisymmetric", False), ("axisymmetric", True), ("3D", False)):
            for poisson, shear in SHEARS.items():
                for per_cell in (1, 2, 4) if full else (2,):
                    for fraction in (0.8, 0.99) if full else (0.99,):
                        done = attempt(barreno, flying(mode, shape, per_cell, fraction, shear, near_axis=near_axis), longest=120.0)
                        where = "at the axis" if near_axis else ""
                        setup = f"{mode} {where} {shape}, {per_cell} per cell, {poisson}, Courant Fraction {fraction:g}"
                        why = NO_STEP if shape == CONTROL else ""
                        known = table.holds_or_stops if shape == CONTROL else table.finishes
                        if shape == CONTROL:
                            known(title, setup, done, "stray energy over kinetic", stray_energy, 1e-9, "at t = ", why=why)
                        else:
                            known(title, setup, done, "stray energy over kinetic", stray_energy, 1e-9)
    title = "Few particles in free flight"
    for across in (2, 3):
        for per_cell in (1, 2) if full else (2,):
            done = attempt(barreno, flying("plane strain", "GIMP", per_cell, 0.8, SHEARS["nu = 0.3"], across=across))
            table.finishes(title, f"{across} by {across} particles, GIMP, {per_cell} per cell", done, "stray energy over kinetic", stray_energy, 1e-9)
