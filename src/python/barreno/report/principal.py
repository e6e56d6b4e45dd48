# SPDX-License-Identifier: BSD-3-Clause
"""Principal stresses, compression positive: their invariants, the octahedral view, and which is which along a path."""

import itertools

import numpy as np

AXIS = np.ones(3) / np.sqrt(3.0)  # the hydrostat
# In the octahedral plane: the first principal stress upwards.
UP = np.array([2.0, -1.0, -1.0]) / np.sqrt(6.0)
ACROSS = np.array([0.0, 1.0, -1.0]) / np.sqrt(2.0)
APART = 0.01  # of the largest difference: principal stresses that are closer have no directions of their own


def principal(xx, yy, zz, xy):
    """Principal stresses of stresses in a plane and normal to it (tension positive): compression positive, largest first."""
    middle, radius = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), xy)
    return -np.sort(np.stack([middle + radius, middle - radius, zz], axis=-1), axis=-1)


def lode_angle(stress):
    """Degrees from triaxial compression (0) through pure shear (30) to triaxial extension (60), of sorted principal stresses."""
    first, second, third = np.moveaxis(stress, -1, 0)
    return np.degrees(np.arctan2(np.sqrt(3.0) * (second - third), 2.0 * first - second - third))


def pressure_and_shear(stress):
    """Mean stress and sqrt(J2)."""
    mean = stress.mean(axis=-1)
    return mean, np.sqrt(0.5 * np.sum((stress - mean[..., None]) ** 2, axis=-1))


def tensors(xx, yy, zz, xy, yz=0.0, zx=0.0):
    """Arrays of components as matrices."""
    xx, yy, zz, xy, yz, zx = np.broadcast_arrays(*map(np.asarray, (xx, yy, zz, xy, yz, zx)))
    return np.stack([np.stack(row, axis=-1) for row in ((xx, xy, zx), (xy, yy, yz), (zx, yz, zz))], axis=-2)


def turned_least(axes, values, vectors):
    """The principal axes that are nearest to older ones; stresses that hardly differ have a plane, or all of space, for their directions.

    @param values, vectors  in the order of the axes
    """
    gap, new = APART * np.ptp(values), np.empty_like(axes)
    alike = np.abs(values[:, None] - values) <= gap
    for axis in range(3):
        own = vectors[:, alike[axis]]
        new[:, axis] = own @ (own.T @ axes[:, axis])
    left, _, right = np.linalg.svd(new)
    return left @ right


def along_path(stress):
    """Principal stresses along a path, compression positive, each that whose direction is nearest to the one before; the first lie along x,
    y and z.

    @param stress  (time, 3, 3), tension positive
    """
    axes, found = np.eye(3), []
    for one in stress:
        values, vectors = np.linalg.eigh(-one)
        near = np.abs(axes.T @ vectors)
        order = list(max(itertools.permutations(range(3)), key=lambda turn: sum(near[axis, turn[axis]] for axis in range(3))))
        found.append(values[order])
        axes = turned_least(axes, values[order], vectors[:, order])
    return np.array(found)


def revolved(p, q, angles=73, shape=None):
    """The surface of a meridian (p, sqrt(J2)) of triaxial compression: three arrays (points, angles).

    @param shape  sqrt(J2) at a Lode angle in degrees over that in triaxial compression; 1 without
    """
    angle = np.linspace(0.0, 2.0 * np.pi, angles)
    along = np.sqrt(3.0) * p[:, None] * np.ones_like(angle)
    out = np.sqrt(2.0) * q[:, None] * (shape(lode_of_turn(angle)) if shape else 1.0)
    point = along[..., None] * AXIS + (out * np.cos(angle))[..., None] * UP + (out * np.sin(angle))[..., None] * ACROSS
    return np.moveaxis(point, -1, 0)


def lode_of_turn(angle):
    """Lode angle in degrees of a direction in the octahedral plane, so many radians from the first principal stress."""
    return np.abs((np.degrees(angle) + 60.0) % 120.0 - 60.0)
