# SPDX-License-Identifier: BSD-3-Clause
"""A script that shows a run in ParaView as the report does: fields mirrored at the axis, at a time."""

import os

import numpy as np

from barreno.runs.exodus_sets import files_of
from barreno.report.fields import look_in, norm_of, range_of, values_of
from barreno.report.particles import areas_of
from barreno.report.pieces import carried, pieces_of
from barreno.report.tones import WITHOUT
from barreno.report.view_template import TEMPLATE
from barreno.runs.plots import plt

# The reader joins velocity_x and velocity_y into the vector "velocity_".
VECTORS = ("velocity_", "darcy_velocity_")
COLOURS = 33  # of a scale of colours


def array_of(name):
    """(array, component) of a field in ParaView; speed is the magnitude of the velocity."""
    if name == "speed":
        return "velocity_", "Magnitude"
    start = next((start for start in VECTORS if name.startswith(start)), None)
    return (start, name[-1].upper()) if start else (name, None)


def colour_points(look, limits):
    """[value in SI, red, green, blue, ...] of the report's colours, as ParaView's RGBPoints have them: between two of them ParaView goes
    straight from one colour to the other. Values follow the norm of the look, so that a centre and logarithms are kept."""
    norm, shares = norm_of(look, limits), np.linspace(0.0, 1.0, COLOURS)
    values = np.ma.getdata(norm.inverse(shares)) * look.scale
    colours = plt.get_cmap(look.colours)(shares)[:, :3]
    return [float(f"{part:.6g}") for value, colour in zip(values, colours) for part in (value, *colour)]


def shown_field(frame, deck, name):
    """(array, component, points of the colours) in SI. What the report computes from fields of the file is shown as the field that it comes
    from."""
    if name == "porosity" and name not in frame.names:
        name = "plastic_volume_strain"
    shapes, of = frame.shapes
    look = look_in(frame.file, deck, name)
    values = values_of(frame, deck, name)[of] / look.scale
    seen = ~pieces_of(frame, deck).apart | carried(name)  # as in the picture of the report
    return *array_of(name), colour_points(look, range_of(values[seen], areas_of(shapes)[seen], look))


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
        "RIGHT": right, "WITHOUT": [float(WITHOUT)] * 3,
        "TIME": frame.time, "MIRRORED": run.deck.mirrored(), "DOWN": bool(run.deck.has_jet and run.deck.direction > 0.0),
        "POINTS": frame.corners.shape[1] == 1, "SIZE": size_of_points(run.file), "DIMENSIONS": run.file.dimensions,
    }  # fmt: skip
    constants = "\n".join(f"{name} = {value!r}" for name, value in values.items())
    return TEMPLATE.replace("# CONSTANTS\n",
        "# LEFT and RIGHT: array, component, and the report's colours as value in SI, red, green, blue; WITHOUT: of no value\n"
        f"{constants}\n")
