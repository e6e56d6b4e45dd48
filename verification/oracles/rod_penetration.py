#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Depth of a long rod by the theory of Alekseevskii and Tate, with strengths that follow from Johnson and Cook's flow stress.

The rod (velocity v, length l, density rho_p, strength Y) digs at u into a target of resistance R >= Y and density rho_t:
    rho_p (v - u)^2 / 2 + Y = rho_t u^2 / 2 + R,   dP/dt = u,   dl/dt = -(v - u),   rho_p l dv/dt = -Y.
It ends when the rod is used up, or when u is 0; the theory knows nothing of the time after that.

Resistance of a target whose flow stress is Y, Young's modulus E:
    spherical cavity   R = 2/3 Y (1 + ln(2 E / (3 Y)))        Bishop, Hill, Mott 1945
    Tate               R = Y (2/3 + ln(0.57 E / Y))           Tate 1986
Strength of a rod: Y itself, or 1.7 Y (Tate 1986).

    rod_penetration.py --self-check     0 if every figure holds

Sources: V. Alekseevskii, Combust. Explos. Shock Waves 2 (1966) 63-66; A. Tate, J. Mech. Phys. Solids 15 (1967) 387-399;
R. Bishop, R. Hill, N. Mott, Proc. Phys. Soc. 57 (1945) 147-159; A. Tate, Int. J. Engng Sci. 24 (1986) 599-612.
"""
import dataclasses
import sys

import numpy as np
from scipy.integrate import solve_ivp

USED_UP = 1e-6  # of the rod's length, at which it counts as used up: dv/dt is infinite at none
STRAINS = 4000  # parts of the range of strains over which a flow stress is a mean


@dataclasses.dataclass(frozen=True)
class Dug:
    depth: float
    time: float  # of the end since the impact
    length: float  # left of the rod
    first_rate: float  # u at the impact


def rate(velocity, rod_density, target_density, strength, resistance):
    """u of the equation above, which is quadratic in u; 0 where the rod is too slow to dig."""
    quadratic = [rod_density - target_density, -2.0 * rod_density * velocity,
        rod_density * velocity**2 + 2.0 * (strength - resistance)]  # fmt: skip
    if quadratic[2] <= 0.0:
        return 0.0
    if quadratic[0] == 0.0:
        return -quadratic[2] / quadratic[1]
    root = np.sqrt(quadratic[1] ** 2 - 4.0 * quadratic[0] * quadratic[2])
    return float(2.0 * quadratic[2] / (-quadratic[1] + root))


def penetrate(velocity, length, rod_density, target_density, strength, resistance):
    """The depth of a rod until it is used up or too slow."""
    if resistance < strength:
        raise ValueError("a rod that is stronger than its target goes on without being used up; this is not integrated here")
    dig = lambda v: rate(v, rod_density, target_density, strength, resistance)  # noqa: E731
    used_up = lambda t, state: state[1] - USED_UP * length  # noqa: E731
    slow = lambda t, state: rod_density * state[0] ** 2 + 2.0 * (strength - resistance) - 1e-9 * rod_density * velocity**2  # noqa: E731
    used_up.terminal = slow.terminal = True

    def change(t, state):
        v, left, _ = state
        u = dig(v)
        return [-strength / (rod_density * left), u - v, u]

    first = dig(velocity)
    if first == 0.0:
        return Dug(0.0, 0.0, length, 0.0)
    path = solve_ivp(change, (0.0, 1e3 * length / (velocity - first)), [velocity, length, 0.0], method="LSODA", events=[used_up, slow],
        rtol=1e-10, atol=[1e-9 * velocity, 1e-12 * length, 1e-12 * length])  # fmt: skip
    return Dug(float(path.y[2, -1]), float(path.t[-1]), float(path.y[1, -1]), first)


def cavity_resistance(flow, young):
    return 2.0 / 3.0 * flow * (1.0 + np.log(2.0 * young / (3.0 * flow)))


def tate_resistance(flow, young):
    return flow * (2.0 / 3.0 + np.log(0.57 * young / flow))


def flow_stress(card, strain_rate, strain):
    """Mean over the plastic strains from 0 to `strain` at a rate, without heat flow. card: the parameters of Johnson and Cook's model by
    their names in a card, SI."""
    parts = strain / STRAINS
    heating = card.get("Taylor Quinney", 0.9) / (card["Density"] * card["Specific Heat"])
    warm, total, stress = 0.0, 0.0, 0.0
    faster = 1.0 + card["C"] * np.log(strain_rate / card["Reference Strain Rate"])
    for i in range(STRAINS):
        middle = warm + 0.5 * heating * stress * parts  # half-way through this part, as the part before it warmed
        softening = 1.0 - (middle / (card["Melt Temperature"] - card["Room Temperature"])) ** card["m"]
        stress = (card["A"] + card["B"] * ((i + 0.5) * parts) ** card["n"]) * faster * max(0.0, softening)
        warm += heating * stress * parts
        total += stress * parts
    return total / strain


def young_modulus(card):
    bulk, shear = card["Density"] * card["Sound Speed"] ** 2, card["Shear Modulus"]
    return 9.0 * bulk * shear / (3.0 * bulk + shear)


def self_check():
    v, length, rod, target = 3000.0, 0.04, 17600.0, 7830.0
    off = {}
    fluid = length * (rod / target) ** 0.5
    off["without strength: l sqrt(rho_p / rho_t)"] = penetrate(v, length, rod, target, 0.0, 0.0).depth / fluid - 1.0
    # Y = R: u = v / (1 + mu), and dl/dv = rho_p l v mu / ((1 + mu) Y).
    mu, both = (target / rod) ** 0.5, 4e9
    exact = length / mu * (1.0 - np.exp(-rod * mu * v**2 / (2.0 * both * (1.0 + mu))))
    off["strength = resistance: closed form"] = penetrate(v, length, rod, target, both, both).depth / exact - 1.0
    # Equal densities, Y = 0: v - u = v / 2 + R / (rho v).
    lag = v / 2.0 + 5e9 / (rod * v)
    off["equal densities, rod without strength"] = penetrate(v, length, rod, rod, 0.0, 5e9).depth / (length * (v - lag) / lag) - 1.0
    u = rate(v, rod, target, 2e9, 5e9)
    off["stresses at the bottom"] = (0.5 * rod * (v - u) ** 2 + 2e9) / (0.5 * target * u**2 + 5e9) - 1.0
    slow = penetrate(500.0, length, rod, target, 2e9, 5e9)
    off["too slow to dig"] = slow.depth / length
    metal = {"A": 1e9, "B": 0.0, "n": 1.0, "C": 0.0, "m": 1.0, "Reference Strain Rate": 1.0, "Density": 8000.0, "Specific Heat": 500.0,
        "Room Temperature": 300.0, "Melt Temperature": 1800.0, "Taylor Quinney": 1.0}  # fmt: skip
    # B = C = 0, m = 1: d sigma / d strain = -sigma A / (rho c (Tm - Tr)), so the stress falls exponentially.
    a = 1e9 / (8000.0 * 500.0 * 1500.0)
    off["flow stress that heat lowers, closed form"] = flow_stress(metal, 1e5, 1.0) / (1e9 * (1.0 - np.exp(-a)) / a) - 1.0
    limits = dict.fromkeys(off, 1e-5)
    for name, value in off.items():
        print(f"{name}: {abs(value):.2e} <= {limits[name]:.0e}")
    return 0 if all(abs(value) <= limits[name] for name, value in off.items()) else 1


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    sys.exit(self_check())
