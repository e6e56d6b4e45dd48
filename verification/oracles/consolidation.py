# SPDX-License-Identifier: BSD-3-Clause
"""Exact pore pressures of poroelastic bodies that drain. Lengths over the drainage path, times T = c t / path^2, pressures over that
of the load. Tension positive elsewhere in this project; pressures here are positive in compression.

Sources: K. Terzaghi, Erdbaumechanik (1925); E. Detournay, A. H.-D. Cheng, Fundamentals of poroelasticity (1993).
"""
import dataclasses

import numpy as np
from scipy.optimize import brentq
from scipy.special import erfc


@dataclasses.dataclass
class Rock:
    """Linear poroelastic rock: moduli [Pa] of the drained rock, of grains and fluid; mobility k / viscosity [m2/(Pa s)]."""

    bulk: float
    shear: float
    grains: float
    fluid: float
    porosity: float
    mobility: float = 1.0

    @property
    def biot(self):
        return 1.0 - self.bulk / self.grains

    @property
    def storage(self):
        """1/M, at fixed strain."""
        return self.porosity / self.fluid + (self.biot - self.porosity) / self.grains

    @property
    def undrained_bulk(self):
        return self.bulk + self.biot**2 / self.storage

    @property
    def skempton(self):
        return self.biot / (self.storage * self.undrained_bulk)

    @property
    def uniaxial_storage(self):
        """At fixed stress along one axis and no strain across."""
        return self.storage + self.biot**2 / self.confined

    @property
    def diffusivity(self):
        return self.mobility / self.uniaxial_storage

    @property
    def confined(self):
        """Stress over strain along one axis, drained, no strain across."""
        return self.bulk + 4.0 / 3.0 * self.shear

    @property
    def undrained_confined(self):
        return self.undrained_bulk + 4.0 / 3.0 * self.shear

    @property
    def uniaxial_loading(self):
        """Undrained pore pressure over a stress along one axis, no strain across."""
        return self.biot / (self.storage * self.undrained_confined)


BEREA = Rock(8e9, 6e9, 36e9, 2.25e9, 0.19)


def terzaghi(depth, T, terms=2000):
    """p over that just after the load, `depth` below the open end over the height: sum 2/m sin(m z) exp(-m^2 T), m = (k + 1/2) pi."""
    m = (np.arange(terms) + 0.5) * np.pi
    return np.sum(2.0 / m * np.sin(np.multiply.outer(depth, m)) * np.exp(-(m**2) * T), axis=-1)


def terzaghi_ramped(depth, T, ramp, terms=2000):
    """The same for a load that rises linearly until T = ramp: mean of the response over its parts."""
    m = (np.arange(terms) + 0.5) * np.pi
    on = min(T, ramp)
    decay = np.exp(-(m**2) * (T - on)) * -np.expm1(-(m**2) * on) / m**2 / ramp
    return np.sum(2.0 / m * np.sin(np.multiply.outer(depth, m)) * decay, axis=-1)


def terzaghi_settled(T, ramp, terms=2000):
    """Degree of consolidation, the mean over the height of load(T) - p, under a load that rises to 1 until T = ramp."""
    m = (np.arange(terms) + 0.5) * np.pi
    on = min(T, ramp)
    return on / ramp + np.sum(2.0 / m**4 * np.exp(-(m**2) * (T - on)) * np.expm1(-(m**2) * on)) / ramp


def terzaghi_by_images(depth, T, images=8):
    """The same as terzaghi(), summed over mirror images: few terms for small T."""
    k = np.arange(images)
    near, far = np.add.outer(depth, 2.0 * k), np.add.outer(-np.asarray(depth), 2.0 * k + 2.0)
    return 1.0 - np.sum((-1.0) ** k * (erfc(near / (2.0 * np.sqrt(T))) + erfc(far / (2.0 * np.sqrt(T)))), axis=-1)


