# SPDX-License-Identifier: BSD-3-Clause
"""Independent reference implementation of the sandstone model Arenisca: state, update, fluid exchange, scatter.

Written from the equations; it shares nothing with the library it judges. Slow and plain: every scalar equation is
solved by a bracketed root to round-off, elastic moduli are those at the middle of the substep (iterated), the
plastic variable and the flow direction are those at its end (backward Euler, first order in the substep).

Conventions: SI, tension positive, symmetric tensors as xx yy zz xy yz zx with tensor shear, unrotated
(corotational) strain increments.
"""
import copy
import dataclasses
import math

import numpy as np
from scipy.optimize import brentq

from oracles.arenisca_laws import Laws
from oracles.arenisca_return import closest

UNIT = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
TWICE = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def as_six(tensor):
    """3x3 or 6 -> 6 (xx yy zz xy yz zx)."""
    tensor = np.asarray(tensor, dtype=float)
    return np.array([tensor[i, j] for i, j in PAIRS]) if tensor.shape == (3, 3) else tensor.copy()


def as_matrix(six):
    """6 -> 3x3."""
    a, b, c, d, e, f = six
    return np.array([[a, d, f], [d, b, e], [f, e, c]])


def dot(a, b):
    """a : b."""
    return float(np.sum(a * b * TWICE))


def invariants(stress):
    """I1, deviator, rho = sqrt(J2)."""
    i1 = float(stress[0] + stress[1] + stress[2])
    s = stress - i1 / 3 * UNIT
    return i1, s, math.sqrt(0.5 * dot(s, s))


def lode_angle(s, rho):
    """theta in [0, pi/3]: cos 3 theta = (3 sqrt(3)/2) J3/J2^1.5; 0 is triaxial extension."""
    if rho == 0:
        return 0.0
    low, mid, high = np.linalg.eigvalsh(as_matrix(s / rho))
    return math.atan2(math.sqrt(3) * (mid - low), 2 * high - mid - low)


def deviator(s0, rho, theta):
    """Deviator of given rho, theta with the eigenvectors (and their order) of s0."""
    _, vectors = np.linalg.eigh(as_matrix(s0))  # ascending
    turn = 2 * math.pi / 3
    values = 2 / math.sqrt(3) * rho * np.array([math.cos(theta + turn), math.cos(theta - turn), math.cos(theta)])
    return as_six(vectors @ np.diag(values) @ vectors.T)


@dataclasses.dataclass
class State:
    """History of a point. e: plastic volumetric variable; mu: fluid mass / initial fluid mass."""

    stress: np.ndarray  # quasi-static
    dynamic: np.ndarray  # what the host sees when rate dependence is on
    plastic: np.ndarray  # plastic strain tensor
    strain: np.ndarray
    e: float = 0.0
    mu: float = 1.0
    coherence: float = 1.0
    dissipation: float = 0.0  # integral of (sigma - zeta/3 I) : d eps_p [J/m3]
    least_dissipation: float = 0.0  # most negative increment met
    plastic_steps: int = 0

    @property
    def evp(self):
        """Volumetric plastic strain."""
        return float(self.plastic[:3].sum())

    def copy(self):
        """Independent copy: fields are replaced, never written into."""
        return copy.copy(self)


