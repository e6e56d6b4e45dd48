# SPDX-License-Identifier: BSD-3-Clause
"""Thick sphere under a pressure in its hollow, at rest: Lame's state, on a surface that cuts the cells."""
import numpy as np
from tools.case import Result
from tools.choices import shape_functions
from tools.manufactured_runs import centres
from tools.runs import order, run_deck

A, B, PRESSURE = 1.0, 2.0, 1e5
BULK, SHEAR = 200e9 / 3 / (1 - 0.6), 200e9 / 2 / 1.3
LIMITS = ((2, 6e-3), (3, 2e-3))  # particles per cell, error of the displacement


def lame(r):
    """u_r, radial and hoop stress."""
    f = PRESSURE * A**3 / (B**3 - A**3)
    return f * (r / (3 * BULK) + B**3 / (4 * SHEAR * r**2)), f * (1 - (B / r) ** 3), f * (1 + 0.5 * (B / r) ** 3)


def rms(x):
    return float(np.sqrt(np.mean(np.square(x))))


def measure(barreno, shape, per_cell, cells):
    """rms errors of displacement and stress over all particles, and of the radial stress over those at the wall; None if the run stops."""
    h = (B - A) / cells
    side = float(np.ceil(B / h + 1.0) * h)
    settings = {"Grid/Cell Size": repr(h), "Grid/Upper": f"{{{side!r}, {side!r}}}", "Step/Shape Function": shape,
                "Bodies/Wall/Particles Per Cell": str(per_cell)}  # fmt: skip
    try:
        run = run_deck(barreno, "thick_sphere.xml", settings)
    except RuntimeError as error:
        if "ended with 3" not in str(error):  # the steps are unstable, and the run says so
            raise
        return None
    start, end = run.particles(0), run.particles()
    X = np.array(centres(start)[:2])
    moved = np.array(centres(end)[:2]) - X
    R = np.hypot(*X)
    n = X / R
    t = np.array([-n[1], n[0]])
    stress = lambda a, b: a[0] * b[0] * end["stress_xx"] + a[1] * b[1] * end["stress_yy"] + (  # noqa: E731
        a[0] * b[1] + a[1] * b[0]) * end["stress_xy"]  # fmt: skip
    u, radial, hoop = lame(R)
    scale = lame(np.array([A]))[0][0]
    displacement = rms(np.concatenate([np.sum(moved * n, 0) - u, np.sum(moved * t, 0)])) / scale
    errors = [stress(n, n) - radial, stress(t, t) - hoop, stress(n, t), end["stress_zz"] - hoop]
    wall = R < A + h
    table = run.table("history.csv")
    return {
        "displacement": displacement,
        "stress": rms(np.concatenate(errors)) / PRESSURE,
        "wall": rms(errors[0][wall]) / PRESSURE,
        "worst": float(np.max(np.abs(errors[0]))) / PRESSURE,
        "moving": table["kinetic"][-1] / table["elastic"][-1],
        "remainder": run.summary["balances"]["energy"]["error"],
    }


def row(shape, per_cell, cells, found):
    m, before = found[cells], found.get(cells // 2)
    if m is None:
        return [shape, per_cell, cells, "stops", *[""] * 7]
    rates = [order([before[k], m[k]])[0] if before else "" for k in ("displacement", "stress")]
    return [shape, per_cell, cells, m["displacement"], rates[0], m["stress"], rates[1], m["wall"], m["worst"], m["moving"], m["remainder"]]


def run(barreno, full):
    result = Result(
        "Thick sphere under internal pressure",
        "A follower pressure on a curved surface that cuts the cells; damping brings the wall to rest.",
        "Lame. rms over all particles: displacement relative to that of the wall, radial, hoop and shear stress relative to the "
        "pressure. For the radial stress also the rms over the particles within a cell of the wall, and the largest error of all.",
        ["shape function", "particles per cell", "cells in the wall", "displacement error", "order", "stress error", "order",
            "radial stress at the wall",
         "worst radial stress", "kinetic / elastic energy", "energy ledger remainder"],
        [],
    )  # fmt: skip
    levels = (8, 16, 32) if full else (16,)
    for number, shape in enumerate(shape_functions(barreno)):
        for per_cell, limit in LIMITS if full else (LIMITS[1 - number % 2],):  # in turn
            name = f"{shape}, {per_cell} particles per cell"
            found = {cells: measure(barreno, shape, per_cell, cells) for cells in levels}
            result.rows += [row(shape, per_cell, cells, found) for cells in levels]
            result.demand(f"{name}: runs that stop", sum(m is None for m in found.values()), 0)
            if found[16]:
                result.demand(f"{name}, 16 cells: displacement error", found[16]["displacement"], limit)
                result.demand(f"{name}, 16 cells: stress error", found[16]["stress"], 3e-2)
                result.demand(f"{name}, 16 cells: kinetic over elastic energy", found[16]["moving"], 1e-5)
        ends = [found[cells] for cells in (levels[0], levels[-1])]
        if full and all(ends):
            result.demand(f"{name}: mean order of the displacement", order([m["displacement"] for m in ends], 4.0)[0], 1.5, at_least=True)
            result.demand(f"{name}: mean order of the stress", order([m["stress"] for m in ends], 4.0)[0], 0.8, at_least=True)
    result.notes = (
        "With two particles per cell the error of the displacement does not decrease steadily with the cells. It depends on how the "
        "surface happens to cut the particles' squares, and is largest along the axis. With three it decreases. Stress errors depend on "
        "this too. Damping also acts on particle motion that the nodes cannot represent; otherwise particles at the inner surface would "
        "oscillate against each other indefinitely."
    )
    return result
