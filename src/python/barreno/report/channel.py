# SPDX-License-Identifier: BSD-3-Clause
"""Picture of the channel: particles in their deformed shapes, a field at the left and another at the right of the axis."""

import dataclasses

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D

from barreno.report.fields import look_of, range_of, values_of
from barreno.report.outline import draw_outline
from barreno.report.particles import areas_of
from barreno.runs.plots import plain_log, plt

MILLI, MICRO = 1e-3, 1e-6
WITHOUT = "0.75"  # colour of a material that does not carry the field
VOID = "#e3ebf1"  # unlike the ends and the middles of the colours
WHOLE, CLOSE = 98.5, 96.0  # percent of the area that the colours tell apart, of all and of a part
MOST_TICKS = 8
JET = "#d62728"
BAR, BAR_GAP = 0.22, 0.95  # inches: a bar of colours, and room for the numbers and the name of an axis beside it
BODY_LINES = ("black", "#7a3b00", "#005f73", "#5a189a", "#386641")


@dataclasses.dataclass
class Half:
    """A field on one side of the axis."""

    field: str
    mirror: float  # -1: drawn as the mirror image
    limits: tuple = None  # of the colours, in the picture's unit; as the particles have it unless given


def draw_edges(axes, shapes):
    """Thin borders of particles; debris drawn out into needles would become a tangle of lines."""
    long = np.linalg.norm(np.ptp(shapes, axis=1), axis=1)
    compact = shapes[long < 3.5 * np.sqrt(areas_of(shapes))]
    axes.add_collection(PolyCollection(compact, facecolors="none", edgecolors="0.35", linewidths=0.2, rasterized=True))


def draw_quads(axes, shapes, values, colours, limits, edges=False, doubling=False):
    """Quadrangles in the colours of their values, or of their logarithms (Look.doubling); grey where there is none."""
    known = np.isfinite(values) & (values > 0.0) if doubling else np.isfinite(values)
    # Lines between neighbours would show through the gaps of antialiasing.
    plain = {"edgecolors": "none", "linewidths": 0, "antialiased": False, "rasterized": True}
    axes.add_collection(PolyCollection(shapes[~known], facecolors=WITHOUT, **plain))
    quads = PolyCollection(shapes[known], array=values[known], cmap=colours, **plain)
    if doubling:
        quads.set_norm(LogNorm(*limits))
    quads.set_clim(*limits)
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
    look = look_of(half.field)
    shapes, of = frame.shapes
    values = values_of(frame, deck, half.field)[of] / look.scale
    seen = inside(shapes, box)
    limits = half.limits or range_of(values[seen], areas_of(shapes[seen]), look, WHOLE if box is None else CLOSE)
    return draw_quads(axes, shapes / MILLI * np.array([half.mirror, 1.0]), values, look.colours, limits, edges, look.doubling), look.label


def line_of(frame, deck, block):
    """(colour, label) of a block's outline; the jet is red."""
    name = frame.file.block_names[block]
    if name == deck.text("Jet/Material"):
        return JET, f"jet ({name})"
    bodies = [b for b, other in enumerate(frame.file.block_names) if other != deck.text("Jet/Material")]
    return BODY_LINES[bodies.index(block) % len(BODY_LINES)], name


def draw_outlines(axes, frame, deck, mirrors, width=0.8):
    """Border of every material. @return the lines of a legend"""
    shapes, of = frame.shapes
    legend = []
    for block in np.unique(frame.block[of]):
        colour, label = line_of(frame, deck, int(block))
        for mirror in mirrors:
            draw_outline(axes, shapes[frame.block[of] == block] / MILLI, mirror, deck.mirrored(), crumbs=colour == JET, colors=colour,
                linewidths=width)
        legend.append(Line2D([], [], color=colour, lw=1.5, label=label))
    return legend


def set_up(axes, deck):
    axes.set_aspect("equal")
    axes.set_facecolor(VOID)
    axes.set_xlabel("r [mm]" if deck.mode == "axisymmetric" else "x [mm]")
    axes.set_ylabel("y [mm]")