class Layers:
    """Column of height 1 whose two layers differ in diffusivity alone, open at the top, sealed at the bottom.

    Modes sin(w z / sqrt(c1)) above `split`, A cos(w (1 - z) / sqrt(c2)) below; pressure and flow go through for
    s1 cos(u) cos(v) = s2 sin(u) sin(v), s = sqrt(c), u = w split / s1, v = w (1 - split) / s2: one root for each pi of u + v.
    """

    def __init__(self, split, top, bottom, terms=2000):
        self.split, self.s1, self.s2 = split, top**0.5, bottom**0.5
        self.way = split / self.s1 + (1.0 - split) / self.s2
        ends = np.arange(terms + 1) * np.pi / self.way
        self.w = np.array([brentq(self._equation, a, b, xtol=1e-13) for a, b in zip(ends, ends[1:])])
        u, v = self._angles(self.w)
        # A from pressure or from flow, whichever is not 0 over 0.
        flow = np.abs(np.sin(v)) > np.abs(np.cos(v))
        self.amplitude = np.where(flow, self.s1 * np.cos(u), np.sin(u)) / np.where(flow, self.s2 * np.sin(v), np.cos(v))
        self.area = self.s1 * (1.0 - np.cos(u)) / self.w + self.amplitude * self.s2 * np.sin(v) / self.w
        square = 0.5 * split - self.s1 * np.sin(2.0 * u) / (4.0 * self.w)
        square += self.amplitude**2 * (0.5 * (1.0 - split) + self.s2 * np.sin(2.0 * v) / (4.0 * self.w))
        self.weight = self.area / square

    def _angles(self, w):
        return w * self.split / self.s1, w * (1.0 - self.split) / self.s2

    def _equation(self, w):
        u, v = self._angles(w)
        return self.s1 * np.cos(u) * np.cos(v) - self.s2 * np.sin(u) * np.sin(v)

    def _decay(self, t, ramp):
        """Of each mode, under a load that rises to 1 until t = ramp."""
        on = min(t, ramp)
        return np.exp(-(self.w**2) * (t - on)) * -np.expm1(-(self.w**2) * on) / self.w**2 / ramp

    def pressure(self, depth, t, ramp):
        z = np.asarray(depth)[..., None]
        shape = np.where(z < self.split, np.sin(self.w * z / self.s1), self.amplitude * np.cos(self.w * (1.0 - z) / self.s2))
        return shape @ (self.weight * self._decay(t, ramp))

    def mean(self, t, ramp):
        return float(np.sum(self.area * self.weight * self._decay(t, ramp)))


def layers_by_differences(split, top, bottom, t, cells=400, steps=400):
    """Pressures in the middle of cells at t after a sudden load: finite volumes, two-stage stiffly accurate Runge-Kutta (SDIRK2)."""
    z = (np.arange(cells) + 0.5) / cells
    resistance = 0.5 / cells / np.where(z < split, top, bottom)
    between = 1.0 / (resistance[1:] + resistance[:-1])
    main = np.zeros(cells)
    main[0] = 1.0 / resistance[0]
    main[:-1] += between
    main[1:] += between
    matrix = -cells * (np.diag(main) - np.diag(between, 1) - np.diag(between, -1))
    g, dt = 1.0 - 0.5**0.5, t / steps
    inverse = np.linalg.inv(np.eye(cells) - g * dt * matrix)
    p = np.ones(cells)
    for _ in range(steps):
        first = matrix @ (inverse @ p)
        p = p + dt * ((1.0 - g) * first + g * matrix @ (inverse @ (p + (1.0 - g) * dt * first)))
    return z, p


class Mandel:
    """Pore pressure between two rigid plates pressed together by F per width on each half, -1 < x < 1, drained at x = +-1, over F."""

    def __init__(self, rock, terms=60):
        nu = (3 * rock.bulk - 2 * rock.shear) / (6 * rock.bulk + 2 * rock.shear)
        ku = rock.undrained_bulk
        nu_u = (3 * ku - 2 * rock.shear) / (6 * ku + 2 * rock.shear)
        slope = (1 - nu) / (nu_u - nu)
        self.roots = np.array(
            [brentq(lambda a: np.sin(a) - slope * a * np.cos(a), n * np.pi + 1e-9, (n + 0.5) * np.pi) for n in range(terms)]
        )
        self.factor = 2.0 * rock.skempton * (1.0 + nu_u) / 3.0
        self.nu, self.nu_u = nu, nu_u

    def pressure(self, x, T):
        a = self.roots
        weight = np.sin(a) / (a - np.sin(a) * np.cos(a)) * np.exp(-(a**2) * T)
        return self.factor * np.sum(weight * (np.cos(np.multiply.outer(x, a)) - np.cos(a)), axis=-1)

    def settlement(self, T):
        """Displacement of a plate towards the middle, times 2 G (plate width 2, height 2b) over (F b); 0 before the load."""
        if T <= 0.0:
            return 0.0
        a = self.roots
        sum_ = np.sum(np.sin(a) * np.cos(a) / (a - np.sin(a) * np.cos(a)) * np.exp(-(a**2) * T))
        return (1 - self.nu) - 2.0 * (1 - self.nu_u) * sum_


