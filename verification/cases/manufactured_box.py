# SPDX-License-Identifier: BSD-3-Clause
"""Axis-aligned displacement of the unit box: order of accuracy of every shape function in every mode."""
from case import Result
from choices import modes, shape_functions
from manufactured_runs import Failed, box_run, displacement_error
from runs import order

FOLLOWS_ITS_PARTICLES = ("CPDI", "contiguous GIMP")
CONTROL = "linear"  # must not converge
FLOOR = 0.01  # amplitude up to which a support of fixed size is second order down to h = 1/64


def refine(barreno, mode, shape, amplitude, per_cell, levels, result):
    """Rows of one refinement; returns rms errors."""
    errors = []
    for cells in levels:
        run, motion = box_run(barreno, mode, shape, amplitude, cells, per_cell)
        case = [mode, shape, amplitude, per_cell, cells]
        if isinstance(run, Failed):
            result.rows.append([*case, run.why, "", "", ""])
            return errors
        rms, greatest, _ = displacement_error(run, motion)
        rate = order([errors[-1], rms])[0] if errors else float("nan")
        errors.append(rms)
        result.rows.append([*case, rms / amplitude, rate, greatest / amplitude, run.summary["balances"]["energy"]["error"]])
    return errors


def demand(mode, shape, amplitude, per_cell, levels, errors, result):
    """The orders that must hold, and the control that must not."""
    what = f"{mode}, {shape}, A = {amplitude}, {per_cell} particles per cell: order"
    rates = order(errors)
    complete = len(errors) == len(levels)
    if shape == CONTROL:
        result.demand(f"{what} of the last halving (control)", rates[-1] if complete else -1.0, 1.0)
    elif shape in FOLLOWS_ITS_PARTICLES:
        result.demand(f"{what} of the last halving", rates[-1] if complete else -1.0, 1.9, at_least=True)
    elif amplitude <= FLOOR:
        result.demand(f"{what}, least of all halvings", min(rates) if complete else -1.0, 1.8, at_least=True)


def run(barreno, full):
    result = Result(
        "Axis-aligned displacement",
        "Order of accuracy at small and large strain, for shape functions and modes that this build has.",
        "manufactured solution of the neo-Hookean box (`verification/oracles/manufactured.py`); rms and greatest error of "
        "the displacement over all particles, the largest over ten instants of half a period, over the amplitude A in metres.",
        ["mode", "shape function", "A", "particles per cell", "cells", "rms error / A", "order", "greatest error / A",
         "energy ledger remainder"],
        [],
    )  # fmt: skip
    for mode in modes(barreno):
        solid = mode == "3D"
        levels = ((4, 8, 16) if solid else (8, 16, 32, 64)) if full else ((4, 8) if solid else (8, 16, 32))
        for shape in shape_functions(barreno):
            for amplitude in (0.01, 0.1) if full else (0.01,):
                for per_cell in (2, 4) if full and mode == "plane strain" else (2,):
                    errors = refine(barreno, mode, shape, amplitude, per_cell, levels, result)
                    if full or len(levels) > 2:
                        demand(mode, shape, amplitude, per_cell, levels, errors, result)
    result.notes = (
        "Supports of fixed size (GIMP, B-splines) stop converging where the boxes of strained particles no longer fit "
        "together: an error that grows with the strain and, once it leads, with the number of cells. It is expected there and "
        "no order is demanded; shape functions that follow their particles must keep order 2 at both amplitudes."
    )
    return result
