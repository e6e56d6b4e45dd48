# SPDX-License-Identifier: BSD-3-Clause
"""Outlines of bodies: the border of what their particles cover."""

import numpy as np
from matplotlib.collections import PolyCollection

from barreno.runs.plots import plt

MOST_PIXELS = 1500  # along an edge of the picture
SMOOTH = 2  # pixels, a third of a particle, on both sides: window of the border


def covered(shapes, box, pixels):
    """Whether particles cover a pixel, (rows from below, columns)."""
    figure = plt.figure(figsize=(pixels[0] / 100.0, pixels[1] / 100.0), dpi=100)
    axes = figure.add_axes([0.0, 0.0, 1.0, 1.0])
    axes.set(xlim=(box[0], box[1]), ylim=(box[2], box[3]))
    axes.axis("off")
    axes.add_collection(PolyCollection(shapes, facecolors="k", edgecolors="none", linewidths=0, snap=False))
    figure.canvas.draw()
    dark = np.asarray(figure.canvas.buffer_rgba())[::-1, :, 0] < 128
    plt.close(figure)
    return dark


def grown(mask):
    """With the eight pixels around each."""
    wide = np.pad(mask, 1)
    rows = wide[:-2] | wide[1:-1] | wide[2:]
    return rows[:, :-2] | rows[:, 1:-1] | rows[:, 2:]


def without_gaps(mask, times):
    """Grown and shrunk again: gaps between particles of torn rock are no border."""
    wide = np.pad(mask, times + 1, mode="edge")
    for _ in range(times):
        wide = grown(wide)
    for _ in range(times):
        wide = ~grown(~wide)
    return wide[times + 1 : -times - 1, times + 1 : -times - 1]


def smoothed(mask, times):
    """Share of a mask in a window of 2*times + 1 pixels, along rows and then along columns: its contour at a half has no steps."""
    for axis in (0, 1):
        wide = np.pad(mask.astype(float), [(times + 1, times) if one == axis else (0, 0) for one in (0, 1)], mode="edge")
        sums = np.cumsum(wide, axis=axis)
        after, before = (np.take(sums, np.arange(mask.shape[axis]) + shift, axis=axis) for shift in (2 * times + 1, 0))
        mask = (after - before) / (2 * times + 1)
    return mask


def border_of(shapes, axis, crumbs):
    """(x, y, share): what the border is a contour of; None where nothing is covered."""
    size = float(np.median(np.ptp(shapes[:, :, 0], axis=1)))
    lower, upper = shapes.min(axis=(0, 1)), shapes.max(axis=(0, 1))
    pixel = max(size / 6.0, float((upper - lower).max()) / MOST_PIXELS, 1e-12)
    counts = np.maximum(np.ceil((upper - lower) / pixel).astype(int), 2) + 8
    left = 0.0 if axis else lower[0] - 4 * pixel
    box = (left, left + counts[0] * pixel, lower[1] - 4 * pixel, lower[1] - 4 * pixel + counts[1] * pixel)
    mask = without_gaps(covered(shapes, box, counts), 3)
    if not crumbs:
        mask = ~without_gaps(~mask, 3)
    if not mask.any():
        return None
    rows, columns = mask.shape
    x = box[0] + (np.arange(columns) + 0.5) * (box[1] - box[0]) / columns
    y = box[2] + (np.arange(rows) + 0.5) * (box[3] - box[2]) / rows
    return x, y, smoothed(mask, SMOOTH)


def draw_outline(axes, shapes, mirror, axis, crumbs=True, lying=False, hidden=None, **line):
    """The border of quadrangles, mirror = -1 of their mirror image, +1 of themselves; with y along the paper where they lie. With an axis
    at x = 0 the body goes on beyond it and has no border there; without crumbs, what is one particle wide has none.

    @param hidden  (x, y): where no border is drawn; everywhere it is, unless given
    """
    found = border_of(shapes, axis, crumbs) if len(shapes) else None
    if found is None:
        return
    x, y, share = found
    if hidden is not None:
        share = np.where(hidden(*np.meshgrid(x, y)), np.nan, share)
    across = (y, mirror * x, share.T) if lying else (mirror * x, y, share)
    axes.contour(*across, levels=[0.5], **line)