class Cryer:
    """Pore pressure at the centre of a ball under a pressure on its drained surface, over that pressure; T = c t / R^2."""

    def __init__(self, rock, terms=200):
        self.storage, self.biot, self.bulk = rock.uniaxial_storage, rock.biot, rock.bulk
        self.gamma = 4.0 * rock.shear * rock.biot**2 / (3.0 * rock.bulk * (rock.bulk + 4.0 / 3.0 * rock.shear) * rock.uniaxial_storage)
        g = self.gamma

        def equation(y):
            return (3 * g - (1 + g) * y * y) * np.sin(y) - 3 * g * y * np.cos(y)

        self.roots = np.array([brentq(equation, n * np.pi + 1e-6, (n + 1) * np.pi - 1e-6) for n in range(terms)])

    def centre(self, T):
        y, g = self.roots, self.gamma
        # of Q(y) = 1 + g (1 + 3 (y cot y - 1) / y^2), which the roots make zero
        slope = 3 * g * ((1.0 / np.tan(y) - y / np.sin(y) ** 2) / y**2 - 2.0 * (y / np.tan(y) - 1.0) / y**3)
        factor = 2.0 * self.biot / (self.storage * self.bulk)
        return float(np.sum(factor * (1.0 - y / np.sin(y)) / (slope * y) * np.exp(-(y**2) * T)))


def self_check():
    for T in (0.01, 0.1, 0.5):
        assert abs(terzaghi(0.25, T) - terzaghi_by_images(0.25, T)) < 1e-12
    assert abs(terzaghi_ramped(0.5, 0.2, 1e-6) - terzaghi(0.5, 0.2)) < 1e-5
    heights = (np.arange(2000) + 0.5) / 2000
    for T in (0.005, 0.05, 0.5):
        mean = np.mean(terzaghi_ramped(heights, T, 0.01))
        assert abs(min(T, 0.01) / 0.01 - mean - terzaghi_settled(T, 0.01)) < 1e-5
    alike = Layers(0.3, 1.0, 1.0)
    assert np.max(np.abs(alike.pressure(heights, 0.1, 0.01) - terzaghi_ramped(heights, 0.1, 0.01))) < 1e-9
    for top, bottom in ((1.0, 10.0), (10.0, 1.0)):
        z, p = layers_by_differences(0.6, top, bottom, 0.1)
        layers = Layers(0.6, top, bottom)
        assert np.max(np.abs(layers.pressure(z, 0.1, 1e-9) - p)) < 1e-5
        assert abs(layers.mean(0.1, 1e-9) - np.mean(p)) < 1e-5
    assert abs(BEREA.uniaxial_loading - 0.3507795100) < 1e-9
    assert abs(BEREA.uniaxial_storage - 1.38580246914e-10) < 1e-20
    assert abs(BEREA.skempton - 0.5511811024) < 1e-9
    for fluid in (1e7, 1e9, 36e9, 1e12):
        rock = dataclasses.replace(BEREA, fluid=fluid)
        pores, solid = 1.0 / rock.bulk - 1.0 / rock.grains, 1.0 / fluid - 1.0 / rock.grains
        assert abs(rock.skempton - pores / (pores + rock.porosity * solid)) < 1e-12
    # Undrained at first, and what both halves of the plates' pressure must come to.
    mandel, cryer = Mandel(BEREA), Cryer(BEREA)
    assert abs(mandel.pressure(0.0, 1e-3) - mandel.factor / 2.0) < 2e-3
    assert abs(mandel.settlement(1e-8) - (1 - mandel.nu_u)) < 1e-2 and abs(mandel.settlement(9.0) - (1 - mandel.nu)) < 1e-9
    assert abs(cryer.centre(2e-4) - BEREA.skempton) < 2e-2


if __name__ == "__main__":
    self_check()
    print("consistent")
