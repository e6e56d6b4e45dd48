#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Waves from a cavity in an infinite elastic solid whose wall takes a pressure at t = 0 and keeps it.

Units: cavity radius a = 1, speed of plane waves 1, density 1, pressure 1; nu is Poisson's ratio.

Spherical (Blake), closed form: with tau = t - (r - 1), u = d/dr (f(tau) / r),
    f'' + 2 eta f' + w0^2 f = -1,   eta = 2 cs^2,   w0 = 2 cs,   cs^2 = (1 - 2 nu) / (2 (1 - nu)).
Cylindrical, plane strain, by its Laplace transform u = A K1(s r), A = 1 / (s [s K0(s) + 2 cs^2 K1(s)]), inverted
numerically.

    cavity_waves.py --self-check     0 if every figure holds

Sources: F. Blake, J. Acoust. Soc. Am. 24 (1952) 211-215; A. Eringen, E. Suhubi, Elastodynamics II, 1975;
J. Abate, P. Valko, Int. J. Numer. Meth. Engng 60 (2004) 979-993 (inversion).
"""
import sys

import numpy as np
from scipy.special import kve


def shear_share(poisson):
    return (1 - 2 * poisson) / (2 * (1 - poisson))


def blake(r, t, poisson=0.25):
    """u, v and radial stress at r >= 1."""
    cs2 = shear_share(poisson)
    eta, w0 = 2 * cs2, 2 * np.sqrt(cs2)
    w, tau = np.sqrt(w0**2 - eta**2), t - (r - 1)
    decay, c, s = np.exp(-eta * tau), np.cos(w * tau), np.sin(w * tau)
    f = -(1 - decay * (c + eta / w * s)) / w0**2
    f1 = -decay * (eta**2 / w + w) * s / w0**2
    f2 = -1 - 2 * eta * f1 - w0**2 * f
    behind = tau > 0
    u = np.where(behind, -f1 / r - f / r**2, 0.0)
    v = np.where(behind, -f2 / r - f1 / r**2, 0.0)
    stress = np.where(behind, f2 / r + 4 * cs2 * (f1 / r**2 + f / r**3), 0.0)
    return u, v, stress


def inverse_laplace(transform, t, terms=20):
    """f(t) of a transform that takes arrays of s (last axis), t > 0, by the fixed Talbot path; 1e-8 in double precision."""
    t = np.asarray(t, float)[..., None]
    scale = 2 * terms / (5 * t)
    angle = np.arange(1, terms) * np.pi / terms
    cot = 1 / np.tan(angle)
    s = scale * angle * (cot + 1j)
    turn = 1 + 1j * (angle + (angle * cot - 1) * cot)
    path = (np.exp(t * s) * transform(s) * turn).real.sum(axis=-1)
    start = 0.5 * (np.exp(t * scale) * transform(scale + 0j)).real[..., 0]
    return (start + path) * scale[..., 0] / terms


def cylindrical(r, t, poisson=0.25):
    """u, v and radial stress at r >= 1; arrays of places."""
    cs2, r = shear_share(poisson), np.asarray(r, float)
    tau = t - (r - 1)
    behind, place = tau > 0, r[..., None]

    def K(order, s):  # times exp(s): what is left of it is the time of arrival
        return kve(order, s)

    def factor(s):
        return 1 / (s * (s * K(0, s) + 2 * cs2 * K(1, s)))

    parts = (
        lambda s: factor(s) * K(1, s * place),
        lambda s: s * factor(s) * K(1, s * place),
        lambda s: factor(s) * (-s * K(0, s * place) - 2 * cs2 / place * K(1, s * place)),
    )
    return tuple(np.where(behind, inverse_laplace(part, np.where(behind, tau, 1.0)), 0.0) for part in parts)


# Values of another program: r, tau, u, v, radial stress.
BLAKE = [(1, 0.5, 0.443786467, 0.753427925, -1.0), (2, 1, 0.296191678, 0.114098605, -0.201393429),
         (4, 4, 0.040014201, -0.009519183, -0.006531243)]  # fmt: skip
CYLINDRICAL = [(1, 0.5, 0.473103876, 0.882416479, -1.0), (2, 1, 0.572062217, 0.434313368, -0.506661256),
               (4, 4, 0.585610983, -0.048236289, -0.007543375)]  # fmt: skip


def wave_residual(r, t):
    """Of u_tt = u_rr + u_r / r - u / r^2, over its terms."""
    h = 1e-2
    u = [[float(cylindrical(r + i * h, t + j * h)[0]) for j in (-1, 0, 1)] for i in (-1, 0, 1)]
    tt = (u[1][2] - 2 * u[1][1] + u[1][0]) / h**2
    rr = (u[2][1] - 2 * u[1][1] + u[0][1]) / h**2
    rest = tt - rr - (u[2][1] - u[0][1]) / (2 * h) / r + u[1][1] / r**2
    return abs(rest) / (abs(tt) + abs(rr))


def self_check():
    off = {}
    for name, solution, samples in (("Blake", blake, BLAKE), ("cylindrical", cylindrical, CYLINDRICAL)):
        off[name] = max(
            abs(got - want) for r, tau, *wanted in samples for got, want in zip(solution(float(r), tau + r - 1.0), wanted)
        )
    off["wave equation"] = wave_residual(1.7, 1.9)
    limits = {"Blake": 1e-8, "cylindrical": 1e-8, "wave equation": 1e-3}
    for name, value in off.items():
        print(f"{name}: {value:.2e} <= {limits[name]:.0e}")
    return 0 if all(value <= limits[name] for name, value in off.items()) else 1


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    sys.exit(self_check())
