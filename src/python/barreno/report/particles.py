# SPDX-License-Identifier: BSD-3-Clause
"""particles.e: the particles that exist at a time, with their shapes, sizes and fields."""

import functools

import numpy as np
from netCDF4 import chartostring

from barreno.runs.exodus_sets import open_whole

# Corners of a particle of size 2 x 2 whose file gives no shape.
SQUARE = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
CUT = 1e-3  # of the smallest particle: how far a cut lies from a plane of symmetry, so that it meets particles and not their faces


def names_in(data, key):
    if key not in data.variables:
        return []
    return [str(text).split("\0")[0].strip() for text in np.atleast_1d(chartostring(data.variables[key][:]))]


class ParticleFile:
    """The file or the set of files, open: its times, blocks of materials and names of fields."""

    def __init__(self, file):
        self.data = open_whole(file)
        dimensions = self.data.dimensions
        self.times = np.array(self.data.variables["time_whole"][:], float)
        self.elements = len(dimensions["num_elem"])
        self.dimensions = len(dimensions["num_dim"]) if "num_dim" in dimensions else 2
        self.names = names_in(self.data, "name_elem_var")
        blocks = range(1, len(dimensions["num_el_blk"]) + 1)
        self.sizes = [len(dimensions[f"num_el_in_blk{b}"]) if f"num_el_in_blk{b}" in dimensions else 0 for b in blocks]
        self.block_names = names_in(self.data, "eb_names") or [f"block {b}" for b in blocks]
        self.block = np.repeat(np.arange(len(self.sizes)), self.sizes)
        self.start = [self.data.variables[f"coord{axis}"][:] for axis in "xyz"[: self.dimensions]]

    def close(self):
        self.data.close()

    def frame(self, step=-1):
        return Frame(self, step if step >= 0 else len(self.times) + step)

    def fields(self, block=None):
        """Names of the fields that a block carries, or any block."""
        blocks = [block] if block is not None else range(len(self.sizes))
        return [name for i, name in enumerate(self.names, 1) if any(f"vals_elem_var{i}eb{b + 1}" in self.data.variables for b in blocks)]

    @functools.cached_property
    def numbers(self):
        """Numbers of the elements, which ParaView shows as their global ids; the same of a particle in every run of its deck."""
        known = self.data.variables.get("elem_num_map")
        return np.arange(1, self.elements + 1) if known is None else np.array(known[:])

    def series(self, name, element):
        """Values of one element at all times; nan in a block that does not carry them."""
        block = int(self.block[element])
        key = f"vals_elem_var{self.names.index(name) + 1}eb{block + 1}" if name in self.names else ""
        if key not in self.data.variables:
            return np.full(len(self.times), np.nan)
        return np.array(self.data.variables[key][:, element - sum(self.sizes[:block])], float)

    def track(self, element):
        """(time, axis): the centre of an element at all times."""
        nodes = len(self.start[0]) // self.elements
        own = slice(element * nodes, (element + 1) * nodes)
        return np.stack([start[own].mean() + self.data.variables[f"vals_nod_var{axis}"][:, own].mean(axis=1)
            for axis, start in enumerate(self.start, 1)], axis=-1)

    def radius(self):
        """Half of the size at the start of particles that the file has as plain points; nan without."""
        parts = [self.data.variables.get(f"attrib{b}") for b in range(1, len(self.sizes) + 1)]
        return np.concatenate([np.full(size, np.nan) if part is None else np.ravel(part[:])[:size]
            for part, size in zip(parts, self.sizes)])


class Frame:
    """One time of the file. Arrays have an entry for each particle that exists then."""

    def __init__(self, file, step):
        self.file, self.step = file, step
        self.time = float(file.times[step])
        self.names, self.sizes = file.names, file.sizes
        self.alive = self.variable("status") > 0.5
        self.block = file.block[self.alive]

    def variable(self, name):
        """Values of all elements; nan in blocks that do not carry it."""
        parts = []
        for b, size in enumerate(self.sizes):
            key = f"vals_elem_var{self.names.index(name) + 1}eb{b + 1}" if name in self.names else ""
            has = size > 0 and key in self.file.data.variables
            parts.append(self.file.data.variables[key][self.step] if has else np.full(size, np.nan))
        return np.concatenate(parts)

    def of_alive(self, names):
        """The first of the names that each block has."""
        values = np.full(len(self.alive), np.nan)
        for name in names:
            found = self.variable(name)
            values = np.where(np.isnan(values), found, values)
        return values[self.alive]

    @functools.cached_property
    def corners(self):
        """(particle, corner, axis) in m; one corner, the centre, where the file has plain points."""
        moved = [
            start + self.file.data.variables[f"vals_nod_var{axis}"][self.step] for axis, start in enumerate(self.file.start, 1)
        ]
        return np.stack(moved, axis=1).reshape(self.file.elements, -1, len(moved))[self.alive]

    @functools.cached_property
    def centres(self):
        return self.corners.mean(axis=1)

    @functools.cached_property
    def shapes(self):
        """Quadrangles in the plane of the picture, (shape, corner, xy), and the particle of each: all particles in two dimensions, in
        three those that a plane just inside the least z cuts, halfway between their faces."""
        corners = self.corners
        if corners.shape[1] == 1:
            return self.squares(), np.arange(len(corners))
        if corners.shape[2] == 2:
            return corners, np.arange(len(corners))
        z = corners[:, :, 2]
        thin = float(np.ptp(z, axis=1).min(initial=1.0))
        cut = z.min(initial=0.0) + CUT * thin if z.min(initial=0.0) >= -0.1 * thin else 0.0
        found = np.flatnonzero((z.min(axis=1) <= cut) & (z.max(axis=1) > cut))
        return 0.5 * (corners[found, :4, :2] + corners[found, 4:, :2]), found

    def squares(self):
        """Plain points as squares of their volume."""
        half = self.file.radius()[self.alive] * np.clip(np.nan_to_num(self.of_alive(["volume_ratio"]), nan=1.0), 0.0,
            4.0) ** (1.0 / self.file.dimensions)
        if np.isnan(half).any():
            area = np.prod(np.ptp(self.centres[:, :2], axis=0)) if len(half) else 0.0
            half = np.where(np.isnan(half), 0.5 * np.sqrt(area / max(len(half), 1)), half)
        return self.centres[:, None, :2] + half[:, None, None] * SQUARE


def offsets(centres, point):
    """(across, along): how far places are from a point (x, y), which in three dimensions lies in z = 0: distance across the y axis, and
    difference along it."""
    across = np.hypot(centres[:, 0] - point[0], centres[:, 2] if centres.shape[1] == 3 else 0.0)
    return across, centres[:, 1] - point[1]


def areas_of(shapes):
    """Areas of quadrangles."""
    first, second = shapes[:, 2] - shapes[:, 0], shapes[:, 3] - shapes[:, 1]
    return 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
