# SPDX-License-Identifier: BSD-3-Clause
"""The fit: residuals, the optimiser in three stages, ranges, and the parameters that the data leave open."""

from dataclasses import dataclass, field

import numpy
from scipy import optimize, stats

from barreno_fit import guess
from barreno_fit.answers import Laboratory
from barreno_fit.card import TOLERANCE, in_a_test
from barreno_fit.faults import NUMERICAL, Fault, Rejected
from barreno_fit.kinds import KINDS
from barreno_fit.parameters import PARAMETERS, bounds_of, free_of, seen, tie, unseen
from barreno_fit.specimens import opened

HYDROSTATIC = ("hydrostatic", "bulk modulus", "crush pressure", "open pores")
BEST_STARTS = 3
STEP = 4e-3  # of a difference, in what the optimiser sees
REJECTED = 1e3  # residual where the library refuses
LEAST_MODEL = 1e-6  # of a datum: a model's value below is taken as this
SETTLED = 1.1  # of the sum of squares: a parameter that goes back to its start may not cost more
LEAST_SCALE = 0.05  # of the uncertainty: below it a fit is exact, and its scatter no measure of what data determine
LARGEST_RHO = 0.98


@dataclass
class Problem:
    """What stays the same during a fit."""

    library: object
    start: dict  # card
    fixed: dict
    bounds: dict
    say: object = print
    updates: int = field(default=0)  # cards that were tried

    def card(self, values):
        return tie({**self.start, **self.fixed, **values}, self.fixed)

    def answers(self, laboratory, values, **more):
        self.updates += 1
        with opened(in_a_test(self.card(values), **{"Tolerance": TOLERANCE, **more}), self.library) as rock:
            return laboratory.answers(rock)


def residuals_of(tests, answers):
    """Of each test and channel: (model - data) over the uncertainty. In curves that is relative to the largest value of the channel; in
    tables it is ln(model/data) over the relative uncertainty."""
    out = []
    for test, answer in zip(tests, answers):
        for name in test.channels:
            data, model = test.columns[name], answer[name]
            if KINDS[test.kind].curve:
                out.append((model - data) / (test.uncertainty * numpy.abs(data).max()))
            else:
                out.append(numpy.log(numpy.maximum(model, LEAST_MODEL * data) / data) / test.uncertainty)
    return out


class Search:
    """Least squares over some parameters and tests; the other parameters stand in `values`."""

    def __init__(self, problem, tests, names, values):
        self.problem, self.tests, self.names, self.values = problem, tests, list(names), dict(values)
        self.laboratory = Laboratory(tests)
        self.count = sum(test.rows * len(test.channels) for test in tests)
        limits = [bounds_of(name, problem.bounds) for name in self.names]
        self.low, self.high = (numpy.array([limit[k] for limit in limits]) for k in (0, 1))

    def at(self, z):
        return {**self.values, **{name: unseen(name, value) for name, value in zip(self.names, z)}}

    def seen_start(self, values):
        card = self.problem.card({**self.values, **values})
        z = numpy.array([seen(name, card[name]) for name in self.names])
        room = 1e-6 * (self.high - self.low)
        return numpy.clip(z, self.low + room, self.high - room)

    def residuals(self, z):
        try:
            return numpy.concatenate(residuals_of(self.tests, self.problem.answers(self.laboratory, self.at(z))))
        except Rejected:
            return numpy.full(self.count, REJECTED)

    def jacobian(self, z, middle=None):
        """Central differences; on one side where a bound or the library is in the way."""
        middle = self.residuals(z) if middle is None else middle
        columns = []
        for i in range(len(z)):
            sides = []
            for sign in (1.0, -1.0):
                there = z.copy()
                there[i] += sign * STEP
                if not self.low[i] <= there[i] <= self.high[i]:
                    continue
                found = self.residuals(there)
                if not (found == REJECTED).all():
                    sides.append((sign * STEP, found))
            if len(sides) == 2:
                columns.append((sides[0][1] - sides[1][1]) / (2.0 * STEP))
            else:
                columns.append((sides[0][1] - middle) / sides[0][0] if sides else numpy.zeros(self.count))
        return numpy.stack(columns, axis=1)

    def solve(self, starts):
        """The best of least squares from the best of the starts: (values, sum of squares, z)."""
        ranked = sorted(((float((r**2).sum()), i, z) for i, z in enumerate(map(self.seen_start, starts)) for r in [self.residuals(z)]))
        ranked = [entry for entry in ranked if entry[0] < self.count * REJECTED**2][:BEST_STARTS]
        if not ranked:
            raise Fault("the library refuses every card that the fit could start from; give one with --start that these tests can be made of.", NUMERICAL)
        best = None
        for _, _, z in ranked:
            found = optimize.least_squares(
                self.residuals, z, lambda x: self.jacobian(x), bounds=(self.low, self.high), x_scale="jac", ftol=1e-8, xtol=1e-7, max_nfev=50
            )
            if best is None or found.cost < best.cost:
                best = found
        return self.at(best.x), 2.0 * best.cost, best.x


@dataclass
class Result:
    """values: of the fitted parameters; ranges: name -> (low, high); open: name -> sentence."""

    values: dict
    ranges: dict
    left_open: dict
    squares: float
    count: int
    rho: float
    card: dict


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


