# SPDX-License-Identifier: BSD-3-Clause
"""Porous copper on a rigid wall: pressure, front speed and heat behind the shock that closes its voids."""
import numpy as np
from tools.case import Result
from tools.penetration import between_particles_and_grid
from tools.runs import run_deck

C0, SLOPE, DENSITY, GRUNEISEN = 3940.0, 1.489, 8930.0, 2.02  # of copper.xml


def exact(speed, expansion):
    """Pressure [Pa], speed of the front away from the wall [m/s] and eta = 1 - V / V_ref behind it.

    The metal stops at the wall: mass and momentum give rho0 U^2 = p (alpha - 1 + eta), energy gives the heat U^2 / 2, and
    p = a(eta) + Gamma0 rho0 U^2 / 2 then is a(eta) / (1 - Gamma0 (alpha - 1 + eta) / 2)."""

    def pressure(eta):
        curve = DENSITY * C0**2 * eta / (1.0 - SLOPE * eta) ** 2 * (1.0 - 0.5 * GRUNEISEN * eta)
        return curve / (1.0 - 0.5 * GRUNEISEN * (expansion - 1.0 + eta))

    low, high = 0.0, min(0.99 / SLOPE, 2.0 / GRUNEISEN - (expansion - 1.0)) * (1.0 - 1e-12)
    for _ in range(200):
        eta = 0.5 * (low + high)
        if pressure(eta) * (expansion - 1.0 + eta) < DENSITY * speed**2:
            low = eta
        else:
            high = eta
    return pressure(eta), speed * (1.0 - eta) / (expansion - 1.0 + eta), eta


def settings(h, speed, expansion, end):
    return {
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{60 mm, {h} mm}}",
        "Bodies/Slug/Upper": f"{{50 mm, {h} mm}}",
        "Bodies/Slug/Expansion": expansion,
        "Bodies/Slug/Velocity": f"{{{-speed} m/s, 0 m/s}}",
        "Time/End Time": f"{1e6 * end} us",
        "Output/Field Interval": f"{1e5 * end} us",
    }


def front(particles, plateau):
    """Where the pressure is half of the plateau's [m]."""
    columns = np.unique(np.round(particles["x"], 7))
    pressure = np.array([particles["pressure"][np.abs(particles["x"] - x) < 1e-7].mean() for x in columns])
    last = int(np.nonzero(pressure > 0.5 * plateau)[0].max())
    a, b = pressure[last], pressure[last + 1]
    return columns[last] + (columns[last + 1] - columns[last]) * (a - 0.5 * plateau) / (a - b)


def plateau_of(particles, front_speed):
    """Mean pressure, over the volume, and mean heat, over the mass, from three to eight tenths of the front's way."""
    reach = front_speed * particles["time"]
    behind = (particles["x"] > 0.3 * reach) & (particles["x"] < 0.8 * reach)
    pressure = np.average(particles["pressure"][behind], weights=particles["volume_ratio"][behind])
    return float(pressure), float(particles["internal_energy"][behind].mean())


def measure(run, plateau, front_speed):
    """Pressure and heat of the plateau, the means of the last three outputs, and the front's speed over the last half of the time."""
    early, late = run.particles(-6), run.particles(-1)
    speed = (front(late, plateau) - front(early, plateau)) / (late["time"] - early["time"])
    pressure, heat = np.mean([plateau_of(run.particles(step), front_speed) for step in (-3, -2, -1)], axis=0)
    return float(pressure), float(heat), float(speed)


def stress_of_voids(run):
    """Largest stress [Pa] and plastic strain of particles whose voids are open, over all instants, and how many there were."""
    stress = plastic = 0.0
    count = 0
    for step in range(run.instants()):
        particles = run.particles(step)
        is_open = particles["expansion_strain"] > 0.0
        count += int(is_open.sum())
        if not is_open.any():
            continue
        components = [name for name in particles if name.startswith("stress_")]
        stress = max([stress] + [float(np.abs(particles[name][is_open]).max()) for name in components])
        plastic = max(plastic, float(np.abs(particles["plastic_strain"][is_open]).max()))
    return stress, plastic, count


def run(barreno, full):
    result = Result(
        "Porous copper on a rigid wall",
        "A metal whose voids are an expansion strain: pressure, front speed and heat behind the shock that closes them, and no stress and "
        "no plastic work before.",
        "Jump conditions with the Mie-Grueneisen equation of state: p = a(eta) / (1 - Gamma0 (alpha - 1 + eta) / 2), front speed "
        "U (1 - eta) / (alpha - 1 + eta), heat U^2 / 2. Alpha is solid over mean density, U the slug's speed.",
        ["speed [m/s]", "alpha", "cell [mm]", "pressure [GPa]", "front [m/s]", "pressure error", "front speed error", "heat error",
         "ledger remainder", "losses not returned: heat error", "energy that stress_integration and transfer took, over what was put in"],
        [],
    )  # fmt: skip
    cases = [(1000.0, 1.25), (1000.0, 1.5), (200.0, 1.25), (200.0, 1.5)] if full else [(1000.0, 1.25), (200.0, 1.5)]
    for speed, expansion in cases:
        plateau, front_speed, _ = exact(speed, expansion)
        for h in (1.0, 0.5, 0.25) if full else (0.5,):
            given = settings(h, speed, expansion, 0.025 / front_speed)
            finished = run_deck(barreno, "porous_slug.xml", given)
            lossy = run_deck(barreno, "porous_slug.xml", {**given, "Step/Return Losses": "false"})
            pressure, heat, found = measure(finished, plateau, front_speed)
            energy = 0.5 * speed**2
            errors = {"pressure": pressure / plateau - 1.0, "front speed": found / front_speed - 1.0, "heat": heat / energy - 1.0}
            lost = measure(lossy, plateau, front_speed)[1] / energy - 1.0
            result.rows.append([speed, expansion, h, plateau / 1e9, front_speed, *errors.values(),
                                finished.summary["balances"]["energy"]["error"], lost, between_particles_and_grid(lossy)])  # fmt: skip
            where = f"{speed:g} m/s, alpha {expansion:g}, {h:g} mm"
            if h <= 0.5:
                for what, error in errors.items():
                    result.demand(f"{what}, {where}", abs(error), 0.02)
            stress, plastic, count = stress_of_voids(finished)
            result.demand(f"stress where voids are open [Pa], {where}", stress, 0.0)
            result.demand(f"plastic strain where voids are open, {where}", plastic, 0.0)
            result.demand(f"particles with open voids seen, {where}", count, 100, at_least=True)
            for which, one in (("", finished), (", losses not returned", lossy)):
                result.demand(f"ledger remainder{which}, {where}", abs(one.summary["balances"]["energy"]["error"]), 1e-3)
    return result
