# SPDX-License-Identifier: BSD-3-Clause
"""A rod of tungsten goes through a layer of water: the momentum that it keeps, and the length that the water consumes."""
import math

import numpy as np
from tools.case import Result
from tools.runs import run_deck

SPEED, LENGTH, LAYER = 6000.0, 60e-3, 12e-3  # of jet_through_water.xml
ROD, WATER = 17600.0, 998.2  # Density of tungsten.xml and of water.xml
UNTOUCHED = 1.0 - LAYER / LENGTH * math.sqrt(WATER / ROD)  # share of the rod


def shares(run):
    """(momentum of the rod over that at the start, share of its mass that has lost less than 3 % of its velocity)."""
    count = run.count_of_block(1)
    first, last = run.particles(0), run.particles()
    mass = first["x"][:count] / first["x"][:count].sum()  # particles of one size, on rings
    speed = last["velocity_y"][:count] / SPEED
    there = np.isfinite(speed)
    return float((mass * speed)[there].sum()), float(mass[there & (speed > 0.97)].sum())


def run(barreno, full):
    result = Result(
        "Jet through water",
        "A jet keeps its momentum in a layer of liquid, which consumes the length that fluids consume.",
        f"the hydrodynamic rule: 1 - (12 mm / 60 mm) sqrt(rho_water / rho_rod) = {UNTOUCHED:.4f} of the rod is untouched.",
        ["cell [mm]", "momentum that the rod keeps", "untouched share", "its error", "momentum balance"],
        [],
    )
    for h in (1.0, 0.5, 0.25) if full else (0.5,):
        finished = run_deck(barreno, "jet_through_water.xml", {"Grid/Cell Size": f"{h} mm"})
        momentum, untouched = shares(finished)
        balance = finished.summary["balances"]["momentum"]["error"]
        balance = max(map(abs, balance)) if isinstance(balance, list) else abs(balance)
        result.rows.append([h, momentum, untouched, untouched / UNTOUCHED - 1.0, balance])
        result.demand(f"momentum that the rod loses, {h} mm", 1.0 - momentum, 0.05)
        if h < 1.0:
            result.demand(f"untouched share against the rule, {h} mm", abs(untouched / UNTOUCHED - 1.0), 0.02)
        result.demand(f"momentum balance, {h} mm", balance, 1e-9)
    return result
