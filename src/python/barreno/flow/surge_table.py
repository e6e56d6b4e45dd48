# SPDX-License-Identifier: BSD-3-Clause
"""What a surge has done, before and after: lines of the screen and numbers of flow.json."""

import math

import numpy as np

from barreno.runs.tables import aligned

PARTS = (0.25, 0.5, 0.75)  # of the hole's length before, at which its radius is told


def skin_of(efficiency, rings):
    """s of CFE = ln(R/r) / (ln(R/r) + s), r the radius of the round hole of the same length and volume."""
    return (1.0 / efficiency - 1.0) * math.log(rings.radii[-1] / rings.hole_radius) if efficiency > 0.0 else math.inf


def numbers_of(inflow, at):
    """@param at  depths of the radii"""
    rings, efficiency = inflow.rings, inflow.shot.rate / inflow.virgin.rate
    radii = np.interp(at, rings.middles[1], rings.wall)
    return {"core_flow_efficiency": efficiency, "skin": skin_of(efficiency, rings), "shape_factor": inflow.shot.rate,
        "shape_factor_virgin": inflow.virgin.rate, "hole_radius": rings.hole_radius, "hole_length": rings.hole_length,
        "hole_volume": rings.hole_volume,
        "radii": [{"depth": float(depth), "radius": float(radius)} for depth, radius in zip(at, radii)]}


def numbers_of_surge(cleaning):
    first = cleaning.before.rings
    at = first.depths[0] + first.hole_length * np.array(PARTS)
    before, after = (numbers_of(one, at) for one in (cleaning.before, cleaning.after))
    return {"pressure": cleaning.pressure, "limit": cleaning.limit, "steepest_gradient": cleaning.steepest,
        "lost_cohesion": cleaning.measure, "removed_mass": cleaning.mass, "passes": cleaning.passes,
        "flow_ratio": after["shape_factor"] / before["shape_factor"], "before": before, "after": after}


def rows_of(numbers):
    before, after = numbers["before"], numbers["after"]
    yield "", "before", "after"
    for name, key, scale, form in (("core flow efficiency", "core_flow_efficiency", 1.0, ".3f"), ("skin", "skin", 1.0, "+.2f"),
            ("shape factor [m]", "shape_factor", 1.0, ".4g"), ("radius of a round hole [mm]", "hole_radius", 1e3, ".2f"),
            ("length of the hole in rock [mm]", "hole_length", 1e3, ".1f")):
        yield name, format(scale * before[key], form), format(scale * after[key], form)
    for old, new in zip(before["radii"], after["radii"]):
        yield f"radius at a depth of {1e3 * old['depth']:.1f} mm [mm]", f"{1e3 * old['radius']:.2f}", f"{1e3 * new['radius']:.2f}"


def lines_of_surge(cleaning):
    numbers = numbers_of_surge(cleaning)
    yield (f"surge of {1e-6 * cleaning.pressure:.4g} MPa: {1e3 * cleaning.mass:.3g} g of rock without cohesion removed; the flow at the "
        f"same pressure drop is {numbers['flow_ratio']:.3f} times that before")
    yield from aligned(list(rows_of(numbers)))
    yield (f"Rock without cohesion: {cleaning.measure}. It goes from the wall where the gradient exceeds {1e-9 * cleaning.limit:.4g} "
        f"MPa/mm (a limit that is assumed, docs/flow.md); the steepest before was {1e-9 * cleaning.steepest:.4g} MPa/mm.")
    yield ""
    yield "After the surge:"
