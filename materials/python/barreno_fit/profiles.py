# SPDX-License-Identifier: BSD-3-Clause
"""Profiles: one parameter is held and all others are fitted again, from a point near their best values."""

import numpy

from barreno_fit.search import LEAST_SCALE, REJECTED, ROUGH, Search

REFITS = 6  # steps of a refit
FAR = 2.0  # widths of an open range: steps of parameters that the data leave open are kept below that
LITTLE = 0.02  # of the growth at an end: a refit that can gain less is done
BETTER = 2e-3  # of the sum of squares: a profile that lies lower has found a better minimum
PARTS = (1.0, 0.5, 0.25)  # of a step, the first that gains is taken


class Better(Exception):
    """A profile went below the solution: the values where it did."""


def step_of(search, spread, i, x, r, J):
    """Levenberg's step of all parameters but i, and of none that is at a bound and would go beyond; and what it should gain."""
    downhill = -(J.T @ r)
    stuck = ((x <= search.low) & (downhill < 0.0)) | ((x >= search.high) & (downhill > 0.0))
    stuck[i] = True
    free, step = numpy.flatnonzero(~stuck), numpy.zeros(len(x))
    if len(free):
        short = numpy.diag(numpy.sqrt(spread.growth) / (FAR * search.wide()[free]))
        step[free] = numpy.linalg.lstsq(numpy.vstack([J[:, free], short]), numpy.concatenate([-r, numpy.zeros(len(free))]), rcond=None)[0]
    return step, float(r @ r) - float(((r + J @ step) ** 2).sum())


def refit(search, spread, i, x):
    """Least squares over all parameters but i from x: (sum of squares, x). The derivatives are those of the solution, and follow the
    residuals by Broyden's updates, so that a step costs one card and not one of each parameter."""
    r, J = search.residuals(x), spread.slopes.copy()
    for _ in range(REFITS):
        step, gain = step_of(search, spread, i, x, r, J)
        if gain <= LITTLE * spread.growth:
            return float(r @ r), x
        for part in PARTS:
            there = numpy.clip(x + part * step, search.low, search.high)
            found, way = search.residuals(there), there - x
            if (found == REJECTED).all() or not way.any():
                continue
            J += numpy.outer(found - r - J @ way, way / (way @ way))
            if found @ found < r @ r:
                break
        else:
            return refit_anew(search, i, x)
        x, r = there, found
    return float(r @ r), x


def refit_anew(search, i, x):
    """The same with derivatives of its own, where the others do not lead downhill."""
    name = search.names[i]
    rest = [other for other in search.names if other != name]
    held = Search(search.problem, search.tests, rest, search.at(x))
    room = 1e-9
    found = held.descend(numpy.clip(numpy.delete(x, i), held.low + room, held.high - room), ROUGH, REFITS)
    return 2.0 * found.cost, numpy.insert(found.x, i, x[i])


def grown(search, spread, i, end, guess):
    """How much the sum of squares grows when parameter i is held at an end and the others are fitted again, and where they are then; infinite
    where the library refuses the card."""
    x = numpy.clip(guess, search.low, search.high)
    x[i] = end
    if (search.residuals(x) == REJECTED).all():
        return numpy.inf, x
    squares, x = refit(search, spread, i, x)
    if squares < (1.0 - BETTER) * spread.squares and spread.squares > LEAST_SCALE**2 * search.count:
        raise Better(search.at(x))
    return squares - spread.squares, x
