# SPDX-License-Identifier: BSD-3-Clause
"""Closed laws of Arenisca: parameters, elasticity, crush curve, pore fluid, yield surface.

Written from the published equations (Homel, Guilkey and Brannon 2015 and the project's design paper), not from
another program. Tension positive, SI. x = I1 - zeta is the first invariant seen from the elastic centre, rho the
root of J2, theta the Lode angle (0 in triaxial extension, pi/3 in triaxial compression), e the plastic volumetric
variable (volumetric strain of the elastic centre, or volumetric plastic strain in the published form).
"""
import functools
import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

REQUIRED = ("B0", "G0")
DEFAULTS = {
    "PEAKI1": 0.0, "FSLOPE": 0.0, "STREN": 0.0, "YSLOPE": 0.0, "BETA_nonassociativity": 1.0,
    "B0": None, "B1": 0.0, "B2": 0.0, "B3": 0.0, "B4": 0.0,
    "G0": None, "G1": 0.0, "G2": 0.0, "G3": 0.0, "G4": 0.0,
    "p0_crush_curve": 0.0, "p1_crush_curve": 0.0, "p3_crush_curve": 0.0, "CR": 0.5,
    "fluid_B0": 0.0, "fluid_pressure_initial": 0.0, "T1_rate_dependence": 0.0, "T2_rate_dependence": 0.0,
    "J3_type": 0, "J3_psi": 1.0, "Density": 0.0,
    "Matrix bulk modulus": None,            # B0 + B1 unless given
    "Backstress strain": "elastic centre",  # or "plastic": the published form
    "Undrained moduli": "biot",             # "arenisca3": the reference code's; "gassmann without B1": see below
    # choices that the design paper leaves open; the first is the oracle's
    "Cavitation": "gap",                    # fluid engages when the gas gap has closed; "centre": when p_c > 0
    "Flow strain": "centre",                # flow rule for the strain about the centre; "plastic": for eps_p
    "Cap strain": "centre",                 # X(e); "porosity": X at the strain of equal drained porosity
    "Moduli when dilated": "same",          # "B0": K = B0 once e > 0, as in the published benchmark 08
    "Coupling in tension": "yes",           # "no": B3 acts for I1 < 0 only
}  # fmt: skip
GAUSS = [(float(t), float(w)) for t, w in zip(*np.polynomial.legendre.leggauss(24))]
LODE_TYPES = {"none": 0, "gudehus": 1, "willam-warnke": 2, "mohr-coulomb": 3}
CONVEX = {1: (7 / 9, 9 / 7), 2: (0.5, 2.0), 3: (0.5, 2.0)}


class BadParameter(ValueError):
    """A parameter breaks a rule; the text names it, its value and the rule."""


def complete(given):
    """All parameters, defaults filled in and checked. Raises BadParameter."""
    unknown = set(given) - set(DEFAULTS)
    if unknown:
        raise BadParameter(f"unknown parameter {sorted(unknown)}")
    missing = [name for name in REQUIRED if name not in given]
    if missing:
        raise BadParameter(f"missing parameter {missing}")
    p = dict(DEFAULTS, **given)
    if isinstance(p["J3_type"], str):
        p["J3_type"] = LODE_TYPES[p["J3_type"].lower()]
    if p["Matrix bulk modulus"] is None:
        p["Matrix bulk modulus"] = p["B0"] + p["B1"]
    for name, value, good, rule in rules(p):
        if not good:
            raise BadParameter(f"{name} = {value!r}: {rule}")
    return p


CHOICES = {
    "Backstress strain": ("elastic centre", "plastic"),
    "Undrained moduli": ("biot", "arenisca3", "gassmann without B1"),
    "Cavitation": ("gap", "centre"),
    "Flow strain": ("centre", "plastic"),
    "Cap strain": ("centre", "porosity"),
    "Moduli when dilated": ("same", "B0"),
    "Coupling in tension": ("yes", "no"),
}