class Arenisca:
    """The model. parameters: published names, SI."""

    def __init__(self, parameters, p3=None):
        self.laws = Laws(parameters, p3)
        p = self.p = self.laws.p
        self.beta2 = p["BETA_nonassociativity"] ** 2
        self.gamma = self.laws.gamma if p["J3_type"] else None
        self.rate = p["T1_rate_dependence"] > 0

    def initial(self, coherence=1.0):
        """Virgin state: stress -p_i I, centred."""
        stress = -self.laws.pi * UNIT if self.laws.Kf else 0.0 * UNIT
        return State(stress.copy(), stress.copy(), 0 * UNIT, 0 * UNIT, coherence=coherence)

    # -- quantities derived from a state ------------------------------------------------------------------------
    def zeta(self, s):
        """Backstress [Pa]."""
        return self.laws.zeta(s.e, s.mu)

    def cap(self, s):
        """X from the elastic centre [Pa]."""
        return self.laws.cap(s.e, s.mu)

    def pore_pressure(self, s):
        """Actual fluid pressure [Pa]."""
        return self.laws.pore_pressure(float(s.stress[:3].sum()) - self.zeta(s), s.e, s.mu)

    def porosity(self, s):
        """Porosity at the elastic centre."""
        return self.laws.porosity(s.e, s.mu)

    def yield_value(self, s):
        """rho - Gamma F [Pa] (axis and vertex: distance beyond X or P); <= 0 elastic."""
        surface = self.laws.surface(s.e, s.mu, s.coherence)
        i1, dev, rho = invariants(s.stress)
        x = i1 - self.zeta(s)
        if x > surface.P or x < surface.X:
            return max(x - surface.P, surface.X - x) + rho
        gamma = self.gamma(lode_angle(dev, rho))[0] if self.gamma else 1.0
        return rho - gamma * surface.strength(x)

    def moduli(self, s):
        """Tangent (K, G) at a state [Pa]."""
        x = float(s.stress[:3].sum()) - self.zeta(s)
        return self.laws.bulk(x, s.e, s.mu), self.laws.shear(x, s.e)

    # -- update -----------------------------------------------------------------------------------------------
    def advance(self, state, strain_increment, dt=0.0, substeps=1):
        """New state after a strain increment (3x3 or 6), in equal substeps."""
        step = as_six(strain_increment) / substeps
        state = state.copy()
        for _ in range(substeps):
            self._substep(state, step, dt / substeps)
        return state

    def _substep(self, s, step, dt):
        laws = self.laws
        zeta = laws.zeta(s.e, s.mu)
        i1, dev, _ = invariants(s.stress)
        x = i1 - zeta
        dv = float(step[:3].sum())
        dd = step - dv / 3 * UNIT
        xm, em, old = x, s.e, None
        for _ in range(12):
            k, g = laws.bulk(xm, em, s.mu), laws.shear(xm, em)
            if old and abs(k - old[0]) <= 1e-14 * k and abs(g - old[1]) <= 1e-14 * g:
                break
            old = k, g
            x1, dev1, e1, plastic = self._trial_and_return(s, x, dev, dv, dd, k, g, zeta)
            xm, em = 0.5 * (x + x1), 0.5 * (s.e + e1)
        zeta1 = laws.zeta(e1, s.mu)
        stress = dev1 + (x1 + zeta1) / 3 * UNIT
        if self.rate:
            self._overstress(s, stress, 2 * g * dd + k * dv * UNIT, step, dt)
        if plastic:
            # strain increment - C^-1 : stress increment
            dp = step - (dev1 - dev) / (2 * g) - (x1 + zeta1 - x - zeta) / (9 * k) * UNIT
            work = dot(dev1 + x1 / 3 * UNIT, dp)
            s.plastic = s.plastic + dp
            s.dissipation += work
            s.least_dissipation = min(s.least_dissipation, work)
            s.plastic_steps += 1
        s.stress, s.e, s.strain = stress, e1, s.strain + step
        if not self.rate:
            s.dynamic = stress.copy()

    def _overstress(self, s, stress, elastic, step, dt):
        """Duvaut-Lions, exact for constant rates: tau = T1 |D|^-T2; D = 0 with T2 > 0: tau infinite."""
        if dt <= 0:
            s.dynamic = s.dynamic + stress - s.stress
            return
        size = math.sqrt(dot(step, step)) / dt
        t1, t2 = self.p["T1_rate_dependence"], self.p["T2_rate_dependence"]
        ratio = 0.0 if size == 0 and t2 > 0 else dt / (t1 * (size**-t2 if t2 > 0 else 1.0))
        decay = math.exp(-ratio)
        mean = -math.expm1(-ratio) / ratio if ratio > 0 else 1.0
        s.dynamic = stress + (elastic - (stress - s.stress)) * mean + (s.dynamic - s.stress) * decay

    def _trial_and_return(self, s, x, dev, dv, dd, k, g, zeta):
        """(x, deviator, e, plastic?) at the end, moduli given."""
        laws = self.laws
        x0, dev0 = x + 3 * k * dv, dev + 2 * g * dd
        rho0 = math.sqrt(0.5 * dot(dev0, dev0))
        theta0 = lode_angle(dev0, rho0) if self.gamma else 0.0
        top = self.gamma(theta0)[0] if self.gamma else 1.0
        w2 = self.beta2 * 3 * k / g
        follows = laws.plastic_form or self.p["Flow strain"] == "plastic"

        def back(de, cap=None):
            """Closest point to the trial on the surface at e + de, and the change of e it implies.

            Flow about the centre: the trial moves with it. Flow of eps_p: the trial stays while the centre moves.
            """
            surface = laws.surface(s.e + de, s.mu, s.coherence, cap)
            seen = x0 - (laws.zeta(s.e + de, s.mu) - zeta) if follows else x0
            if surface.X <= seen <= surface.P and rho0 <= top * surface.strength(seen):
                x1, rho1, theta1 = seen, rho0, theta0
            else:
                x1, rho1, theta1 = closest(surface, self.gamma, seen, rho0, theta0, w2)
            return x1, rho1, theta1, ((seen if laws.plastic_form else x0) - x1) / (3 * k)

        first = laws.surface(s.e, s.mu, s.coherence)
        if first.X <= x0 <= first.P and rho0 <= top * first.strength(x0):
            return x0, dev0, s.e, False
        de = self._consistent(back)
        x1, rho1, theta1, got = back(de)
        e1 = s.e + de
        if abs(de - got) > max(1e-9 * abs(de), 1e-12):
            x1, rho1, theta1, e1 = self._at_jump(back, s, de)
        if self.gamma is None:
            dev1 = dev0 * (rho1 / rho0) if rho0 > 0 else 0 * dev0
        else:
            dev1 = deviator(dev0, rho1, theta1)
        return x1, dev1, e1, True

    def _at_jump(self, back, s, de):
        """X jumps at e + de: the last pore closes within round-off, or the published form's fluid ends.

        The cap is then where the return gives de, between the two sides; e goes to the side of the larger one.
        """
        miss = lambda size: back(de, -math.exp(size))[3] - de
        near = min(abs(self.laws.cap(s.e + de + d, s.mu)) for d in (-1e-12, 0.0, 1e-12))
        low, high = math.log(near), math.log(near) + 1
        while miss(high) < 0 and high < 80:
            high += 1
        if miss(low) > 0 or miss(high) < 0:  # no jump: round-off of e where the pores are closed but for 1e-10
            return (*back(de)[:3], s.e + de)
        size = brentq(miss, low, high, xtol=1e-13, rtol=8.9e-16)
        x1, rho1, theta1, _ = back(de, -math.exp(size))
        e1 = s.e + de
        for _ in range(64):  # to the side of the larger cap
            if -self.laws.cap(e1, s.mu) >= math.exp(size):
                break
            e1 = math.nextafter(e1, -math.inf)
        return x1, rho1, theta1, e1

    @staticmethod
    def _consistent(back):
        """de with de = what the return to the surface at e + de gives; between 0 and the non-hardening return's."""
        start = back(0.0)[3]
        if start == 0:
            return 0.0
        miss = lambda de: de - back(de)[3]
        far, at_far = start, miss(start)
        for _ in range(60):
            if at_far == 0:
                return far
            if at_far * start > 0:  # signs: miss(0) = -start
                return brentq(miss, 0.0, far, xtol=1e-15 * abs(start), rtol=8.9e-16, maxiter=500)
            far *= 1.5
            at_far = miss(far)
        raise ArithmeticError("no consistent plastic strain increment")

    # -- fluid exchange (drained step of pore-fluid.md) ----------------------------------------------------------
    def exchange_fluid(self, state, pressure_change, substeps=100):
        """Change the actual pore pressure by pressure_change [Pa] at fixed strain, elastically.

        The total mean stress moves by -alpha dp. While the centre is under fluid pressure
        dp_c = dp (1 - alpha B)/(1 - B), d e = -dp_c/Km. When p_c has come to zero the unloaded pores hold a gas gap
        instead, and the threshold at which the fluid engages moves by dp (1 - alpha B)/B. mu is what fits.
        """
        s, laws = state.copy(), self.laws
        dp = pressure_change / substeps
        for _ in range(substeps):
            x = float(s.stress[:3].sum()) - laws.zeta(s.e, s.mu)
            kd, phi = laws.drained(x, s.e), laws.porosity(s.e, s.mu)
            alpha, b = 1 - kd / laws.Km, laws._skempton(kd, phi)
            pc = laws.centre_pressure(s.e, s.mu)
            edge = min(0.0, laws.threshold(s.e, s.mu)) if pc == 0 else 0.0
            # moved share of (1 - alpha B) dp: first close the gap, then raise p_c; or lower p_c, then open the gap
            share = dp * (1 - alpha * b)
            closing = min(max(share, 0.0), -edge * b / 3)
            dpc = max((share - closing) / (1 - b), -pc) if share >= -edge * b / 3 or edge == 0 else 0.0
            edge = min(0.0, edge + 3 * (share - dpc * (1 - b)) / b)
            pc, s.e = pc + dpc, s.e - dpc / laws.Km
            gap = edge / (3 * laws.Km) - laws.elastic_strain(edge, s.e) if edge < 0 else 0.0
            filled = math.exp(s.e) * (1 - gap)
            pore = filled - (1 - laws.phi_i) * math.exp(-(pc - laws.pi) / laws.Km)
            s.mu = pore * math.exp((pc - laws.pi) / laws.Kf) / laws.phi_i
            s.stress = s.stress - alpha * dp * UNIT
            s.dynamic = s.dynamic - alpha * dp * UNIT
        return s


def weibull_coherence(modulus, volume, reference_volume, uniform, bound=math.inf):
    """PEAKI1 of a particle / mean PEAKI1.

    (Vref/V)^(1/m) (-ln U)^(1/m)/Gamma(1 + 1/m); uniform None: the random term by its mean ("scale only").
    Bounded from above, because STREN > YSLOPE*PEAKI1 must hold.
    """
    if math.isinf(modulus):
        return min(1.0, bound)
    scale = (reference_volume / volume) ** (1 / modulus)
    random = 1.0 if uniform is None else (-math.log(uniform)) ** (1 / modulus) / math.gamma(1 + 1 / modulus)
    return min(scale * random, bound)
