# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a channel: deformed particles at the last time of particles.e, pressure at the left and plastic strain at the right. In axisymmetry
the left half is the mirror image."""

import numpy as np
from matplotlib.collections import PolyCollection
from netCDF4 import Dataset, chartostring

PLASTIC_STRAIN = ("equivalent_plastic_strain", "plastic_strain")
MILLI, MICRO, MEGA = 1e-3, 1e-6, 1e6
PRESSURE_LABEL, PLASTIC_LABEL = "pressure [MPa]", "plastic strain [-]"


class Fields:
    """The last step of particles.e: corners of the particles that exist, and their variables."""

    def __init__(self, file):
        data = Dataset(file)
        data.set_auto_mask(False)
        self.time = float(data.variables["time_whole"][-1])
        elements = len(data.dimensions["num_elem"])
        x = data.variables["coordx"][:] + data.variables["vals_nod_var1"][-1]
        y = data.variables["coordy"][:] + data.variables["vals_nod_var2"][-1]
        corners = np.stack([x, y], axis=1).reshape(elements, -1, 2)
        self.names = [
            str(t).split("\0")[0].strip()
            for t in np.atleast_1d(chartostring(data.variables["name_elem_var"][:]))
        ]
        self.sizes = [
            len(data.dimensions[f"num_el_in_blk{b + 1}"])
            if f"num_el_in_blk{b + 1}" in data.dimensions
            else 0
            for b in range(len(data.dimensions["num_el_blk"]))
        ]
        self.data = data
        self.alive = self.variable("status") > 0.5
        self.corners = corners[self.alive]

    def variable(self, name):
        """Values of all elements; nan in blocks that do not carry it."""
        parts = []
        for b, size in enumerate(self.sizes):
            key = f"vals_elem_var{self.names.index(name) + 1}eb{b + 1}" if name in self.names else ""
            has = size > 0 and key in self.data.variables
            parts.append(self.data.variables[key][-1] if has else np.full(size, np.nan))
        return np.concatenate(parts)

    def of_alive(self, names):
        """The first of the names that each block has."""
        values = np.full(len(self.alive), np.nan)
        for name in names:
            found = self.variable(name)
            values = np.where(np.isnan(values), found, values)
        return values[self.alive]


def draw_half(axes, corners, values, colours, limits):
    if corners.shape[1] == 1:
        return axes.scatter(
            corners[:, 0, 0], corners[:, 0, 1], c=values, s=1, cmap=colours,
            vmin=limits[0], vmax=limits[1],
        )
    shapes = PolyCollection(corners, array=values, cmap=colours, edgecolors="none", linewidths=0)
    shapes.set_clim(*limits)
    # Lines between neighbours would show through the gaps of antialiasing.
    shapes.set_antialiased(False)
    axes.add_collection(shapes)
    return shapes


def areas_of(corners):
    if corners.shape[1] < 4:
        return np.ones(len(corners))
    first, second = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    return 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


def limits_of(values, areas, percent):
    """Colour range that leaves out 100 - percent of the picture at each end: a jet in pieces has single particles
    under thousands of times the pressure of the rock."""
    finite = np.isfinite(values)
    if not finite.any():
        return 0.0, 1.0
    order = np.argsort(values[finite])
    share = np.cumsum(areas[finite][order]) / areas[finite].sum()
    at = lambda part: values[finite][order][min(np.searchsorted(share, part), len(order) - 1)]
    lower, upper = min(0.0, at(1.0 - 0.01 * percent)), at(0.01 * percent)
    return lower, upper if upper > lower else lower + 1.0


def is_mirrored(summary):
    return summary.get("mode", "axisymmetric") == "axisymmetric"


def flies_up(summary):
    """Whether a jet flies along +y. It is drawn going down."""
    return summary.get("jet", {}).get("direction", -1.0) > 0.0


def size_of(fields, mirrored):
    """Width and height of the picture [mm]."""
    corners = fields.corners / MILLI
    return np.ptp(corners[:, :, 0]) * (2.0 if mirrored else 1.0), max(np.ptp(corners[:, :, 1]), 1e-12)


def draw_channel(left, right, fields, mirrored, inverted):
    """On two axes, or on one that is given twice.  @return what carries the colours of pressure and of plastic strain"""
    corners = fields.corners / MILLI
    pressure = fields.of_alive(["pressure"]) / MEGA
    plastic = fields.of_alive(PLASTIC_STRAIN)
    mirror = np.array([-1.0, 1.0]) if mirrored else np.ones(2)
    a = draw_half(left, corners * mirror, pressure, "viridis", limits_of(pressure, areas_of(corners), 99.0))
    # A block without plastic strain (elastic material) is drawn as zero.
    b = draw_half(right, corners, np.nan_to_num(plastic), "inferno", limits_of(plastic, areas_of(corners), 98.0))
    for one in {left, right}:
        one.set_facecolor("0.85")
        one.set_aspect("equal")
        one.set_xlabel("r [mm]" if mirrored else "x [mm]")
        one.set_ylabel("y [mm]")
        one.autoscale_view()
        if inverted:
            one.invert_yaxis()
    return a, b
