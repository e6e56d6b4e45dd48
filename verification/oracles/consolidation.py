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
        """Displacement of a plate towards the middle, times 2 G (plate width 2, height 2b) over (F b)."""
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
    assert abs(BEREA.uniaxial_loading - 0.3507795100) < 1e-9
    assert abs(BEREA.uniaxial_storage - 1.38580246914e-10) < 1e-20
    assert abs(BEREA.skempton - 0.5511811024) < 1e-9
    # Undrained at first, and what both halves of the plates' pressure must come to.
    mandel, cryer = Mandel(BEREA), Cryer(BEREA)
    assert abs(mandel.pressure(0.0, 1e-3) - mandel.factor / 2.0) < 2e-3
    assert abs(cryer.centre(2e-4) - BEREA.skempton) < 2e-2


if __name__ == "__main__":
    self_check()
    print("consistent")