def rules(p):
    """Yield (name, value, holds, rule)."""
    for name, words in CHOICES.items():
        yield name, p[name], p[name] in words, f"must be one of {words}"
    for name in ("B0", "G0"):
        yield name, p[name], p[name] > 0, "must be positive"
    for name in ("B1", "B2", "B3", "B4", "FSLOPE", "STREN", "YSLOPE", "PEAKI1", "p1_crush_curve", "p3_crush_curve",
                 "fluid_B0", "fluid_pressure_initial", "T1_rate_dependence", "T2_rate_dependence"):  # fmt: skip
        yield name, p[name], p[name] >= 0, "must not be negative"
    yield "BETA_nonassociativity", p["BETA_nonassociativity"], p["BETA_nonassociativity"] > 0, "must be positive"
    yield "CR", p["CR"], 0 <= p["CR"] < 1, "must be in [0, 1)"
    yield "B3", p["B3"], p["B3"] < p["B0"], "must be less than B0"
    if p["STREN"] > 0 and p["FSLOPE"] > 0:
        yield "FSLOPE", p["FSLOPE"], p["FSLOPE"] > p["YSLOPE"], "must exceed YSLOPE"
        yield "STREN", p["STREN"], p["STREN"] > p["YSLOPE"] * p["PEAKI1"], "must exceed YSLOPE*PEAKI1"
    if p["p3_crush_curve"] > 0:
        yield "p0_crush_curve", p["p0_crush_curve"], p["p0_crush_curve"] < 0, "must be negative"
        yield "p1_crush_curve", p["p1_crush_curve"], p["p1_crush_curve"] > 0, "must be positive"
    if p["G1"] and p["G2"]:
        low = 1.5 * p["B0"] * (1 - 2 * p["G1"]) / (1 + p["G1"])
        yield "G0", p["G0"], abs(p["G0"] - low) < 1e-3 * low, f"must be 1.5 B0 (1-2 G1)/(1+G1) = {low:.6g}"
    yield "J3_type", p["J3_type"], p["J3_type"] in (0, 1, 2, 3), "must be 0, 1, 2 or 3"
    if p["J3_type"]:
        low, high = CONVEX[p["J3_type"]]
        yield "J3_psi", p["J3_psi"], low <= p["J3_psi"] <= high, f"must be in [{low:.4g}, {high:.4g}] (convexity)"
    yield ("fluid_pressure_initial", p["fluid_pressure_initial"],
           p["fluid_B0"] > 0 or p["fluid_pressure_initial"] == 0, "needs fluid_B0 > 0")  # fmt: skip
    if p["fluid_B0"] > 0 and p["p3_crush_curve"] > 0:
        phi, km = -math.expm1(-p["p3_crush_curve"]), p["Matrix bulk modulus"]
        yield "Matrix bulk modulus", km, p["B0"] <= (1 - phi) * km, "needs B0 <= (1 - porosity) Km (else storage < 0)"


# ---------------------------------------------------------------------------------------------------- Lode angle
def lode_function(kind, psi):
    """Gamma(theta) and its derivative: 1 in triaxial compression, psi in triaxial extension.

    1 Gudehus, 2 Willam-Warnke, 3 Mohr-Coulomb (a straight line in the octahedral plane).
    """
    if kind == 0 or (kind != 3 and psi == 1.0):
        return lambda t: (1.0, 0.0)
    if kind == 1:
        def gamma(t):
            u = 0.5 * ((1 - math.cos(3 * t)) + (1 + math.cos(3 * t)) / psi)
            du = 1.5 * math.sin(3 * t) * (1 - 1 / psi)
            return 1 / u, -du / (u * u)
    elif kind == 2:
        def gamma(t):
            c, s, k, n = math.cos(t), math.sin(t), 1 - psi * psi, 2 * psi - 1
            root = max(math.sqrt(max(4 * k * c * c + 5 * psi * psi - 4 * psi, 0.0)), 1e-300)
            root_slope = -4 * k * c * s / root
            if psi > 1:  # the same, rationalised: the form below is 0/0 inside
                bottom = 2 * k * c - n * root
                value = (k - n * n) / bottom
                return value, -value * (-2 * k * s - n * root_slope) / bottom
            top, bottom = 2 * k * c + n * root, 4 * k * c * c + n * n
            return top / bottom, (-2 * k * s + n * root_slope + top / bottom * 8 * k * c * s) / bottom
    else:
        a, b = 1 / psi, (2 - 1 / psi) / math.sqrt(3)

        def gamma(t):
            u = a * math.cos(t) + b * math.sin(t)
            return 1 / u, (a * math.sin(t) - b * math.cos(t)) / (u * u)
    return gamma


