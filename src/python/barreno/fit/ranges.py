# SPDX-License-Identifier: BSD-3-Clause
"""What the data say of each parameter: a 95 % range by linearisation and by profile likelihood."""

from dataclasses import dataclass

import numpy
from scipy import stats

from barreno.fit.kinds import KINDS
from barreno.fit.parameters import PARAMETERS, unseen
from barreno.fit.profiles import Better, grown
from barreno.fit.search import LEAST_SCALE, residuals_of

LARGEST_RHO = 0.98
TRIALS = 6  # of an end
FIRST, OPEN = 0.5, 2.0  # widths of an open range: the first trial is no further, and no trial beyond the second
NEAR = 0.06  # of the root of the growth at an end, at which it is one
AT_BOUND = 0.02  # of the width of an open range: nearer to a bound a parameter stands at it


def correlation(tests, parts):
    """Of neighbouring residuals of curves: 0 for scatter, near 1 where the model's shape misses."""
    products = squares = 0.0
    at = iter(parts)
    for test in tests:
        for _ in test.channels:
            r = next(at)
            if KINDS[test.kind].curve:
                products += float((r[1:] * r[:-1]).sum())
                squares += float((r**2).sum())
    return min(max(products / squares, 0.0), LARGEST_RHO) if squares > 0.0 else 0.0


@dataclass
class Spread:
    """At the solution z: 95 % half widths in what the optimiser sees (half), the same as if residuals scattered (decided), how the other
    parameters go along with each (along[:, i]), the sum of squares and how much it may grow within a range (growth)."""

    half: numpy.ndarray
    decided: numpy.ndarray
    along: numpy.ndarray
    slopes: numpy.ndarray  # J
    squares: float
    growth: float
    rho: float


def spread_of(search, z):
    """Linearised ranges.

    half = t s sqrt(c diag (J^T J)^-1), s^2 = sum r^2/(m - n), c = (1 + rho)/(1 - rho); t of Student with m/c - n degrees of freedom (1 at
    least), rho the correlation of neighbouring residuals.
    """
    r = search.residuals(z)
    J = search.jacobian(z, r, central=True)
    m, n = J.shape
    squares = float((r**2).sum())
    parts = residuals_of(search.tests, search.problem.answers(search.laboratory, search.at(z)))
    rho = correlation(search.tests, parts)
    covariance = numpy.linalg.inv(J.T @ J + 1e-6 * numpy.eye(n))
    deviation = numpy.sqrt(numpy.diag(covariance))
    s = numpy.sqrt(squares / max(m - n, 1))
    longer = (1.0 + rho) / (1.0 - rho)
    t = stats.t.ppf(0.975, max(m / longer - n, 1.0))
    decided = stats.t.ppf(0.975, max(m - n, 1)) * max(s, LEAST_SCALE) * deviation
    return Spread(t * s * numpy.sqrt(longer) * deviation, decided, covariance / deviation**2, J, squares, t**2 * s**2 * longer, rho)


def root_of(growth, spread):
    """Growth of the sum of squares over that at the end of a range, as a root: a linear problem's is proportional to the distance."""
    return numpy.sqrt(max(growth, 0.0) / spread.growth)


def next_half(half, inner, outer):
    """Where to look for the end: between a point inside of the range and one outside (half width, root), or further out."""
    if outer is None:
        return half * (min(2.0, 1.1 / max(inner[1], 0.1)) if inner[1] > 0.0 else 2.0)
    if numpy.isinf(outer[1]):
        return 0.5 * (inner[0] + outer[0])
    part = (1.0 - inner[1]) / max(outer[1] - inner[1], 1e-6)
    return inner[0] + min(max(part, 0.1), 0.9) * (outer[0] - inner[0])


def end_of(search, z, spread, i, sign):
    """One end of a range: where the sum of squares has grown by spread.growth, with all other parameters fitted again (profile
    likelihood)."""
    half = min(spread.half[i], FIRST * search.wide()[i])  # a valley that bends is followed from near
    if len(z) < 2 or half == 0.0 or spread.growth <= LEAST_SCALE**2:
        return z[i] + sign * half
    inner, outer, along, J = (0.0, 0.0), None, sign * spread.along[:, i], spread.slopes
    start = z
    for _ in range(TRIALS):
        if half > 1.1 * search.wide()[i] * OPEN:
            break
        end = numpy.clip(z[i] + sign * half, search.low[i], search.high[i])
        growth, there, J = grown(search, spread, i, end, start + (abs(end - z[i]) - inner[0]) * along, J)
        half, root = abs(end - z[i]), root_of(growth, spread)
        if abs(root - 1.0) <= NEAR or (root < 1.0 and end in (search.low[i], search.high[i])):
            return end
        if root < 1.0:
            along = (there - start) / (half - inner[0]) if half > inner[0] else along  # the others go on as they went
            inner, start = (half, root), there
        else:
            outer = (half, root)
        half = next_half(half, inner, outer)
    return z[i] + sign * (outer[0] if outer and numpy.isinf(outer[1]) else half)


def at_bound(search, i, z):
    return min(z[i] - search.low[i], search.high[i] - z[i]) < AT_BOUND * PARAMETERS[search.names[i]].wide


def within(search, spread):
    """Ends of what the cards that were tried reach in each parameter without more than spread.growth: a profile cannot be narrower, and one
    that a ridge has stopped is."""
    inside = numpy.array([z for z, squares in search.visited if squares <= spread.squares + spread.growth])
    return inside.min(axis=0), inside.max(axis=0)


def range_of(search, z, spread, i, settled=False):
    """Ends of a range; `settled`: a lower sum of squares on the way is no reason to begin again."""
    ends = []
    for sign in (-1.0, 1.0):
        try:
            end = end_of(search, z, spread, i, sign)
        except Better:
            if not settled:
                raise
            end = z[i] + sign * spread.half[i]
        ends.append(numpy.clip(end, search.low[i], search.high[i]))
    return ends


def shown_range(search, spread, i, ends):
    """(low, high) of a parameter from the ends of its profile and from the cards that were tried."""
    low, high = within(search, spread)
    return tuple(sorted(unseen(search.names[i], end) for end in (min(ends[0], low[i]), max(ends[1], high[i]))))
