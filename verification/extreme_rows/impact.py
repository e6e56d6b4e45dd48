# SPDX-License-Identifier: BSD-3-Clause
"""Impact at 10 km/s: copper on copper, tungsten on something twenty times lighter."""
import numpy as np
from tools.runs import run_deck
from tools.small_decks import BARE, DECKS, attempt, attempt_file, elastic, symmetry

SPEED = 5000.0  # of each plate
C0, SLOPE, DENSITY = 3940.0, 1.489, 8930.0
SHOCK = C0 + SLOPE * SPEED
PRESSURE, SHOCKED, ENERGY = DENSITY * SHOCK * SPEED, DENSITY * SHOCK / (SHOCK - SPEED), 0.5 * SPEED**2


def copper(barreno, h, fraction):
    settings = {
        "Grid/Cell Size": f"{h} mm",
        "Grid/Upper": f"{{60 mm, {h} mm}}",
        "Bodies/Left plate/Upper": f"{{0 mm, {h} mm}}",
        "Bodies/Right plate/Upper": f"{{50 mm, {h} mm}}",
        "Bodies/Left plate/Velocity": f"{{{SPEED} m/s, 0 m/s}}",
        "Bodies/Right plate/Velocity": f"{{-{SPEED} m/s, 0 m/s}}",
        "Materials/Copper/A": "0",
        "Materials/Copper/B": "0",
        "Step/Courant Fraction": fraction,
        "Time/End Time": "3 us",
        "Output/Field Interval": "3 us",
    }
    return attempt_file(barreno, DECKS / "shock_copper.xml", settings, longest=120.0)


def plateau(run):
    """Means behind the front."""
    late = run.particles()
    reach = (SHOCK - SPEED) * late["time"]
    behind = (np.abs(late["x"]) > 0.3 * reach) & (np.abs(late["x"]) < 0.7 * reach)
    return {name: float(late[name][behind].mean()) for name in ("pressure", "density", "internal_energy")}


def copper_rows(barreno, full, table):
    title = "Impact at 10 km/s, copper on copper"
    for h, fraction in ((1.0, 0.8), (1.0, 0.4), (0.5, 0.8)) if full else ((1.0, 0.8),):
        done = copper(barreno, h, fraction)
        setup = f"cells of {h:g} mm, Courant Fraction {fraction:g}"
        if not done.finished:
            table.finishes(title, setup, done, "pressure", lambda r: 1.0, 0.0)
            continue
        mean = plateau(done.run)
        for name, exact in (("pressure", PRESSURE), ("density", SHOCKED), ("internal_energy", ENERGY)):
            table.within(title, setup, f"|{name.replace('_', ' ')} over {exact:.6g} less 1|", abs(mean[name] / exact - 1.0), 0.02)
        particles = done.run.particles()
        table.within(title, setup, "least density [kg/m3]", particles["density"].min(), 0.0, at_least=True)
        table.within(title, setup, "least internal energy [J/kg]", particles["internal_energy"].min(), -1e-6 * ENERGY, at_least=True)
        table.within(title, setup, "momentum error", abs(done.run.summary["balances"]["momentum"]["error"]), 1e-12)


def light_target(ratio):
    """A bar of density 1000 ratio, c = 4 km/s, meets one of 1000 with c = 2 km/s end to end at 1 m/s; elastic, uniaxial."""
    heavy = 1000.0 * ratio
    stiff = lambda density, c: elastic(density * c * c - 4.0 / 3.0 * 1e9, 1e9, density)  # noqa: E731
    return {
        "Grid": {"Mode": "plane strain", "Lower": (-0.6, 0), "Upper": (0.6, 0.01), "Cell Size": 0.01},
        "Materials": {"Heavy": stiff(heavy, 4000.0), "Light": stiff(1000.0, 2000.0)},
        "Bodies": {
            "Left": {"Material": "Heavy", "Lower": (-0.5, 0), "Upper": (0, 0.01), "Velocity": (1, 0)},
            "Right": {"Material": "Light", "Lower": (0, 0), "Upper": (0.5, 0.01)},
        },
        "Conditions": symmetry("y_lower", "y_upper"),
        "Step": dict(BARE),
        "Time": {"End Time": 1e-4},
    }


def interface_error(ratio):
    """Impedances give v = Z1 V / (Z1 + Z2) behind both waves."""
    exact = 1.0 * ratio * 4000.0 / (ratio * 4000.0 + 2000.0)

    def error(run):
        now = run.particles()
        near = (np.abs(now["x"]) < 0.15) & (now["x"] > -0.15)
        return abs(now["velocity_x"][near].mean() / exact - 1.0)

    return error


