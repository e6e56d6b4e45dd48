# SPDX-License-Identifier: BSD-3-Clause
"""Symmetric impact of copper plates without strength: the plateau against the Mie-Grueneisen jump."""
import numpy as np
from tools.case import Result
from tools.penetration import between_particles_and_grid
from tools.runs import run_deck

C0, SLOPE, DENSITY, SPEED = 3940.0, 1.489, 8930.0, 1000.0
SHOCK_SPEED = C0 + SLOPE * SPEED
PRESSURE = DENSITY * SHOCK_SPEED * SPEED
SHOCKED = DENSITY * SHOCK_SPEED / (SHOCK_SPEED - SPEED)
ENERGY = 0.5 * SPEED**2
GRUNEISEN, HEAT, ROOM = 2.02, 383.0, 294.0  # of copper.xml: Gruneisen, Specific Heat [J/kg K], Room Temperature [K]


def temperature_of_jump():
    """Behind the shock [K]: with Gamma rho and c constant, e - e_s(V) = c (T - T_s(V)), where s is the isentrope through the
    start: T_s = T_room exp(Gamma0 eta), e_s = integral over x from 0 to eta of P_H(x) (1 - Gamma0 x / 2) exp(Gamma0 (eta - x)) dx / rho0,
    P_H = rho0 c0^2 x / (1 - s x)^2."""
    eta = 1.0 - DENSITY / SHOCKED
    x, weight = np.polynomial.legendre.leggauss(20)
    x = 0.5 * eta * (1.0 + x)
    curve = C0**2 * x / (1.0 - SLOPE * x) ** 2 * (1.0 - 0.5 * GRUNEISEN * x)
    isentrope = 0.5 * eta * float(np.sum(weight * curve * np.exp(GRUNEISEN * (eta - x))))
    return ROOM * np.exp(GRUNEISEN * eta) + (ENERGY - isentrope) / HEAT


TEMPERATURE = temperature_of_jump()


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


# Errors with Return Losses fall with the cells [1/mm].
FIRST_ORDER = {"internal energy": 0.016, "temperature": 0.04}


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
    mean = {name: float(late[name][behind].mean()) for name in ("pressure", "density", "internal_energy", "temperature")}
    mean["velocity"] = float(np.sqrt((late["velocity_x"][behind] ** 2).mean()))
    travelled = [front(late, side) - front(early, side) for side in (-1.0, 1.0)]
    return mean, float(np.mean(travelled)) / (late["time"] - early["time"]) + SPEED


def run(barreno, full):
    result = Result(
        "Shock in copper",
        "Pressure, density and internal energy behind a strong shock, and its speed: the artificial viscosity heats the metal as the jump "
        "conditions require.",
        f"Rankine-Hugoniot: P = {PRESSURE:.6g} Pa, rho = {SHOCKED:.6g} kg/m3, e = {ENERGY:.6g} J/kg, U_s = {SHOCK_SPEED:.6g} m/s; "
        f"with the equation of state T = {TEMPERATURE:.4g} K.",
        ["cell [mm]", "pressure error", "density error", "energy error", "temperature error", "shock speed error",
         "energy that stress_integration and transfer took, over what was put in", "ledger remainder",
         "energy error, losses returned", "temperature error, losses returned"],
        [],
    )  # fmt: skip
    for h in (1.0, 0.5, 0.25) if full else (1.0, 0.5):
        finished = run_deck(barreno, "shock_copper.xml", settings(h))
        mean, speed = plateau(finished)
        errors = {
            "pressure of the plateau": mean["pressure"] / PRESSURE - 1.0,
            "density of the plateau": mean["density"] / SHOCKED - 1.0,
            "internal energy of the plateau": mean["internal_energy"] / ENERGY - 1.0,
            "temperature of the plateau": mean["temperature"] / TEMPERATURE - 1.0,
            "shock speed": speed / SHOCK_SPEED - 1.0,
        }
        kept = run_deck(barreno, "shock_copper.xml", {**settings(h), "Step/Return Losses": "true"})
        mean, _ = plateau(kept)
        returned = {"internal energy": mean["internal_energy"] / ENERGY - 1.0, "temperature": mean["temperature"] / TEMPERATURE - 1.0}
        result.rows.append([h, *errors.values(), between_particles_and_grid(finished), finished.summary["balances"]["energy"]["error"],
                            *returned.values()])  # fmt: skip
        for what, error in errors.items():
            result.demand(f"{what}, {h} mm", abs(error), 0.005 if what == "shock speed" else 0.01)
        for what, error in returned.items():
            result.demand(f"{what} of the plateau, losses returned, {h} mm", abs(error), FIRST_ORDER[what] * h)
        result.demand(f"energy between particles and grid, losses returned, {h} mm", abs(between_particles_and_grid(kept)), 1e-9)
    result.notes = (
        "The heat of the plateau has two errors of opposite sign. One makes it too large and decreases with the cells. The other does "
        "not decrease, since a front is the same number of cells and steps wide on any grid. The losses in stress_integration and "
        "transfer decrease with the step, not with the cells. "
        "At 1 mm the two cancel. With Return Losses, which returns to each particle what the "
        "grid took from it, only the first remains, and decreases. Most of the temperature rise is isentropic, so that a relative error of "
        "the energy is about twice as large in the temperature."
    )
    return result
