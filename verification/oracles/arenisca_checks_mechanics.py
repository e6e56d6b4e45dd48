# SPDX-License-Identifier: BSD-3-Clause
"""Checks of mechanics: what must hold for any parameters, without published numbers."""
import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize

from oracles.arenisca_laws import lode_function
from oracles.arenisca_model import Arenisca, UNIT, as_matrix, as_six, deviator, dot, invariants, lode_angle
from oracles.arenisca_paths import hydrostatic, mixed_path, strain_path, triaxial_compression
from oracles.arenisca_return import closest

ROCK = dict(PEAKI1=21e6, FSLOPE=0.435, STREN=4e8, YSLOPE=0.02, B0=8e9, B1=28e9, B2=4e8, G0=8e9,
            p0_crush_curve=-6e8, p1_crush_curve=1.5e-9, p3_crush_curve=0.22, CR=0.5)  # fmt: skip
WET = dict(ROCK, fluid_B0=2.2e9)
VARIABLE = dict(ROCK, G1=0.2, G2=0.05, G0=1.5 * 8e9 * 0.6 / 1.2)
CASES = {
    "drained": ROCK,
    "variable Poisson's ratio, coupling": dict(VARIABLE, B3=1e9, B4=0.01),
    "nonassociated, linear": dict(ROCK, STREN=0.0, YSLOPE=0.0, BETA_nonassociativity=0.6),
    "Gudehus": dict(ROCK, J3_type=1, J3_psi=0.8),
    "Willam-Warnke": dict(ROCK, J3_type=2, J3_psi=0.7),
    "Willam-Warnke, psi > 1": dict(ROCK, J3_type=2, J3_psi=1.4),
    "Mohr-Coulomb": dict(ROCK, J3_type=3, J3_psi=0.75),
    "undrained": WET,
    "undrained, p_i = 30 MPa, Gudehus": dict(WET, fluid_pressure_initial=3e7, J3_type=1, J3_psi=0.85),
    "undrained, published form": {**WET, "Backstress strain": "plastic"},
    "undrained, flow of eps_p": {**WET, "Flow strain": "plastic"},
    "undrained, Willam-Warnke, nonassociated": dict(WET, J3_type=2, J3_psi=0.8, BETA_nonassociativity=0.7),
    "no pores": dict(ROCK, p3_crush_curve=0.0),
    "no cohesion": dict(ROCK, PEAKI1=0.0),
    "no shear strength": dict(ROCK, PEAKI1=0.0, FSLOPE=0.0, STREN=0.0, YSLOPE=0.0),
}


def turned(six, rotation):
    """R t R^T."""
    return as_six(rotation @ as_matrix(six) @ rotation.T)


def random_rotation(rng):
    """Uniformly random."""
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def random_paths():
    """Random strain paths: admissible stress, dissipation, isotropy."""
    rng = np.random.default_rng(7)
    for name, parameters in CASES.items():
        model = Arenisca(parameters)
        outside = least = turn = bookkeeping = 0.0
        for _ in range(3):
            s, r = model.initial(), random_rotation(rng)
            other = model.initial()
            for _ in range(8):
                step = rng.normal(size=6) * 0.012 - 0.008 * UNIT
                s, other = model.advance(s, step, substeps=2), model.advance(other, turned(step, r), substeps=2)
                size = 1e6 + np.abs(s.stress).max()
                outside = max(outside, model.yield_value(s) / size)
                turn = max(turn, np.abs(turned(s.stress, r) - other.stress).max() / size)
                least = max(least, -s.least_dissipation / max(s.dissipation, 1.0))
                if model.laws.Kf == 0:
                    bookkeeping = max(bookkeeping, abs(s.evp - s.e))
        yield f"{name}: outside the surface", outside, 1e-9
        yield f"{name}: negative dissipation", least, 1e-12
        yield f"{name}: isotropy", turn, 2e-7
        if bookkeeping:
            yield f"{name}: evp against the variable of the laws", bookkeeping, 1e-12


def hard_steps():
    """Random steps up to 20 % strain in one or two substeps, through total pore collapse."""
    rng = np.random.default_rng(11)
    more = {"rate": dict(WET, T1_rate_dependence=1e-4, T2_rate_dependence=0.3),
            "published form": {**WET, "Backstress strain": "plastic", "Undrained moduli": "arenisca3"}}  # fmt: skip
    for name, parameters in {**CASES, **more}.items():
        model, outside, least = Arenisca(parameters), 0.0, 0.0
        for _ in range(2):
            s = model.initial()
            for _ in range(8):
                size = 10 ** rng.uniform(-4, -0.7)
                s = model.advance(s, rng.normal(size=6) * size - rng.uniform() * size * UNIT, 1e-3, 2)
                if s.e > -0.999999 * model.laws.p3:  # beyond, e holds no more digits of the pores
                    outside = max(outside, model.yield_value(s) / (1e6 + np.abs(s.stress).max()))
                least = max(least, -s.least_dissipation / max(s.dissipation, 1.0))
        yield f"{name}: outside the surface", outside, 1e-9
        yield f"{name}: negative dissipation", least, 1e-9


