# SPDX-License-Identifier: BSD-3-Clause
"""The channels of several runs side by side, each drawn as in the report of a run, with the same colours for the same values."""

import dataclasses
import textwrap

import numpy as np
from matplotlib.patches import Patch

from barreno.report.channel import Half, draw_half, set_limits, set_up, time_text
from barreno.report.deck import Deck, read_deck
from barreno.report.fields import PLASTIC_STRAIN
from barreno.report.files import reading
from barreno.report.hole import face_of, jet_particles, measure_hole
from barreno.report.particles import Frame, ParticleFile
from barreno.report.pieces import Pieces, pieces_of
from barreno.report.tones import JET, RUBBLE
from barreno.report.view import size_of
from barreno.runs.faults import BadRun, NothingToDraw
from barreno.runs.pictures import save
from barreno.runs.plots import plt

TALL, LEAST, MOST, WIDEST = 4.2, 1.5, 6.0, 14.0  # of a channel, and of the picture [in]
MARGIN = 0.6  # in, beside a channel
AHEAD = 0.3  # of the length of the hole: rock behind it that is shown
MILLI = 1e-3
LONGEST_LINE = 24  # letters over a channel
LONGEST_REASON = 200
UNREADABLE = (BadRun, OSError, ArithmeticError, AttributeError, LookupError, MemoryError, RuntimeError, TypeError, ValueError)


@dataclasses.dataclass
class Channel:
    """The end of a run."""

    frame: Frame
    deck: Deck
    pieces: Pieces  # jet and rubble, in their own colours as in a report


def read_channel(folder):
    frame = ParticleFile(folder / "particles.e").frame()
    if len(frame.corners) == 0:
        raise ValueError("its last step has no particle")
    deck = checked_deck(folder / "deck.xml")
    hole = measure_hole(frame, deck, face_of(None, frame.file, deck)) if deck.has_jet else None
    return Channel(frame, deck, pieces_of(frame, deck, hole))


def checked_deck(file):
    """A deck that was changed by hand may have words for the numbers that a picture needs."""
    deck = read_deck(file)
    with reading(file):
        deck.materials_of_bodies()
        deck.mirrored()
        deck.slugs()
    return deck


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
            remarks.append(f"channels.png lacks {row.label}, because {row.folder} cannot be drawn ({why}).")
    return found, remarks


def reach_of(channel):
    """(least x, largest x, face of everything, end of what is shown) along the jet's direction, in m: rock far behind the hole is left
    out."""
    frame, deck = channel.frame, channel.deck
    shapes, of = frame.shapes
    along = deck.direction * shapes[:, :, 1]
    near, far, jet = float(along.min()), float(along.max()), jet_particles(frame, deck)[of]
    tip = float(along[jet].max()) if jet.any() else far
    left, right = float(shapes[:, :, 0].min()), float(shapes[:, :, 0].max())
    return left, right, near, min(far, max(tip + AHEAD * (tip - near), near + right - left))


def box_of(channels, mirrored):
    """(x, x, y, y) in mm that holds the channels of all runs; None without a jet."""
    known = [channel for channel in channels if channel]
    if not all(channel.deck.has_jet for channel in known) or len({channel.deck.direction for channel in known}) > 1:
        return None
    left, right, near, far = np.array([reach_of(channel) for channel in known]).T
    ends = sorted(known[0].deck.direction * value / MILLI for value in (near.min(), far.max()))
    return (-right.max() / MILLI if mirrored else left.min() / MILLI, right.max() / MILLI, *ends)


def shape_of(channels, mirrored, box, columns):
    """Width of a channel in inches, rows and columns of the matrix."""
    sizes = [size_of(channel.frame, mirrored, box) for channel in channels if channel]
    panels = 1 if mirrored else 2
    wide = panels * min(MOST, max(LEAST, TALL * max(width / height for width, height in sizes))) + MARGIN
    columns = columns or min(len(channels), max(1, int(WIDEST / wide)))
    return wide, -(-len(channels) // columns), columns


def title_of(row, frame):
    depth = row.depth()
    words = f"{1e3 * depth:.1f} mm at {time_text(frame.time)}" if depth else time_text(frame.time)
    wrap = textwrap.TextWrapper(LONGEST_LINE, break_long_words=False, break_on_hyphens=False).wrap
    return "\n".join([*(line for part in row.label.split(", ") for line in wrap(part)), words])


def draw_one(axes, row, channel, mirrored, box):
    """Pressure at the left and plastic strain at the right. @return what carries the colours, and the labels"""
    left, right = axes[0], axes[-1]
    frame, deck = channel.frame, channel.deck
    plastic = next((name for name in PLASTIC_STRAIN if name in frame.names), PLASTIC_STRAIN[0])
    shapes = [
        draw_half(left, frame, deck, Half("pressure", -1.0 if mirrored else 1.0, pieces=channel.pieces)),
        draw_half(right, frame, deck, Half(plastic, 1.0, pieces=channel.pieces)),
    ]
    for one in {left, right}:
        set_up(one, deck)
        set_limits(one, frame, deck, box)
        one.tick_params(labelsize=8)
        for axis in (one.xaxis, one.yaxis):
            axis.label.set_size(9)
        one.label_outer()
    left.set_title(title_of(row, frame), fontsize=9)
    return shapes


def share_colours(figure, axes, halves, side):
    """One range for all runs.  @param halves  [(what carries the colours, label)]"""
    shapes, (label, *_) = zip(*halves)
    limits = [one.get_clim() for one in shapes]
    for one in shapes:
        one.set_clim(min(low for low, _ in limits), max(high for _, high in limits))
    scale = figure.colorbar(shapes[0], ax=axes, location=side, shrink=0.8 / len(axes), aspect=30, pad=0.02, extend="both")
    scale.set_label(label, size=9)
    scale.ax.tick_params(labelsize=8)
    scale.solids.set_edgecolor("face")


def draw_channels(file, rows, columns):
    """@return sentences on runs that are not in the picture"""
    channels, remarks = read_all(rows)
    if not any(channels):
        raise NothingToDraw("no run has a particles.e that can be read")
    mirrored = all(channel.deck.mirrored() for channel in channels if channel)
    panels = 1 if mirrored else 2
    box = box_of(channels, mirrored)
    wide, lines, columns = shape_of(channels, mirrored, box, columns)
    figure, axes = plt.subplots(lines, panels * columns, figsize=(wide * columns + 2.0, (TALL + 1.0) * lines), squeeze=False,
        layout="constrained")
    halves = []
    for i in range(lines * columns):
        place = axes[i // columns, panels * (i % columns) : panels * (i % columns + 1)]
        if i < len(rows) and channels[i]:
            halves.append(draw_one(place, rows[i], channels[i], mirrored, box))
            continue
        for one in place:
            one.set_axis_off()
    if any(channel and channel.deck.has_jet for channel in channels):
        handles = [Patch(color=JET, label="jet"), Patch(color=RUBBLE, label="loose pieces in the hole")]
        figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, fontsize=9, frameon=False)
    for side, of_side in zip(("left", "right"), zip(*halves)):
        share_colours(figure, axes, of_side, side)
    save(figure, file, bbox_inches="tight")  # labels of the scales reach beyond the axes
    return remarks
