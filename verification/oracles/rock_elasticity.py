# SPDX-License-Identifier: BSD-3-Clause
"""Moduli and strength of Arenisca without a third invariant, and the work of its elastic cycles, written anew from docs/method.md (17 and
21); it shares nothing with the library. Pressures p are positive in compression, and effective ones in wet rock; q = sqrt(J2)."""
import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


def rule(parts):
    """Places and weights of Gauss and Legendre with eight points in each part of [0, 1] (parts, 8); parts are short near 0."""
    edges = np.linspace(0.0, 1.0, parts + 1) ** 3
    half = 0.5 * np.diff(edges)[:, None]
    return 0.5 * (edges[:-1] + edges[1:])[:, None] + half * NODES, half * WEIGHTS


FINE = tuple(of.ravel() for of in rule(60))
ONE = tuple(of.ravel() for of in rule(1))


def integral(function, start, end):
    """Of an array function over a short [start, end]."""
    at, weights = ONE
    return float((end - start) * (weights * function(start + (end - start) * at)).sum())


class RockElasticity:
    """@param card  numbers of a card in SI   @param constant  dilated rock whose moduli pressure does not change"""

    def __init__(self, card, constant=False):
        self.card, self.constant = card, constant

    def get(self, name):
        return self.card.get(name, 0.0)

    def grain_share(self, p):
        """exp(B2/I1): how far the grains bear the pressure."""
        if self.constant:
            return np.zeros_like(np.asarray(p, float))
        return np.exp(-self.get("B2") / (3.0 * np.maximum(p, 1.0))) * (np.asarray(p) > 0.0)

    def shear(self, p):
        share = self.grain_share(p)
        if self.get("G1") == 0.0 or self.get("G2") == 0.0:
            return self.get("G0") + 0.0 * share
        ratio = self.get("G1") + self.get("G2") * share
        return 1.5 * (self.get("B0") + self.get("B1") * share) * (1.0 - 2.0 * ratio) / (1.0 + ratio)

    def bulk(self, p):
        share, p = self.grain_share(p), np.asarray(p, float)
        grains = self.get("B0") + (self.get("B1") + self.get("Grain stiffening") * np.maximum(p, 0.0)) * share
        start, end = self.get("Transition start"), self.get("Transition end")
        if end == 0.0 or self.constant:
            return grains
        way = np.clip((p - start) / (end - start), 0.0, 1.0)
        return 1.0 / (1.0 / grains + 6.0 * self.get("Transition strain") * way * (1.0 - way) / (end - start))

    def strength(self, p):
        """Limit of q without a cap, of cold and whole rock."""
        y = self.get("PEAKI1") + 3.0 * np.asarray(p, float)
        slope, own = self.get("YSLOPE"), self.get("STREN") - self.get("YSLOPE") * self.get("PEAKI1")
        rise = slope * y
        if self.get("Strength limit") > 0.0:
            rise = rise / (1.0 + rise / (self.get("Strength limit") - own))
        return own * (1.0 - np.exp(-(self.get("FSLOPE") - slope) * y / own)) + rise

    def volume(self, p):
        """Volume at a pressure over that at none, of elastic compression: exp of minus the integral of dp/K."""
        at, weights = FINE
        p = np.asarray(p, float)
        return np.exp(-p * (weights / self.bulk(p[..., None] * at)).sum(axis=-1))

    def compliance(self, p):
        """J/G over J at no pressure: what a unit of q^2/2 stores."""
        return self.volume(p) / self.shear(p)

    def stored(self, p, q):
        """What the release of q and then of p gives back, per volume at no pressure."""
        at, weights = FINE
        at = p * at
        return float((p * weights * self.volume(at) * at / self.bulk(at)).sum() + 0.5 * q**2 * self.compliance(p))

    def rectangle(self, p, q):
        """Work that a cycle takes up which loads q at p[0] and unloads it at p[1], per volume at no pressure; negative: creates."""
        return 0.5 * (q[1] ** 2 - q[0] ** 2) * (self.compliance(p[0]) - self.compliance(p[1]))

    def polygon(self, corners):
        """The same of a closed path of straight lines between corners (p, q): the integral of J/G q dq."""
        total = 0.0
        for (p0, q0), (p1, q1) in zip(corners, [*corners[1:], corners[0]]):
            if q0 != q1:
                total += integral(lambda s: self.compliance(p0 + s * (p1 - p0)) * (q0 + s * (q1 - q0)) * (q1 - q0), 0.0, 1.0)
        return total

    def falls(self, most):
        """By how much J/G falls between pressures up to `most`; and q^2/2 of the strength there."""
        points = np.concatenate([[0.0], np.geomspace(1e-5, 1.0, 2001)]) * most
        return -np.diff(self.compliance(points)), 0.5 * self.strength(0.5 * (points[1:] + points[:-1])) ** 2

    def bound(self, most):
        """The most that one cycle can create below the strength and the pressure `most`, per volume at no pressure; where J/G falls."""
        falls, squares = self.falls(most)
        return float((squares * falls).sum())
