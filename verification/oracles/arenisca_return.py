# SPDX-License-Identifier: BSD-3-Clause
"""Closest point on the yield surface in the energy norm, by bracketed roots.

Distance^2 = (x - x0)^2/3 + w^2 |s - s0|^2/2 with w = beta sqrt(3K/G): z = I1/sqrt(3), r = w sqrt(J2). The set is
convex and isotropic, so the closest stress has the trial's eigenvectors and stays in its sextant: unknowns are
x and, with a third invariant, the Lode angle.
"""
import math

from scipy.optimize import brentq

TIGHT = dict(xtol=1e-300, rtol=8.9e-16, maxiter=300)


def closest_meridian(surface, x0, r0, w2, g=1.0):
    """Closest (x, rho) on rho = g F(x), r0 the trial's component in this half-plane; (x0, r0) not inside.

    The derivative of half the distance^2 along x, D(x) = (x-x0)/3 + w2 g F' (g F - r0), rises monotonically where
    g F <= r0 (F is concave); where g F > r0 the sign is that of the side on which the trial lies.
    """
    if r0 <= 0:
        x = min(max(x0, surface.X), surface.P)
        return x, 0.0

    def slope(x):
        value, rate = surface.limit(x)
        if g * value > r0:
            return -1.0
        return (x - x0) / 3 + w2 * g * rate * (g * value - r0)

    if surface.capped and _on_cap(surface, x0, r0, w2, g, slope):
        return _closest_on_cap(surface, x0, r0, w2, g)
    high = surface.P if math.isfinite(surface.P) else max(x0, 0.0) + 1.0
    if slope(high) <= 0 and math.isfinite(surface.P):
        return surface.P, g * max(surface.limit(surface.P)[0], 0.0)
    low = surface.kappa
    if not surface.capped:
        step = abs(x0) + r0 + surface.a1 + 1.0
        low = min(x0, high) - step
        while slope(low) > 0:
            step *= 2
            low -= step
    if slope(low) >= 0:
        return low, g * max(surface.limit(low)[0], 0.0)
    x = brentq(slope, low, high, **TIGHT)
    return x, g * max(surface.limit(x)[0], 0.0)


def _on_cap(surface, x0, r0, w2, g, slope):
    """Does the closest point lie left of kappa?"""
    at = g * surface.limit(surface.kappa)[0]
    if at > r0:
        return x0 < surface.kappa
    return slope(surface.kappa) >= 0


def _closest_on_cap(surface, x0, r0, w2, g):
    """x = kappa - L sin(t), fc = cos(t): smooth up to the tip."""
    length, kappa = surface.kappa - surface.X, surface.kappa
    left = x0 <= surface.X or (x0 < kappa and _cap_slope(surface, x0) > 0)

    def slope(t):
        c, s = math.cos(t), math.sin(t)
        x = kappa - length * s
        value, rate = surface.limit(x)
        value = max(value, 0.0)
        f, df = value * c, -length * rate * c * c - value * s
        if g * f > r0:
            return -1.0 if left else 1.0
        return -(x - x0) / 3 * length * c + w2 * g * df * (g * f - r0)

    top = 0.5 * math.pi
    if slope(0.0) >= 0:
        t = 0.0
    elif slope(top) <= 0:
        t = top
    else:
        t = brentq(slope, 0.0, top, **TIGHT)
    x = kappa - length * math.sin(t)
    return x, g * max(surface.limit(x)[0], 0.0) * max(math.cos(t), 0.0)


def _cap_slope(surface, x):
    value, rate = surface.limit(x)
    part = (surface.kappa - x) / (surface.kappa - surface.X)
    fc = math.sqrt(max(1 - part * part, 1e-300))
    return rate * fc + max(value, 0.0) * part / (fc * (surface.kappa - surface.X))


def closest(surface, gamma, x0, rho0, theta0, w2):
    """Closest (x, rho, theta); gamma None: no third invariant."""
    if gamma is None or rho0 == 0:
        x, rho = closest_meridian(surface, x0, rho0, w2)
        return x, rho, theta0
    top = math.pi / 3

    def at(t):
        g, dg = gamma(t)
        c = math.cos(t - theta0)
        x, rho = closest_meridian(surface, x0, rho0 * c, w2, g)
        far = (x - x0) ** 2 / 3 + w2 * (rho * rho - 2 * rho * rho0 * c)
        turn = dg * rho / g * (rho - rho0 * c) + rho * rho0 * math.sin(t - theta0)
        return x, rho, far, turn

    # distance over half-planes is quasi-convex in theta: bracket by samples, then the root of its derivative
    grid = [top * k / 6 for k in range(7)]
    best = min(range(len(grid)), key=lambda k: at(grid[k])[2])
    low, high = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
    turn = lambda t: at(t)[3] or (-1e-300 if t < grid[best] else 1e-300)
    if turn(low) >= 0:
        t = low
    elif turn(high) <= 0:
        t = high
    else:
        t = brentq(turn, low, high, xtol=1e-15, rtol=8.9e-16)
    x, rho, _, _ = at(t)
    return x, rho, t
