# SPDX-License-Identifier: BSD-3-Clause
"""How the plane of a run lies on the paper: upright, or with the depth along the paper where it is long."""

import dataclasses

import numpy as np

MILLI = 1e-3
LONG = 1.6  # times as long as wide: such a picture lies
UPRIGHT, LYING, WIDEST = 9.0, 12.0, 13.0  # inches along y, and at most
WIDE, LEAST_WIDE = 3.5, 8.0  # median radii of the hole, and cells, that its own picture shows on each side of the axis
NARROW, STRETCH = 6.0, 3.0  # where the picture of the hole is so many times longer than wide, radii are drawn so many times larger
LEAST, MOST = 2.4, 7.5  # inches across a picture that lies


@dataclasses.dataclass
class View:
    """What a picture shows of the plane, and how."""

    box: tuple = None  # part of the plane over both halves in mm, (x, x, y, y); all that there is
    limits: tuple = (None, None)  # of the colours at the left and at the right, in the picture's units
    edges: bool = False  # borders of particles
    title: str = ""
    hole: object = None  # report.hole.Hole: its wall is drawn, and loose pieces in it are told from rock
    measured: object = None  # report.measured.Measured: a hole that was measured, drawn too
    stretch: float = 1.0  # how many times larger than along y lengths across it are


def hole_view(whole, deck):
    """The hole alone, and where it is long and narrow with its radii stretched; None where nothing is open."""
    hole = whole.hole
    walled = hole.radius[: hole.open_rows][np.isfinite(hole.radius[: hole.open_rows])]
    if not len(walled):
        return None
    across = max(WIDE * float(np.median(walled)), LEAST_WIDE * hole.cell)
    depths = -0.06 * hole.length - 4.0 * hole.cell, 1.1 * hole.length + 4.0 * hole.cell
    ends = [hole.face + deck.direction * depth for depth in depths]
    box = tuple(value / MILLI for value in (-across, across, min(ends), max(ends)))
    stretch = STRETCH if box[3] - box[2] > NARROW * (box[1] - box[0]) else 1.0
    title = f"radii {STRETCH:g} times larger than depths, " if stretch > 1.0 else ""
    return dataclasses.replace(whole, box=box, stretch=stretch, title=title)


def span_of(frame, mirrored, box=None):
    """(across, along y) of what is drawn, in mm."""
    if box is not None:
        return np.abs([box[1] - box[0], box[3] - box[2]])
    shapes, _ = frame.shapes
    span = np.ptp(shapes.reshape(-1, 2), axis=0) / MILLI
    return np.array([span[0] * (2.0 if mirrored else 1.0), max(span[1], 1e-9)])


def is_long(frame, mirrored, box=None):
    across, along = span_of(frame, mirrored, box)
    return bool(along > LONG * across)


def size_of(frame, mirrored, box=None, tall=UPRIGHT):
    """Inches of an upright panel: width, height."""
    across, along = span_of(frame, mirrored, box)
    wide = tall * across / along
    if wide > WIDEST:
        wide, tall = WIDEST, max(WIDEST * along / across, 2.0)
    return max(wide, 2.5), tall


def size_lying(frame, mirrored, view):
    """Inches of a panel with y along the paper: width, height."""
    across, along = span_of(frame, mirrored, view.box)
    tall = LYING * view.stretch * across / along
    return (LYING, tall) if tall >= LEAST else (LYING, max(tall, 1.2))


def placed(points, mirror=1.0, lying=False):
    """Points (..., xy) on the paper; mirror = -1: of the mirror image at x = 0."""
    points = points * np.array([mirror, 1.0])
    return points[..., ::-1] if lying else points
