# SPDX-License-Identifier: BSD-3-Clause
"""The stable step: 0.99 of the shape function's, 0.99 and 1.2 of one bar's own, and damping beyond it."""
import numpy as np
from tools.amplification import critical, growth, places
from tools.choices import shape_functions
from extreme_rows.time import free_block
from tools.small_decks import BARE, attempt, elastic, symmetry

CONTROL = "linear"
CELLS, SPEED = 10, 100.0  # of the bar; its wave speed
GAIN = "greatest energy over that at the start, less 1"


def bar(shape, per_cell, fraction, time, offset=0.37, **step):
    """A free bar of 10 cells between walls along which it slides, in its first standing wave."""
    return {
        "Grid": {"Mode": "plane strain", "Lower": (-3, 0), "Upper": (14, 1), "Cell Size": 1.0},
        "Materials": {"Elastic": elastic(6e6, 3e6)},
        "Bodies": {
            "Bar": {
                "Material": "Elastic", "Lower": (offset, 0), "Upper": (offset + CELLS, 1), "Particles Per Cell": per_cell,
                "Velocity": (1e-3, 0), "Velocity Wave Number": (np.pi / CELLS, 0),
            }
        },
        "Conditions": symmetry("y_lower", "y_upper"),
        "Step": {"Shape Function": shape, "Courant Fraction": fraction, **BARE, **step},
        "Time": {"End Time": time},
        "Output": {"History Interval": time / 100},
    }  # fmt: skip


def energy_gained(run):
    table = run.table("history.csv")
    total = table["kinetic"] + table["elastic"]
    return float(total[1:].max() / total[0] - 1.0)


def shape_rows(barreno, full, table):
    title = "0.99 of the stable step"
    for shape in shape_functions(barreno):
        if shape == CONTROL:
            continue
        for per_cell in (1, 2, 4) if full else (2,):
            done = attempt(barreno, bar(shape, per_cell, 0.99, 50.0 if full else 5.0), longest=200.0)
            setup = f"free bar, {shape}, {per_cell} per cell and direction, Courant Fraction 0.99"
            table.finishes(title, setup, done, GAIN, energy_gained, 1e-2)


def own_limit_rows(barreno, full, table):
    """A step beyond the stable one is no deck: Courant Fraction ends at 1. But linear functions have no stable step in general, and
    each bar has its own: a hundredth of a particle's cell in the next cell makes a light node. That bar's critical step is known
    exactly (tools/amplification.py) and far below what the deck may ask for."""
    title = "0.99 and 1.2 of the critical Courant number"
    probe = attempt(barreno, bar(CONTROL, 1, 1.0, 0.03, offset=0.55))
    if not probe.finished:
        table.within(title, "the step at Courant Fraction 1", "exit code", 1, 0)
        return
    whole = float(probe.run.table("history.csv")["dt"][1]) * SPEED  # c dt / h of the first step at fraction 1
    x = places(CELLS, 1, 0.55)
    own = critical(x, 0.5, "linear")
    for part in (0.99, 1.2):
        rate = growth(x, 0.5, part * own, "linear")
        setup = f"the bar with linear functions and a light node: critical number {own:.4f}, {part:g} of it (grows by {rate:.4g} a step)"
        done = attempt(barreno, bar(CONTROL, 1, part * own / whole, 2000 * own / SPEED, offset=0.55))
        if part < 1.0:
            table.finishes(title, setup, done, GAIN, energy_gained, 1e-2)
        else:
            table.stops(title, setup, done, 3, "energy supplied", "Courant Fraction", "fastest particle")
    table.stops(title, "Courant Fraction 1.2", attempt(barreno, bar("GIMP", 2, 1.2, 0.1)), 1, "Courant Fraction")
    longer = {"Initial Step": 1.0, "Growth Limit": 1e6, "Largest Step": 1.0}
    done = attempt(barreno, bar("GIMP", 2, 0.8, 2.0, **longer))
    table.finishes(title, "Initial Step and Largest Step of 200 stable ones, any growth", done, GAIN, energy_gained, 1e-2)


def damping_rows(barreno, full, table):
    title = "Damping"
    for order in ("stress last", "modified stress last"):
        for damping in (1.0, 1e2, 1e4, 1e6):
            step = {"Damping": damping, "Order": order}
            done = attempt(barreno, free_block(1e3 / (1e3 + damping), Step=step))
            table.finishes(title, f"{damping:g} 1/s, {order}: an undamped step is 4 ms", done, GAIN, energy_gained, 1e-9)


def run(barreno, full, table):
    shape_rows(barreno, full, table)
    own_limit_rows(barreno, full, table)
    damping_rows(barreno, full, table)
