# SPDX-License-Identifier: BSD-3-Clause
"""Curves of several runs."""

from barreno.runs.plots import plt

TOLD_APART = 10  # colours that the eye tells apart
MOST_LABELS = 24


def colours_of(count):
    if count <= TOLD_APART:
        return [f"C{i}" for i in range(count)]
    return [plt.get_cmap("viridis")(i / (count - 1)) for i in range(count)]


def save(figure, file, **more):
    figure.savefig(file, dpi=110, format="png", **more)
    plt.close(figure)


def add_legend(axes, count):
    """Beside the curves if they are many, and none of more labels than can be read."""
    if count <= TOLD_APART:
        axes.legend(fontsize=8)
    elif count <= MOST_LABELS:
        axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))


def draw_depths(file, series):
    """Depth against time.  @param series  [(label, times, depths)]"""
    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    for (label, time, depth), colour in zip(series, colours_of(len(series))):
        axes.plot(1e6 * time, 1e3 * depth, lw=1.3, color=colour, label=label)
    axes.set_xlabel("time [µs]")
    axes.set_ylabel("depth [mm]")
    add_legend(axes, len(series))
    axes.grid(alpha=0.3)
    save(figure, file)
