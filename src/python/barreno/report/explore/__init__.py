# SPDX-License-Identifier: BSD-3-Clause
"""The explorable view at the top of a report's page: particles of all outputs, which scripts of the page draw (page/*.js)."""

import dataclasses
import json
import pathlib
import re

import numpy as np
from markupsafe import Markup

from barreno.report.explore.codes import packed
from barreno.report.explore.curves import depth_plots, energy_plot
from barreno.report.explore.fields import chosen_fields, field_of, material_field, state_field
from barreno.report.explore.stack import PLACES, SHAPE, Stack, drawn, steps_between
from barreno.report.fields import known_fields
from barreno.report.files import reading
from barreno.report.hole import cell_along_path, face_of
from barreno.report.pieces import pieces_of
from barreno.report.tones import RUBBLE, tones_of
from barreno.report.view import MILLI, View, hole_view, is_long
from barreno.report.wall import MEASURED
from barreno.runs.regular_file import read_text

HERE = pathlib.Path(__file__).parent.parent
MOST_BYTES = 15_000_000  # of a page
MOST_ENTRIES = 8_000_000  # particles times outputs: what a browser holds easily
LEVELS = (4095, 1023, 255)  # codes of a field: 12 bits, fewer where a page would be too large
TRIED = 40  # outputs from which the size of many is estimated
TRIALS = 6
SCRIPTS = ("numbers", "colours", "state", "camera", "pixels", "marks", "values", "bars", "curves", "controls", "start")
BANNER = re.compile(r"\A\s*/\*!.*?\*/\s*", re.DOTALL)


class TooLarge(Exception):
    """Two outputs do not fit either."""


def file_text(name):
    return read_text(HERE / name)


def view_script():
    """The scripts of the page as one, whose names are its own."""
    return "\n".join(["(() => {", '"use strict";', *(file_text(f"page/{name}.js") for name in SCRIPTS), "})();"])


def tips_of(run, table, stack):
    """Along y [m], of every output: the bottom of the hole, before the hit the particle of the jet that is furthest along its flight, or
    None."""
    direction, found = run.deck.direction, []
    depth = np.interp(stack.times, table["time"], table["depth"]) if table is not None else np.zeros(len(stack.times))
    jet = run.deck.text("Jet/Material")
    for output, deep in zip(stack.outputs, depth):
        frame = output.frame
        own = frame.block == frame.file.block_names.index(jet) if jet in frame.file.block_names else np.zeros(len(frame.block), bool)
        if deep > 0.0:
            found.append(face_of(table, run.file, run.deck) + direction * float(deep))
        elif own.any():
            found.append(direction * float((direction * run.file.frame(frame.step).centres[own, 1]).max()))
        else:
            found.append(None)
    return found


def grid_of(run):
    """Cells of the largest size; those of particles are in the field cell_size where there are several."""
    lower, size = run.deck.vector("Grid/Lower"), run.deck.number("Grid/Cell Size")
    return {"lower": lower[:2], "size": size} if len(lower) >= 2 and np.isfinite(size) and size > 0.0 else None


def how_it_lies(run, hole_of):
    """(whether depth runs along the view, the part of the plane with the hole in m or None): as the pictures of the last output lie."""
    last, mirrored = len(run.file.times) - 1, run.deck.mirrored()
    frame, hole = run.file.frame(last), hole_of(last)
    seen = hole_view(View(hole=hole), run.deck) if hole is not None and hole.open_rows else None
    lying = is_long(frame, mirrored) or (seen is not None and is_long(frame, mirrored, seen.box))
    return lying, None if seen is None else [[MILLI * value for value in ends] for ends in (seen.box[:2], seen.box[2:])]


def rubble_of(run, stack, hole_of):
    """(output, column): 1 where a particle is a loose piece of the target in the hole, as in the pictures."""

    def rubble(frame):
        found, hole = np.zeros(int(frame.alive.sum()), np.uint8), hole_of(frame.step)
        if hole is not None:
            _, of = frame.shapes
            found[of] = pieces_of(frame, run.deck, hole).rubble
        return found

    return stack.table(rubble, 0, np.uint8)


def measured_of(run, hole_of, measured):
    """Name and wall of a measured hole, (radius, y) in m down to its bottom; None without one."""
    if measured is None:
        return None
    depth = [*measured.depth, measured.end, measured.end]
    radius = [*measured.radius, measured.radius[-1], 0.0]
    face = hole_of(len(run.file.times) - 1).face
    wall = [[float(r), float(face + run.deck.direction * down)] for r, down in zip(radius, depth)]
    return {"name": f"measured ({measured.name})", "colour": MEASURED, "wall": wall}


