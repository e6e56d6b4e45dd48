# SPDX-License-Identifier: BSD-3-Clause
"""Blake's wave in three dimensions: the octant between three symmetry planes, beside the axisymmetric quarter."""
from tools.case import Result
from cases.spherical_wave import FRONT, measure
from tools.octant import octant
from tools.runs import order

OUTER, END = 3.25, 2e-3  # radius of the solid [m], which no wave has left by then; time [s]
SHAPES = ("GIMP", "CPDI")


def settings(space, shape, cells):
    shared = {
        "Grid/Cell Size": repr(1.0 / cells),
        "Step/Shape Function": shape,
        "Bodies/Solid/Radius": f"{OUTER!r} m",
        "Time/End Time": repr(END),
    }
    return {**shared, **(octant("Solid", OUTER + 0.25, 1.0 / cells) if space else {})}


def run(barreno, full):
    result = Result(
        "Wave from a spherical cavity, in three dimensions",
        "A pressure on a curved surface that cuts the cells, in three dimensions; symmetry planes on three sides.",
        "Blake (`verification/oracles/cavity_waves.py`), as for the wave from a spherical cavity, to 2 ms. The axisymmetric runs are of "
        f"the same solid to the same time. rms over the volume in both modes, which gives the front more weight than averaging over "
        f"the particles of a plane. Velocity and stress at more than {FRONT} m from the front.",
        ["mode", "shape function", "cells per radius", "displacement error", "order", "velocity error", "order", "stress error",
         "order", "displacement of the wall", "energy ledger remainder", "particles"],
        [],
    )  # fmt: skip
    for shape in SHAPES if full else SHAPES[:1]:
        levels = (4, 8, 16) if full and shape == SHAPES[0] else (4, 8)
        errors = {}
        for space in (False, True):
            mode = "3D" if space else "axisymmetric"
            found = errors[mode] = []
            for cells in levels:
                error, *others = measure(barreno, settings(space, shape, cells), by_volume=True)
                found.append(error)
                rates = [order([a, b])[0] for a, b in zip(*found[-2:])] if len(found) > 1 else [float("nan")] * 3
                result.rows.append([mode, shape, cells, *(x for pair in zip(error, rates) for x in pair), *others])
        demand(shape, levels, errors, result)
    return result


def demand(shape, levels, errors, result):
    fine, plane = errors["3D"], errors["axisymmetric"]
    allowed = 0.01 * 16 / levels[-1]  # as the axisymmetric case demands at 16 cells, by the first order
    for what, k, least in (("displacement", 0, 1.0), ("velocity", 1, 5.0), ("stress", 2, 5.0)):
        result.demand(f"{shape}: {what} error in 3D at {levels[-1]} cells", fine[-1][k], least * allowed)
    # Beside the front nothing but the third direction tells the modes apart.
    for k, what in enumerate(("displacement", "velocity", "stress")):
        name = f"{shape}: {what} error in 3D over that in axisymmetry at {levels[-1]} cells"
        result.demand(name, fine[-1][k] / plane[-1][k], 1.1)
    rates = order([e[0] for e in fine])
    result.demand(f"{shape}: order of the displacement in 3D", rates[-1], 0.8, at_least=True)