def elastic_round_trips():
    """Elastic closed paths return: stress, and no plastic strain."""
    for name in ("drained", "variable Poisson's ratio, coupling", "undrained", "undrained, p_i = 30 MPa, Gudehus"):
        model = Arenisca(CASES[name])
        start = hydrostatic(model, [-0.02], 5)[0]
        k, _ = model.moduli(start)
        start = model.advance(start, UNIT * 0.25 * 6e8 / (9 * k))  # off the cap
        up, side = np.array([1.0, -0.3, -0.2, 0.2, 0.1, -0.1]) * 2e-4, np.array([-0.5, 0.5, 0.2, 0.0, 0.3, 0.0]) * 2e-4
        s = start
        for step in (up, side, -side, -up):
            s = model.advance(s, step, substeps=5)
        yield f"{name}: there and back", np.abs(s.stress - start.stress).max() / 1e8, 1e-11
        yield f"{name}: plastic strain", abs(s.dissipation - start.dissipation) / 1e6, 0.0


def closest_points():
    """Closest point against a general minimiser over the surface in (x, rho, theta)."""
    rng = np.random.default_rng(3)
    for kind, psi, name in ((0, 1.0, "none"), (1, 0.8, "Gudehus"), (2, 0.6, "Willam-Warnke"),
                            (2, 1.7, "Willam-Warnke, psi 1.7"), (3, 0.6, "Mohr-Coulomb")):  # fmt: skip
        worst = 0.0
        for trial in range(30):
            cap = -10 ** rng.uniform(7.5, 9)
            surface = Arenisca(dict(ROCK)).laws.surface(0.0)
            surface.X, surface.kappa = cap, surface.P - 0.5 * (surface.P - cap)
            gamma = lode_function(kind, psi)
            x0, rho0, theta0 = rng.uniform(1.6 * cap, -0.4 * cap), 10 ** rng.uniform(6, 9.3), rng.uniform(0, math.pi / 3)
            if trial < 9:
                theta0 = (0.0, math.pi / 6, math.pi / 3)[trial % 3]
            if surface.X < x0 < surface.P and rho0 < gamma(theta0)[0] * surface.strength(x0):
                continue
            w2 = rng.uniform(0.3, 4)
            got = closest(surface, gamma if kind else None, x0, rho0, theta0, w2)

            def distance(u, x0=x0, rho0=rho0, theta0=theta0, w2=w2, gamma=gamma, surface=surface):
                x = surface.X + (surface.P - surface.X) * 0.5 * (1 - math.cos(u[0]))
                t = math.pi / 6 * (1 - math.cos(u[1]))
                rho = gamma(t)[0] * max(surface.strength(x), 0.0)
                return (x - x0) ** 2 / 3 + w2 * (rho**2 + rho0**2 - 2 * rho * rho0 * math.cos(t - theta0))

            own = (got[0] - x0) ** 2 / 3 + w2 * (
                got[1] ** 2 + rho0**2 - 2 * got[1] * rho0 * math.cos(got[2] - theta0))  # fmt: skip
            grid = [(a, b) for a in np.linspace(0, math.pi, 61) for b in np.linspace(0, math.pi, 13)]
            start = min(grid, key=distance)
            best = minimize(distance, start, method="Nelder-Mead", options=dict(xatol=1e-10, fatol=0, maxiter=800)).fun
            worst = max(worst, math.sqrt(own / best) - 1 if best > 0 else 0.0)
        yield f"{name}: farther than the minimiser by", worst, 1e-9


