# SPDX-License-Identifier: BSD-3-Clause
"""Scales of the colours: bars beside, above or below a picture, with a line at the value of the start."""

import numpy as np
from matplotlib.colors import LogNorm

from barreno.report.particles import areas_of
from barreno.report.hole import jet_particles
from barreno.report.fields import values_of
from barreno.runs.plots import plain_log

BAR, BAR_GAP = 0.22, 0.95  # inches: a bar of colours, and room for the numbers and the name of an axis beside it
MOST_TICKS = 8
ROUND_OFF = 1e-9  # of a range of colours
ALIKE = 0.02  # of the range of the colours: a body whose values at the start differ by less has one initial value


def initial_value(file, deck, name):
    """(value in SI, spread, material): area-weighted median at the start in the body with the largest area that carries the field; None
    where nothing does."""
    start = file.frame(0)
    shapes, of = start.shapes
    values, areas = values_of(start, deck, name)[of], areas_of(shapes)
    known = np.isfinite(values) & ~jet_particles(start, deck)[of]
    if not known.any():
        return None
    blocks = start.block[of]
    block = max(np.unique(blocks[known]), key=lambda one: areas[known & (blocks == one)].sum())
    own = known & (blocks == block)
    order = np.argsort(values[own])
    share = np.cumsum(areas[own][order]) / areas[own].sum()
    low, middle, high = (float(values[own][order][min(np.searchsorted(share, part), len(order) - 1)]) for part in (0.05, 0.5, 0.95))
    return middle, high - low, file.block_names[block]


def mark_of(file, deck, name, quads, look):
    """The initial value where the scale has a place for one, in the picture's unit; else None."""
    if look.doubling:
        return None
    found, (low, high) = initial_value(file, deck, name), quads.get_clim()
    if found is None or found[1] / look.scale > ALIKE * (high - low):
        return None
    value = found[0] / look.scale
    return value if low <= value <= high else None


def doubling_values(quads):
    """The values of a field that is coloured by logarithms, for its bar; none of other fields, and of too many."""
    if not isinstance(quads.norm, LogNorm):
        return []
    # Of steps, ends of a run's intervals leave values that differ in their last digits.
    values = sorted({float(f"{value:.3g}") for value in np.unique(quads.get_array())})
    return values if len(values) <= MOST_TICKS else []


def arrows_of(*drawn):
    """Ends of a bar that have an arrow, as Matplotlib's extend: those beyond which a picture has a value. Plastic strain has none below
    zero.

    @param drawn  what carries the colours, all with the same range"""
    low, high = drawn[0].get_clim()
    slack = ROUND_OFF * max(abs(low), abs(high))
    values = [one.get_array() for one in drawn if len(one.get_array())]
    below = any(float(one.min()) < low - slack for one in values)
    above = any(float(one.max()) > high + slack for one in values)
    return {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]


def draw_mark(place, mark, upright):
    line = place.axhline if upright else place.axvline
    line(mark, color="k", lw=2.6)
    line(mark, color="w", lw=1.2)


def fill_bar(figure, place, quads, label, side, mark=None):
    """A bar of colours in axes of its own; its numbers at a side of it."""
    upright, values = side in ("left", "right"), doubling_values(quads)
    words = label if mark is None else f"{label} (line: initial value {float(f'{mark:.3g}') + 0.0:g})"  # no minus before a zero
    bar = figure.colorbar(quads, cax=place, label=words, extend="neither" if len(values) else arrows_of(quads),
        orientation="vertical" if upright else "horizontal")
    axis = place.yaxis if upright else place.xaxis
    if len(values):
        bar.set_ticks(values, labels=[f"{value:.3g}" for value in values])
        bar.minorticks_off()
    elif isinstance(quads.norm, LogNorm):
        plain_log(axis)
    axis.set_ticks_position(side)
    axis.set_label_position(side)
    bar.solids.set_edgecolor("face")
    if mark is not None:
        draw_mark(place, mark, upright)


def bar_beside(figure, axes, quads, label, side, wide, mark=None):
    """A bar at the left or the right of axes that are so many inches wide."""
    at = -(BAR_GAP + BAR) / wide if side == "left" else 1.0 + 0.5 * BAR / wide
    fill_bar(figure, axes.inset_axes([at, 0.2, BAR / wide, 0.6]), quads, label, side, mark)
