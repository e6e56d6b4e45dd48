# SPDX-License-Identifier: BSD-3-Clause
"""The hole: radius against depth from the shapes of particles, finer than cells.

Lines across the axis, eight per cell, find which lengths the target's particles cover. The wall of a row is where they cover half of a
window one cell wide and one cell high: for a sharp wall that is the wall itself, wherever it lies in its cell, and single particles that
fly through the hole do not move it. Expanded debris covers no more than it did as rock. depth.csv has the same measure from boxes along the
axes.
"""

import dataclasses
import functools

import numpy as np

LINES = 8  # per cell
ROWS = 2  # per cell
BINS = 16  # per cell, across
CHUNK = 4096  # lines at once
CLOSED = 0.25  # radius in cells below which a hole is closed


@dataclasses.dataclass
class Hole:
    cell: float  # [m]
    face: float  # y of the outer face
    depth: np.ndarray = dataclasses.field(repr=False)  # of the rows, from the face along the flight [m]
    radius: np.ndarray = dataclasses.field(repr=False)  # of the wall; inf where the target has none, 0 where it is closed [m]
    plane: bool  # a slot in plane strain instead of a round hole

    @property
    def first_row(self):
        """The first row that has a whole wall: at its rim a crater may be as wide as the target, and the next row is cut by the rim."""
        first = int(np.argmax(np.isfinite(self.radius)))
        return min(first + 1, len(self.radius) - 1) if first > 0 else 0

    @property
    def open_rows(self):
        """Rows from the face to where the hole is closed or leaves the target; a gap between bodies has no wall, and the hole goes on
        behind it."""
        walled = np.flatnonzero(np.isfinite(self.radius))
        last = walled[-1] if len(walled) else -1
        ended = (self.radius < CLOSED * self.cell) | (np.arange(len(self.radius)) > last)
        return int(np.argmax(ended)) if ended.any() else len(walled)

    @property
    def length(self):
        """Half-way between the last open row and the next [m]."""
        return (self.open_rows + 0.5) * self.cell / ROWS if self.open_rows else 0.0

    @property
    def entrance_diameter(self):
        return 2.0 * float(self.radius[self.first_row]) if self.open_rows else 0.0

    def diameter_below(self, depth):
        """In the first row with a whole wall below a depth; 0 where the hole does not reach it [m]."""
        rows = np.flatnonzero(np.isfinite(self.radius) & (self.depth >= depth + 0.5 * self.cell))
        return 2.0 * float(self.radius[rows[0]]) if len(rows) and rows[0] < self.open_rows else 0.0

    @property
    def volume(self):
        """Of a round hole [m3], or of a slot per thickness [m2]."""
        r = np.where(np.isfinite(self.radius), self.radius, 0.0)[: self.open_rows]
        areas = 2.0 * r if self.plane else np.pi * r**2
        # A row stands for what is around it; above the first one there is another half of a row.
        return float(np.sum(areas) + 0.5 * np.sum(areas[:1])) * self.cell / ROWS

    def radius_at(self, depth):
        walled = np.isfinite(self.radius) & (np.arange(len(self.radius)) >= self.first_row)
        return float(np.interp(depth, self.depth[walled], self.radius[walled]))


