# SPDX-License-Identifier: BSD-3-Clause
"""The wall of the hole as a thin smooth line in pictures of the channel."""

import numpy as np

from barreno.report.view import placed

MILLI = 1e-3
MEASURED = "#ff00aa"  # unlike all colours of fields and materials
BESIDE = 1.5  # cells around the wall
WINDOW, SHARE = 5, 0.02  # rows, or a share of them where that is more: the line is their median, so that torn pieces make no spikes


def smooth_wall(hole):
    """(depth, radius) of the open rows, closed at the bottom; the line only, no measure is taken from it."""
    rows = hole.open_rows
    radius = np.where(np.isfinite(hole.radius[:rows]), hole.radius[:rows], np.nan)
    half = max(WINDOW, int(SHARE * rows)) // 2
    middle = np.median(np.lib.stride_tricks.sliding_window_view(np.pad(radius, half, mode="edge"), 2 * half + 1), axis=1)
    depth = np.concatenate([hole.depth[:rows], [hole.length]])
    return depth, np.concatenate([middle, [0.0]])


def at_wall(hole, deck):
    """What says whether a place (x, y) in mm is in the hole or near its wall, where the wall's own line is enough."""
    depth, radius = smooth_wall(hole)

    def near(x, y):
        down = deck.direction * (y * MILLI - hole.face)
        reach = np.interp(down, depth, np.nan_to_num(radius) + BESIDE * hole.cell, left=-1.0, right=-1.0)
        return np.abs(x) * MILLI < reach

    return near


def draw_wall(axes, hole, deck, mirrors, lying):
    if hole.open_rows < WINDOW:
        return
    depth, radius = smooth_wall(hole)
    y = hole.face + deck.direction * depth
    for mirror in (1.0, -1.0) if deck.mirrored() else (mirrors[0], -mirrors[0]):
        line = placed(np.stack([radius, y], axis=1) / MILLI, mirror, lying).T
        axes.plot(*line, color="w", lw=1.6, solid_joinstyle="round")
        axes.plot(*line, color="k", lw=0.6, solid_joinstyle="round")


def draw_measured(axes, view, deck, lying):
    """A measured hole as dashes on both sides of the axis."""
    y = view.hole.face + deck.direction * view.measured.depth
    for mirror in (1.0, -1.0):
        line = placed(np.stack([view.measured.radius, y], axis=1) / MILLI, mirror, lying).T
        axes.plot(*line, color=MEASURED, lw=1.4, ls=(0, (4, 2)))