# --------------------------------------------------------------------------------------------------- yield surface
class Surface:
    """F(x) = Ff(x) fc(x); elastic if X <= x <= P and rho <= Gamma(theta) F(x). Stress in Pa."""

    def __init__(self, p, peak, cap):
        fslope, yslope, stren = p["FSLOPE"], p["YSLOPE"], p["STREN"]
        self.P, self.a2, self.a3, self.a4 = peak, 0.0, 0.0, 0.0
        if fslope == 0 and stren > 0:
            self.P, self.a1 = math.inf, stren  # von Mises: no vertex
        elif stren == 0 or fslope == yslope:
            self.a1, self.a4 = peak * fslope, fslope
        else:
            left = stren - yslope * peak
            self.a1, self.a4 = stren, yslope
            self.a2 = (fslope - yslope) / left
            self.a3 = left * math.exp(-self.a2 * peak)
        self.X = cap if math.isfinite(self.P) else -math.inf
        self.capped = math.isfinite(self.X)
        self.kappa = self.P - p["CR"] * (self.P - self.X) if self.capped else -math.inf

    def limit(self, x):
        """Ff and its slope."""
        grown = self.a3 * math.exp(self.a2 * x) if self.a3 else 0.0
        return self.a1 - grown - self.a4 * x, -self.a2 * grown - self.a4

    def strength(self, x):
        """F = Ff fc at x, negative outside [X, P]."""
        if x > self.P or x < self.X:
            return -1.0
        value = max(self.limit(x)[0], 0.0)
        if x < self.kappa:
            part = (self.kappa - x) / (self.kappa - self.X)
            value *= math.sqrt(max(0.0, (1 - part) * (1 + part)))
        return value