def crossings(shapes, lines):
    """Which lengths quadrangles cover on lines y = const: (line, from, to) of every pair that meets."""
    low, high = shapes[:, :, 1].min(axis=1), shapes[:, :, 1].max(axis=1)
    first, last = np.searchsorted(lines, low), np.searchsorted(lines, high)
    count = np.maximum(last - first, 0)
    of = np.repeat(np.arange(len(shapes)), count)
    line = np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    begin, end = shapes[of], np.roll(shapes, -1, axis=1)[of]
    y = lines[line][:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (y - begin[:, :, 1]) / (end[:, :, 1] - begin[:, :, 1])
        x = np.where((part >= 0.0) & (part <= 1.0), begin[:, :, 0] + part * (end[:, :, 0] - begin[:, :, 0]), np.nan)
    fine = np.isfinite(x).any(axis=1)
    return line[fine], np.nanmin(x[fine], axis=1), np.nanmax(x[fine], axis=1)


def covered_lengths(line, start, end, lines, bins, width):
    """Covered length up to every edge of the bins, (lines, bins + 1); what is covered twice counts once, to a bin."""
    slopes = np.zeros((lines, bins + 3))
    for at, sign in ((np.clip(start, 0.0, bins * width), 1.0), (np.clip(end, 0.0, bins * width), -1.0)):
        bin_of = np.minimum((at / width).astype(int), bins)
        part = at / width - bin_of
        np.add.at(slopes, (line, bin_of + 1), sign * (1.0 - part) * width)
        np.add.at(slopes, (line, bin_of + 2), sign * part * width)
    ramps = np.cumsum(np.cumsum(slopes, axis=1), axis=1)[:, : bins + 1]
    filled = np.minimum(np.diff(ramps, axis=1), width)
    return np.concatenate([np.zeros((lines, 1)), np.cumsum(filled, axis=1)], axis=1)


def wall_of(length, width, cell):
    """First radius at which half of a window one cell wide is covered, of lengths up to every edge of the bins; rows at once."""
    half = int(round(0.5 * cell / width))
    # The other side of the axis looks the same.
    whole = np.concatenate([-length[:, half:0:-1], length], axis=1)
    window = whole[:, 2 * half :] - whole[:, : -2 * half]
    reached = window >= 0.5 * cell
    found = reached.any(axis=1)
    at = np.argmax(reached, axis=1)
    rows = np.arange(len(window))
    before = window[rows, np.maximum(at - 1, 0)]
    step = np.where(at > 0, (0.5 * cell - before) / np.maximum(window[rows, at] - before, 1e-300), 1.0)
    return np.where(found, np.where(at > 0, (at - 1 + step) * width, 0.0), np.inf)


def from_behind_monitor(frame, deck):
    """Whether a particle starts on the near side of the monitor's plane, as charge and liner do; parts of gas that has been split are not
    there at the start."""
    start = frame.file.frame(0)
    shapes, of = start.shapes
    behind = np.ones(frame.file.elements, bool)
    behind[np.flatnonzero(start.alive)[of]] = deck.direction * (shapes[:, :, 1].mean(axis=1) - deck.number("Jet Monitor/Position")) < 0.0
    return behind[frame.alive]


def jet_particles(frame, deck):
    """Whether a particle belongs to the jet: of its material, and none of a body, which is there from the start. Of a run that forms its
    jet, what forms it too."""
    if deck.forms_jet:
        return from_behind_monitor(frame, deck)
    name = deck.text("Jet/Material")
    if name not in frame.file.block_names:
        return np.zeros(int(frame.alive.sum()), bool)
    of_jet = frame.block == frame.file.block_names.index(name)
    if name in deck.materials_of_bodies():
        of_jet &= ~(frame.file.frame(0).alive[frame.alive])
    return of_jet


def target_particles(frame, deck):
    """Whether a particle belongs to the target: to a solid that is not the jet."""
    names = frame.file.block_names
    liquids = [index for index, name in enumerate(names) if deck.text(f"Materials/{name}/Model") == "Liquid"]
    return ~jet_particles(frame, deck) & ~np.isin(frame.block, liquids)


def target_shapes(frame, deck):
    """Quadrangles of the target's particles; expanded ones shrunk to the area that they had as sound rock."""
    shapes, of = frame.shapes
    keep = target_particles(frame, deck)[of]
    ratio = np.maximum(np.nan_to_num(frame.of_alive(["volume_ratio"])[of][keep], nan=1.0), 1.0)
    shapes = shapes[keep]
    centre = shapes.mean(axis=1, keepdims=True)
    return centre + (shapes - centre) / np.sqrt(ratio)[:, None, None]


def cell_along_path(file, deck):
    """Size of the cells next to the axis, from the target's particles there at the start."""
    frame = file.frame(0)
    shapes, of = frame.shapes
    keep = target_particles(frame, deck)[of] if len(of) else np.zeros(0, bool)
    near = np.abs(shapes[keep][:, :, 0]).min(axis=1)
    width = np.ptp(shapes[keep][:, :, 0], axis=1)
    first = width[near <= near.min(initial=np.inf) + 1e-9]
    names = np.array(file.block_names, object)[frame.block[of][keep]]
    per_cell = max((count for name, count in deck.materials_of_bodies().items() if name in names), default=2)
    size, whole = float(np.median(first)) * per_cell if len(first) else float("nan"), deck.number("Grid/Cell Size")
    if not (size > 0.0 and whole > 0.0):
        return size if size > 0.0 else whole
    # Particles fit their body, so their size is that of a cell only nearly; refined cells are a half, a quarter, ...
    return whole * 2.0 ** round(np.log2(size / whole))


def face_of(table, file, deck):
    """y of the outer face, which depth.csv states; else the near end of the target at the start."""
    for line in table.comments if table is not None else ():
        if "outer face at y = " in line:
            return float(line.split("outer face at y = ")[1].split()[0])
    shapes, of = file.frame(0).shapes
    y = shapes[target_particles(file.frame(0), deck)[of]][:, :, 1]
    return float(y.min() if deck.direction > 0.0 else y.max())


def rear_of(file, deck, face):
    """Depth of the target's rear at the start: debris that flies behind it has no hole."""
    frame = file.frame(0)
    shapes, of = frame.shapes
    return float((deck.direction * (shapes[target_particles(frame, deck)[of]][:, :, 1] - face)).max(initial=0.0))


def rows_of(side, lines, bins, width, cell):
    """Radius of every row on one side of the axis, from shapes whose y is the depth and whose x counts from the axis."""
    lines_of = 0.5 * cell / LINES + cell / LINES * np.arange(lines)
    length = np.zeros((lines // (LINES // ROWS), bins + 1))
    low, high = side[:, :, 1].min(axis=1), side[:, :, 1].max(axis=1)
    for begin in range(0, lines, CHUNK):
        part = lines_of[begin : begin + CHUNK]
        inside = side[(high >= part[0]) & (low <= part[-1])]
        covered = covered_lengths(*crossings(inside, part), len(part), bins, width)
        group = LINES // ROWS
        length[begin // group : (begin + len(part)) // group] = covered.reshape(-1, group, bins + 1).mean(axis=1)
    # A row is half a cell apart from the next and a cell high.
    return wall_of(0.5 * (length[:-1] + length[1:]), width, cell)


def measure_hole(frame, deck, face):
    """The hole that the jet has left at the time of a frame."""
    cell = cell_along_path(frame.file, deck)
    shapes = target_shapes(frame, deck).copy()
    shapes[:, :, 1] = deck.direction * (shapes[:, :, 1] - face)
    end = min(float(shapes[:, :, 1].max(initial=cell)), max(cell, rear_of(frame.file, deck, face)))
    lines = LINES * max(2, int(np.ceil(end / cell)))
    widest = float(np.abs(shapes[:, :, 0]).max(initial=cell))
    width = cell / BINS
    bins = int(np.ceil(widest / width)) + BINS
    sides = [1.0] if shapes[:, :, 0].mean(axis=1).min(initial=0.0) > -0.25 * cell else [1.0, -1.0]
    radii = [rows_of(shapes * np.array([side, 1.0]), lines, bins, width, cell) for side in sides]
    radius = np.mean(radii, axis=0)
    depth = cell / ROWS * (1.0 + np.arange(len(radius)))
    return Hole(cell, face, depth, radius, deck.mode == "plane strain")


def holes_of(run, table):
    """The hole at an output, each measured once."""
    return functools.cache(lambda step: hole_at(run, table, run.file.frame(step)))


def hole_at(run, table, frame):
    """The hole at the time of a frame; None without depth.csv, and before the jet has hit."""
    if table is None or float(np.interp(frame.time, table["time"], table["depth"])) <= 0.0:
        return None
    return measure_hole(frame, run.deck, face_of(table, run.file, run.deck))