def scene_of(run, fields, table, shown, steps, levels):
    """All that the script needs, as JSON can hold it.

    @param shown  as view_of() has it"""
    file, deck = run.file, run.deck
    stack = Stack(file, steps)
    places, shapes, sizes, largest, areas = stack.places()
    tones = tones_of(deck, file.block_names)
    colours = [tones[name] for name in file.block_names]
    names = chosen_fields(known_fields(file, deck), fields)
    lying, hole = how_it_lies(run, shown.hole_of)
    loose = rubble_of(run, stack, shown.hole_of)
    return {
        "times": [float(time) for time in stack.times], "outputs": len(file.times), "steps": [int(step) for step in steps],
        "mirrored": bool(deck.mirrored()), "down": bool(deck.has_jet and deck.direction > 0.0),
        "up": bool(deck.has_jet and deck.direction < 0.0), "lying": lying, "hole": hole, "cut": file.dimensions == 3,
        "across": "r" if deck.mode == "axisymmetric" else "x", "jet": deck.text("Jet/Material"),
        "low": [float(value) for value in stack.low], "quantum": stack.quantum, "largest": largest / PLACES, "shapeUnit": 1.0 / SHAPE,
        "tips": tips_of(run, table, stack), "around": cell_along_path(file, deck), "grid": grid_of(run),
        "numbers": packed(file.numbers[stack.elements].astype(np.uint32)), "there": packed(stack.there()),
        "measured": measured_of(run, shown.hole_of, shown.measured),
        "rubble": packed(loose), "loose": bool(loose.any()), "rubbleColour": RUBBLE,
        "places": packed(places), "shapes": packed(shapes), "sizes": packed(sizes),
        "fields": [*(field_of(stack, deck, name, areas, levels) for name in names), material_field(stack, colours),
            state_field(stack, deck)],
        "left": fields[0], "right": next((name for name in names if name == fields[1]), names[-1]),
    }  # fmt: skip


def as_json(scene):
    """For a script element: no text in it can end the element or begin another."""
    text = json.dumps(scene, allow_nan=False, ensure_ascii=True, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def shown_at_once(file):
    """About how many particles an output shows: in three dimensions those of a cut."""
    return file.elements if file.dimensions == 2 else len(drawn(file.frame(-1))[2])


def fitted(run, fields, table, shown, room):
    """The scene as text of at most so many bytes, and its number of outputs: finer codes and all outputs where they fit."""
    count, curves = len(run.file.times), curves_of(run, table)
    text_of = lambda steps, levels: as_json({**scene_of(run, fields, table, shown, steps, levels), **curves})  # noqa: E731
    most, levels = min(count, max(2, MOST_ENTRIES // max(shown_at_once(run.file), 1))), list(LEVELS)
    if count > TRIED:
        each = len(text_of(steps_between(count, TRIED), levels[-1])) / TRIED
        most, levels = (most, levels) if each * most < room else (max(2, int(room / each)), levels[-1:])
    for _ in range(TRIALS):
        steps = steps_between(count, most)
        text = text_of(steps, levels[0])
        if len(text) <= room:
            return text, len(steps)
        if len(levels) > 1:
            levels = levels[1:]
        elif len(steps) <= 2:
            break
        else:
            most = max(2, min(len(steps) - 1, int(0.9 * len(steps) * room / len(text))))
    raise TooLarge


def curves_of(run, table):
    plots = []
    if table is not None:
        with reading(run.folder / "depth.csv"):
            plots += depth_plots(table)
    history = run.history_table()
    with reading(run.folder / "history.csv"):
        return {"plots": [*plots, energy_plot(history)]}


def about_outputs(shown, count):
    if shown == count:
        return ""
    return f"The view has {shown} of the run's {count} outputs, evenly spaced, so that the page stays below 15 MB."


def library(name):
    """A library's built file with its licence in the place of its first comment."""
    licence = file_text(f"third_party/{name.split('.')[0]}.LICENSE").replace("*/", "* /")
    return f"/*! {name}\n{licence}\n*/\n{BANNER.sub('', file_text(f'third_party/{name}'), 1)}"


@dataclasses.dataclass
class Shown:
    """Holes that the view shows."""

    hole_of: object  # the hole at an output, as hole.holes_of() has it
    measured: object = None  # report.measured.Measured: drawn over it


def view_of(run, fields, shown, room):
    """What a page has of the view, in at most so many bytes: {"outputs": sentence, "data": JSON, "scripts": texts}.

    @param shown  Shown
    @raises TooLarge"""
    scripts = [library("uPlot.iife.min.js"), view_script()]
    styles = [file_text(name) for name in ("third_party/uPlot.min.css", "page/view.css", "page/view.html")]
    room -= sum(len(text.encode()) for text in (*styles, *scripts)) + 1000
    with run.particles_read():
        scene, outputs = fitted(run, fields, run.depth_table(), shown, room)
    # Neither JSON, where markup is escaped, nor a script of ours has text that ends its element.
    return {"outputs": about_outputs(outputs, len(run.file.times)), "data": Markup(scene), "scripts": [Markup(text) for text in scripts]}


def explorable(page_of, run, fields, shown):
    """A page with the view; where the run is too large for one, with a sentence that says so.

    @param page_of  (view, sentence) to the text of a page
    @param shown  as view_of() has it"""
    try:
        return page_of(view_of(run, fields, shown, MOST_BYTES - len(page_of().encode())), "")
    except TooLarge:
        return page_of(None, f"This page has no view to explore: the run's {run.file.elements} particles do not fit into a page of 15 MB.")
