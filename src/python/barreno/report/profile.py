# SPDX-License-Identifier: BSD-3-Clause
"""A measured profile: a table of radius against depth."""

import numpy as np

from barreno.fit.table import decoded, is_number, split_table
from barreno.report.measured import Measured, fault
from barreno.runs.faults import on_one_line
from barreno.runs.regular_file import read_bytes
from barreno.runs.words import LENGTH_UNITS

HEADER = 'begin the file with for example "depth [mm], radius [mm]"'
LARGEST = 100.0  # m; a larger number has another unit


def column_of(file, table, names):
    """(index, factor to SI) of the first column with one of the names."""
    at = next((i for i, name in enumerate(table.names) if name in names), None)
    if at is None:
        heads = ", ".join(table.heads[:6]) or "nothing"
        if table.heads and all(is_number(head) for head in table.heads):
            raise fault(file, f"has no header, but begins with numbers; {HEADER}.")
        raise fault(file, f"has no column {' or '.join(names)} (its header has {heads}); {HEADER}.")
    unit = table.units[at]
    if unit not in LENGTH_UNITS:
        said = f"the unit '{unit}', which is no length" if unit else "no unit"
        raise fault(file, f"gives its column {table.heads[at]} {said}; use one of {', '.join(LENGTH_UNITS)}, as in \"{names[0]} [mm]\".")
    return at, LENGTH_UNITS[unit]


def number_in(file, line, cells, column):
    cell = cells[column] if column < len(cells) else ""
    if not is_number(cell) or not np.isfinite(float(cell)):
        raise fault(file, f"has '{on_one_line(cell)[:40]}' for a number in line {line}; correct or remove that line.")
    return float(cell)


def check_rows(file, lines, depth, radius):
    """@raises Fault  where depth does not grow or a radius is negative"""
    for line, before, here, r in zip(lines, [-np.inf, *depth], depth, radius):
        if r < 0.0:
            raise fault(file, f"has a negative radius in line {line}; a radius counts from the axis of the hole outwards.")
        if here <= before:
            raise fault(file, f"has a depth in line {line} that is not larger than the one before; sort the rows by growing depth.")
        if here < 0.0:
            raise fault(file, f"has a negative depth in line {line}; depth counts from the outer face of the target along the shot.")
        if max(here, r) > LARGEST:
            raise fault(file, f"has a length above {LARGEST:g} m in line {line}; check the units of its header.")


def read_profile(file):
    """A CSV file with the columns depth and radius, or diameter, each with its unit in the header."""
    text = decoded(read_bytes(file))
    if text is None:
        raise fault(file, "is no text; give a CSV file, a TIFF file of slices, or a folder of PNG slices.")
    table = split_table(file.name, text, {"depth", "radius", "diameter"})
    if not table.names:
        raise fault(file, f"is empty; {HEADER}.")
    depth_at, depth_factor = column_of(file, table, ("depth",))
    radius_at, radius_factor = column_of(file, table, ("radius", "diameter"))
    if table.names[radius_at] == "diameter":
        radius_factor *= 0.5
    if len(table.rows) < 2:
        raise fault(file, f"has {len(table.rows)} rows of numbers; a profile needs at least two.")
    depth, radius = (np.array([factor * number_in(file, line, cells, at) for line, cells in table.rows])
        for at, factor in ((depth_at, depth_factor), (radius_at, radius_factor)))
    check_rows(file, [line for line, _ in table.rows], depth, radius)
    if not radius.any():
        raise fault(file, "contains no hole: all its radii are zero.")
    return Measured(file.name, depth, radius, float(depth[-1]))
