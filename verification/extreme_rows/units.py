# SPDX-License-Identifier: BSD-3-Clause
"""The same problem in other units and on other scales: every figure without a dimension is the same."""
import numpy as np
from tools.small_decks import attempt, symmetry


def pressed(units="SI", length=1.0, time=1.0, mass=1.0, gravity=False, poisson_flow=False):
    """A block that falls on a fixed floor while a load presses it, in units of so many m, s and kg."""
    per_length, stress = 1.0 / length, length * time**2 / mass
    density, speed = length**3 / mass, time / length
    deck = {
        "Units": units,
        "Grid": {"Mode": "plane strain", "Lower": (0, 0), "Upper": (2 * per_length, 2 * per_length), "Cell Size": 0.125 * per_length},
        "Materials": {
            "Rubber": {
                "Model": "Neo-Hookean", "Density": repr(1000.0 * density), "Bulk Modulus": repr(6e6 * stress),
                "Shear Modulus": repr(3e6 * stress),
                "Bad Particles": "stop",
            }
        },
        "Bodies": {
            "Block": {
                "Material": "Rubber", "Lower": (0.5 * per_length, 0), "Upper": (1.5 * per_length, 1 * per_length),
                "Velocity": (0.3 * speed, -2.0 * speed)
            }
        },
        "Conditions": {"Floor": {"Face": "y_lower", "Kind": "fixed"}},
        "Loads": {"Top": {"Kind": "pressure", "Body": "Block", "Faces": "{y_upper}", "Times": (0, 0.01 / time),
            "Pressures": (0, repr(1e5 * stress))}},
        "Time": {"End Time": repr(0.03 / time)},
    }  # fmt: skip
    return deck


def figures(run, length, time):
    """Places over the block's size, velocities over its wave speed, of all particles, and the energies over the kinetic one at the start;
    files are in SI."""
    now, table = run.particles(), run.table("history.csv")
    speed = length / time
    energies = np.array([table[name][-1] for name in ("kinetic", "elastic", "viscous", "boundary_work")]) / table["kinetic"][0]
    places = [now[name] / length for name in ("x", "y")] + [now[name] / speed for name in ("velocity_x", "velocity_y")]
    return np.concatenate([*places, energies])


def scaled(length=1.0, time=1.0, mass=1.0):
    """The problem itself so many times as large, slow and heavy: decks in SI with other numbers."""
    return pressed("SI", 1.0 / length, 1.0 / time, 1.0 / mass)


def apart(one, other):
    return float(np.abs(one - other).max() / np.abs(one).max())


def run(barreno, full, table):
    title = "Units"
    plain = attempt(barreno, pressed())
    if not plain.finished:
        table.finishes(title, "SI", plain, "exit code", lambda r: 0, 0)
        return
    reference = figures(plain.run, 1.0, 1.0)
    year = 365.25 * 86400.0
    for name, words, length, time, mass in (
        ("millimetre, microsecond, gram", "mm-us-g", 1e-3, 1e-6, 1e-3),
        ("centimetre, second, gram", "cm-s-g", 1e-2, 1.0, 1e-3),
        ("kilometre, year, kilogram (years are no unit of decks)", "km-yr-kg", 1e3, year, 1.0),
        ("kilometre, hour, tonne", "km-h-t", 1e3, 3600.0, 1e3),
    ):
        done = attempt(barreno, pressed(words, length, time, mass))
        if done.code == 1:
            table.stops(title, name, done, 1, "Units")
        else:
            table.finishes(title, name, done, "change of places, velocities and energies",
                lambda r: apart(reference, figures(r, 1.0, 1.0)), 1e-10)
    title = "Scales of 1e-12 and 1e12"
    for name, length, time, mass in (
        ("lengths and times 1e-12", 1e-12, 1e-12, 1.0),
        ("lengths and times 1e12", 1e12, 1e12, 1.0),
        ("masses and stresses 1e-12", 1.0, 1.0, 1e-12),
        ("masses and stresses 1e12", 1.0, 1.0, 1e12),
        ("kilometres and years", 1e3, year, 1.0),
        ("times 1e-8: stresses 1e16", 1.0, 1e-8, 1.0),
        ("times 1e12: stresses 1e-24", 1.0, 1e12, 1.0),
    ):
        done = attempt(barreno, scaled(length, time, mass))

        def change(run, length=length, time=time):
            return apart(reference, figures(run, length, time))

        table.finishes(title, name, done, "change of places, velocities and energies", change, 1e-10)
    done = attempt(barreno, scaled(1.0, 1e-12, 1.0))
    table.stops(title, "times 1e-12: faster than light", done, 1, "Bodies/Block/Velocity", "light")