def set_limits(axes, frame, deck, box=None):
    """All that there is, or a box (x, x, y, y) in mm; a jet is drawn going down."""
    if box is None:
        axes.autoscale_view()
    else:
        axes.set(xlim=box[:2], ylim=box[2:])
    if deck.has_jet and deck.direction > 0.0 and not axes.yaxis_inverted():
        axes.invert_yaxis()


def doubling_values(quads):
    """The values of a field that is coloured by logarithms, for its bar; none of other fields, and of too many."""
    if not isinstance(quads.norm, LogNorm):
        return []
    # Of steps, ends of a run's intervals leave values that differ in their last digits.
    values = sorted({float(f"{value:.3g}") for value in np.unique(quads.get_array())})
    return values if len(values) <= MOST_TICKS else []


def draw_bar(figure, axes, quads, label, side, wide):
    """A bar of colours at a side of axes that are so many inches wide."""
    at = -(BAR_GAP + BAR) / wide if side == "left" else 1.0 + 0.5 * BAR / wide
    place = axes.inset_axes([at, 0.2, BAR / wide, 0.6])
    values = doubling_values(quads)
    bar = figure.colorbar(quads, cax=place, label=label, extend="neither" if len(values) else "both")
    if len(values):
        bar.set_ticks(values, labels=[f"{value:.3g}" for value in values])
        bar.minorticks_off()
    elif isinstance(quads.norm, LogNorm):
        plain_log(place.yaxis)
    place.yaxis.set_ticks_position(side)
    place.yaxis.set_label_position(side)
    bar.solids.set_edgecolor("face")


def size_of(frame, mirrored, box=None, tall=9.0):
    """Inches of what is drawn: width of a panel, height."""
    shapes, _ = frame.shapes
    span = np.ptp(shapes.reshape(-1, 2), axis=0) if box is None else np.abs([box[1] - box[0], box[3] - box[2]])
    width, height = span[0] * (2.0 if mirrored and box is None else 1.0), max(span[1], 1e-12)
    wide = tall * width / height
    if wide > 13.0:
        wide, tall = 13.0, max(13.0 * height / width, 2.0)
    return max(wide, 2.5), tall


def time_text(time):
    unit, scale = next(((unit, scale) for unit, scale in (("s", 1.0), ("ms", 1e-3)) if abs(time) >= 0.9999 * scale), ("µs", MICRO))
    return f"{time / scale:.4g} {unit}"


def draw_channel(frame, deck, left, right, box=None, limits=(None, None), edges=False, title=""):
    """The figure: mirrored halves where there is an axis, else the two fields side by side.

    @param box     part of the plane in mm, (x, x, y, y), over both halves
    @param limits  of the colours at the left and at the right, in the picture's units
    """
    mirrored = deck.mirrored()
    wide, tall = size_of(frame, mirrored, box)
    count = 1 if mirrored else 2
    figure, grid = plt.subplots(1, count, figsize=(count * wide + 2.7, tall + 0.6), squeeze=False, layout="constrained")
    panels = [grid[0, 0], grid[0, -1]]
    halves = (Half(left, -1.0 if mirrored else 1.0, limits[0]), Half(right, 1.0, limits[1]))
    for axes, half, side in zip(panels, halves, ("left", "right")):
        quads, label = draw_half(axes, frame, deck, half, box, edges)
        if side == "right" or not mirrored or left != right:  # one bar serves two equal halves
            draw_bar(figure, axes, quads, label, side, wide)
    legend = []
    for axes in {id(one): one for one in panels}.values():
        set_up(axes, deck)
        legend = draw_outlines(axes, frame, deck, (-1.0, 1.0) if mirrored else (1.0,), 0.9 if edges else 0.6)
        set_limits(axes, frame, deck, box)
    if mirrored:
        panels[0].axvline(0.0, color="k", lw=0.5, ls=(0, (8, 4)))
    if legend:
        drop = 0.55 / tall  # half an inch below the axes, whatever their height
        panels[0].legend(handles=legend, loc="upper center", bbox_to_anchor=(0.5, -drop), ncols=min(len(legend), 3), fontsize=9,
            frameon=False)
    panels[0].set_title(f"{title}t = {time_text(frame.time)}")
    return figure
