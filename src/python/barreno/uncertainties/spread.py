# SPDX-License-Identifier: BSD-3-Clause
"""From a sample of runs to an interval and to shares of the variance (docs/uncertainty.md has the equations). Inputs are shares of their
ranges, from 0 to 1, and count as evenly distributed there."""

import dataclasses
import math

import numpy

LEVEL = 0.9
ENDS = (0.5 - 0.5 * LEVEL, 0.5, 0.5 + 0.5 * LEVEL)
DRAWS = 20000
VARIANCE = 1.0 / 3.0  # of an even distribution from -1 to 1
FAIR = 0.5  # share of the variance that effects foretell, below which they say little


@dataclasses.dataclass
class Effect:
    """Of one range: its share of the variance, the change of the answer at either end, and whether scatter alone would explain it."""

    share: float
    at_low: float
    at_high: float
    told: bool = True


@dataclasses.dataclass
class Spread:
    low: float
    median: float
    high: float
    effects: list  # of Effect, in the order of the ranges
    rest: float | None  # share of interaction, curvature and scatter; None where the design does not show it
    centre: float  # answer that effects are changes from
    foretold: float | None = None  # share of the variance that the effects foretell of runs that they were not made of


def quantiles(draws):
    return tuple(map(float, numpy.quantile(draws, ENDS)))


def confidence_of_span(count, level=LEVEL):
    """That least and largest of so many independent values hold a part of all (order statistics)."""
    return 1.0 - count * level ** (count - 1) + (count - 1) * level**count


def foretold_by(x, y, leverage, residuals):
    """1 - PRESS/SS: each run from a fit without it."""
    left_out = residuals / numpy.maximum(1.0 - leverage, 1e-12)
    total = float(((y - y.mean()) ** 2).sum())
    return 1.0 - float((left_out**2).sum()) / total if total > 0.0 else 0.0


def predicted(mean, slopes, s, runs, freedom):
    """Answers of cases that nobody has run: inputs drawn anew, and the scatter of a run and of the mean, after Student."""
    generator = numpy.random.default_rng(0)
    z = generator.uniform(-1.0, 1.0, (DRAWS, len(slopes)))
    return mean + z @ slopes + s * math.sqrt(1.0 + 1.0 / runs) * generator.standard_t(freedom, DRAWS)


def by_regression(shares, answers):
    """Of a Latin hypercube: least squares, y = b0 + sum b_j z_j + e with z_j from -1 to 1.

    Parameters
    ----------
    shares : array
        A row for each run, a column for each range.
    answers : array
        One for each run.
    """
    from scipy import stats

    y, z = numpy.asarray(answers, float), 2.0 * numpy.asarray(shares, float) - 1.0
    runs, ranges = z.shape
    x = numpy.hstack([numpy.ones((runs, 1)), z])
    inverse = numpy.linalg.inv(x.T @ x)
    beta = inverse @ (x.T @ y)
    residuals, freedom = y - x @ beta, runs - ranges - 1
    s = float(numpy.sqrt((residuals**2).sum() / freedom))
    errors = s * numpy.sqrt(numpy.diag(inverse))[1:]
    slopes = beta[1:]
    # An estimate that is not too large in the mean: scatter alone gives b^2 = its squared error.
    variances = numpy.maximum(slopes**2 - errors**2, 0.0) * VARIANCE
    total = float(variances.sum()) + s**2
    told = numpy.abs(slopes) > stats.t.ppf(0.5 + 0.5 * LEVEL, freedom) * errors
    low, median, high = quantiles(predicted(beta[0], numpy.sqrt(variances / VARIANCE), s, runs, freedom))
    effects = [Effect(float(variance / total) if total > 0.0 else 0.0, -float(slope), float(slope), bool(clear))
        for variance, slope, clear in zip(variances, slopes, told)]
    leverage = (x @ inverse * x).sum(axis=1)
    return Spread(low, median, high, effects, s**2 / total if total > 0.0 else 0.0, float(beta[0]), foretold_by(x, y, leverage, residuals))


def parabola(middle, at_low, at_high):
    """(a, b, c) of a u^2 + b u + c through 0 at the middle and the changes at 0 and 1."""
    a = ((at_high - at_low) - (0.0 - at_low) / middle) / (1.0 - middle)
    return a, at_high - at_low - a, at_low


def variance_of(a, b):
    """Of a u^2 + b u, u evenly from 0 to 1."""
    return b * b / 12.0 + 4.0 * a * a / 45.0 + a * b / 6.0


def one_at_a_time(shares, answers):
    """The middle, then both ends of each range: a parabola for each, and their sum."""
    middle, y = shares[0], numpy.asarray(answers, float)
    curves = [parabola(middle[j], y[1 + 2 * j] - y[0], y[2 + 2 * j] - y[0]) for j in range(len(middle))]
    variances = [variance_of(a, b) for a, b, _ in curves]
    total = sum(variances)
    u = numpy.random.default_rng(0).uniform(0.0, 1.0, (DRAWS, len(middle)))
    low, median, high = quantiles(y[0] + sum(a * u[:, j] ** 2 + b * u[:, j] + c for j, (a, b, c) in enumerate(curves)))
    effects = [Effect(variance / total if total > 0.0 else 0.0, float(y[1 + 2 * j] - y[0]), float(y[2 + 2 * j] - y[0]))
        for j, variance in enumerate(variances)]
    return Spread(low, median, high, effects, None, float(y[0]))
