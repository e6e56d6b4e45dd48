# SPDX-License-Identifier: BSD-3-Clause
"""The channels of several runs side by side, each drawn as in the report of a run, with the same colours for the same values."""

import dataclasses
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from barreno_report.channel import Half, draw_half, set_limits, set_up, size_of, time_text  # noqa: E402
from barreno_report.deck import Deck, read_deck  # noqa: E402
from barreno_report.exodus_sets import as_one_file  # noqa: E402
from barreno_report.fields import PLASTIC_STRAIN  # noqa: E402
from barreno_report.particles import Frame, ParticleFile  # noqa: E402
from barreno_runs.faults import BadRun, NothingToDraw  # noqa: E402
from barreno_runs.pictures import save  # noqa: E402

TALL, LEAST, MOST, WIDEST = 3.6, 1.8, 6.0, 14.0  # of a channel, and of the picture [in]
LONGEST_LINE = 24  # letters over a channel
LONGEST_REASON = 200
UNREADABLE = (BadRun, OSError, ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError, ValueError)


@dataclasses.dataclass
class Channel:
    """The end of a run."""

    frame: Frame
    deck: Deck


def read_channel(folder):
    with as_one_file(folder / "particles.e") as file:
        frame = ParticleFile(file).frame()
        if len(frame.corners) == 0:
            raise ValueError("its last step has no particle")
    return Channel(frame, read_deck(folder / "deck.xml"))


def read_all(rows):
    """[Channel or None] and sentences on what cannot be read."""
    found, remarks = [], []
    for row in rows:
        found.append(None)
        if not row.scalars:
            continue
        try:
            found[-1] = read_channel(row.folder)
        except UNREADABLE as error:
            why = " ".join(str(error).split())[:LONGEST_REASON]
            remarks.append(f"channels.png lacks {row.label}, because {row.folder / 'particles.e'} cannot be read ({why}).")
    return found, remarks


def shape_of(channels, mirrored, columns):
    """Width of a channel in inches, rows and columns of the matrix."""
    sizes = [size_of(channel.frame, mirrored) for channel in channels if channel]
    panels = 1 if mirrored else 2
    wide = panels * min(MOST, max(LEAST, TALL * max(width / height for width, height in sizes))) + 0.2
    columns = columns or min(len(channels), max(1, int(WIDEST / wide)))
    return wide, -(-len(channels) // columns), columns


def title_of(row, frame):
    depth = row.depth()
    words = f"{1e3 * depth:.1f} mm at {time_text(frame.time)}" if depth else time_text(frame.time)
    return "\n".join([*(line for part in row.label.split(", ") for line in textwrap.wrap(part, LONGEST_LINE)), words])


def draw_one(axes, row, channel, mirrored):
    """Pressure at the left and plastic strain at the right. @return what carries the colours, and the labels"""
    left, right = axes[0], axes[-1]
    frame, deck = channel.frame, channel.deck
    plastic = next((name for name in PLASTIC_STRAIN if name in frame.names), PLASTIC_STRAIN[0])
    shapes = [draw_half(left, frame, deck, Half("pressure", -1.0 if mirrored else 1.0)), draw_half(right, frame, deck, Half(plastic, 1.0))]
    for one in {left, right}:
        set_up(one, deck)
        set_limits(one, frame, deck)
        one.tick_params(labelsize=6)
        one.label_outer()
    left.set_title(title_of(row, frame), fontsize=8)
    return shapes


def share_colours(figure, axes, halves, side):
    """One range for all runs.  @param halves  [(what carries the colours, label)]"""
    shapes, (label, *_) = zip(*halves)
    limits = [one.get_clim() for one in shapes]
    for one in shapes:
        one.set_clim(min(low for low, _ in limits), max(high for _, high in limits))
    scale = figure.colorbar(shapes[0], ax=axes, location=side, label=label, shrink=0.6 / len(axes), aspect=30, pad=0.02, extend="both")
    scale.ax.tick_params(labelsize=7)
    scale.solids.set_edgecolor("face")


def draw_channels(file, rows, columns):
    """@return sentences on runs that are not in the picture"""
    channels, remarks = read_all(rows)
    if not any(channels):
        raise NothingToDraw("no run has a particles.e that can be read")
    mirrored = all(channel.deck.mirrored() for channel in channels if channel)
    panels = 1 if mirrored else 2
    wide, lines, columns = shape_of(channels, mirrored, columns)
    figure, axes = plt.subplots(lines, panels * columns, figsize=(wide * columns + 2.0, (TALL + 0.6) * lines), squeeze=False, layout="constrained")
    halves = []
    for i in range(lines * columns):
        place = axes[i // columns, panels * (i % columns) : panels * (i % columns + 1)]
        if i < len(rows) and channels[i]:
            halves.append(draw_one(place, rows[i], channels[i], mirrored))
            continue
        for one in place:
            one.set_axis_off()
    for side, of_side in zip(("left", "right"), zip(*halves)):
        share_colours(figure, axes, of_side, side)
    save(figure, file, bbox_inches="tight")  # labels of the scales reach beyond the axes
    return remarks
