# SPDX-License-Identifier: BSD-3-Clause
"""Limits of the wet oracle (arenisca_pores.py): no fluid, elastic poroelasticity, drainage, initial pressure, gas."""
import math

import numpy as np

from oracles.arenisca_model import UNIT
from oracles.arenisca_paths import strain_path
from oracles.arenisca_pores import WetArenisca, gassmann, model, skempton

ROCK = {"PEAKI1": 21e6, "FSLOPE": 0.435, "STREN": 4e8, "YSLOPE": 0.02, "B0": 8e9, "B1": 28e9, "B2": 4e8, "G0": 8e9,
        "p0_crush_curve": -6e8, "p1_crush_curve": 1.5e-9, "p3_crush_curve": 0.22, "CR": 0.5}  # fmt: skip
WET = {**ROCK, "fluid_B0": 2.2e9, "Matrix bulk modulus": 40e9, "fluid_pressure_initial": 2e7}
PATH = [((-0.03, -0.02, -0.02), 1.0), ((-0.05, -0.02, -0.01), 2.0)]


def no_fluid():
    """Kf = 0 is the dry law; Kf -> 0 tends to it at first order."""
    end = lambda kf: strain_path(model({**ROCK, "fluid_B0": kf}), PATH, 40)[-1].stress
    dry = end(0.0)
    off = [np.abs(end(kf) - dry).max() / np.abs(dry).max() for kf in (1e3, 1e4, 1e5)]
    yield "wet: Kf = 1 kPa: off the dry rock", off[0], 1e-5
    yield "wet: Kf -> 0 first order: |ratio - 10|", max(abs(off[1] / off[0] - 10), abs(off[2] / off[1] - 10)), 0.1


def elastic():
    """Gassmann's modulus and Skempton's B by differences, and Kf = Km."""
    for kf in (1e8, 2.2e9, 2e10, 40e9):
        rock = WetArenisca({**WET, "fluid_B0": kf})
        s = rock.advance(rock.initial(), -1e-3 * UNIT, 0.0, 20)
        step = 1e-7
        more, less = rock.advance(s, -step / 3 * UNIT), rock.advance(s, step / 3 * UNIT)
        pressure = -float((more.stress - less.stress)[:3].sum()) / 3
        k = rock.dry.moduli(s.rock)[0]
        exact = gassmann(k, 40e9, kf, s.porosity)
        yield f"wet: Gassmann's modulus, Kf = {kf:g}", abs(pressure / (2 * step) / exact - 1), 1e-6
        b = skempton(k, 40e9, kf, s.porosity)
        yield f"wet: Skempton's B, Kf = {kf:g}", abs((more.p - less.p) / pressure / b - 1), 1e-6
        if kf == 40e9:
            yield "wet: Kf = Km: K = Km, B = 1", max(abs(exact / 40e9 - 1), abs(b - 1)), 1e-14


def drainage():
    """Fluid taken out at fixed strain until there is no pressure, and volumes and mass on the way."""
    rock = WetArenisca({**WET, "fluid_pressure_initial": 0.0})
    s = strain_path(rock, [((-0.02, -0.02, -0.02), 1.0)], 100)[-1]
    yield "wet: grains and fluid fill the volume", abs((s.grains + rock.fluid(s, s.p)) / s.volume - 1), 1e-12
    out = (s.volume - s.grains) / rock.phi_i - s.mu
    empty = rock.advance(s, 0 * UNIT, 0.0, 100, 1.5 * min(out, -0.01))
    yield "wet: drained: pressure [Pa]", empty.p, 0.0
    dry = rock.dry.advance(rock.dry.initial(), np.full(3, -0.02).tolist() + [0.0] * 3, 0.0, 100)
    yield "wet: drained rock is crushed as dry rock", abs(empty.evp - dry.evp) / 0.06, 1e-5
    yield "wet: and has its stress", float(np.abs(empty.stress - dry.stress).max() / np.abs(dry.stress).max()), 1e-4


def initial_pressure():
    """Incompressible grains: the strain of a rock decides its effective stress, whatever the pressure to begin with."""
    grains = {**WET, "Matrix bulk modulus": 1e18, "fluid_B0": 2.2e9}
    ends = [strain_path(WetArenisca({**grains, "fluid_pressure_initial": p}), PATH, 20)[-1] for p in (0.0, 9e7)]
    off = np.abs(ends[1].rock.stress - ends[0].rock.stress).max() / np.abs(ends[0].rock.stress).max()
    yield "wet: effective stress at p_i = 90 MPa, of that at 0", float(off), 1e-8
    rise = [s.p / p - 1 for s, p in ((ends[1], 9e7 + ends[0].p),)][0]
    yield "wet: the pressure is higher by p_i", abs(rise), 1e-8


def gas():
    """No tension in the fluid; the pores fill again where they ran out."""
    rock = WetArenisca({**WET, "fluid_pressure_initial": 1e6})
    s = rock.advance(rock.initial(), 1e-3 * UNIT, 0.0, 20)
    yield "wet: torn: pressure [Pa]", s.p, 0.0
    yield "wet: torn: there is gas", float(s.grains + rock.fluid(s, 0.0) >= s.volume), 0.0
    again = rock.advance(s, -3e-3 * UNIT, 0.0, 20)
    yield "wet: pressed: no gas", abs((again.grains + rock.fluid(again, again.p)) / again.volume - 1), 1e-12
    mass = math.exp(-(again.p - 1e6) / 2.2e9) * rock.phi_i / (again.volume * again.porosity)
    yield "wet: and no fluid is lost", abs(mass - 1), 1e-12


def pores():
    """Wet rock, poroplastic form."""
    for group in (no_fluid, elastic, drainage, initial_pressure, gas):
        yield from group()
