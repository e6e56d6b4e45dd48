# SPDX-License-Identifier: BSD-3-Clause
"""A script that shows a run in ParaView as the report does: fields mirrored at the axis, at a time."""

import os

import numpy as np

from barreno.runs.exodus_sets import files_of
from barreno.report.fields import look_of, range_of, values_of
from barreno.report.particles import areas_of
from barreno.report.view_template import TEMPLATE

# The reader joins velocity_x and velocity_y into the vector "velocity_".
VECTORS = ("velocity_", "darcy_velocity_")


def array_of(name):
    """(array, component) of a field in ParaView; speed is the magnitude of the velocity."""
    if name == "speed":
        return "velocity_", "Magnitude"
    start = next((start for start in VECTORS if name.startswith(start)), None)
    return (start, name[-1].upper()) if start else (name, None)


def shown_field(frame, deck, name):
    """(array, component, colours, (least, largest), whether the colours are turned over) in SI. What the report computes from fields of the
    file is shown as the field that it comes from."""
    if name == "porosity" and name not in frame.names:
        name = "plastic_volume_strain"
    shapes, of = frame.shapes
    look = look_of(name)
    limits = range_of(values_of(frame, deck, name)[of], areas_of(shapes), look)
    return *array_of(name), "Cool to Warm" if look.signed else "Viridis (matplotlib)", tuple(map(float, limits)), look.colours == "RdBu"


def size_of_points(file):
    """Median width of particles that the file has as plain points [m]."""
    half = file.radius()
    half = half[np.isfinite(half) & (half > 0.0)]
    return 2.0 * float(np.median(half)) if len(half) else 1e-3


def view_script(run, fields, time):
    """Text of the script; its files are named from its own folder, so that a run can be moved."""
    here = run.folder / "report" / "paraview"
    frame = run.frame(time)
    left, right = (shown_field(frame, run.deck, name) for name in fields)
    values = {
        "FOLDER": str(here.resolve()),
        "FILES": [os.path.relpath(file, here) for file in files_of(run.particle_path)], "BLOCKS": run.file.block_names, "LEFT": left,
        "RIGHT": right,
        "TIME": frame.time, "MIRRORED": run.deck.mirrored(), "DOWN": bool(run.deck.has_jet and run.deck.direction > 0.0),
        "POINTS": frame.corners.shape[1] == 1, "SIZE": size_of_points(run.file), "DIMENSIONS": run.file.dimensions,
    }  # fmt: skip
    constants = "\n".join(f"{name} = {value!r}" for name, value in values.items())
    return TEMPLATE.replace("# CONSTANTS\n",
        f"# LEFT and RIGHT: array, component, colours, their range in SI, and whether they are turned over\n{constants}\n")
