# SPDX-License-Identifier: BSD-3-Clause
"""Arenisca with fluid in its pores, in the poroplastic form (docs/method.md 10): the dry law of arenisca_model.py for the
effective stress and the strain of the skeleton, around it one equation for the pressure.

Every substep finds the rise dp of the pressure by a bracketed root: with it the skeleton is strained by
de + dp/(3 Km) I, and grains and fluid must fill the volume. First order in the substep, like the dry law.
"""
import dataclasses
import math

import numpy as np
from scipy.optimize import brentq

from arenisca_laws import complete
from arenisca_model import UNIT, Arenisca, as_six

OF_THE_FLUID = ("fluid_B0", "fluid_pressure_initial", "Matrix bulk modulus", "Backstress strain", "Undrained moduli")


@dataclasses.dataclass
class PoreState:
    """History of a point: the dry rock's, whose stress is the effective one, and what fills the volume."""

    rock: object  # State of the dry law
    pressure: float  # of the fluid [Pa]
    solid: float  # volume of grains over volume
    fluid: float  # volume of fluid over volume; less than the pores where there is gas
    strain: np.ndarray

    @property
    def stress(self):
        """Total stress [Pa]."""
        return self.rock.stress - self.pressure * UNIT

    @property
    def dynamic(self):
        return self.stress


class WetArenisca:
    """The model. parameters: published names, SI; fluid_B0 > 0."""

    def __init__(self, parameters):
        whole = complete({name: value for name, value in parameters.items() if name != "Backstress strain"})
        self.Kf, self.Km, self.pi = whole["fluid_B0"], whole["Matrix bulk modulus"], whole["fluid_pressure_initial"]
        self.porosity = -math.expm1(-whole["p3_crush_curve"])
        self.dry = Arenisca({name: value for name, value in parameters.items() if name not in OF_THE_FLUID})

    def initial(self):
        """Virgin state: stress -p_i I, which is no effective stress."""
        return PoreState(self.dry.initial(), self.pi, 1.0 - self.porosity, self.porosity, 0 * UNIT)

    def advance(self, state, strain_increment, dt=0.0, substeps=1):
        """New state after a strain increment (3x3 or 6) without flow of the fluid, in equal substeps."""
        step = as_six(strain_increment) / substeps
        for _ in range(substeps):
            state = self._substep(state, step, dt / substeps)
        return state

    def _substep(self, s, step, dt):
        volume = math.exp(float(step[:3].sum()))

        def end(dp):
            """The skeleton after its strain, and what grains and fluid then fill of the old volume."""
            rock = self.dry.advance(s.rock, step + dp / (3 * self.Km) * UNIT, dt)
            rise = -float((rock.stress - s.rock.stress)[:3].sum()) / 3
            return rock, s.solid * math.exp(-(rise / s.solid + dp) / self.Km), s.fluid * math.exp(-dp / self.Kf)

        def excess(dp):
            _, solid, fluid = end(dp)
            return solid + fluid - volume

        dp = -s.pressure
        if excess(dp) > 0:
            reach = max(1e3, self.Kf * abs(math.log(volume)))
            while excess(dp + reach) > 0:
                reach *= 2
            dp = brentq(excess, dp, dp + reach, xtol=1.0, rtol=8.9e-16)  # [Pa]
        rock, solid, fluid = end(dp)
        return PoreState(rock, s.pressure + dp, solid / volume, fluid / volume, s.strain + step)


def moduli_of_biot(model, state):
    """Undrained bulk modulus and Skempton's B of a state, by Gassmann and Biot, from the drained modulus."""
    drained = model.dry.moduli(state.rock)[0]
    porosity = 1.0 - state.solid
    biot = 1.0 - drained / model.Km
    storage = (biot - porosity) / model.Km + porosity / model.Kf
    undrained = drained + biot**2 / storage
    return undrained, biot / storage / undrained