# ------------------------------------------------------------------------------------------------------ all laws
class Laws:
    """Elasticity, crush curve and pore fluid of one parameter set; p3 is a property of the particle."""

    def __init__(self, parameters, p3=None):
        self.p = p = complete(parameters)
        self.p3 = p["p3_crush_curve"] if p3 is None else p3
        self.Km, self.pi = p["Matrix bulk modulus"], p["fluid_pressure_initial"]
        self.phi_i = -math.expm1(-self.p3)
        self.Kf = p["fluid_B0"] if self.p3 > 0 else 0.0  # no pores, no fluid
        self.gamma = lode_function(p["J3_type"], p["J3_psi"])
        self.plastic_form = p["Backstress strain"] == "plastic"
        self.published = p["Undrained moduli"] != "biot"  # the reference code's moduli and its rate of zeta
        if self.published and self.Kf > 0:
            c1 = self.Kf * (1 - self.phi_i) + self.Km * self.phi_i
            self.ev0 = c1 * self.pi / (self.Kf * self.Km)
            self._tabulate_published_zeta()
        for name in ("centre_pressure", "filling_strain", "porosity", "threshold", "cap"):  # asked for repeatedly
            setattr(self, name, functools.lru_cache(maxsize=64)(getattr(self, name)))

    # -- elasticity -----------------------------------------------------------------------------------------
    def drained(self, x, e):
        """Drained tangent bulk modulus [Pa]: B0 + B1 exp(B2/x) - B3 exp(B4/e)."""
        p = self.p
        k = p["B0"]
        if x < 0 and p["B1"] and not (e > 0 and p["Moduli when dilated"] == "B0"):
            k += p["B1"] * math.exp(p["B2"] / x)
        if e < 0 and p["B3"] and (x < 0 or p["Coupling in tension"] == "yes"):
            k -= p["B3"] * math.exp(p["B4"] / e)
        return k

    def shear(self, x, e):
        """Shear modulus [Pa]; with G1, G2 from Poisson's ratio of the drained rock (a fluid carries no shear)."""
        p = self.p
        if not (p["G1"] and p["G2"]):
            return p["G0"]
        nu = p["G1"] + (p["G2"] * math.exp(p["B2"] / x) if x < 0 else 0.0)
        return 1.5 * self.drained(x, e) * (1 - 2 * nu) / (1 + nu)

    def saturate(self, kd, phi):
        """Biot-Gassmann: Kd + alpha^2/(alpha/Km + phi (1/Kf - 1/Km)), alpha = 1 - Kd/Km."""
        alpha = 1 - kd / self.Km
        if alpha == 0:
            return kd
        return kd + alpha * alpha / (alpha / self.Km + phi * (1 / self.Kf - 1 / self.Km))

    def bulk(self, x, e, mu=1.0):
        """Tangent bulk modulus of dx = 3 K (d eps - d e), drained or saturated [Pa]."""
        if self.Kf == 0:
            return self.drained(x, e)
        if self.published:
            return self._published_bulk(e) if e <= self.ev0 else self.drained(x, e)
        kd = self.drained(x, e)
        return self.saturate(kd, self.porosity(e, mu)) if self.engaged(x, e, mu) else kd

    # -- pore fluid -----------------------------------------------------------------------------------------
    def centre_pressure(self, e, mu=1.0):
        """p_c >= 0 from exp(e) = (1-phi_i) exp(-(p_c-p_i)/Km) + mu phi_i exp(-(p_c-p_i)/Kf) [Pa]."""
        if self.Kf == 0:
            return 0.0
        if self.published:
            return -self._published_zeta(e) / 3
        # ln of the sum is convex and falling in q: Newton converges from any start
        q, ls, lf = 0.0, math.log1p(-self.phi_i), math.log(mu * self.phi_i) if mu > 0 else -math.inf
        for _ in range(200):
            a, b = ls - q / self.Km, lf - q / self.Kf
            top = max(a, b)
            ea, eb = math.exp(a - top), math.exp(b - top)
            value = top + math.log(ea + eb) - e
            slope = -(ea / self.Km + eb / self.Kf) / (ea + eb)
            step = value / slope
            q -= step
            if abs(step) <= 1e-15 * (abs(q) + self.Kf):
                break
        return max(0.0, self.pi + q)

    def zeta(self, e, mu=1.0):
        """Backstress: I1 at the elastic centre [Pa]."""
        return -3 * self.centre_pressure(e, mu)

    def filling_strain(self, mu=1.0):
        """e at which the fluid just fills the pores without pressure."""
        return math.log((1 - self.phi_i) * math.exp(self.pi / self.Km) + mu * self.phi_i * math.exp(self.pi / self.Kf))

    def porosity(self, e, mu=1.0):
        """Pore volume / volume at the elastic centre: 1 - (1-phi_i) exp(-(p_c-p_i)/Km - e)."""
        if self.Kf == 0 or self.published:
            return max(0.0, -math.expm1(-self.p3 - e))
        pc = self.centre_pressure(e, mu)
        if pc > 0:
            return mu * self.phi_i * math.exp(-(pc - self.pi) / self.Kf - e)
        return max(0.0, 1 - (1 - self.phi_i) * math.exp(self.pi / self.Km - e))

    def elastic_strain(self, x, e):
        """Drained elastic volume strain from the centre to x: integral of dx/(3 Kd)."""
        return sum(w * 0.5 * x / (3 * self.drained(0.5 * x * (1 + t), e)) for t, w in GAUSS)

    def threshold(self, e, mu=1.0):
        """x below which the fluid carries pressure [Pa].

        Centre under fluid pressure: the actual pressure p_c - B x/3 falls to zero at x = 3 p_c/B > 0.
        Centre without fluid pressure: the gas gap 1 - exp(e0 - e) closes when the pore strain
        eps - x/(3 Km) has used it up (pore volume strain = alpha d eps). Both give 0 at e = e0.
        """
        gap = -math.expm1(self.filling_strain(mu) - e)
        if gap <= 0:
            kd, phi = self.drained(1.0, e), self.porosity(e, mu)
            b = self._skempton(kd, phi)
            return 3 * self.centre_pressure(e, mu) / b if b > 0 else math.inf
        closure = lambda x: self.elastic_strain(x, e) - x / (3 * self.Km) + gap
        low = -3 * gap * self.Km
        while closure(low) > 0:
            low *= 2
            if low < -1e16:
                return -math.inf
        return brentq(closure, low, -1e-300, xtol=1e-6, rtol=1e-13)

    def engaged(self, x, e, mu=1.0):
        """Does the fluid carry pressure at x?"""
        if self.p["Cavitation"] == "centre":
            return self.centre_pressure(e, mu) > 0 or e <= self.filling_strain(mu)
        if x <= 0 and e <= self.filling_strain(mu):
            return True
        return x < self.threshold(e, mu)

    def _skempton(self, kd, phi):
        alpha = 1 - kd / self.Km
        if alpha <= 0:
            return 0.0
        m = 1 / (phi / self.Kf + (alpha - phi) / self.Km)
        return alpha * m / (kd + alpha * alpha * m)

    def pore_pressure(self, x, e, mu=1.0):
        """Actual pressure of the fluid p = p_c + B (P - p_c), P - p_c = -x/3, never negative [Pa]."""
        if self.Kf == 0 or not self.engaged(x, e, mu):
            return 0.0
        b = self._skempton(self.drained(x, e), self.porosity(e, mu))
        pc = self.centre_pressure(e, mu)
        start = self.threshold(e, mu) if pc == 0 and self.p["Cavitation"] == "gap" else 0.0
        return max(0.0, pc - b * (x - start) / 3)

    # -- crush curve ----------------------------------------------------------------------------------------
    def cap_dry(self, e):
        """Crush curve X(e) [Pa]: -inf when no pore is left or there was none."""
        p0, p1, p3 = self.p["p0_crush_curve"], self.p["p1_crush_curve"], self.p3
        if p3 == 0 or e <= -p3:
            return -math.inf
        if e <= 0:
            return p0 + math.log1p(e / p3) / p1
        return p0 * math.exp(math.log1p(e) / (p0 * p1 * p3))

    def cap(self, e, mu=1.0):
        """X from the elastic centre: crush curve, scaled by Ks/Kd at x = X/2 where the fluid works [Pa]."""
        if self.Kf == 0:
            return self.cap_dry(e)
        if self.published:
            dry = self.cap_dry(e)
            if not math.isfinite(dry) or e > self.ev0:
                return dry
            fit = self.drained(1.0, e) + self.p["B1"] * math.exp(2 * self.p["B2"] / dry)  # B1 even when dilated
            return dry * self._published_bulk(e) / fit
        shift = (self.centre_pressure(e, mu) - self.pi) / self.Km if self.p["Cap strain"] == "porosity" else 0.0
        dry = self.cap_dry(e + shift)
        if not math.isfinite(dry):
            return dry
        kd = self.drained(dry / 2, min(e, 0.0))  # dilated rock too: the strength does not jump with its moduli
        ratio = self.saturate(kd, self.porosity(e, mu)) / kd
        if e <= self.filling_strain(mu):
            return dry * ratio
        if self.p["Cavitation"] == "centre":
            return dry
        closed = self.threshold(e, mu)
        return dry if closed <= dry else closed + (dry - closed) * ratio

    def surface(self, e, mu=1.0, coherence=1.0, cap=None):
        """Yield surface at e, seen from the elastic centre."""
        return Surface(self.p, coherence * self.p["PEAKI1"], self.cap(e, mu) if cap is None else cap)

    # -- the reference code's form, for its own numbers -------------------------------------------------------
    def _published_porosity(self, e):
        c1 = self.Kf * (1 - self.phi_i) + self.Km * self.phi_i
        pore = math.exp(e * self.Km / c1) * self.phi_i
        return pore / (math.exp(e * self.Kf / c1) * (1 - self.phi_i) + pore)

    def _published_bulk(self, e):
        """Saturated modulus without the B1 term; 'arenisca3' also subtracts phi/Km twice."""
        kd, phi = self.drained(1.0, e), self._published_porosity(e)
        alpha = 1 - kd / self.Km
        first = alpha - phi if self.p["Undrained moduli"] == "arenisca3" else alpha
        return kd + alpha * alpha / (first / self.Km + phi * (1 / self.Kf - 1 / self.Km))

    def _published_rate(self, e, zeta):
        """d zeta/d e = 3 Kf Km exp(e)/(exp(e)(Kf + Km) - S Km - F Kf); zero beyond ev0.

        S = (1-phi_i) exp(zeta/3Km), F = phi_i exp(p_i/Kf + zeta/3Kf). It is the derivative of exp(e) = S + F,
        which does not hold at the start if p_i > 0.
        """
        grown = math.exp(e)
        solid = (1 - self.phi_i) * math.exp(zeta / (3 * self.Km))
        fluid = self.phi_i * math.exp((3 * self.pi + zeta) / (3 * self.Kf))
        return 3 * self.Kf * self.Km * grown / (grown * (self.Kf + self.Km) - solid * self.Km - fluid * self.Kf)

    def _tabulate_published_zeta(self):
        rate = lambda e, z: [self._published_rate(e, z[0])]
        start, options = [-3 * self.pi], dict(rtol=1e-12, atol=1e-12 * self.Kf, dense_output=True, method="DOP853")
        enough = lambda e, z: z[0] + 3 * self.pi + 20 * self.Kf  # the pores are all but closed
        enough.terminal = True
        self._crush = solve_ivp(rate, (0, -min(2.0, 1.5 * self.p3 + 0.5)), start, events=enough, **options).sol
        self._dilate = solve_ivp(rate, (0, self.ev0), start, **options).sol if self.ev0 > 0 else None

    def _published_zeta(self, e):
        if e <= 0:
            return float(self._crush(max(e, self._crush.t_min))[0])
        return float(self._dilate(min(e, self.ev0))[0]) if self._dilate else 0.0
