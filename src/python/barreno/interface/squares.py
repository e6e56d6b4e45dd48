# SPDX-License-Identifier: BSD-3-Clause
"""Values of particles on the squares of a regular grid."""

import numpy as np

LEAST, MOST = 4, 32  # parts of a particle's edge


def count_squares(shapes, spacing):
    """Of the box that holds all shapes, as a float."""
    return float(np.prod(np.ptp(shapes, axis=(0, 1)) / spacing + 1.0)) if len(shapes) else 0.0


def mean_on_squares(shapes, values, spacing):
    """Mean of a field over the material in each square.

    Every quadrangle is divided into n x n parts of equal reference area, at most a quarter of a square wide; a part counts with its area
    |dx/dr x dx/ds| / n^2 in the square that holds its centre. The error of a mean is that of the area along the edge of the square.

    Parameters
    ----------
    shapes : ndarray (particles, 4, 2)
        Corners in order around the quadrangle [m].
    values : ndarray (particles,)
    spacing : float
        Edge of the squares [m]; they begin at multiples of it.

    Returns
    -------
    x, y : ndarray
        Centres of the squares [m].
    means : ndarray (len(y), len(x))
        nan where there is no material with a value.
    """
    fine = np.isfinite(values)
    shapes, values = shapes[fine], values[fine]
    if not len(shapes):
        return np.empty(0), np.empty(0), np.empty((0, 0))
    low = np.floor(shapes.min(axis=(0, 1)) / spacing + 1e-9).astype(int)
    high = np.maximum(np.ceil(shapes.max(axis=(0, 1)) / spacing - 1e-9).astype(int), low + 1)
    wide, tall = high - low
    edge = np.median(np.ptp(shapes, axis=1).max(axis=1))
    parts = int(np.clip(np.ceil(4.0 * edge / spacing), LEAST, MOST))
    middles = (np.arange(parts) + 0.5) / parts
    area, total = np.zeros(wide * tall), np.zeros(wide * tall)
    a, b, c, d = (shapes[:, i] for i in range(4))
    for s in middles:
        for r in middles:
            centre = (1 - s) * ((1 - r) * a + r * b) + s * ((1 - r) * d + r * c)
            along, across = (1 - s) * (b - a) + s * (c - d), (1 - r) * (d - a) + r * (c - b)
            weight = np.abs(along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]) / parts**2
            column, row = np.clip(np.floor(centre / spacing).astype(int) - low, 0, [wide - 1, tall - 1]).T
            np.add.at(area, row * wide + column, weight)
            np.add.at(total, row * wide + column, weight * values)
    means = np.full(wide * tall, np.nan)
    np.divide(total, area, out=means, where=area > 0.0)
    return spacing * (np.arange(*(low[0], high[0])) + 0.5), spacing * (np.arange(low[1], high[1]) + 0.5), means.reshape(tall, wide)
