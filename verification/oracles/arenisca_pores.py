# SPDX-License-Identifier: BSD-3-Clause
"""Arenisca with fluid in its pores, poroplastic form (docs/method.md 10), around the dry law of arenisca_model.py.

Volumes are over the volume of the virgin rock, so that the fluid needs no history: with J the volume, V that of the grains and mu
the mass of fluid over its initial mass,

    J - V = mu phi_i exp(-(p - p_i)/Kf)   in full pores;   p = 0 and J - V larger than that where there is gas
    d ln V = -(dP'/n + dp)/Km,   n = V/J
    d sigma' = dry law (d eps + dp/(3 Km) I),   sigma = sigma' - p I,   P' = -tr(sigma')/3

The grains are integrated with n at the middle of a substep, the dry law as in arenisca_model.py (backward Euler), the pressure is a
root to round-off: first order in the substep when the stress turns, second under pressure alone. A solid that flows keeps its volume,
so plastic strain appears in sigma' only.
"""
import copy
import dataclasses
import math

import numpy as np
from scipy.optimize import brentq

from oracles.arenisca_laws import complete
from oracles.arenisca_model import UNIT, Arenisca, State, as_six


def gassmann(drained, grains, fluid, porosity):
    """Undrained bulk modulus (Gassmann 1951) [Pa]."""
    biot = 1.0 - drained / grains
    return drained + biot**2 / (porosity / fluid + (1.0 - porosity) / grains - drained / grains**2)


def skempton(drained, grains, fluid, porosity):
    """Rise of the pore pressure over that of the mean pressure, undrained (Skempton 1954)."""
    dry = 1.0 / drained - 1.0 / grains
    return dry / (dry + porosity * (1.0 / fluid - 1.0 / grains))


FORM = "Backstress strain"  # without it a card means this form
FLUID_ONLY = ("fluid_B0", "fluid_pressure_initial", "Matrix bulk modulus", FORM, "Undrained moduli")


@dataclasses.dataclass
class WetState:
    """History of a point; volumes over the virgin volume, stresses in Pa."""

    rock: State  # of the skeleton: its stress is the effective one
    p: float  # pressure of the fluid
    volume: float  # J
    grains: float  # V
    strain: np.ndarray
    mu: float = 1.0  # mass of fluid over its initial mass
    rise: float = 0.0  # of p in the last substep: where the next one looks first

    @property
    def stress(self):
        """Total quasi-static stress."""
        return self.rock.stress - self.p * UNIT

    @property
    def dynamic(self):
        """Total stress, overstress included: what a host sees."""
        return self.rock.dynamic - self.p * UNIT

    @property
    def porosity(self):
        """Volume of pores over the current volume."""
        return 1.0 - self.grains / self.volume

    @property
    def plastic(self):
        """Plastic strain of the skeleton."""
        return self.rock.plastic

    @property
    def evp(self):
        """Volumetric plastic strain."""
        return self.rock.evp

    e = evp  # of which the crush curve is a function

    @property
    def dissipation(self):
        """Integral of sigma' : d eps_p [J/m3]."""
        return self.rock.dissipation

    def copy(self):
        """Independent copy: fields are replaced, never written into."""
        return copy.copy(self)


