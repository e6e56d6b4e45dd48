#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Manufactured motions: displacement and the force per mass that a neo-Hookean solid needs to follow it.

    sigma = [lambda ln J I + mu (B - I)] / J,  P = lambda ln J F^-T + mu (F - F^-T),  rho0 a = Div P + rho0 b

Each motion is a function x(X, t); b follows from it without a formula of its own, by differences in 40 digits, and that is
what the self-check compares the closed forms with: momentum balance at random points, and sample values of another program.

    manufactured.py --self-check     a few seconds; 0 if every figure holds

Sources: P. Wallstedt, J. Guilkey, J. Comput. Phys. 227 (2008) 9628-9642 (axis-aligned, ring); K. Kamojjala et al.,
Engng Comput. 31 (2015) 209-226 (vortex). The axisymmetric form is derived here.
"""
import random
import sys

import numpy as np


class Solid:
    """Constants of the material; c is the speed sqrt(E / rho) that sets the period 2 / c of every motion."""

    def __init__(self, young, poisson, density):
        self.young, self.poisson, self.density = young, poisson, density
        self.shear = young / (2 * (1 + poisson))
        self.lam = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
        self.bulk = self.lam + self.shear * 2 / 3
        self.speed = (young / density) ** 0.5


def aligned(solid, amplitude, phases, X, t, m=np):
    """Axis-aligned displacement: x_i = X_i + A sin(pi X_i) sin(c pi t + phase_i)."""
    s = [amplitude * m.sin(solid.speed * m.pi * t + p) for p in phases]
    x = [X[i] + s[i] * m.sin(m.pi * X[i]) for i in range(len(X))]
    u = [s[i] * m.sin(m.pi * X[i]) for i in range(len(X))]
    f = [1 + s[i] * m.pi * m.cos(m.pi * X[i]) for i in range(len(X))]
    k = sum(m.log(q) for q in f)
    mu, rho = solid.shear, solid.density
    b = [m.pi**2 * u[i] * (mu / rho - solid.speed**2 - (solid.lam * (k - 1) - mu) / (rho * f[i] ** 2)) for i in range(len(X))]
    return x, b


def turned(m, angle, x, y):
    return [m.cos(angle) * x - m.sin(angle) * y, m.sin(angle) * x + m.cos(angle) * y]


def vortex(solid, angle, X, t, m=np):
    """Generalized vortex: the point (R, Theta) turns by A sin(c pi t) h(R), 0.75 < R < 1.25."""
    R = m.sqrt(X[0] ** 2 + X[1] ** 2)
    s, rate = angle * m.sin(solid.speed * m.pi * t), solid.speed * m.pi
    h = 1 - 32 * (R - 1) ** 2 + 256 * (R - 1) ** 4
    dh = 64 * (R - 1) * (4 * R - 5) * (4 * R - 3)
    stiffness = solid.shear / solid.density
    radial = -R * (angle * rate * m.cos(rate * t) * h) ** 2 + stiffness * R * (s * dh) ** 2
    across = -s * (R * rate**2 * h + stiffness * 64 * (96 * R**3 - 240 * R**2 + 188 * R - 45))
    back = turned(m, s * h, X[0] / R, X[1] / R)
    return turned(m, s * h, X[0], X[1]), [back[0] * radial - back[1] * across, back[1] * radial + back[0] * across]


def ring_profile(inner, outer, R):
    """g of the ring and its first two derivatives: free of traction at both radii if lambda = 0."""
    scale = outer * (outer - 3 * inner)
    c1, c2, c3 = -6 * inner / scale, 3 * (outer + inner) / (outer * scale), -2 / (outer * scale)
    return c1 + c2 * R + c3 * R**2, c2 + 2 * c3 * R, 2 * c3


def ring(solid, amplitude, inner, outer, X, t, m=np):
    """Expanding ring: x = (1 + A sin(c pi t) g(R)) X, lambda = 0."""
    R = m.sqrt(X[0] ** 2 + X[1] ** 2)
    g, dg, ddg = ring_profile(inner, outer, R)
    s, rate = amplitude * m.sin(solid.speed * m.pi * t), solid.speed * m.pi
    hoop, radial = 1 + s * g, 1 + s * (g + R * dg)
    slope = s * (2 * dg + R * ddg)
    difference = (radial - 1 / radial) - (hoop - 1 / hoop)
    force = -(rate**2) * s * g * R - solid.shear / solid.density * (slope * (1 + 1 / radial**2) + difference / R)
    return [hoop * X[0], hoop * X[1]], [force * X[0] / R, force * X[1] / R]


def axisymmetric(solid, amplitude, phase, X, t, m=np):
    """r = R + A sin(pi R) sin(c pi t), z = Z + A sin(pi Z) sin(c pi t + phase); X = (R, Z)."""
    R, Z = X
    rate = solid.speed * m.pi
    s, w = amplitude * m.sin(rate * t), amplitude * m.sin(rate * t + phase)
    U, dU = s * m.sin(m.pi * R), s * m.pi * m.cos(m.pi * R)
    W, dW = w * m.sin(m.pi * Z), w * m.pi * m.cos(m.pi * Z)
    f1, f2, f3 = 1 + dU, 1 + U / R, 1 + dW
    k = m.log(f1 * f2 * f3)
    lam, mu, rho = solid.lam, solid.shear, solid.density
    p1, p2 = (lam * k / f + mu * (f - 1 / f) for f in (f1, f2))
    dp1 = -(m.pi**2) * U * ((lam * (1 - k) + mu) / f1**2 + mu) + lam * (dU / R - U / R**2) / (f1 * f2)
    b_r = -(rate**2) * U - (dp1 + (p1 - p2) / R) / rho
    b_z = -(rate**2) * W + m.pi**2 * W * ((lam * (1 - k) + mu) / f3**2 + mu) / rho
    return [R + U, Z + W], [b_r, b_z]


def momentum_residual(solid, motion, X, t, m):
    """|rho a - Div P - rho b| over the size of its terms, by central differences of x(X, t)."""
    mp, n = m, len(X)

    def gradient(Y):
        step, F = mp.mpf(10) ** -12, mp.eye(3)
        for j in range(n):
            ends = [motion([Y[i] + (sign * step if i == j else 0) for i in range(n)], t)[0] for sign in (1, -1)]
            for i in range(n):
                F[i, j] = (ends[0][i] - ends[1][i]) / (2 * step)
        return F

    def stress(Y):
        F = gradient(Y)
        inverse = (F**-1).T
        return solid.lam * mp.log(mp.det(F)) * inverse + solid.shear * (F - inverse)

    step = mp.mpf(10) ** -8
    div = [mp.mpf(0)] * n
    for j in range(n):
        p, q = (stress([X[i] + (sign * step if i == j else 0) for i in range(n)]) for sign in (1, -1))
        for i in range(n):
            div[i] += (p[i, j] - q[i, j]) / (2 * step)
    dt = mp.mpf(10) ** -10
    before, now, after = (motion(X, t + d)[0] for d in (-dt, 0, dt))
    b = motion(X, t)[1]
    rest = [solid.density * ((after[i] - 2 * now[i] + before[i]) / dt**2 - b[i]) - div[i] for i in range(n)]
    return float(max(abs(r) for r in rest) / (max(abs(d) for d in div) + solid.density * max(abs(q) for q in b)))


def in_space(motion):
    """An axisymmetric motion of (R, Z) as one of (X, Y, Z)."""

    def of(X, t):
        radius = (X[0] ** 2 + X[1] ** 2) ** 0.5
        (r, z), (b_r, b_z) = motion([radius, X[2]], t)
        along = [X[0] / radius, X[1] / radius]
        return [r * along[0], r * along[1], z], [b_r * along[0], b_r * along[1], b_z]

    return of


# Values of another program: motion, X, t, x, b.
SAMPLES = [
    ("axis-aligned in space", (0.25, 0.4, 0.7), 0.004, (0.28362492559819785, 0.3901132115816913, 0.6699391603453492),
     (322.8012389665723, -267.01287604965717, -437.62695192268444)),
    ("vortex", (0.9, 0.3), 0.3, (0.4604468208750018, 0.8294508575835605), (-5.960476052602771, 2.897372543949105)),
    ("ring", (0.45, 0.1), 0.004, (0.5455154641423482, 0.12122565869829961), (-2786.6086878545307, -619.2463750787846)),
    ("axisymmetric", (0.4, 0.3), 0.004, (0.44522542485937366, 0.3125), (2625.083214668696, 240.78964905166177)),
]  # fmt: skip


def motions(m, number):
    """name -> (solid, motion, random place); `number` makes the constants."""
    pi = m.pi
    stiff, soft = (Solid(number(e), number("0.3"), number(r)) for e, r in (("10000", "1"), ("1000", "1000")))
    straight = Solid(number("10000000"), number("0"), number("1000"))
    a, tenth = number("0.05"), number("0.1")

    def disk(lower, upper):
        radius, angle = random.uniform(lower, upper), random.uniform(0.0, 6.0)
        return [number(repr(float(radius * f(angle)))) for f in (np.cos, np.sin)]

    def box(n):
        return [number(repr(random.uniform(0.05, 0.95))) for _ in range(n)]

    return {
        "axis-aligned in space": (stiff, lambda X, t: aligned(stiff, a, (0, 2 * pi / 3, 4 * pi / 3), X, t, m), lambda: box(3)),
        "axis-aligned": (stiff, lambda X, t: aligned(stiff, a, (0, pi), X, t, m), lambda: box(2)),
        "vortex": (soft, lambda X, t: vortex(soft, number("1"), X, t, m), lambda: disk(0.75, 1.25)),
        "ring": (straight, lambda X, t: ring(straight, tenth, number("0.4"), number("0.6"), X, t, m), lambda: disk(0.4, 0.6)),
        "axisymmetric": (stiff, lambda X, t: axisymmetric(stiff, a, pi / 2, X, t, m), lambda: box(2)),
    }


def self_check():
    import mpmath

    mpmath.mp.dps = 40
    random.seed(1)
    worst = {}
    for name, (solid, motion, place) in motions(mpmath, mpmath.mpf).items():
        if name == "axisymmetric":
            where = [place() + place() for _ in range(4)]
            checked, points = in_space(motion), [p[:3] for p in where]
        else:
            checked, points = motion, [place() for _ in range(4)]
        period = 2 / solid.speed
        worst[name] = max(
            momentum_residual(solid, checked, X, mpmath.mpf(repr(random.random())) * period, mpmath) for X in points
        )
    plain = motions(np, float)
    off = {
        name: max(abs(g / w - 1.0) for got, want in zip(plain[name][1](list(X), t), (x, b)) for g, w in zip(got, want))
        for name, X, t, x, b in SAMPLES
    }
    print("momentum residual:", {k: f"{v:.1e}" for k, v in worst.items()})
    print("against the samples:", {k: f"{v:.1e}" for k, v in off.items()})
    return 0 if max(worst.values()) < 1e-12 and max(off.values()) < 1e-11 else 1


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    sys.exit(self_check())
