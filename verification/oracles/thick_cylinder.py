#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Thick cylinder under internal pressure, plane strain, small strains: elastic, and elastic perfectly plastic.

Closed forms: Lame (elastic) and Hill (Tresca, the axial stress in between). A von Mises material has none unless it is
incompressible, where it is Tresca's with 2 Y / sqrt(3) for Y; its general answer is computed here on a radial mesh with radial
return, and compared with the closed forms in their limits.

    thick_cylinder.py --self-check     a few seconds; 0 if every figure holds

Sources: R. Hill, The Mathematical Theory of Plasticity, 1950, chapter V; J. Simo, T. Hughes, Computational Inelasticity, 1998,
section 3.3 (radial return and its tangent).
"""
import sys

import numpy as np
from scipy.linalg import solve_banded
from scipy.optimize import brentq


class Cylinder:
    def __init__(self, inner, outer, young, poisson, strength):
        self.a, self.b, self.young, self.poisson, self.strength = inner, outer, young, poisson, strength

    def lame(self, pressure, r):
        """u_r, and stresses along r, hoop and z."""
        a, b, nu = self.a, self.b, self.poisson
        A = pressure * a**2 / (b**2 - a**2)
        u = (1 + nu) / self.young * A * ((1 - 2 * nu) * r + b**2 / r)
        return u, A * (1 - b**2 / r**2), A * (1 + b**2 / r**2), 2 * nu * A + 0 * r

    def front(self, pressure):
        """Radius of Tresca's plastic zone; the inner radius below first yield."""
        a, b, Y = self.a, self.b, self.strength
        if pressure <= Y / 2 * (1 - a**2 / b**2):
            return a
        return brentq(lambda c: Y * np.log(c / a) + Y / 2 * (1 - c**2 / b**2) - pressure, a, b)

    def hill(self, pressure, r):
        """u_r, radial and hoop stress of Tresca's material."""
        b, Y, nu, c = self.b, self.strength, self.poisson, self.front(pressure)
        if c == self.a:
            return self.lame(pressure, r)[:3]
        flows = r < c
        radial = np.where(flows, -Y * (0.5 - c**2 / (2 * b**2) + np.log(c / r)), -Y * c**2 / (2 * b**2) * (b**2 / r**2 - 1))
        hoop = radial + Y * np.where(flows, 1.0, c**2 / r**2)
        u = (1 + nu) * (1 - 2 * nu) / self.young * r * radial + (1 - nu**2) * Y * c**2 / (self.young * r)
        return u, radial, hoop


