# SPDX-License-Identifier: BSD-3-Clause
"""Products of gamma = 3 that a piston follows and that escape into the void: velocity, sound speed and pressure at given points."""
import numpy as np
from tools.case import Result
from tools.runs import run_deck

SPEED, DENSITY = 8500.0, 1600.0  # of the deck [m/s, kg/m3]
PISTON, LENGTH = 500.0, 0.01
# t [us], x [mm]: u, c [m/s], from ExactPack's solution.
POINTS = {(1, 8): (1875.0, 6125.0), (1, 5): (500.0, 4750.0), (2, 12): (4214.2857, 1785.7143), (2, 7): (803.5714, 4446.4286),
    (4, 4): (1208.3333, 3333.3333)}


def pressure(c):
    """On the isentrope of gamma = 3: p = 16/27 rho0 D^2 (c / D)^3 [Pa]."""
    return 16.0 / 27.0 * DENSITY * SPEED**2 * (c / SPEED) ** 3


def settings(h):
    return {
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{40 mm, {h} mm}}",
        "Bodies/Charge/Upper": f"{{10 mm, {h} mm}}",
        "Bodies/Piston/Upper": f"{{-0.004 mm, {h} mm}}",
    }


def at(particles, name, x, h):
    """By a line through what lies within two cells or four particles."""
    gas = np.isfinite(particles["burn"])
    distance = np.abs(particles["x"] - x)
    reach = max(2.0 * h, np.sort(distance[gas])[7])
    near = gas & (distance <= reach)
    return float(np.polyval(np.polyfit(particles["x"][near] - x, particles[name][near], 1), 0.0))


def run(barreno, full):
    result = Result(
        "Escape of products",
        "Two rarefactions that meet, one behind the detonation and one from the free face where it arrived.",
        "Fickett & Rivard, Los Alamos Scientific Laboratory LA-5600-MS, 1974, as in ExactPack: gamma = 3, D = 8500 m/s, rho0 = 1600 kg/m3, "
        "10 mm of explosive, piston of 500 m/s. Errors of the velocity over D / 4, of the pressure over the greater of the exact one and a "
        "tenth of "
        "the Chapman-Jouguet pressure.",
        ["cell [mm]", *(f"{what} error at {x} mm, {t} us" for t, x in POINTS for what in ("velocity", "pressure")),
            "energy ledger remainder"],
        [],
    )  # fmt: skip
    least = 0.1 * DENSITY * SPEED**2 / 4.0
    for h in (0.1, 0.05, 0.025) if full else (0.1,):
        finished = run_deck(barreno, "escape_of_products.xml", settings(h))
        row = []
        for (t, x), (u, c) in POINTS.items():
            now = finished.particles(t)
            row.append(at(now, "velocity_x", 1e-3 * x, 1e-3 * h) / (0.25 * SPEED) - u / (0.25 * SPEED))
            row.append((at(now, "pressure", 1e-3 * x, 1e-3 * h) - pressure(c)) / max(pressure(c), least))
        remainder = finished.summary["balances"]["energy"]["error"]
        result.rows.append([h, *row, remainder])
        result.demand(f"largest error, {h} mm", float(np.max(np.abs(row))), 0.03)
        result.demand(f"energy ledger remainder, {h} mm", abs(remainder), 1e-3)
    return result