def rate_form(model, state, step):
    """The rate equations by Runge-Kutta from a yielding state: an answer without trial, return or root.

    d(s - zeta/3 I) = C : (d eps - lambda m), m = beta^2 f_I1 I + f_dev, d e = lambda tr m, f stays 0.
    """
    laws, gamma = model.laws, model.gamma or (lambda t: (1.0, 0.0))

    def f(stress, e):
        x, dev, rho = invariants(stress)
        return rho - gamma(lode_angle(dev, rho))[0] * laws.surface(e, state.mu).strength(x)

    def slope(stress, e):
        g, h = np.empty(6), 1e-5 * np.abs(stress).max()
        for i in range(6):
            d = np.zeros(6)
            d[i] = h
            g[i] = (f(stress - 2 * d, e) - 8 * f(stress - d, e) + 8 * f(stress + d, e) - f(stress + 2 * d, e)) / (12 * h)
        g[3:] /= 2
        d = 1e-6
        return g, (f(stress, e - 2 * d) - 8 * f(stress, e - d) + 8 * f(stress, e + d) - f(stress, e + 2 * d)) / (12 * d)

    def rate(_, y):
        stress, e = y[:6], y[6]
        x = float(stress[:3].sum())
        k, g = laws.bulk(x, e, state.mu), laws.shear(x, e)
        stiff = lambda t: 2 * g * t + (k - 2 * g / 3) * t[:3].sum() * UNIT
        n, fe = slope(stress, e)
        m = n + (model.beta2 - 1) * n[:3].sum() / 3 * UNIT
        trace = float(m[:3].sum())
        lam = dot(n, stiff(step)) / (dot(n, stiff(m)) - fe * trace)
        return np.append(stiff(step - lam * m), lam * trace)

    begin = np.append(state.stress - model.zeta(state) / 3 * UNIT, state.e)
    end = solve_ivp(rate, (0, 1), begin, rtol=1e-8, atol=1e-3 * np.append(np.ones(6), 1e-9), method="DOP853").y[:, -1]
    return end[:6] + laws.zeta(end[6], state.mu) / 3 * UNIT, end[6]


def against_rate_form():
    """Update, extrapolated in the substep, against the rate equations; and its order."""
    for name in ("drained", "variable Poisson's ratio, coupling", "Gudehus", "Willam-Warnke", "Willam-Warnke, psi > 1",
                 "Mohr-Coulomb", "undrained", "undrained, p_i = 30 MPa, Gudehus",
                 "undrained, Willam-Warnke, nonassociated"):  # fmt: skip
        model = Arenisca(CASES[name])
        step = np.array([-0.016, -0.006, -0.001, 0.004, 0.002, -0.003])
        start = strain_path(model, [((-0.03, -0.018, -0.012), 1.0)], 40)[-1]
        if name == "Mohr-Coulomb":  # stay on a face: the rate equations here know no edges
            start = strain_path(model, [((-0.03, -0.018, -0.006), 1.0)], 40)[-1]
            step = np.array([-0.010, -0.006, -0.002, 0.0, 0.0, 0.0])
        exact, e = rate_form(model, start, step)
        runs = [model.advance(start, step, substeps=n) for n in (8, 16, 32, 64)]
        table = [np.append(s.stress / 1e9, s.e) for s in runs]
        once = [2 * b - a for a, b in zip(table, table[1:])]
        best = (4 * once[-1] - once[-2]) / 3
        yield f"{name}: rate equations", np.abs(best - np.append(exact / 1e9, e)).max(), 3e-6
        error = [np.abs(t - np.append(exact / 1e9, e)).max() for t in table]
        yield f"{name}: |error ratio - 2|, 32 to 64 substeps", abs(error[-2] / error[-1] - 2), 0.2


