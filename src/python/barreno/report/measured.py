# SPDX-License-Identifier: BSD-3-Clause
"""A measured hole: radius against depth."""

import dataclasses

import numpy as np

from barreno.runs.faults import FILE, Fault


@dataclasses.dataclass
class Measured:
    """Rows of a hole that was measured; between two of them it is a cone."""

    name: str  # of its file
    depth: np.ndarray  # below the outer face, growing [m]
    radius: np.ndarray  # [m]
    end: float  # depth of its bottom [m]

    @property
    def start(self):
        return float(self.depth[0])

    def radius_at(self, depth):
        return np.interp(depth, self.depth, self.radius)

    def cones_below(self, start):
        """Height and the two radii of every cone below a depth; behind the last row there is a cylinder to the end."""
        keep, first = self.depth > start, max(start, self.start)
        depth = np.concatenate([[first], self.depth[keep], [self.end]])
        radius = np.concatenate([[self.radius_at(first)], self.radius[keep], self.radius[-1:]])
        return np.diff(depth), radius[:-1], radius[1:]

    def volume_below(self, start):
        """Sum of pi h/3 (r1^2 + r1 r2 + r2^2) [m3]."""
        high, one, other = self.cones_below(start)
        return float(np.sum(np.pi * high / 3.0 * (one**2 + one * other + other**2)))

    def area_below(self, start):
        """Of a slot whose half width the radius is, per thickness [m2]."""
        high, one, other = self.cones_below(start)
        return float(np.sum(high * (one + other)))


def fault(file, what):
    """@param file  path of a measurement"""
    return Fault(f"--measured {file.name} {what}", FILE)
