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
SPARE = 3  # runs beyond the number of ranges that a fit of all needs: one for the mean, two for what the ranges do not explain
LEAST_FREEDOM = 6  # runs that a selection leaves to the scatter
LEAST_FORETOLD = 0.2  # share of the variance that selected effects foretell, below which chance may have selected them
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


def clearest(z, y, chosen):
    """The column that explains most of what those chosen leave, and whether scatter alone would hardly do so for any of the others.

    Of k columns without effect one passes Student's two-sided bound at (1 - LEVEL)/k in less than one sample of ten.
    """
    from scipy import stats

    runs, others = len(y), [j for j in range(z.shape[1]) if j not in chosen]
    freedom = runs - len(chosen) - 2
    if not others or freedom < LEAST_FREEDOM:
        return None
    known = numpy.hstack([numpy.ones((runs, 1)), z[:, chosen]])
    basis = numpy.linalg.qr(known)[0]
    without = lambda columns: columns - basis @ (basis.T @ columns)  # noqa: E731
    rest, columns = without(y), without(z[:, others])
    along = columns.T @ rest / numpy.maximum(numpy.sqrt((columns**2).sum(axis=0)), 1e-300)
    best = int(numpy.argmax(numpy.abs(along)))
    scatter = max(float((rest**2).sum() - along[best] ** 2), 0.0) / freedom
    bound = stats.t.ppf(1.0 - 0.5 * (1.0 - LEVEL) / len(others), freedom)
    return others[best] if along[best] ** 2 > max(bound**2 * scatter, 1e-24 * float(y @ y)) else None


def clear_columns(z, y):
    """Forward selection: one range after the other, as long as it stands out."""
    chosen = []
    while (column := clearest(z, y, chosen)) is not None:
        chosen.append(column)
    return sorted(chosen)


def by_selection(shares, answers):
    """Of a Latin hypercube with fewer runs than a fit of all ranges needs: by_regression of those that stand out. The rest counts as
    scatter, so that the interval has all of them. foretold leaves each run out of the selection too."""
    z, y = 2.0 * numpy.asarray(shares, float) - 1.0, numpy.asarray(answers, float)
    chosen = clear_columns(z, y)
    found = by_regression(numpy.asarray(shares, float)[:, chosen], y)
    of_chosen = dict(zip(chosen, found.effects))
    found.effects = [of_chosen.get(j, Effect(0.0, 0.0, 0.0, False)) for j in range(z.shape[1])]
    found.foretold = 1.0 - sum(missed_alone(z, y, i) ** 2 for i in range(len(y))) / max(float(((y - y.mean()) ** 2).sum()), 1e-300)
    if found.foretold < LEAST_FORETOLD:
        found.effects = [dataclasses.replace(effect, told=False) for effect in found.effects]
    return found


def missed_alone(z, y, i):
    """What a selection and a fit without run i miss of it."""
    others = numpy.arange(len(y)) != i
    chosen = clear_columns(z[others], y[others])
    row = lambda of: numpy.hstack([numpy.ones((len(of), 1)), of[:, chosen]])  # noqa: E731
    return float(y[i] - (row(z[i : i + 1]) @ numpy.linalg.lstsq(row(z[others]), y[others], rcond=None)[0])[0])


def is_selected(runs, ranges):
    """Whether so many runs are too few for a fit of all ranges."""
    return runs < ranges + SPARE


def of_hypercube(shares, answers):
    return (by_selection if is_selected(*numpy.shape(shares)) else by_regression)(shares, answers)


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