def limits():
    """Drained and undrained limits, cavitation, fluid exchange."""
    path = [((-0.03, -0.02, -0.02), 1.0), ((-0.05, -0.02, -0.01), 2.0)]
    end = lambda p: strain_path(Arenisca(p), path, 8)[-1].stress
    dry = end(ROCK)
    yield "Kf = 0 is the drained model", np.abs(end(dict(ROCK, fluid_B0=0.0)) - dry).max(), 0.0
    off = [np.abs(end(dict(ROCK, fluid_B0=kf)) - dry).max() / np.abs(dry).max() for kf in (1e3, 1e4, 1e5)]
    yield "Kf = 1 kPa: off the drained model", off[0], 1e-5
    yield "Kf -> 0 first order: |ratio - 10|", max(abs(off[1] / off[0] - 10), abs(off[2] / off[1] - 10)), 0.1
    model = Arenisca({**WET, "fluid_B0": 36e9})
    worst = max(abs(model.laws.bulk(x, e) / 36e9 - 1) for x in (-1e7, -1e9) for e in (-0.15, 0.0))
    yield "Kf = Km: Ku = Km", worst, 1e-14
    law = Arenisca(WET).laws
    worst = max(abs(law.porosity(e) - (1 - (1 - law.phi_i) * math.exp(-law.centre_pressure(e) / 36e9 - e)))
                for e in (-0.2, -0.1, -0.01))  # fmt: skip
    yield "porosity from solid and from fluid volume", worst, 1e-13

    pressured = Arenisca(dict(WET, fluid_pressure_initial=3e7)).laws
    e0, d = pressured.filling_strain(), 1e-9
    yield "p_c at the filling strain", pressured.centre_pressure(e0) / 3e7, 1e-9
    yield "cap continuous where the fluid runs out", abs(pressured.cap(e0 + d) / pressured.cap(e0 - d) - 1), 1e-6
    yield "threshold continuous there [Pa]", abs(pressured.threshold(e0 + d) - pressured.threshold(e0 - d)), 1e3
    below, above = pressured.cap(e0 - 1e-3), pressured.cap(e0 + 0.05)
    yield "cap drained when the gap is wide", abs(above / pressured.cap_dry(e0 + 0.05) - 1) + (below > above), 1e-12
    centre = Arenisca({**WET, "fluid_pressure_initial": 3e7, "Cavitation": "centre"}).laws
    jump = centre.cap(e0 - d) / centre.cap(e0 + d) - 1
    yield f"with 'Cavitation' = centre the cap jumps by {100 * jump:.0f} % there", 0.0, 1.0

    rock = {"B0": 8e9, "G0": 6e9, "Matrix bulk modulus": 36e9, "fluid_B0": 2.2e9, "PEAKI1": 1e9, "FSLOPE": 0.3,
            "p3_crush_curve": -math.log(0.8), "p0_crush_curve": -6e9, "p1_crush_curve": 1e-9}  # fmt: skip
    model = Arenisca(rock)
    s = hydrostatic(model, [-1e-3], 1)[0]
    law = model.laws
    alpha, b = 1 - 8 / 36, law._skempton(8e9, 0.2)
    yield "undrained p = B P", abs(model.pore_pressure(s) / (b * 8e6 * law.bulk(-1.0, 0) / 8e9) - 1), 1e-12
    drained = model.exchange_fluid(s, -model.pore_pressure(s), 200)
    got = -drained.stress[0] / 1e-3
    yield f"drain at fixed strain: K = {got / 1e9:.4f} GPa (drained 8)", abs(got / 8e9 - 1), 1e-3
    yield "actual pressure after it, of before", abs(model.pore_pressure(drained) / model.pore_pressure(s)), 1e-9
    half = model.exchange_fluid(s, -0.5 * model.pore_pressure(s), 200)
    yield "half drained: pressure", abs(model.pore_pressure(half) / model.pore_pressure(s) - 0.5), 1e-9
    volume = (1 - half.mu) * law.phi_i / (0.5 * model.pore_pressure(s)) * 1e10
    yield "half drained: fluid volume against dp/M", abs(volume / ((0.2 / 2.2 + (alpha - 0.2) / 36) * 10) - 1), 1e-2
    back = model.exchange_fluid(drained, model.pore_pressure(s), 200)
    yield "fluid put back: mass ratio", abs(back.mu - 1), 1e-12


def strengths():
    """Strength in triaxial compression and extension, card and cap tip."""
    for kind, psi in ((0, 1.0), (1, 0.8), (2, 0.7), (3, 0.6)):
        rock = dict(B0=1e10, G0=1e10, PEAKI1=3e7, FSLOPE=0.3, J3_type=kind, J3_psi=psi)
        model = Arenisca(rock)
        s = mixed_path(model, [((-5e7, -5e7, -5e7, 0, 0, 0), 1.0)], [1, 1, 1, 0, 0, 0], 1)[-1]
        for sign, top in ((-1, 1.0), (1, psi)):
            start = s.strain[2]
            end = mixed_path(model, [((-5e7, -5e7, start + sign * 0.02, 0, 0, 0), 2.0)], [1, 1, 0, 0, 0, 0], 10, s)[-1]
            i1, _, rho = invariants(end.stress)
            kind_of = "compression" if sign < 0 else "extension"
            yield f"J3_type {kind}: triaxial {kind_of} strength", abs(rho / (top * 0.3 * (3e7 - i1)) - 1), 1e-8
    model = Arenisca(WET)
    s = triaxial_compression(model, 5e7, [-0.02], 20)[-1]
    yield "triaxial compression, undrained: lateral stress held", abs(s.stress[0] / -5e7 - 1), 1e-7
    s = hydrostatic(Arenisca(ROCK), [-0.3], 50)[0]
    law = Arenisca(ROCK).laws
    yield "crush curve: e = p3 (exp(p1 (X - p0)) - 1)", abs(s.e - 0.22 * math.expm1(1.5e-9 * (law.cap(s.e) + 6e8))), 1e-13
    s = hydrostatic(Arenisca(CASES["no pores"]), [-0.3], 5)[0]
    yield "no pores: no plastic strain in compression", abs(s.evp), 0.0
    s = strain_path(Arenisca(CASES["no shear strength"]), [((-0.2, 0.0, 0.0), 1.0)], 20)[-1]
    yield "no shear strength: deviator", invariants(s.stress)[2], 1e-6
    s = strain_path(Arenisca(CASES["no shear strength"]), [((0.02, 0.0, 0.0), 1.0)], 2)[-1]
    yield "no strength: stress in tension", np.abs(s.stress).max(), 1e-6


mechanics = (random_paths, hard_steps, elastic_round_trips, closest_points, against_rate_form, limits, strengths)
