# SPDX-License-Identifier: BSD-3-Clause
"""Legends that cover no curve: in a corner that is free, else below the axes."""

import numpy as np
from matplotlib.collections import PathCollection

CORNERS = ("upper left", "upper right", "lower right", "lower left")
BELOW = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.18)}  # under the numbers and the name of the axis


def meets(axes, box):
    """Whether a curve, an area or a point of the axes is in a box of pixels."""
    for line in axes.lines:
        if line.get_visible() and line.get_transform().transform_path(line.get_path()).intersects_bbox(box, filled=False):
            return True
    for drawn in axes.collections:
        if isinstance(drawn, PathCollection):
            points = drawn.get_offset_transform().transform(drawn.get_offsets())
            if np.any([box.contains(x, y) for x, y in points]):
                return True
        elif any(drawn.get_transform().transform_path(path).intersects_bbox(box) for path in drawn.get_paths()):
            return True
    return False


def covers(axes):
    """Whether the legend of the axes lies on something that is drawn in them; after the figure has been laid out."""
    return axes.get_legend() is not None and meets(axes, axes.get_legend().get_window_extent())


def is_placed_inside(axes, **style):
    """In the first free corner as the figure is laid out now. @return whether there is one"""
    for corner in CORNERS:
        axes.legend(loc=corner, **style)
        if not covers(axes):
            return True
    return False


def place_legends(*panels, **style):
    """Of axes in one figure that have anything with a label: in a corner, else below the axes, where the layout makes room for it."""
    laid_out = False
    for axes in panels:
        if not axes.get_legend_handles_labels()[0]:
            continue
        if not laid_out:
            axes.figure.draw_without_rendering()
        laid_out = is_placed_inside(axes, **style)  # which takes no room
        if not laid_out:
            axes.legend(**BELOW, **style)
