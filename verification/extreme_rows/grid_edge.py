# SPDX-License-Identifier: BSD-3-Clause
"""Particles that leave the grid, that are alone in it, that fill it; bodies of nothing."""
import numpy as np
from tools.small_decks import BARE, attempt, elastic

MODES = {"plane strain": 2, "axisymmetric": 2, "3D": 3}


def block(mode, per_cell, lower, upper, velocity, end, cells=4, transfer="FLIP", **material):
    n = MODES[mode]
    deck = {
        "Grid": {"Mode": mode, "Lower": [0] * n, "Upper": [cells] * n, "Cell Size": 1.0},
        "Materials": {"Elastic": {**elastic(6e6, 3e6), **material}},
        "Bodies": {
            "Block": {"Material": "Elastic", "Lower": lower[:n], "Upper": upper[:n], "Velocity": velocity[:n],
                "Particles Per Cell": per_cell}
        },
        "Step": {"Transfer": transfer, **BARE},
        "Time": {"End Time": end},
        "Output": {"History Interval": end / 20},
    }
    if mode == "axisymmetric":
        deck["Conditions"] = {"Axis": {"Face": "x_lower", "Kind": "symmetry"}}
    return deck


def mass_error(run):
    return float(np.abs(run.table("history.csv")["mass_error"]).max())


def left(run):
    return run.summary["removed_particles"]["left_grid"]["count"]


def energy_error(run):
    return float(np.abs(run.table("history.csv")["energy_error"]).max())


def leaving_rows(barreno, full, table):
    title = "Particles that leave the grid"
    for mode in MODES:
        count = 4 ** MODES[mode]
        deck = block(mode, 2, (1.1, 1.1, 1.1), (3.1, 3.1, 3.1), (0.0, 50.0, 0.0), 0.2)
        for ranks in (1, 2) if full and mode == "plane strain" else (1,):
            done = attempt(barreno, deck, ranks=ranks)
            setup = f"{mode}, all of a block at 50 m/s, {ranks} rank{'s' if ranks > 1 else ''}"
            table.finishes(title, setup, done, "particles that did not leave", lambda r, n=count: abs(left(r) - n), 0)
            table.finishes(title, setup, done, "mass error", mass_error, 1e-14)
    done = attempt(barreno, block("plane strain", 2, (1.1, 1.1), (3.1, 3.1), (70.0, 70.0), 0.2))
    table.finishes(title, "through a corner", done, "particles that did not leave", lambda r: abs(left(r) - 16), 0)
    done = attempt(barreno, block("plane strain", 2, (0, 0), (4, 4), (0.0, 0.0), 0.2))
    table.finishes(title, "a body that fills the grid, at rest", done, "particles that left", left, 0)
    done = attempt(barreno, block("plane strain", 2, (3, 1), (5, 3), (0.0, 0.0), 0.2))
    table.stops(title, "a body that reaches beyond the grid", done, 1, "Bodies/Block")


def lone_rows(barreno, full, table):
    title = "A single particle in an empty grid"
    for mode in MODES:
        lower = [1.4] * 3
        upper = [2.4] * 3
        velocity = [0.0 if mode == "axisymmetric" else 7.0, 9.0, 3.0]
        done = attempt(barreno, block(mode, 1, lower, upper, velocity, 0.1, cells=8))
        table.finishes(title, f"{mode}, one per cell", done, "missing particles", lambda r: abs(len(r.particles()["x"]) - 1), 0)

        def off(run, velocity=velocity):
            first, last = run.particles(0), run.particles()
            moved = [last[a] - first[a] - 0.1 * v for a, v in zip("xyz", velocity) if a in last]
            return float(np.abs(moved).max())

        table.finishes(title, f"{mode}, one per cell", done, "|place - exact| after 0.1 s [m]", off, 1e-12)


def per_cell_rows(barreno, full, table):
    title = "Particles per cell"
    for mode, per_cell in (("plane strain", 1), ("plane strain", 8), ("plane strain", 16), ("3D", 1), ("3D", 4)):
        n = MODES[mode]
        deck = block(mode, per_cell, (1, 1, 1), (2, 2, 2), (3.0, 5.0, 0.0), 0.05)
        done = attempt(barreno, deck)
        setup = f"{mode}, {per_cell}^{n} = {per_cell**n} in a cell"
        table.finishes(title, setup, done, "mass error", mass_error, 1e-14)
        table.finishes(title, setup, done, "energy error", energy_error, 1e-12)
    done = attempt(barreno, block("plane strain", 17, (1, 1, 1), (2, 2, 2), (3.0, 5.0, 0.0), 0.05))
    table.stops(title, "17 per cell and direction", done, 1, "Particles Per Cell", "16")


def nothing_rows(barreno, full, table):
    title = "Nothing"
    deck = block("plane strain", 2, (1, 1), (2, 2), (0, 0), 0.1)
    deck["Materials"]["Unused"] = elastic(1e9, 1e9)
    table.finishes(title, "a material without particles", attempt(barreno, deck), "mass error", mass_error, 1e-14)
    empty = dict(deck)
    empty.pop("Bodies")
    done = attempt(barreno, empty)
    if done.finished:
        table.finishes(title, "no body at all", done, "particles", lambda r: r.table("history.csv")["particles"][-1], 0)
    else:
        table.stops(title, "no body at all", done, 1, "Bodies")
    flat = block("plane strain", 2, (1, 1), (1, 2), (0, 0), 0.1)
    table.stops(title, "a body without thickness", attempt(barreno, flat), 1, "Bodies/Block")
    thin = block("plane strain", 1, (1, 1), (1 + 1e-9, 2), (0, 0), 1e-9)
    done = attempt(barreno, thin)
    table.holds_or_stops(title, "a body 1e-9 cells thick, to 1 ns", done, "mass error", mass_error, 1e-12, "at t = ")


def run(barreno, full, table):
    leaving_rows(barreno, full, table)
    lone_rows(barreno, full, table)
    per_cell_rows(barreno, full, table)
    nothing_rows(barreno, full, table)
