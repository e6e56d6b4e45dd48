# SPDX-License-Identifier: BSD-3-Clause
"""The limit surface of Arenisca from the parameters of a card (docs/materials/arenisca.md, Strength): sqrt(J2) against pressure."""

import numpy as np


class Strength:
    """Meridian of triaxial compression at a particle's mean strength; for rock with a fluid of the effective stress."""

    def __init__(self, number):
        """@param number  a function that gives a parameter by its published name, nan where it is missing"""
        self.peak, self.FSLOPE, self.STREN, self.YSLOPE = (number(name) for name in ("PEAKI1", "FSLOPE", "STREN", "YSLOPE"))
        self.CR, self.p0, self.p1, self.p3 = (number(name) for name in ("CR", "p0_crush_curve", "p1_crush_curve", "p3_crush_curve"))
        if not np.isfinite([self.peak, self.FSLOPE, self.STREN, self.YSLOPE]).all():
            raise ValueError("the card lacks a parameter of strength")

    def limit(self, x):
        """Ff(I1) without the cap."""
        if self.STREN == 0.0:
            return self.FSLOPE * (self.peak - x)
        if self.FSLOPE == 0.0:
            return np.full_like(x, self.STREN)
        room = self.STREN - self.YSLOPE * self.peak
        return self.STREN - room * np.exp((self.FSLOPE - self.YSLOPE) / room * (x - self.peak)) - self.YSLOPE * x

    def hydrostatic_strength(self, e):
        """X of the crush curve at a volumetric plastic strain; -inf of rock whose pores are closed or that has none."""
        if not self.p3 > 0.0 or 1.0 + e / self.p3 <= 0.0:
            return -np.inf
        return self.p0 + np.log1p(e / self.p3) / self.p1 if e <= 0.0 else self.p0 * (1.0 + e) ** (1.0 / (self.p0 * self.p1 * self.p3))

    def curve(self, e, most, points=400):
        """(p, q) of the surface at a volumetric plastic strain, up to a pressure."""
        X = self.hydrostatic_strength(e)
        x = np.linspace(self.peak, max(X, -3.0 * most), points)
        cap = np.ones_like(x)
        if np.isfinite(X):
            kappa = self.peak - self.CR * (self.peak - X)
            cap = np.where(x < kappa, 1.0 - ((kappa - x) / (kappa - X)) ** 2, 1.0)
        return -x / 3.0, np.maximum(self.limit(x), 0.0) * np.sqrt(np.maximum(cap, 0.0))


def strength_of(deck, material):
    """Of a material of the deck; None where it is no Arenisca, or its card lacks a parameter."""
    if not deck.text(f"Materials/{material}/Model").startswith("Arenisca"):
        return None
    try:
        return Strength(lambda name: deck.number(f"Materials/{material}/{name}"))
    except ValueError:
        return None
