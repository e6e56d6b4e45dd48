# SPDX-License-Identifier: BSD-3-Clause
"""Rock under no and much confinement, as even and as scattered as its Weibull modulus can say."""
import math

import numpy as np
from tools.small_decks import attempt

SIZE, CELL = 0.04, 0.0025


def block(pressure=None, end=2e-5, mode="axisymmetric", **card):
    deck = {
        "Grid": {"Mode": mode, "Lower": (0, 0), "Upper": (0.05, 0.05), "Cell Size": CELL},
        "Materials": {"Rock": {"Card": "berea_sandstone.xml", "Bad Particles": "stop", **card}},
        "Bodies": {"Block": {"Material": "Rock", "Lower": (0, 0), "Upper": (SIZE, SIZE)}},
        "Conditions": {"Axis": {"Face": "x_lower", "Kind": "symmetry"}, "Floor": {"Face": "y_lower", "Kind": "symmetry"}},
        "Time": {"End Time": end},
    }
    if pressure is not None:
        deck["Confinement"] = {"Pressure": pressure, "Bodies": "{Block}"}
    return deck


def fastest(run):
    now = run.particles()
    return float(np.hypot(now["velocity_x"], now["velocity_y"]).max())


def stress_error(pressure):
    def error(run):
        now = run.particles()
        return float(max(np.abs(now[f"stress_{pair}"] + pressure).max() for pair in ("xx", "yy", "zz")) / max(pressure, 1.0))

    return error


def confinement_rows(barreno, table):
    title = "Confinement"
    for pressure in (0.0, 1e6, 1e8, 1e9):
        done = attempt(barreno, block(pressure), longest=120.0)
        setup = f"Berea sandstone under {1e-6 * pressure:g} MPa for 20 us"
        words = ("Confinement",)
        if done.code == 1:
            table.stops(title, setup, done, 1, *words)
            continue
        table.finishes(title, setup, done, "fastest particle [m/s]", fastest, 1e-8)
        table.finishes(title, setup, done, "stress less -p, over p", stress_error(pressure), 1e-9)


def coherence(run):
    first = run.particles(0)
    return first["coherence"]


def weibull_rows(barreno, full, table):
    """The mean strength of particles of volume v is (V / v)^(1 / m) of that of specimens of volume V."""
    title = "Weibull modulus"
    volume = CELL**3 / 8.0
    for modulus in (0.2, 1.0, 6.0, 1e6):
        done = attempt(barreno, block(end=1e-7, **{"Weibull modulus": modulus, "Weibull reference volume": volume}))
        setup = f"m = {modulus:g}, particles as large as the specimens"
        table.finishes(title, setup, done, "least coherence", lambda r: coherence(r).min(), 0.0, at_least=True)
        table.finishes(title, setup, done, "coherence that is finite", lambda r: float(np.isfinite(coherence(r)).all()), 1.0, at_least=True)
        if modulus >= 1.0:
            scatter = math.sqrt(math.gamma(1 + 2 / modulus) / math.gamma(1 + 1 / modulus) ** 2
                - 1.0) if modulus < 1e3 else math.pi / math.sqrt(6) / modulus
            count = (SIZE / CELL * 2) ** 2
            table.finishes(title, setup, done, "|mean coherence less 1| in standard errors",
                           lambda r, s=scatter, n=count: abs(coherence(r).mean() - 1.0) / (s / math.sqrt(n) + 1e-12), 4.0)  # fmt: skip
    for ratio in (1e-12, 1e12):
        done = attempt(barreno, block(end=1e-7, **{"Weibull modulus": 6.0, "Weibull reference volume": volume * ratio}))
        table.finishes(title, f"m = 6, specimens {ratio:g} times a particle", done, "|mean coherence over its law less 1|",
                       lambda r, e=ratio ** (1 / 6.0): abs(coherence(r).mean() / e - 1.0), 0.05)  # fmt: skip


def run(barreno, full, table):
    confinement_rows(barreno, table)
    weibull_rows(barreno, full, table)
