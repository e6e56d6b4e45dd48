# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a particle or two in free flight: nothing happens to them."""
import numpy as np
from tools.choices import shape_functions
from extreme_rows.stable_step import CONTROL
from tools.small_decks import BARE, attempt, elastic

STRAY = "stray energy over kinetic"
MODES = {"plane strain": 2, "axisymmetric": 2, "3D": 3}


def flying(mode, shape, per_cell, fraction, poisson, across=1, near_axis=False, viscosity=False):
    """`across` particles each way at 1 m/s against c = 100 m/s: hundreds of steps at every place in a cell."""
    n = MODES[mode]
    size = across / per_cell
    begin = [1.03, 1.03, 1.03][:n]
    velocity = [0.37, 1.0, 0.21][:n]
    if mode == "axisymmetric":
        begin[0], velocity[0] = 0.0 if near_axis else 3.3, 0.0
    shear = 1e7 * (1.0 - 2.0 * poisson) / (2.0 - 2.0 * poisson)  # of M = K + 4 G / 3 = 10 MPa
    deck = {
        "Grid": {"Mode": mode, "Lower": [0, -3, -3][:n], "Upper": [8, 8, 8][:n], "Cell Size": 1.0},
        "Materials": {"Elastic": elastic(1e7 - 4.0 * shear / 3.0, shear)},
        "Bodies": {
            "Crumb": {
                "Material": "Elastic", "Lower": begin, "Upper": [b + size for b in begin], "Particles Per Cell": per_cell,
                "Velocity": velocity,
            }
        },
        "Step": {"Shape Function": shape, "Courant Fraction": fraction, "Stable Alone": "true", **({} if viscosity else BARE)},
        "Time": {"End Time": 3.0},
        "Output": {"History Interval": 0.1},
    }  # fmt: skip
    if mode == "axisymmetric":
        deck["Conditions"] = {"Axis": {"Face": "x_lower", "Kind": "symmetry"}}
    return deck


def stray_energy(run):
    """What has become of the kinetic energy, over it."""
    table = run.table("history.csv")
    return float((np.abs(table["kinetic"] - table["kinetic"][0]) + np.abs(table["elastic"])).max() / table["kinetic"][0])


def alone_rows(barreno, full, table):
    title = "A particle alone in free flight"
    for shape in shape_functions(barreno):
        for mode, near_axis in (("plane strain", False), ("axisymmetric", False), ("axisymmetric", True), ("3D", False)):
            if mode != "plane strain" and shape != "GIMP" and not full:
                continue
            for poisson in (0.0, 0.3, 0.49) if full else (0.3,):
                for per_cell in (1, 2, 4) if full else (2,):
                    deck = flying(mode, shape, per_cell, 0.99, poisson, near_axis=near_axis)
                    setup = (
                        f"{mode}{' at the axis' if near_axis else ''}, {shape}, {per_cell} per cell, nu = {poisson:g}, Courant Fraction "
                        "0.99"
                    )
                    flown(table, title, setup, attempt(barreno, deck), may_stop(shape, near_axis, False))


def default_rows(barreno, full, table):
    title = "A particle alone in free flight, with artificial viscosity"
    for shape in shape_functions(barreno) if full else ("GIMP",):
        for mode in MODES if full else ("plane strain",):
            for poisson in (0.0, 0.3, 0.49) if full else (0.3,):
                for per_cell in (1, 2, 4) if full else (2,):
                    setup = f"{mode}, {shape}, {per_cell} per cell, nu = {poisson:g}, Stable Alone"
                    done = attempt(barreno, flying(mode, shape, per_cell, 0.8, poisson, viscosity=True))
                    flown(table, title, setup, done, may_stop(shape, False, True))


def few_rows(barreno, full, table):
    title = "Few particles in free flight"
    for across in (2, 3):
        for per_cell in (1, 2, 4) if full else (2,):
            for poisson in (0.3, 0.49) if full else (0.3,):
                done = attempt(barreno, flying("plane strain", "GIMP", per_cell, 0.99, poisson, across=across))
                flown(table, title, f"{across} by {across} particles, GIMP, {per_cell} per cell, nu = {poisson:g}, Courant Fraction 0.99",
                    done, False)


def may_stop(shape, near_axis, viscous):
    """Where no step is known to be stable: linear functions with a particle near a node line (docs/method.md 4), points near the
    axis, whose hoops are stiffer than the rule for the step knows, and viscosity, which pushes a particle alone out in one step."""
    return shape == CONTROL or (near_axis and "spline" in shape) or viscous


def flown(table, title, setup, done, stopping):
    """A run that may stop must say that it went wrong."""
    if done.finished or not stopping:
        table.finishes(title, setup, done, STRAY, stray_energy, 1e-9)
    else:
        table.stops(title, setup, done, 3, "at t = ", "of material 'Elastic'")


def run(barreno, full, table):
    alone_rows(barreno, full, table)
    default_rows(barreno, full, table)
    few_rows(barreno, full, table)
