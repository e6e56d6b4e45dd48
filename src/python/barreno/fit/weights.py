# SPDX-License-Identifier: BSD-3-Clause
"""Weights of curves: each channel by its own scatter, where its file says no uncertainty."""

import numpy
from scipy import stats

from barreno.fit.kinds import KINDS
from barreno.fit.search import EXACT, LEAST_SCALE, MANY

SURE = 0.01  # chance of a difference between channels that scatter alike, below which they are weighed apart
COMMON = 2.0  # degrees of freedom that the scatter of all channels adds to that of each, in logarithms: few rows say little
ROUNDS, STEADY = 3, 0.15  # of the scales: at most so many, until none changes by a larger part
LARGEST = 4.0  # of a scale, and its inverse the least: one channel must not be fitted exactly at the cost of all others


def unstated(tests):
    """(test, channel, its residuals as a slice) of the curves whose files do not say how uncertain they are."""
    out, at = [], 0
    for test in tests:
        for channel in test.channels:
            if KINDS[test.kind].curve and not test.stated:
                out.append((test, channel, slice(at, at + test.rows)))
            at += test.rows
    return out


def differ(variances, degrees):
    """Bartlett's test: the chance that channels of one variance look as unlike as these."""
    total = degrees.sum()
    pooled = (degrees * variances).sum() / total
    value = total * numpy.log(pooled) - (degrees * numpy.log(variances)).sum()
    value /= 1.0 + ((1.0 / degrees).sum() - 1.0 / total) / (3.0 * (len(degrees) - 1))
    return stats.chi2.sf(value, len(degrees) - 1)


def scales_of(search, z):
    """{(file, channel): scatter of a channel over the common one, the geometric mean}, or nothing where the channels scatter alike.

    The variance of a channel is sum r^2/(rows - their leverage); the leverage is the part of the rows that the parameters take up.
    """
    channels, r = unstated(search.tests), search.residuals(z)
    leverage = (numpy.linalg.qr(search.jacobian(z, r))[0] ** 2).sum(axis=1)
    degrees = numpy.array([rows.stop - rows.start - leverage[rows].sum() for _, _, rows in channels])
    squares = numpy.array([(r[rows] ** 2).sum() * test.scales.get(channel, 1.0) ** 2 for test, channel, rows in channels])
    if len(channels) < 2 or (degrees < 2.0).any() or squares.sum() <= LEAST_SCALE**2 * degrees.sum() or not (squares > 0.0).all():
        return {}
    variances = squares / degrees
    if differ(variances, degrees) > SURE:
        return {}
    own = numpy.log(variances)
    away = own - (degrees * own).sum() / degrees.sum()
    sizes = numpy.exp(0.5 * away * degrees / (COMMON + degrees)).clip(1.0 / LARGEST, LARGEST)
    return {(test.file, channel): float(size) for (test, channel, _), size in zip(channels, sizes)}


def weigh(search, found):
    """Gives each channel its scale where they scatter unlike, and goes on to the minimum with those weights; again, until the scales
    stay."""
    before = {}
    for _ in range(ROUNDS):
        scales = scales_of(search, found[2])
        if not scales or max(abs(numpy.log(scales[key] / before.get(key, 1.0))) for key in scales) < STEADY:
            break
        before = scales
        for test in search.tests:
            test.scales = {channel: scales[test.file, channel] for channel in test.channels if (test.file, channel) in scales}
        room = 1e-9
        best = search.descend(numpy.clip(found[2], search.low + room, search.high - room), EXACT, MANY)
        found = search.at(best.x), 2.0 * best.cost, best.x
    return found
