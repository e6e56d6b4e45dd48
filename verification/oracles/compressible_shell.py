#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Thick spherical shell of a compressible von Mises matrix under slow outer and inner pressure, finite strain.

Elasticity in logarithmic strains e_r = ln(dr/dR), e_t = ln(r/R), with s = sigma_r - sigma_t:

    sigma_r = K (e_r + 2 e_t) + (2/3) s,   s = 2 G (e_r - e_t - g) within [-Y, Y],   d sigma_r / dr = -2 s / r

g is the plastic part of e_r - e_t; it is what plastic flow left when the load last turned. Marched from the inner
surface in R (Runge-Kutta, fourth order), the inner radius by shooting. As K / G grows it tends to shell_statics.py.

    compressible_shell.py --self-check     0 if every figure holds
"""
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy as np
from scipy.optimize import brentq

from oracles.shell_statics import Shell, distension, loading


class CompressibleShell:
    def __init__(self, shell, bulk_modulus, inner, outer, steps=400):
        self.shell, self.bulk, self.a0, self.b0 = shell, bulk_modulus, inner, outer
        self.R = np.linspace(inner, outer, 2 * steps + 1)  # middles of the steps too
        self.g = np.zeros_like(self.R)

    def fluid(self, a):
        return self.shell.fluid_pressure - 3.0 * self.shell.fluid_modulus * np.log(a / self.a0)

    def radial(self, i, r, q):
        """(e_r, s) at a point whose radial stress is -q."""
        G, Y, K = self.shell.shear_modulus, self.shell.strength, self.bulk
        e_t = np.log(r / self.R[i])
        e_r = (4.0 / 3.0 * G * (e_t + self.g[i]) - 2.0 * K * e_t - q) / (K + 4.0 / 3.0 * G)
        s = 2.0 * G * (e_r - e_t - self.g[i])
        if abs(s) > Y:
            s = Y if s > 0.0 else -Y
            e_r = -(q + 2.0 / 3.0 * s) / K - 2.0 * e_t
        return e_r, s

    def march(self, a, whole=False):
        """Outer radius and pressure for an inner radius; with `whole` also rows (R, r, sigma_r, s, e_r) at the ends of steps."""
        r, q, rows = a, self.fluid(a), []
        h = self.R[2] - self.R[0]

        def slopes(i, r, q):
            e_r, s = self.radial(i, r, q)
            d = np.exp(e_r)
            return d, 2.0 * s * d / r

        for i in range(0, len(self.R) - 1, 2):
            if whole:
                rows.append((self.R[i], r, -q, *self.radial(i, r, q)[::-1]))
            d1, q1 = slopes(i, r, q)
            d2, q2 = slopes(i + 1, r + 0.5 * h * d1, q + 0.5 * h * q1)
            d3, q3 = slopes(i + 1, r + 0.5 * h * d2, q + 0.5 * h * q2)
            d4, q4 = slopes(i + 2, r + h * d3, q + h * q3)
            r += h / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + d4)
            q += h / 6.0 * (q1 + 2.0 * q2 + 2.0 * q3 + q4)
        if whole:
            i = len(self.R) - 1
            rows.append((self.R[i], r, -q, *self.radial(i, r, q)[::-1]))
            return r, q, np.array(rows).T
        return r, q

    def at_strain(self, strain):
        """Inner radius at a volume strain ln(b^3 / b0^3) of the whole."""
        b = self.b0 * np.exp(strain / 3.0)
        return self.inner(lambda a: self.march(a)[0] - b, b)

    def at_pressure(self, pressure, b):
        """Inner radius under an outer pressure; b is about the outer radius then."""
        return self.inner(lambda a: self.march(a)[1] - pressure, b)

    def inner(self, miss, b):
        matrix = self.b0**3 - self.a0**3
        low, high = np.cbrt(max(b**3 - 1.1 * matrix, 1e-6 * matrix)), np.cbrt(b**3 - 0.9 * matrix)
        return brentq(miss, low, high, xtol=1e-14 * self.b0, rtol=1e-13)

    def turn(self, a):
        """The load turns at this inner radius: plastic strains stay."""
        R, r = self.R, np.empty_like(self.R)
        _, _, rows = self.march(a, whole=True)
        r[::2] = rows[1]
        g = rows[4] - np.log(rows[1] / rows[0]) - rows[3] / (2.0 * self.shell.shear_modulus)
        self.g = np.interp(R, R[::2], g)

    def measures(self, a):
        """What a run can say of itself: P, p_f, and the radii that radii.csv would show (src/output/radii.hpp)."""
        _, pressure, (R, r, _, _, _) = self.march(a, whole=True)
        weights = np.full(len(R), 2.0)  # Simpson in R, mass as R^2 dR
        weights[1::2] = 4.0
        weights[0] = weights[-1] = 1.0
        mass = weights * R**2
        moved = np.sum(mass * r**3) / np.sum(mass) - np.sum(mass * R**3) / np.sum(mass)
        matrix = self.b0**3 - self.a0**3
        swollen = 0.5 * (r[-1] ** 3 - r[0] ** 3 - matrix)
        return pressure, self.fluid(a), np.cbrt(self.a0**3 + moved - swollen), np.cbrt(self.b0**3 + moved + swollen)


# Values of another program, for b0 = 1, phi = 0.2, K / G = 10: strain, P, p_f, a; the last two after the turn at -0.06.
DRAINED = [(-0.004, 1.90653977e8, 0.0, 0.582135357), (-0.02, 3.36311158e8, 0.0, 0.567119486), (-0.06, 3.75414568e8, 0.0, 0.524300153),
           (-0.058, 2.56695156e8, 0.0, 0.525680601), (-0.056, 1.38789096e8, 0.0, 0.527061777)]  # fmt: skip
WET = [(-0.004, 2.11571675e8, 2.90575666e7, 0.582234515), (-0.02, 5.25739888e8, 1.90531280e8, 0.568162574),
       (-0.06, 1.03825768e9, 6.67672593e8, 0.528537343), (-0.058, 9.11515352e8, 6.51237468e8, 0.529855131),
       (-0.056, 7.85505881e8, 6.34833364e8, 0.531173708)]  # fmt: skip


def self_check():
    off = {}
    for name, fluid, table in (("drained", 0.0, DRAINED), ("undrained", 2.2e9, WET)):
        shell = CompressibleShell(Shell(fluid_modulus=fluid), 150e9, np.cbrt(0.2), 1.0)
        worst = 0.0
        for strain, p, p_f, a in table:
            found = shell.at_strain(strain)
            pressure, fluid_now = shell.march(found)[1], shell.fluid(found)
            worst = max(worst, abs(pressure / p - 1.0), abs(fluid_now - p_f) / p, abs(found / a - 1.0))
            if strain == -0.06:
                shell.turn(found)
        off[f"{name}, against another program"] = worst
    stiff = CompressibleShell(Shell(), 15e9 * 1e5, np.cbrt(0.2), 1.0)
    exact = loading(Shell(), distension(Shell(), -0.02))[0]
    off["K/G = 1e5 against the incompressible shell"] = abs(stiff.march(stiff.at_strain(-0.02))[1] / exact - 1.0)
    limits = {"K/G = 1e5 against the incompressible shell": 1e-3}
    for name, value in off.items():
        print(f"{name}: {value:.2e} <= {limits.get(name, 1e-4):.0e}")
    return 0 if all(value <= limits.get(name, 1e-4) for name, value in off.items()) else 1


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    sys.exit(self_check())
