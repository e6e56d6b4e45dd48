# SPDX-License-Identifier: BSD-3-Clause
"""Parameters that a fit may change, and the numbers that the optimiser sees of them."""

import math
from typing import NamedTuple

from barreno.fit import units
from barreno.fit.kinds import KINDS
from barreno.runs.faults import Fault


class Parameter(NamedTuple):
    """The optimiser sees ln of the magnitude (log), or the value itself.

    wide  half width of a range, in what the optimiser sees, from which on the data are said not to determine the parameter
    """

    dimension: str
    low: float
    high: float
    log: bool = True
    sign: float = 1.0
    wide: float = 1.5


PARAMETERS = {
    "PEAKI1": Parameter("stress", 1e3, 1e10),
    "FSLOPE": Parameter("ratio", 1e-3, 5.0),
    "STREN": Parameter("stress", 1e4, 1e12),
    "YSLOPE": Parameter("ratio", 0.0, 2.0, log=False, wide=0.15),
    "BETA_nonassociativity": Parameter("ratio", 0.02, 1.0, log=False, wide=0.45),
    "Dilatancy limit": Parameter("ratio", 1e-3, 1.0),
    "Dilatancy pressure": Parameter("stress", 1e5, 1e12),
    "CR": Parameter("ratio", 0.02, 0.98, log=False, wide=0.45),
    "B0": Parameter("stress", 1e6, 1e12),
    "B1": Parameter("stress", 1e5, 1e12),
    "B2": Parameter("stress", 1e5, 1e11),
    "G0": Parameter("stress", 1e6, 1e12),
    "G1": Parameter("ratio", 0.01, 0.48, log=False, wide=0.2),
    "G2": Parameter("ratio", -0.4, 0.4, log=False, wide=0.2),
    "p0_crush_curve": Parameter("stress", 1e5, 1e12, sign=-1.0),
    "p1_crush_curve": Parameter("compliance", 1e-13, 1e-4),
    "p3_crush_curve": Parameter("ratio", 1e-3, 1.5),
}
DIMENSION_OF = {**{name: p.dimension for name, p in PARAMETERS.items()}, "Density": "density"}
UNIT_OF = {"stress": "MPa", "ratio": "", "compliance": "1/GPa"}
SI_OF = {"stress": "Pa", "ratio": "", "compliance": "1/Pa"}


def seen(name, value):
    """A value as the optimiser sees it."""
    p = PARAMETERS[name]
    return math.log(max(p.sign * value, 1e-300)) if p.log else value


def unseen(name, z):
    p = PARAMETERS[name]
    return p.sign * math.exp(z) if p.log else z


def bounds_of(name, given):
    """Bounds as the optimiser sees them."""
    p = PARAMETERS[name]
    low, high = given.get(name, (p.sign * p.low, p.sign * p.high))
    return sorted((seen(name, low), seen(name, high)))


def tie(card, fixed):
    """With a Poisson's ratio the shear modulus of unstressed rock follows, or moduli would jump at zero pressure."""
    if card.get("G1", 0.0) != 0.0 and "G0" not in fixed:
        card["G0"] = 1.5 * card["B0"] * (1.0 - 2.0 * card["G1"]) / (1.0 + card["G1"])
    return card


def free_of(tests, card, fixed):
    """Names that these tests may determine. What the start switches off with 0 stays off."""
    names = {name for test in tests for name in KINDS[test.kind].fits}
    if any(set(test.channels) & {"volume_strain", "radial_strain"} and test.kind == "triaxial" for test in tests):
        names |= {"BETA_nonassociativity", "Dilatancy limit", "Dilatancy pressure"}
    names -= set(fixed)
    names -= {name for name in names if name != "YSLOPE" and name != "BETA_nonassociativity" and card.get(name, 0.0) == 0.0}
    if card.get("STREN", 0.0) == 0.0:
        names.discard("YSLOPE")
    names -= {"G0"} if card.get("G1", 0.0) != 0.0 else {"G2"}
    return [name for name in PARAMETERS if name in names]


def named_value(text, option):
    """`NAME=value` of the command line."""
    name, equals, value = text.partition("=")
    name = name.strip()
    if not equals or not value.strip():
        raise Fault(f'{option} "{text}" is not NAME=value; write for example {option} "PEAKI1=12 MPa".')
    if name not in DIMENSION_OF:
        raise Fault(f"{option} {name} names no parameter of a fit; they are {', '.join(DIMENSION_OF)}.")
    return name, value


def fixed_values(texts):
    out = {}
    for text in texts:
        name, value = named_value(text, "--fix")
        out[name] = units.quantity(value, DIMENSION_OF[name], f"--fix {name}", plain=True)
    return out


def given_bounds(texts):
    out = {}
    for text in texts:
        name, value = named_value(text, "--bounds")
        if name not in PARAMETERS:
            raise Fault(f"--bounds {name} has no effect, since {name} is not fitted; use --fix.")
        parts = value.split(",")
        if len(parts) != 2:
            raise Fault(f'--bounds "{text}" is not NAME=low,high; write for example --bounds "PEAKI1=1 MPa,20 MPa".')
        low, high = (units.quantity(part, DIMENSION_OF[name], f"--bounds {name}", plain=True) for part in parts)
        p = PARAMETERS[name]
        if not low < high or (p.log and not (p.sign * low > 0.0 and p.sign * high > 0.0)):
            sign = " below 0" if p.sign < 0 else " above 0" if p.log else ""
            raise Fault(f'--bounds "{text}" is not an interval{sign}; give the lower one first.')
        out[name] = (low, high)
    return out


def shown(name, value):
    p = PARAMETERS[name]
    large = p.dimension == "stress" and abs(value) >= 2e9
    scale, unit = (1e9, " GPa") if large else {"stress": (1e6, " MPa"), "compliance": (1e-9, " 1/GPa")}.get(p.dimension, (1.0, ""))
    return f"{value / scale:.4g}{unit}"
