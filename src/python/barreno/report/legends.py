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
    """Whether the legend of the axes lies on something that is drawn in them; after the figure has been drawn."""
    return axes.get_legend() is not None and meets(axes, axes.get_legend().get_window_extent())


def place_legend(axes, **style):
    """In the first free corner as the figure is laid out now, else below the axes, where a layout makes room for it."""
    figure = axes.figure
    for corner in CORNERS:
        axes.legend(loc=corner, **style)
        figure.draw_without_rendering()
        if not covers(axes):
            return
    axes.legend(**BELOW, **style)


def place_legends(*panels, **style):
    """Of axes in one figure that have anything with a label."""
    for axes in panels:
        if axes.get_legend_handles_labels()[0]:
            place_legend(axes, **style)
