# SPDX-License-Identifier: BSD-3-Clause
"""Depth against one or two parameters."""

from barreno.runs.pictures import colours_of, plt, save

MOST_CURVES = 8


class Axis:
    """Where the values of a parameter stand: numbers, or words in their order."""

    def __init__(self, label, numbers, texts):
        self.label, self.words = label, list(dict.fromkeys(texts)) if numbers is None else None
        self.places = [float(self.words.index(text)) for text in texts] if numbers is None else list(numbers)

    def mark(self, axes, which):
        getattr(axes, f"set_{which}label")(self.label)
        if self.words:
            getattr(axes, f"set_{which}ticks")(range(len(self.words)), self.words)


def draw_curves(axes, x, groups, depths):
    """@param groups  text of every point, which tells the curves apart"""
    names = list(dict.fromkeys(groups))
    for name, colour in zip(names, colours_of(len(names))):
        points = sorted((x.places[i], depths[i]) for i in range(len(depths)) if groups[i] == name)
        axes.plot(*zip(*points), "o-", ms=4, lw=1.2, color=colour, label=name)
    axes.set_ylabel("depth [mm]")
    if names != [""]:
        axes.legend(fontsize=8)


def draw_map(figure, axes, x, y, depths):
    shapes = axes.scatter(x.places, y.places, c=depths, cmap="viridis", s=45)
    y.mark(axes, "y")
    figure.colorbar(shapes, ax=axes, label="depth [mm]")


def draw_against(file, axes_of, labels, depths):
    """@param axes_of  one Axis or two  @param labels  of the second parameter, of every point  @param depths  [m]"""
    depths = [1e3 * depth for depth in depths]
    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    if len(axes_of) == 1:
        draw_curves(axes, axes_of[0], [""] * len(depths), depths)
    elif len(set(labels)) <= MOST_CURVES:
        draw_curves(axes, axes_of[0], labels, depths)
    else:
        draw_map(figure, axes, *axes_of, depths)
    axes_of[0].mark(axes, "x")
    axes.grid(alpha=0.3)
    save(figure, file)
