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
from barreno.report.scales import arrows_of
from barreno.report.view import LYING, NARROW, STRETCH, View, is_long, size_lying, size_of, span_of
from barreno.runs.faults import BadRun, NothingToDraw
from barreno.runs.pictures import save
from barreno.runs.plots import plt

TALL, LEAST, MOST, WIDEST = 4.2, 1.5, 6.0, 14.0  # of a channel, and of the picture [in]
MARGIN, ABOVE = 0.6, 0.55  # in, beside a channel, and above and below one that lies
AHEAD = 0.3  # of the length of the hole: rock behind it that is shown
MILLI = 1e-3
LONGEST_LINE, LETTERS = 24, 15  # letters over a channel that stands, and an inch over one that lies
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


@dataclasses.dataclass
class Layout:
    """How the channels stand, or lie with their depth along the paper."""

    lying: bool
    panels: int  # of a run: one for both fields, or one for each where x = 0 is no mirror
    wide: float  # of a channel [in]
    tall: float
    columns: int
    stretch: float = 1.0  # how many times larger than depths radii are drawn

    def lines(self, count):
        return -(-count // self.columns)

    def figure(self, count):
        """@return the figure, and the axes of every place of the matrix"""
        lines, across, down = self.lines(count), 1 if self.lying else self.panels, self.panels if self.lying else 1
        figure, axes = plt.subplots(down * lines, across * self.columns, figsize=(self.wide * self.columns + (0.0 if self.lying else 2.0),
            self.tall * lines + (2.0 if self.lying else 0.0)), squeeze=False, layout="constrained")
        return figure, axes, [axes[down * line : down * (line + 1), across * column : across * (column + 1)].ravel()
            for line in range(lines) for column in range(self.columns)]


def layout_of(channels, mirrored, box, columns):
    frames, panels = [channel.frame for channel in channels if channel], 1 if mirrored else 2
    if any(is_long(frame, mirrored, box) for frame in frames):
        spans = [span_of(frame, mirrored, box) for frame in frames]
        stretch = STRETCH if any(along > NARROW * across for across, along in spans) else 1.0
        tall = max(size_lying(frame, mirrored, View(box=box, stretch=stretch))[1] for frame in frames)
        columns = columns or 1
        return Layout(True, panels, LYING / columns + MARGIN, panels * (tall / columns + ABOVE), columns, stretch)
    sizes = [size_of(frame, mirrored, box) for frame in frames]
    wide = panels * min(MOST, max(LEAST, TALL * max(width / height for width, height in sizes))) + MARGIN
    tall = min(TALL, (wide - MARGIN) / panels * max(height / width for width, height in sizes)) + 1.0
    return Layout(False, panels, wide, tall, columns or min(len(channels), max(1, int(WIDEST / wide))))


def title_of(row, frame, layout):
    depth = row.depth()
    words = f"{1e3 * depth:.1f} mm at {time_text(frame.time)}" if depth else time_text(frame.time)
    if layout.lying:
        larger = f", radii {layout.stretch:g} times larger than depths" if layout.stretch > 1.0 else ""
        return "\n".join(textwrap.wrap(f"{row.label}: {words}{larger}", int(LETTERS * layout.wide)))
    wrap = textwrap.TextWrapper(LONGEST_LINE, break_long_words=False, break_on_hyphens=False).wrap
    return "\n".join([*(line for part in row.label.split(", ") for line in wrap(part)), words])


def draw_one(axes, row, channel, layout, box):
    """Pressure at the left or above, and plastic strain at the right or below. @return what carries the colours, and the labels"""
    left, right = axes[0], axes[-1]
    frame, deck = channel.frame, channel.deck
    plastic = next((name for name in PLASTIC_STRAIN if name in frame.names), PLASTIC_STRAIN[0])
    shapes = [
        draw_half(left, frame, deck, Half("pressure", -1.0 if layout.panels == 1 else 1.0, pieces=channel.pieces, lying=layout.lying)),
        draw_half(right, frame, deck, Half(plastic, 1.0, pieces=channel.pieces, lying=layout.lying)),
    ]
    for one in {left, right}:
        set_up(one, deck, layout.lying, layout.stretch)
        set_limits(one, frame, deck, box, layout.lying)
        one.tick_params(labelsize=8)
        for axis in (one.xaxis, one.yaxis):
            axis.label.set_size(9)
        one.label_outer()
    left.set_title(title_of(row, frame, layout), fontsize=9, loc="left" if layout.lying else "center")
    return shapes


def share_colours(figure, axes, halves, side):
    """One range for all runs.  @param halves  [(what carries the colours, label)]"""
    shapes, (label, *_) = zip(*halves)
    limits = [one.get_clim() for one in shapes]
    for one in shapes:
        one.set_clim(min(low for low, _ in limits), max(high for _, high in limits))
    lying = side in ("top", "bottom")
    scale = figure.colorbar(shapes[0], ax=axes, location=side, shrink=0.6 if lying else 0.8 / len(axes), aspect=40 if lying else 30,
        pad=0.02, extend=arrows_of(*shapes))
    scale.set_label(label, size=9)
    scale.ax.tick_params(labelsize=8)
    scale.solids.set_edgecolor("face")


def pieces_in(channels):
    """Patches of the pieces that any picture shows in a colour of their own."""
    kinds = (("jet", JET, "jet"), ("rubble", RUBBLE, "loose pieces in the hole"))
    return [Patch(color=colour, label=label) for name, colour, label in kinds
        if any(channel and getattr(channel.pieces, name).any() for channel in channels)]


def draw_channels(file, rows, columns):
    """@return sentences on runs that are not in the picture"""
    channels, remarks = read_all(rows)
    if not any(channels):
        raise NothingToDraw("no run has a particles.e that can be read")
    mirrored = all(channel.deck.mirrored() for channel in channels if channel)
    box = box_of(channels, mirrored)
    layout = layout_of(channels, mirrored, box, columns)
    figure, axes, places = layout.figure(len(rows))
    halves = []
    for i, place in enumerate(places):
        if i < len(rows) and channels[i]:
            halves.append(draw_one(place, rows[i], channels[i], layout, box))
            continue
        for one in place:
            one.set_axis_off()
    handles = pieces_in(channels)
    if handles:
        figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, fontsize=9, frameon=False)
    for side, of_side in zip(("top", "bottom") if layout.lying else ("left", "right"), zip(*halves)):
        share_colours(figure, axes, of_side, side)
    save(figure, file, bbox_inches="tight")  # labels of the scales reach beyond the axes
    return remarks
