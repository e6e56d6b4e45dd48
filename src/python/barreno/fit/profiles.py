# SPDX-License-Identifier: BSD-3-Clause
"""Profiles: one parameter is held and all others are fitted again, from a point near their best values."""

import numpy

from barreno.fit.search import LEAST_SCALE, REJECTED

STEPS, RENEWALS = 5, 2  # of a refit: steps with the same derivatives, and how often these are made anew
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


def chord(search, spread, i, x, r, J):
    """Steps with derivatives that follow the residuals by Broyden's updates, so that a step costs one card: (x, r, J, whether nothing is
    left to gain)."""
    stalled = []
    for _ in range(STEPS):
        step, gain = step_of(search, spread, i, x, r, J)
        if gain <= LITTLE * spread.growth:
            return x, r, J, True
        for part in PARTS:
            there = numpy.clip(x + part * step, search.low, search.high)
            found, way = search.residuals(there), there - x
            if (found == REJECTED).all() or not way.any():
                continue
            J = J + numpy.outer(found - r - J @ way, way / (way @ way))
            if found @ found < r @ r:
                break
        else:
            return x, r, J, False
        stalled, x, r = [*stalled, float(r @ r - found @ found) <= LITTLE * spread.growth], there, found
        if stalled[-2:] == [True, True]:
            break
    return x, r, J, False


def refit(search, spread, i, x, J):
    """Least squares over all parameters but i from x: (sum of squares, x, derivatives). The derivatives are those given; they are made anew
    where they lead no further."""
    r, renewed = search.residuals(x), False
    for last in (*[False] * RENEWALS, True):
        before = float(r @ r)
        x, r, J, done = chord(search, spread, i, x, r, J)
        if done or last or (renewed and before - float(r @ r) <= LITTLE * spread.growth):
            break
        renewed = True
        J = search.jacobian(x, r)
    return float(r @ r), x, J


def grown(search, spread, i, end, guess, J):
    """How much the sum of squares grows when parameter i is held at an end and the others are fitted again, where they are then, and the
    derivatives there; infinite where the library refuses the card."""
    x = numpy.clip(guess, search.low, search.high)
    x[i] = end
    if (search.residuals(x) == REJECTED).all():
        return numpy.inf, x, J
    squares, x, J = refit(search, spread, i, x, J)
    if squares < (1.0 - BETTER) * spread.squares and spread.squares > LEAST_SCALE**2 * search.count:
        raise Better(search.at(x))
    return squares - spread.squares, x, J