class WetArenisca:
    """The model. parameters: published names, SI; fluid_B0 and p3_crush_curve > 0."""

    def __init__(self, parameters):
        p = complete({name: value for name, value in parameters.items() if name != FORM})
        self.Kf, self.Km, self.pi = p["fluid_B0"], p["Matrix bulk modulus"], p["fluid_pressure_initial"]
        self.phi_i = -math.expm1(-p["p3_crush_curve"])
        self.dry = Arenisca({name: value for name, value in parameters.items() if name not in FLUID_ONLY})

    def initial(self):
        """Virgin state: stress -p_i I, which is no effective stress."""
        return WetState(self.dry.initial(), self.pi, 1.0, 1.0 - self.phi_i, 0 * UNIT)

    def advance(self, state, strain_increment, dt=0.0, substeps=1, inflow=0.0):
        """New state after a strain increment (3x3 or 6) and an inflow (mass over the initial mass), in equal substeps."""
        step = as_six(strain_increment) / substeps
        for _ in range(substeps):
            state = self._substep(state, step, dt / substeps, inflow / substeps)
        return state

    # -- quantities derived from a state ------------------------------------------------------------------------
    def zeta(self, s):
        """I1 without effective stress [Pa]."""
        return -3.0 * s.p

    def cap(self, s):
        """X of the crush curve, in terms of the effective stress [Pa]."""
        return self.dry.cap(s.rock)

    def pore_pressure(self, s):
        """Pressure of the fluid [Pa]."""
        return s.p

    def porosity(self, s):
        """Volume of pores over the current volume."""
        return s.porosity

    def yield_value(self, s):
        """That of the dry rock under the effective stress [Pa]; <= 0 elastic."""
        return self.dry.yield_value(s.rock)

    def moduli(self, s):
        """Elastic tangent (K, G): Gassmann's bulk modulus in full pores [Pa]."""
        k, g = self.dry.moduli(s.rock)
        return (gassmann(k, self.Km, self.Kf, s.porosity) if s.p > 0.0 else k), g

    # -- update -----------------------------------------------------------------------------------------------
    def fluid(self, s, p):
        """Volume of the fluid at this pressure."""
        return s.mu * self.phi_i * math.exp(-(p - self.pi) / self.Kf)

    def _after(self, s, step, dt, rise):
        """The point after a strain and a rise of the pressure, whether or not grains and fluid then fill the volume."""
        end = s.copy()
        end.rock = self.dry.advance(s.rock, step + rise / (3.0 * self.Km) * UNIT, dt)
        load = -float((end.rock.dynamic - s.rock.dynamic)[:3].sum()) / 3.0
        end.p, end.rise = s.p + rise, rise
        end.volume, end.strain = s.volume * math.exp(float(step[:3].sum())), s.strain + step
        before = s.grains / s.volume
        for _ in range(40):  # n at the middle contains the end: a contraction by P'/Km
            old, n = end.grains, 0.5 * (before + end.grains / end.volume)
            end.grains = s.grains * math.exp(-(load / n + rise) / self.Km)
            if abs(end.grains - old) <= 1e-16 * old:
                break
        return end

    def _substep(self, s, step, dt, inflow):
        s = s.copy()
        s.mu += inflow
        tried = {}

        def excess(rise):
            """Volume that grains and fluid want beyond what there is; falls with the pressure."""
            end = tried[rise] = self._after(s, step, dt, rise)
            return end.grains + self.fluid(s, end.p) - end.volume

        least = -s.p
        if excess(least) <= 0.0:
            return tried[least]
        softness = self.fluid(s, s.p) / self.Kf + s.grains / self.Km
        low, rise, slope = least, max(s.rise, least), -softness
        for _ in range(8):  # secants from above and below; the bracket decides if they wander
            miss = excess(rise)
            if miss > 0.0:
                low = max(low, rise)
            after = rise - miss / slope
            if abs(after - rise) <= 1e-13 * (s.p + abs(rise)) + 1e-7:
                return tried[rise]
            after = max(after, least)
            change = excess(after) - miss
            if change == 0.0 or after == rise:
                return tried[after]
            slope = min(change / (after - rise), -1e-3 * softness)
            rise = after
        far = max(1e6, 4.0 * abs(rise))
        while excess(low + far) > 0.0:
            far *= 2.0
        return self._after(s, step, dt, brentq(excess, low, low + far, xtol=1e-7, rtol=8.9e-16))


def model(parameters):
    """The form that a card means: poroplastic where fluid is given and no published form is named."""
    wet = parameters.get("fluid_B0", 0.0) > 0.0 and parameters.get("p3_crush_curve", 0.0) > 0.0
    return WetArenisca(parameters) if wet and FORM not in parameters else Arenisca(parameters)
