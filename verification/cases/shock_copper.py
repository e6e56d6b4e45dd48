# SPDX-License-Identifier: BSD-3-Clause
"""Symmetric impact of copper plates without strength: the plateau against the Mie-Grueneisen jump."""
import numpy as np
from case import Result
from runs import run_deck

C0, SLOPE, DENSITY, SPEED = 3940.0, 1.489, 8930.0, 1000.0
SHOCK_SPEED = C0 + SLOPE * SPEED
PRESSURE = DENSITY * SHOCK_SPEED * SPEED
SHOCKED = DENSITY * SHOCK_SPEED / (SHOCK_SPEED - SPEED)
ENERGY = 0.5 * SPEED**2


def settings(h):
    return {
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{60 mm, {h} mm}}",
        "Bodies/Left plate/Upper": f"{{0 mm, {h} mm}}",
        "Bodies/Right plate/Upper": f"{{50 mm, {h} mm}}",
        "Materials/Copper/A": "0",
        "Materials/Copper/B": "0",
        "Output/Field Interval": "3 us",
    }


def front(particles, side):
    """Where the pressure is half of the plateau's, from the mean over the particles of one column."""
    x = side * particles["x"]
    columns = np.unique(np.round(x[x > 1e-3], 7))
    pressure = np.array([particles["pressure"][np.abs(x - column) < 1e-7].mean() for column in columns])
    last = int(np.nonzero(pressure > 0.5 * PRESSURE)[0].max())
    a, b = pressure[last], pressure[last + 1]
    return columns[last] + (columns[last + 1] - columns[last]) * (a - 0.5 * PRESSURE) / (a - b)


def plateau(run):
    """Means behind the front at the end, and the shock's speed between the last two outputs."""
    early, late = run.particles(-2), run.particles(-1)
    reach = (SHOCK_SPEED - SPEED) * late["time"]
    behind = (np.abs(late["x"]) > 0.3 * reach) & (np.abs(late["x"]) < 0.7 * reach)
    mean = {name: float(late[name][behind].mean()) for name in ("pressure", "density", "internal_energy")}
    mean["velocity"] = float(np.sqrt((late["velocity_x"][behind] ** 2).mean()))
    travelled = [front(late, side) - front(early, side) for side in (-1.0, 1.0)]
    return mean, float(np.mean(travelled)) / (late["time"] - early["time"]) + SPEED


def run(barreno, full):
    result = Result(
        "Shock in copper",
        "Pressure, density, internal energy behind a strong shock and its speed: the artificial viscosity heats as the jump demands.",
        f"Rankine-Hugoniot: P = {PRESSURE:.6g} Pa, rho = {SHOCKED:.6g} kg/m3, e = {ENERGY:.6g} J/kg, U_s = {SHOCK_SPEED:.6g} m/s.",
        ["cell [mm]", "pressure error", "density error", "energy error", "shock speed error", "ledger remainder"],
        [],
    )
    for h in (1.0, 0.5, 0.25) if full else (0.5,):
        finished = run_deck(barreno, "shock_copper.xml", settings(h))
        mean, speed = plateau(finished)
        result.rows.append(
            [
                h,
                mean["pressure"] / PRESSURE - 1.0,
                mean["density"] / SHOCKED - 1.0,
                mean["internal_energy"] / ENERGY - 1.0,
                speed / SHOCK_SPEED - 1.0,
                finished.summary["balances"]["energy"]["error"],
            ]
        )
    at = next(row for row in result.rows if row[0] == 0.5)
    result.demand("pressure of the plateau, 0.5 mm", abs(at[1]), 0.01)
    result.demand("density of the plateau, 0.5 mm", abs(at[2]), 0.01)
    result.demand("internal energy of the plateau, 0.5 mm", abs(at[3]), 0.01)
    result.demand("shock speed, 0.5 mm", abs(at[4]), 0.005)
    return result
