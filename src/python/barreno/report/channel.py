# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the channel: particles in their deformed shapes, a field on one side of the axis and another on the other. A long picture
lies: depth runs along the paper, and the field of the left is above the axis."""

import dataclasses

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter

from barreno.report.fields import look_in, norm_of, range_of, values_of
from barreno.report.lying_page import lying_panels
from barreno.report.outline import draw_outline
from barreno.report.particles import areas_of
from barreno.report.pieces import Pieces, carried, pieces_of
from barreno.report.scales import bar_beside, mark_of
from barreno.report.tones import JET, RUBBLE, VOID, WITHOUT, tones_of
from barreno.report.view import View, is_long, placed, size_of
from barreno.report.wall import MEASURED, at_wall, draw_measured, draw_wall
from barreno.runs.plots import plt

MILLI, MICRO = 1e-3, 1e-6
WHOLE, CLOSE = 98.5, 96.0  # percent of the area that the colours tell apart, of all and of a part


@dataclasses.dataclass
class Half:
    """A field on one side of the axis."""

    field: str
    mirror: float  # -1: drawn as the mirror image
    limits: tuple = None  # of the colours, in the picture's unit; as the particles have it unless given
    pieces: Pieces = None  # drawn in their own colours, where the field is none that is looked at in the jet
    lying: bool = False


def draw_edges(axes, shapes):
    """Thin borders of particles; debris drawn out into needles would become a tangle of lines."""
    long = np.linalg.norm(np.ptp(shapes, axis=1), axis=1)
    compact = shapes[long < 3.5 * np.sqrt(areas_of(shapes))]
    axes.add_collection(PolyCollection(compact, facecolors="none", edgecolors="0.35", linewidths=0.2, rasterized=True))


def draw_plain(axes, shapes, colour):
    """Quadrangles in one colour."""
    # Lines between neighbours would show through the gaps of antialiasing.
    axes.add_collection(PolyCollection(shapes, facecolors=colour, edgecolors="none", linewidths=0, antialiased=False, rasterized=True))


def draw_quads(axes, shapes, values, colours, norm, edges=False):
    """Quadrangles in the colours of their values; grey where there is none.

    @param norm  of Matplotlib, from values to colours; one of logarithms leaves out what is not positive
    """
    known = np.isfinite(values) & (values > 0.0) if isinstance(norm, LogNorm) else np.isfinite(values)
    draw_plain(axes, shapes[~known], WITHOUT)
    quads = PolyCollection(shapes[known], array=values[known], cmap=colours, norm=norm, edgecolors="none", linewidths=0, antialiased=False,
        rasterized=True)
    axes.add_collection(quads)
    if edges:
        draw_edges(axes, shapes)
    return quads


def inside(shapes, box):
    """Whether the centre of a quadrangle is in a box (x, x, y, y) in mm, or its mirror image is."""
    if box is None:
        return np.ones(len(shapes), bool)
    x, y = shapes.mean(axis=1).T / MILLI
    return (np.abs(x) <= max(abs(box[0]), abs(box[1]))) & (box[2] <= y) & (y <= box[3])


def draw_half(axes, frame, deck, half, box=None, edges=False):
    """The particles of a frame in the colours of a field; coordinates in mm. @return what a colour bar needs, and its label"""
    look = look_in(frame.file, deck, half.field)
    shapes, of = frame.shapes
    values = values_of(frame, deck, half.field)[of] / look.scale
    plain = np.zeros(len(of), bool) if half.pieces is None or carried(half.field) else half.pieces.apart
    seen = inside(shapes, box) & ~plain
    limits = half.limits or range_of(values[seen], areas_of(shapes[seen]), look, WHOLE if box is None else CLOSE)
    on_paper = placed(shapes / MILLI, half.mirror, half.lying)
    quads = draw_quads(axes, on_paper[~plain], values[~plain], look.colours, norm_of(look, limits), edges)
    if plain.any():
        draw_plain(axes, on_paper[half.pieces.rubble & plain], RUBBLE)
        draw_plain(axes, on_paper[half.pieces.jet & plain], JET)
    return quads, look.label


def draw_outlines(axes, frame, deck, mirrors, width=0.8, seen=None):
    """Border of every material; where pieces are told apart, neither the jet nor rubble has one. @return the lines of a legend"""
    shapes, of = frame.shapes
    blocks, tones, legend = frame.block[of], tones_of(deck, frame.file.block_names), []
    pieces, hole = seen and seen.pieces, seen and seen.view.hole
    for block in np.unique(blocks):
        name = frame.file.block_names[block]
        own = (blocks == block) & ~(pieces.apart if pieces else np.zeros(len(of), bool))
        if not own.any():
            continue
        is_jet = name == deck.text("Jet/Material")
        for mirror in mirrors:
            draw_outline(axes, shapes[own] / MILLI, mirror, deck.mirrored(), crumbs=is_jet, lying=bool(seen and seen.lying),
                hidden=at_wall(hole, deck) if hole is not None and not is_jet else None, colors=tones[name], linewidths=width)
        legend.append(Line2D([], [], color=tones[name], lw=1.8, label=f"jet ({name})" if is_jet else name))
    return legend


def measured_line(view):
    return [Line2D([], [], color=MEASURED, lw=1.4, ls=(0, (4, 2)), label=f"measured ({view.measured.name})")] if view.measured else []


def handles_of(lines, pieces, deck, fields):
    """Patches of the pieces, lines of the bodies; a jet that has the colours of both fields is a line."""
    if all(carried(field) for field in fields):
        return lines
    jet_name = f"jet ({deck.text('Jet/Material')})"
    jet = [Patch(color=JET, label=jet_name)] if pieces.jet.any() else []
    rubble = [Patch(color=RUBBLE, label="loose pieces in the hole")] if pieces.rubble.any() else []
    return [*jet, *rubble, *(line for line in lines if not jet or line.get_label() != jet_name)]


def set_up(axes, deck, lying=False, stretch=1.0):
    axes.set_aspect(stretch if lying else 1.0 / stretch)
    axes.set_facecolor(VOID)
    across, along = (axes.yaxis, axes.xaxis) if lying else (axes.xaxis, axes.yaxis)
    across.set_label_text("r [mm]" if deck.mode == "axisymmetric" else "x [mm]")
    along.set_label_text("y [mm]")
    if deck.mode == "axisymmetric":
        across.set_major_formatter(FuncFormatter(lambda value, _: f"{abs(value):g}"))


def set_limits(axes, frame, deck, box=None, lying=False):
    """All that there is, or a box (x, x, y, y) in mm; a jet is drawn going down, or to the right where the picture lies."""
    if box is None:
        axes.autoscale_view()
    elif lying:
        axes.set(xlim=box[2:], ylim=box[:2])
    else:
        axes.set(xlim=box[:2], ylim=box[2:])
    if lying:
        axes.yaxis.set_inverted(True)
        axes.xaxis.set_inverted(deck.has_jet and deck.direction < 0.0)
    elif deck.has_jet and deck.direction > 0.0 and not axes.yaxis_inverted():
        axes.invert_yaxis()


def time_text(time):
    unit, scale = next(((unit, scale) for unit, scale in (("s", 1.0), ("ms", 1e-3)) if abs(time) >= 0.9999 * scale), ("µs", MICRO))
    return f"{time / scale:.4g} {unit}"


@dataclasses.dataclass
class Seen:
    """A view of one frame, with what is found of it once for both halves."""

    view: View
    pieces: Pieces
    lying: bool


def draw_panel(axes, frame, deck, halves, seen):
    """@return [(what a colour bar needs, label, mark)] of the halves, and the lines of a legend"""
    view, drawn = seen.view, []
    for half in halves:
        quads, label = draw_half(axes, frame, deck, half, view.box, view.edges)
        drawn.append((quads, label, mark_of(frame.file, deck, half.field, quads, look_in(frame.file, deck, half.field))))
    set_up(axes, deck, seen.lying, view.stretch)
    mirrors = (-1.0, 1.0) if deck.mirrored() else (1.0,)
    told = Seen(view, None if any(carried(half.field) for half in halves) else seen.pieces, seen.lying)
    lines = draw_outlines(axes, frame, deck, mirrors, 0.8 if view.edges else 0.6, told)
    if view.hole is not None:
        draw_wall(axes, view.hole, deck, mirrors, seen.lying)
    if view.measured is not None:
        draw_measured(axes, view, deck, seen.lying)
    if deck.mirrored():
        (axes.axhline if seen.lying else axes.axvline)(0.0, color="k", lw=0.5, ls=(0, (8, 4)))
    set_limits(axes, frame, deck, view.box, seen.lying)
    return drawn, lines


def upright_panels(frame, mirrored, view, count):
    """A figure with panels side by side, and the width and height of one in inches."""
    wide, tall = size_of(frame, mirrored, view.box)
    figure, grid = plt.subplots(1, count, figsize=(count * wide + 2.7, tall + 0.6), squeeze=False, layout="constrained")

    def bar(number, side, quads, label, mark):
        bar_beside(figure, grid[0, number], quads, label, side, wide, mark)

    def legend(handles):
        drop = 0.55 / tall  # half an inch below the axes, whatever their height
        grid[0, 0].legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -drop), ncols=min(len(handles), 3), fontsize=9,
            frameon=False)

    return figure, list(grid[0]), bar, legend


def draw_channel(frame, deck, left, right, view=None):
    """The figure: mirrored halves where there is an axis, else the two fields beside each other."""
    view, mirrored = view or View(), deck.mirrored()
    lying = is_long(frame, mirrored, view.box)
    seen = Seen(view, pieces_of(frame, deck, view.hole), lying)
    halves = [Half(field, mirror, limits, seen.pieces, lying)
        for field, mirror, limits in zip((left, right), (-1.0 if mirrored else 1.0, 1.0), view.limits)]
    figure, panels, bar, legend = (lying_panels if lying else upright_panels)(frame, mirrored, view, 1 if mirrored else 2)
    of_panels = [halves] if mirrored else [[half] for half in halves]
    drawn, lines = [], []
    for axes, own in zip(panels, of_panels):
        found, lines = draw_panel(axes, frame, deck, own, seen)
        drawn += found
    for number, (side, (quads, label, mark)) in enumerate(zip(("left", "right"), drawn)):
        if side == "right" or not mirrored or left != right:  # one bar serves two equal halves
            bar(0 if mirrored else number, side, quads, label, mark)
    handles = [*handles_of(lines, seen.pieces, deck, (left, right)), *measured_line(view)]
    if handles:
        legend(handles)
    panels[0].set_title(f"{view.title}t = {time_text(frame.time)}", loc="left" if lying else "center")
    return figure
