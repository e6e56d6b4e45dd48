# SPDX-License-Identifier: BSD-3-Clause
"""What the data say of each parameter: a 95 % range by linearisation and by profile likelihood."""

from dataclasses import dataclass

import numpy
from scipy import stats

from barreno_fit.kinds import KINDS
from barreno_fit.parameters import PARAMETERS, unseen
from barreno_fit.search import ROUGH, Search, residuals_of

LEAST_SCALE = 0.05  # of the uncertainty: below it a fit is exact, and its scatter no measure of what data determine
LARGEST_RHO = 0.98
NONLINEAR = 0.25  # of the growth of the sum of squares: a linearised range that is further off is not kept
EXTENSIONS, REFITS = 5, 8
BETTER = 2e-3  # of the sum of squares: a profile that lies lower has found a better minimum
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
    return Spread(t * s * numpy.sqrt(longer) * deviation, decided, covariance / deviation**2, squares, t**2 * s**2 * longer, rho)


class Better(Exception):
    """A profile went below the solution: the values where it did."""


def grown(search, z, i, end, guess, squares):
    """How much the sum of squares grows when parameter i is held at an end and the others are fitted again."""
    rest = [name for name in search.names if name != search.names[i]]
    held = Search(search.problem, search.tests, rest, {**search.values, search.names[i]: unseen(search.names[i], end)})
    start = numpy.delete(numpy.clip(guess, search.low + 1e-9, search.high - 1e-9), i)
    found = held.descend(start, ROUGH, REFITS)
    if 2.0 * found.cost < (1.0 - BETTER) * squares and squares > LEAST_SCALE**2 * search.count:
        raise Better(held.at(found.x))
    return 2.0 * found.cost - squares


def end_of(search, z, spread, i, sign):
    """One end of a range. The linearised one stands if there the sum of squares has grown as it should; else others are tried, with all other
    parameters fitted again, until it has (profile likelihood)."""
    half = spread.half[i]
    if len(z) < 2 or half == 0.0 or spread.growth <= LEAST_SCALE**2:
        return z[i] + sign * half
    for _ in range(EXTENSIONS):
        guess = z + sign * half * spread.along[:, i]
        end = numpy.clip(guess[i], search.low[i], search.high[i])
        inside = (guess > search.low).all() and (guess < search.high).all()
        growth = float((search.residuals(guess) ** 2).sum()) - spread.squares if inside else numpy.inf
        if abs(growth / spread.growth - (half / spread.half[i]) ** 2) > NONLINEAR or half > spread.half[i]:
            growth = grown(search, z, i, end, guess, spread.squares)
        part = numpy.sqrt(max(growth, 0.0) / spread.growth)
        if part >= 1.0 - NONLINEAR / 2:
            return z[i] + sign * half / max(part, 1.0)
        if end != guess[i]:
            return end
        half *= min(2.0, 1.1 / max(part, 0.1))
    return z[i] + sign * half


def at_bound(search, i, z):
    return min(z[i] - search.low[i], search.high[i] - z[i]) < AT_BOUND * PARAMETERS[search.names[i]].wide


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
    return tuple(sorted(unseen(search.names[i], end) for end in ends))