def half_widths(search, z):
    """95 % half widths in what the optimiser sees, and what of them belongs to uncorrelated residuals.

    t s sqrt(diag (J^T J)^-1), s^2 = sum r^2/(m - n), times sqrt((1 + rho)/(1 - rho)); t of Student with m (1 - rho)/(1 + rho) - n degrees
    of freedom, 1 at least.
    """
    r = search.residuals(z)
    J = search.jacobian(z, r)
    m, n = J.shape
    squares = float((r**2).sum())
    parts = residuals_of(search.tests, search.problem.answers(search.laboratory, search.at(z)))
    rho = correlation(search.tests, parts)
    spread = numpy.sqrt(numpy.diag(numpy.linalg.inv(J.T @ J + 1e-6 * numpy.eye(n))))
    s = numpy.sqrt(squares / max(m - n, 1))
    longer = (1.0 + rho) / (1.0 - rho)
    t = stats.t.ppf(0.975, max(m / longer - n, 1.0))
    decided = stats.t.ppf(0.975, max(m - n, 1)) * max(s, LEAST_SCALE) * spread
    return t * s * numpy.sqrt(longer) * spread, decided, squares, rho


def at_bound(search, i, z):
    return min(z[i] - search.low[i], search.high[i] - z[i]) < 1e-4


def shown(name, value):
    p = PARAMETERS[name]
    large = p.dimension == "stress" and abs(value) >= 2e9
    scale, unit = (1e9, " GPa") if large else {"stress": (1e6, " MPa"), "compliance": (1e-9, " 1/GPa")}.get(p.dimension, (1.0, ""))
    return f"{value / scale:.4g}{unit}"


def range_of(search, i, z, half):
    name = search.names[i]
    ends = [numpy.clip(z[i] + sign * half, -600.0, 600.0) for sign in (-1.0, 1.0)]
    if not PARAMETERS[name].log:
        ends = [numpy.clip(end, search.low[i], search.high[i]) for end in ends]
    return tuple(sorted(unseen(name, end) for end in ends))


def leave_open(problem, tests, names, values):
    """Fits all parameters together; those that the data leave open go back to their start, one after the other."""
    left_open = {}
    search = Search(problem, tests, names, values)
    values, squares, z = search.solve([values])
    while search.names:
        half, decided, squares, rho = half_widths(search, z)
        excess = [decided[i] / PARAMETERS[name].wide for i, name in enumerate(search.names)]
        stuck = [i for i in range(len(z)) if at_bound(search, i, z)]
        worst = int(numpy.argmax(excess))
        if stuck:
            worst = stuck[0]
        elif excess[worst] <= 1.0:
            break
        name = search.names[worst]
        rest = [other for other in search.names if other != name]
        start = problem.card({})[name]
        fewer = {**values}
        fewer.pop(name)
        if rest:
            trial = Search(problem, tests, rest, {**fewer, name: start})
            try:
                found = trial.solve([values])
            except Fault:
                found = None
        else:
            trial = Search(problem, tests, [], {name: start})
            found = ({name: start}, float((trial.residuals(numpy.zeros(0)) ** 2).sum()), numpy.zeros(0))
        if found and found[1] <= SETTLED * squares + LEAST_SCALE**2 * search.count:
            left_open[name] = f"{name} is not determined by these data and is kept at its start, {shown(name, start)}."
            search, (values, squares, z) = trial, found
            values[name] = start
            continue
        at = values[name]
        why = "stands at its bound" if stuck else "is only bounded by these data"
        left_open[name] = f"{name} {why} and is kept at {shown(name, at)} (its start, {shown(name, start)}, fits worse)."
        search = Search(problem, tests, rest, {**fewer, name: at})
        values, squares, z = search.solve([values]) if rest else ({name: at}, squares, numpy.zeros(0))
    return search, values, z, left_open


def fit(problem, tests):
    """Crushing and bulk moduli first, from hydrostatic tests; then strength and shear; then all together."""
    names = free_of(tests, problem.card({}), problem.fixed)
    if not names:
        raise Fault("nothing is left to fit (every parameter that these tests could determine is fixed, or 0 in the start); take a --fix out.")
    count = sum(test.rows * len(test.channels) for test in tests)
    if count < len(names):
        raise Fault(f"{count} data cannot determine {len(names)} parameters ({', '.join(names)}); give more tests, or hold some with --fix.")
    values = {}
    first = [test for test in tests if test.kind in HYDROSTATIC]
    rest = [test for test in tests if test.kind not in HYDROSTATIC]
    for stage, chosen, starts in (("moduli and crushing", first, guess.crushing_starts), ("strength and shear", rest, guess.strength_starts)):
        mine = [name for name in free_of(chosen, problem.card({}), problem.fixed) if name in names and name not in values] if chosen else []
        if not mine:
            continue
        problem.say(f"{stage}: {', '.join(mine)}")
        offers = [{name: value for name, value in start.items() if name in mine} for start in [{}, *starts(chosen, problem.card(values))]]
        search = Search(problem, chosen, mine, values)
        values = search.solve(unique(offers))[0]
    problem.say("all together")
    search, values, z, left_open = leave_open(problem, tests, names, values)
    half, _, squares, rho = half_widths(search, z) if search.names else ([], [], 0.0, 0.0)
    ranges = {name: range_of(search, i, z, half[i]) for i, name in enumerate(search.names)}
    return Result({name: values[name] for name in names}, ranges, left_open, squares, count, rho, problem.card(values))


def unique(offers):
    out = []
    for offer in offers:
        if offer not in out:
            out.append(offer)
    return out
