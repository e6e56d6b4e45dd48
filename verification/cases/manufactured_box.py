# SPDX-License-Identifier: BSD-3-Clause
"""Axis-aligned displacement of the unit box: order of accuracy of every shape function in every mode.

Demanded orders are those of prototypes of the methods in one dimension: where domains follow their particles the order is 1.9 or
more at both amplitudes, at A = 0.01 from 64 cells on and 1.8 before; where the support has one size it is 1.8 or more at
A = 0.01, and at A = 0.1 there is a floor, from which the error grows with the number of cells.
"""
from tools.case import Result
from tools.choices import modes, shape_functions
from tools.manufactured_runs import Failed, box_run, displacement_error
from tools.runs import order

FOLLOWS_ITS_PARTICLES = ("CPDI", "contiguous GIMP")
CONTROL = "linear"  # must not converge
SMALL, LARGE = 0.01, 0.1
SETTLED = 64  # cells from which 1.9 is demanded at the small amplitude


def cells_of(mode, full):
    if mode == "3D":
        return (4, 8, 16) if full else ()
    if mode == "axisymmetric":
        return (8, 16, 32) if full else (8, 16)
    return (8, 16, 32, 64) if full else (8, 16)


def series(barreno, full):
    """(mode, shape function, amplitude, particles per cell, cells) of every refinement."""
    for mode in modes(barreno):
        levels = cells_of(mode, full)
        for shape in shape_functions(barreno) if levels else ():
            for amplitude in (SMALL, LARGE):
                yield mode, shape, amplitude, 2, levels
            if full and mode == "plane strain":
                yield mode, shape, LARGE, 4, levels[:-1]


def refine(barreno, mode, shape, amplitude, per_cell, levels, result):
    """Rows of one refinement; returns rms errors over the amplitude, or nothing if a run failed."""
    errors = []
    for cells in levels:
        run, motion = box_run(barreno, mode, shape, amplitude, cells, per_cell)
        case = [mode, shape, amplitude, per_cell, cells]
        if isinstance(run, Failed):
            result.rows.append([*case, run.why, "", "", ""])
            return []
        rms, greatest, _ = displacement_error(run, motion)
        errors.append(rms / amplitude)
        rate = order(errors[-2:])[0] if len(errors) > 1 else float("nan")
        result.rows.append([*case, errors[-1], rate, greatest / amplitude, run.summary["balances"]["energy"]["error"]])
    return errors


def demand(mode, shape, amplitude, per_cell, levels, errors, result):
    """The orders that must hold, and the control that must not."""
    what = f"{mode}, {shape}, A = {amplitude}, {per_cell} particles per cell: order"
    rates = order(errors) if errors else [-1.0]
    if shape == CONTROL:
        if amplitude == LARGE or levels[-1] >= 32:
            result.demand(f"{what} of the last halving (control)", rates[-1] if errors else 9.0, 0.0)
    elif shape in FOLLOWS_ITS_PARTICLES:
        least = 1.9 if amplitude == LARGE or levels[-1] >= SETTLED else 1.8
        result.demand(f"{what} of the last halving", rates[-1], least, at_least=True)
    elif amplitude == SMALL:
        result.demand(f"{what}, minimum over all halvings", min(rates), 1.8, at_least=True)


def floor_lines(found):
    """Where the errors of each refinement at the large amplitude stop to fall, and how they grow."""
    lines = ["| mode | shape function | particles per cell | smallest error / A | at cells | order of the last halving |",
        "|---|---|---|---|---|---|"]
    for (mode, shape, amplitude, per_cell, levels), errors in found:
        if amplitude == LARGE and errors and shape not in FOLLOWS_ITS_PARTICLES:
            least = min(errors)
            lines.append(f"| {mode} | {shape} | {per_cell} | {least:.3g} | {levels[errors.index(least)]} | {order(errors)[-1]:.2f} |")
    return "\n".join(lines)


def run(barreno, full):
    result = Result(
        "Axis-aligned displacement",
        "Order of accuracy at small and large strain, for all shape functions and modes of this build.",
        "manufactured solution of the neo-Hookean box (`verification/oracles/manufactured.py`); rms and largest error of the displacement "
        "over all particles, the largest over ten instants of half a period, relative to the amplitude A in metres.",
        ["mode", "shape function", "A", "particles per cell", "cells", "rms error / A", "order", "greatest error / A",
         "energy ledger remainder"],
        [],
    )  # fmt: skip
    found = []
    for case in series(barreno, full):
        errors = refine(barreno, *case, result)
        demand(*case, errors, result)
        found.append((case, errors))
    result.notes = (
        "Supports of fixed size (GIMP) and point masses (B-splines, linear) stop converging where strained particles no longer fill the "
        "cells evenly. Sums over particles then approximate integrals with an error that grows with the strain and is divided by the "
        "cell size. "
        "Beyond that floor the error is inversely proportional to the cell size (order -1); it is lower with more particles per "
        "cell and for smoother functions. No order is required there; shape functions that follow their particles must keep their order at "
        "both amplitudes, and linear functions, the control, must not converge. At A = 0.1:\n\n"
        + floor_lines(found)
    )
    return result
