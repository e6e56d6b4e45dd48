# SPDX-License-Identifier: BSD-3-Clause
"""The page of a picture that lies: panels below each other, one scale above them and one below, all places in inches."""

from barreno.report.scales import BAR, fill_bar
from barreno.report.view import size_lying
from barreno.runs.plots import plt

LEFT, RIGHT, ABOVE, BELOW, BETWEEN = 0.8, 0.4, 1.0, 1.55, 0.75  # inches around panels
BAR_FROM, BAR_WIDE = 0.42, 0.56  # of the width of a panel: scales, beside the title or the legend


def lying_panels(frame, mirrored, view, count):
    """A figure with panels below each other, what draws a scale of one, and what draws the legend."""
    wide, tall = size_lying(frame, mirrored, view)
    width, height = LEFT + wide + RIGHT, BELOW + count * tall + (count - 1) * BETWEEN + ABOVE
    figure = plt.figure(figsize=(width, height))
    low = [BELOW + (count - 1 - number) * (tall + BETWEEN) for number in range(count)]
    panels = [figure.add_axes([LEFT / width, one / height, wide / width, tall / height]) for one in low]

    def bar(_, side, quads, label, mark):
        y = height - ABOVE + 0.2 if side == "left" else BELOW - 0.85
        place = figure.add_axes([(LEFT + BAR_FROM * wide) / width, y / height, BAR_WIDE * wide / width, 0.8 * BAR / height])
        fill_bar(figure, place, quads, label, "top" if side == "left" else "bottom", mark)

    def legend(handles):
        # To the left of the lower scale.
        figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(LEFT / width, (BELOW - 0.5) / height), ncols=2, fontsize=9,
            frameon=False, borderaxespad=0.0)

    return figure, panels, bar, legend