class MisesCylinder:
    """Radial elements with one point each; monotone load in equal steps, Newton's method in each."""

    def __init__(self, cylinder, elements=500):
        self.c = cylinder
        self.r = np.linspace(cylinder.a, cylinder.b, elements + 1)
        self.middle, self.dr = 0.5 * (self.r[1:] + self.r[:-1]), np.diff(self.r)
        self.shear = cylinder.young / (2 * (1 + cylinder.poisson))
        self.bulk = cylinder.young / (3 * (1 - 2 * cylinder.poisson))
        self.u = np.zeros(elements + 1)
        self.plastic = np.zeros((elements, 3))  # r, hoop, z

    def strain(self, u):
        e = np.zeros((len(self.dr), 3))
        e[:, 0], e[:, 1] = np.diff(u) / self.dr, 0.5 * (u[1:] + u[:-1]) / self.middle
        return e

    def stress(self, u):
        """Stresses, plastic strains and tangents (element, 3, 3)."""
        e = self.strain(u)
        elastic = e - self.plastic
        mean = elastic.sum(axis=1, keepdims=True) / 3
        trial = 2 * self.shear * (elastic - mean)
        size = np.sqrt((trial**2).sum(axis=1, keepdims=True)) + 1e-30
        limit = np.sqrt(2 / 3) * self.c.strength
        share = np.minimum(1.0, limit / size)
        deviator = np.eye(3) - 1 / 3
        n = trial / size
        flows = (share < 1.0)[..., None]
        tangent = self.bulk + 2 * self.shear * share[..., None] * (deviator - flows * n[:, :, None] * n[:, None, :])
        plastic = self.plastic + (1 - share) * trial / (2 * self.shear)
        return share * trial + 3 * self.bulk * mean, plastic, tangent

    def load(self, pressure, steps=40):
        """Raise the pressure from where it is not yet (zero) to this one."""
        # Strains of an element from its two ends.
        B = np.zeros((len(self.dr), 3, 2))
        B[:, 0, 0], B[:, 0, 1] = -1 / self.dr, 1 / self.dr
        B[:, 1, :] = (0.5 / self.middle)[:, None]
        weight = self.middle * self.dr
        for p in pressure * np.arange(1, steps + 1) / steps:
            for _ in range(60):
                stress, plastic, tangent = self.stress(self.u)
                inner = np.einsum("eij,ei->ej", B, stress) * weight[:, None]
                rest = np.zeros_like(self.u)
                rest[0] = p * self.c.a
                rest[:-1] -= inner[:, 0]
                rest[1:] -= inner[:, 1]
                if np.abs(rest).max() < 1e-8 * p * self.c.a:
                    break
                k = np.einsum("eij,eik,ekl->ejl", B, tangent, B) * weight[:, None, None]
                band = np.zeros((3, len(self.u)))
                band[1, :-1] += k[:, 0, 0]
                band[1, 1:] += k[:, 1, 1]
                band[0, 1:], band[2, :-1] = k[:, 0, 1], k[:, 1, 0]
                self.u = self.u + solve_banded((1, 1), band, rest)
            else:
                raise RuntimeError(f"no equilibrium at a pressure of {p}")
            self.plastic = plastic
        return self

    def at(self, r):
        """u_r, radial and hoop stress."""
        stress = self.stress(self.u)[0]
        return (np.interp(r, self.r, self.u), *(np.interp(r, self.middle, stress[:, i]) for i in (0, 1)))


def self_check():
    steel = Cylinder(1.0, 2.0, 200e9, 0.3, 400e6)
    ends = np.array([1.0, 2.0])
    u, radial, hoop, axial = steel.lame(100e6, ends)
    # Values of another program.
    tests = {"Lame u": np.abs(u / [0.0009533333333333334, 0.0006066666666666666] - 1).max()}
    tests["Lame stress"] = max(abs(radial[0] / -100e6 - 1), abs(hoop[0] / 166666666.66666666 - 1), abs(axial[0] / 2e7 - 1))
    u, radial, hoop = steel.hill(200e6, ends)
    tests["Hill balance at the wall"] = abs(radial[0] / -200e6 - 1)
    tests["Hill u"] = np.abs(u / [0.002081893521000481, 0.0013009467605002406] - 1).max()
    elastic = MisesCylinder(Cylinder(1.0, 2.0, 200e9, 0.3, 4e12)).load(100e6, 1)
    tests["mesh against Lame"] = np.abs(elastic.at(ends)[0] / steel.lame(100e6, ends)[0] - 1).max()
    soft = Cylinder(1.0, 2.0, 200e9, 0.499, 400e6 * np.sqrt(3) / 2)
    equal = Cylinder(1.0, 2.0, 200e9, 0.499, 400e6)
    mises = MisesCylinder(soft).load(200e6)
    inside = np.linspace(1.05, 1.95, 19)
    tests["mesh against Hill, incompressible"] = np.abs(mises.at(inside)[0] / equal.hill(200e6, inside)[0] - 1).max()
    tests["its hoop stress"] = np.abs(mises.at(inside)[2] - equal.hill(200e6, inside)[2]).max() / 400e6
    limits = dict.fromkeys(tests, 1e-9) | {"mesh against Lame": 1e-6, "mesh against Hill, incompressible": 1e-5, "its hoop stress": 1e-5}
    for name, value in tests.items():
        print(f"{name}: {value:.2e} <= {limits[name]:.0e}")
    return 0 if all(value <= limits[name] for name, value in tests.items()) else 1


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    sys.exit(self_check())
