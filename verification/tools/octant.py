# SPDX-License-Identifier: BSD-3-Clause
"""Axisymmetric decks of a ball about the origin, turned into its Cartesian octant."""
import numpy as np
from tools.manufactured_runs import centres


def octant(body, side, cell):
    """Settings for the octant in a cube of `side` [m] with cells of `cell` [m]; the planes x = 0 and y = 0 are the deck's own
    conditions, z = 0 is added."""
    origin = "{0 m, 0 m, 0 m}"
    return {
        "Grid/Mode": "3D",
        "Grid/Lower": origin,
        "Grid/Upper": "{" + ", ".join([f"{side!r} m"] * 3) + "}",
        "Grid/Cell Size": repr(cell),
        f"Bodies/{body}/Centre": origin,
        "Conditions/Third plane/Face": "z_lower",
        "Conditions/Third plane/Kind": "symmetry",
    }


def radii(particles):
    """Distance of the particles from the origin, and the directions there; two components in axisymmetry."""
    x = np.array(centres(particles))
    r = np.sqrt(np.sum(x**2, axis=0))
    return r, x / r


def radial_stress(particles, n):
    """n . sigma . n"""
    total = n[0] ** 2 * particles["stress_xx"] + n[1] ** 2 * particles["stress_yy"] + 2 * n[0] * n[1] * particles["stress_xy"]
    if len(n) == 3:
        total = total + n[2] ** 2 * particles["stress_zz"]
        total = total + 2 * n[2] * (n[1] * particles["stress_yz"] + n[0] * particles["stress_zx"])
    return total


def along(particles, n):
    """Velocity along n."""
    return sum(direction * particles[f"velocity_{axis}"] for direction, axis in zip(n, "xyz"))
