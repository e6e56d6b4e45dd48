# SPDX-License-Identifier: BSD-3-Clause
"""The published limit surface of Arenisca from the parameters of a card (docs/materials/arenisca.md, Strength): sqrt(J2) against pressure.
tests/decks/test_report_surface.py compares it with the material's own. Of rock that has another, a report says so and draws none."""

import copy

import numpy as np

from barreno.report.run_tables import PUBLISHED_SURFACE


def lode_shape(kind, psi):
    """Gamma of a Lode angle in degrees, 0 in triaxial compression and 60 in extension.

    @param kind  J3_type  @param psi  J3_psi
    """
    if kind not in ("Gudehus", "Willam-Warnke", "Mohr-Coulomb"):
        return np.ones_like
    if kind == "Gudehus":
        return lambda lode: 2.0 / ((1.0 + np.cos(np.radians(3.0 * lode))) + (1.0 - np.cos(np.radians(3.0 * lode))) / psi)
    theta = lambda lode: np.radians(60.0 - lode)  # noqa: E731  the angle of the published formulas
    if kind == "Mohr-Coulomb":
        return lambda lode: 1.0 / (np.cos(theta(lode)) / psi + (2.0 - 1.0 / psi) * np.sin(theta(lode)) / np.sqrt(3.0))
    k, n = 1.0 - psi**2, 2.0 * psi - 1.0

    def willam_warnke(lode):
        cosine = np.cos(theta(lode))
        root = np.sqrt(np.maximum(4.0 * k * cosine**2 + psi * (5.0 * psi - 4.0), 0.0))
        if psi > 1.0:  # the same rationalised: the other form is 0/0 within the range
            return (k - n * n) / (2.0 * k * cosine - n * root)
        return (2.0 * k * cosine + n * root) / (4.0 * k * cosine**2 + n * n)

    return willam_warnke


class Strength:
    """Meridian of triaxial compression at a particle's mean strength; for rock with a fluid of the effective stress."""

    def __init__(self, number, shape=np.ones_like):
        """@param number  a function that gives a parameter by its published name, nan where it is missing
        @param shape   of lode_shape
        """
        self.shape = shape
        self.peak, self.FSLOPE, self.STREN, self.YSLOPE = (number(name) for name in ("PEAKI1", "FSLOPE", "STREN", "YSLOPE"))
        most = number("Strength limit")
        self.most = most if most > 0.0 else np.inf
        residual = number("Residual slope")
        self.residual = residual if residual > 0.0 else self.FSLOPE
        self.CR, self.p0, self.p1, self.p3 = (number(name) for name in ("CR", "p0_crush_curve", "p1_crush_curve", "p3_crush_curve"))
        if not np.isfinite([self.peak, self.FSLOPE, self.STREN, self.YSLOPE]).all():
            raise ValueError("the card lacks a parameter of strength")

    @property
    def vertex(self):
        """Largest I1; von Mises' surface has none."""
        return np.inf if self.FSLOPE == 0.0 and self.STREN > 0.0 else self.peak

    @property
    def angled(self):
        """Whether triaxial extension has a strength of its own."""
        return abs(float(self.shape(60.0)) - 1.0) > 1e-9

    def limit(self, x):
        """Ff(I1) without the cap."""
        if self.STREN == 0.0:
            return self.bent(self.FSLOPE * (self.peak - x), self.most)
        if self.FSLOPE == 0.0:
            return np.full_like(x, self.STREN)
        room = self.STREN - self.YSLOPE * self.peak
        saturating = -room * np.expm1((self.FSLOPE - self.YSLOPE) / room * (x - self.peak))
        return saturating + self.bent(self.YSLOPE * (self.peak - x), self.most - room)

    @staticmethod
    def bent(growing, room):
        """A strength that grows without end, and what is left of it below a limit: Lundborg's hyperbola. No limit: infinity."""
        return growing / (1.0 + growing / room)

    def hydrostatic_strength(self, e):
        """X of the crush curve at a volumetric plastic strain; -inf of rock whose pores are closed or that has none."""
        if not self.p3 > 0.0 or 1.0 + e / self.p3 <= 0.0:
            return -np.inf
        return self.p0 + np.log1p(e / self.p3) / self.p1 if e <= 0.0 else self.p0 * (1.0 + e) ** (1.0 / (self.p0 * self.p1 * self.p3))

    def scaled(self, coherence, damage=0.0):
        """Of a particle whose vertex is so many times PEAKI1 before damage (docs/method.md 18)."""
        other = copy.copy(self)
        other.peak = (1.0 - damage) * coherence * self.peak
        other.FSLOPE = self.FSLOPE - damage * (self.FSLOPE - self.residual)
        return other

    def shear_at(self, p, e):
        """sqrt(J2) in triaxial compression at a pressure and a volumetric plastic strain; 0 beyond vertex and cap."""
        x = -3.0 * np.asarray(p, float)
        X = self.hydrostatic_strength(e)
        cap = np.ones_like(x)
        if np.isfinite(X):
            kappa = self.peak - self.CR * (self.peak - X)
            cap = np.where(x < kappa, 1.0 - ((kappa - x) / (kappa - X)) ** 2, 1.0)
        return np.where(x <= self.vertex, np.maximum(self.limit(x), 0.0) * np.sqrt(np.maximum(cap, 0.0)), 0.0)

    def curve(self, e, most, points=400):
        """(p, q) of the surface at a volumetric plastic strain, up to a pressure."""
        p = -np.linspace(self.peak, max(self.hydrostatic_strength(e), -3.0 * most), points) / 3.0
        return p, self.shear_at(p, e)


def is_off(text):
    """Whether a value of a card asks for nothing: a part beside the published ones is off at 0."""
    try:
        return float(text) == 0.0
    except ValueError:
        return text in ("", "none")


def other_entries(deck, material):
    """Entries of a material by which it may have another surface than the published one."""
    return [name for name, value in deck.parameters("Materials", material).items() if name not in PUBLISHED_SURFACE and not is_off(value)]


def surface_of(deck, material):
    """(Strength or None, why there is none) of a material of the deck."""
    model = deck.text(f"Materials/{material}/Model")
    if not model.startswith("Arenisca"):
        return None, f"a report knows no surface of its model ({model or 'unknown'})"
    others = other_entries(deck, material)
    if others:
        return None, f"its card has {' and '.join(others)}, and a report knows the published shear limit and crush curve alone"
    published = deck.text(f"Materials/{material}/Backstress strain", "poroplastic") != "poroplastic"
    if published and deck.number(f"Materials/{material}/fluid_B0", 0.0) > 0.0:
        return None, (
            "its form of the pore fluid (Backstress strain) moves the surface by a part of the pore pressure that particles.e does not have"
        )
    try:
        shape = lode_shape(deck.text(f"Materials/{material}/J3_type"), deck.number(f"Materials/{material}/J3_psi", 1.0))
        return Strength(lambda name: deck.number(f"Materials/{material}/{name}"), shape), ""
    except ValueError:
        return None, "deck.xml lacks a parameter of its strength"


def strength_of(deck, material):
    """Of a material of the deck; None where a report draws no surface."""
    return surface_of(deck, material)[0]