TUNGSTEN = (17600.0, 3992.0, 1.23)
LIGHT = (880.0, 3940.0, 1.489)  # copper's Hugoniot at a twentieth of tungsten's density


def matched(speed):
    """Velocity of the interface and pressure where rho (c0 + s u) u of both sides agree."""
    hugoniot = lambda card, u: card[0] * (card[1] + card[2] * u) * u  # noqa: E731
    low, high = 0.0, speed
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if hugoniot(LIGHT, middle) < hugoniot(TUNGSTEN, speed - middle) else (low, middle)
    return low, hugoniot(LIGHT, low)


def tungsten_on_light(speed, h, end=3e-6):
    fluid = {"A": 0, "B": 0, "Bad Particles": "stop"}
    return {
        "Grid": {"Mode": "plane strain", "Lower": (-0.06, 0), "Upper": (0.08, h), "Cell Size": h},
        "Materials": {
            "Tungsten": {"Card": "tungsten.xml", **fluid},
            "Light": {"Card": "copper.xml", "Density": LIGHT[0], "Shear Modulus": 5e9, **fluid},
        },
        "Bodies": {
            "Projectile": {"Material": "Tungsten", "Lower": (-0.05, 0), "Upper": (0, h), "Velocity": (speed, 0)},
            "Target": {"Material": "Light", "Lower": (0, 0), "Upper": (0.07, h)},
        },
        "Conditions": symmetry("y_lower", "y_upper"),
        "Time": {"End Time": end},
    }


# Where light particles are hit by heavy ones FLIP leaves each a velocity of its own that nodes do not see.


def interface_rows(barreno, speed, table):
    """The velocity of the interface and the pressure hold from shock to shock. Ends before a free end of a bar is heard of."""
    velocity, pressure = matched(speed)
    done = attempt(barreno, tungsten_on_light(speed, 1e-3, 1.2e-5 if speed < 5e3 else 3e-6), longest=120.0)
    title = "Impact at 10 km/s, density ratio 20"
    setup = f"bar of tungsten on one of a twentieth of its density at {1e-3 * speed:g} km/s, cells of 1 mm"

    def mean(run, name, nearest, farthest):
        now = run.particles()
        away = np.abs(now["x"] - velocity * now["time"])
        return now[name][(away > nearest) & (away < farthest)].mean()

    words = ("Particle ", "of material 'Light'", "at t = ")
    for place, nearest, farthest in (("at the interface", -1.0, 2e-3), ("3 to 8 cells off", 3e-3, 8e-3)):
        table.holds_or_stops(title, setup, done, f"|velocity {place} over {velocity:.5g} m/s less 1|",
                             lambda r, a=nearest, b=farthest: abs(mean(r, "velocity_x", a, b) / velocity - 1.0), 0.02, *words)  # fmt: skip
        if done.finished:
            found = abs(mean(done.run, "pressure", nearest, farthest) / pressure - 1.0)
            table.within(title, setup, f"|pressure {place} over {pressure:.5g} Pa less 1|", found, 0.02)


def ratio_rows(barreno, full, table):
    """Bars are the hardest form: no material can give way."""
    title = "Impact at 10 km/s, density ratio 20"
    for speed in (1e4, 1e3):
        interface_rows(barreno, speed, table)
    settings = {"Time/End Time": "10 us", "Materials/Sandstone/Density": "880 kg/m3"}
    done = attempt_file(barreno, DECKS / "perforation_quick.xml", settings, longest=120.0)
    for name, limit in (("mass", 1e-12), ("momentum", 1e-12), ("energy", 1e-3)):
        table.finishes(title, "perforation_quick.xml to 10 us, tungsten 20 times as dense as the rock", done, f"{name} error",
                       lambda r, name=name: abs(r.summary["balances"][name]["error"]), limit)  # fmt: skip


def run(barreno, full, table):
    copper_rows(barreno, full, table)
    ratio_rows(barreno, full, table)
    title = "Density ratio"
    for ratio in (20.0, 1e4):
        done = attempt(barreno, light_target(ratio))
        table.finishes(title, f"bars {ratio:g} to 1 at 1 m/s", done, "|interface velocity over impedances' less 1|",
            interface_error(ratio), 0.01)
        if done.finished:
            table.within(title, f"bars {ratio:g} to 1 at 1 m/s", "energy ledger remainder",
                abs(done.run.summary["balances"]["energy"]["error"]), 1e-6)
