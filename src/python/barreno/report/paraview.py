# SPDX-License-Identifier: BSD-3-Clause
"""A script that shows a run in ParaView as the report does: fields mirrored at the axis, at a time."""

import os

import numpy as np
from matplotlib.colors import to_rgb

from barreno.runs.exodus_sets import files_of
from barreno.report.fields import look_in, norm_of, range_of, values_of
from barreno.report.explore.stack import steps_between
from barreno.report.hole import face_of, jet_particles, target_particles
from barreno.report.particles import areas_of
from barreno.report.pieces import carried, loose_within, pieces_of
from barreno.report.run_tables import UNITS
from barreno.report.tones import JET, RUBBLE, VOID, WITHOUT
from barreno.report.view import MILLI, is_long, span_of
from barreno.report.view_template import TEMPLATE
from barreno.runs.plots import plt

# The reader joins velocity_x and velocity_y into the vector "velocity_".
VECTORS = ("velocity_", "darcy_velocity_")
COLOURS = 33  # of a scale of colours
MOST_WALLS = 60  # outputs whose hole is written; at other times rubble is found by the one before
ALONG, EDGE, BAR_LYING, BAR_UPRIGHT = 1400, 100, 150, 200  # pixels: along a picture, and what is left around it


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


def title_of(look, name):
    """Words of the report's bar of colours; the numbers of ParaView's are in SI."""
    unit = UNITS.get("velocity_x" if name == "speed" else name)
    words = look.label.rpartition(" [")[0] or look.label
    return f"{words}, {unit}" if unit and unit != "-" else words


def shown_field(frame, deck, name):
    """(array, component, points of the colours in SI, title, whether the jet has the field's colours too). What the report computes from
    fields of the file is shown as the field that it comes from."""
    if name == "porosity" and name not in frame.names:
        name = "plastic_volume_strain"
    shapes, of = frame.shapes
    look = look_in(frame.file, deck, name)
    values = values_of(frame, deck, name)[of] / look.scale
    seen = ~pieces_of(frame, deck).apart | carried(name)  # as in the picture of the report
    points = colour_points(look, range_of(values[seen], areas_of(shapes)[seen], look))
    return *array_of(name), points, title_of(look, name), carried(name)


def page_of(frame, mirrored, lying):
    """([width, height] in pixels, half of the height in m) of a picture that leaves room for the bars of colours."""
    across, along = span_of(frame, mirrored) * MILLI
    if lying:
        scale = ALONG / along  # pixels per metre
        shape = [ALONG + EDGE, round(across * scale) + 2 * BAR_LYING]
    else:
        scale = min(ALONG / along, ALONG / max(across, 1e-9))
        shape = [round(across * scale) + 2 * BAR_UPRIGHT, round(along * scale) + EDGE]
    return shape, 0.5 * shape[1] / scale


def blocks_of(frame, deck):
    """(blocks of the target, other blocks, blocks of the jet): a block is the jet's or the target's where all of its particles are."""
    jet, names = jet_particles(frame, deck) if deck.has_jet else np.zeros(len(frame.block), bool), frame.file.block_names
    launched = "" if deck.forms_jet else deck.text("Jet/Material")
    of_jet = [name == launched and bool(jet[frame.block == n].all()) for n, name in enumerate(names)]
    target = target_particles(frame, deck)
    of_target = [not jets and bool(target[frame.block == n].all()) for n, jets in enumerate(of_jet)]
    kinds = {"jet": of_jet, "target": of_target, "other": [not (one or two) for one, two in zip(of_jet, of_target)]}
    return tuple([name for name, own in zip(names, kinds[kind]) if own] for kind in ("target", "other", "jet"))


def walls_text(run, hole_of):
    """The radius inside which a piece of the target is rubble, against depth, at outputs of the run; nothing without a hole."""
    rows = []
    for step in sorted({*steps_between(len(run.file.times), MOST_WALLS)}):
        hole = hole_of(int(step))
        if hole is not None and hole.open_rows:
            depth, radius = loose_within(hole)
            rows += [f"{run.file.times[step]:.9g},{one:.6g},{other:.6g}" for one, other in zip(depth, radius)]
    return "\n".join(["time,depth,radius", *rows, ""]) if rows else ""


def size_of_points(file):
    """Median width of particles that the file has as plain points [m]."""
    half = file.radius()
    half = half[np.isfinite(half) & (half > 0.0)]
    return 2.0 * float(np.median(half)) if len(half) else 1e-3


def view_script(run, fields, time, walls):
    """Text of the script; its files are named from its own folder, so that a run can be moved.

    @param walls  name of the file with the text of walls_text() beside it, or nothing"""
    here = run.folder / "report" / "paraview"
    frame = run.frame(time)
    left, right = (shown_field(frame, run.deck, name) for name in fields)
    target, others, jet = blocks_of(frame, run.deck)
    mirrored, flies = run.deck.mirrored(), run.deck.direction if run.deck.has_jet else 0.0
    lying = is_long(frame, mirrored)
    shape, half = page_of(frame, mirrored, lying)
    values = {
        "FOLDER": str(here.resolve()),
        "FILES": [os.path.relpath(file, here) for file in files_of(run.particle_path)], "TARGET": target, "OTHERS": others, "JET": jet,
        "LEFT": left, "RIGHT": right, "WITHOUT": list(to_rgb(WITHOUT)), "JET_COLOUR": list(to_rgb(JET)),
        "RUBBLE_COLOUR": list(to_rgb(RUBBLE)), "WALLS": walls, "FACE": face_of(run.depth_table(), run.file, run.deck) if walls else 0.0,
        "DIRECTION": flies, "VOID": list(to_rgb(VOID)),
        "LYING": lying, "SHAPE": shape, "HALF": half,
        "TIME": frame.time, "MIRRORED": mirrored, "DOWN": flies > 0.0, "BACK": flies < 0.0,
        "POINTS": frame.corners.shape[1] == 1, "SIZE": size_of_points(run.file), "DIMENSIONS": run.file.dimensions,
    }  # fmt: skip
    constants = "\n".join(f"{name} = {value!r}" for name, value in values.items())
    return TEMPLATE.replace("# CONSTANTS\n",
        "# LEFT and RIGHT: array, component, the report's colours as value in SI, red, green, blue, title, whether the jet has them too;\n"
        "# WITHOUT: colour of no value; HALF: half of the height of the picture in m\n"
        f"{constants}\n")
