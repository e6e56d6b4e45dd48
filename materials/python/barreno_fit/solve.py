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
BEST_STARTS = 2
STEP = 4e-3  # of a difference, in what the optimiser sees
REJECTED = 1e3  # residual where the library refuses
LEAST_MODEL = 1e-6  # of a datum: a model's value below is taken as this
SETTLED = 1.1  # of the sum of squares: a parameter that goes back to its start may not cost more
LEAST_SCALE = 0.05  # of the uncertainty: below it a fit is exact, and its scatter no measure of what data determine
LARGEST_RHO = 0.98
NONLINEAR = 0.4  # of the growth of the sum of squares: a linearised range that is further off is not kept
EXTENSIONS, REFITS, TRIES = 5, 8, 30
ROUGH, EXACT = 1e-4, 1e-5  # relative change of the sum of squares at which a stage ends that the next one continues, and the last one


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


def size_of(test):
    return test.rows * len(test.channels)


class Search:
    """Least squares over some parameters and tests; the other parameters stand in `values`."""

    def __init__(self, problem, tests, names, values, rough=False):
        self.rough = rough  # differences to one side, and an early end: what comes is not the last word
        self.problem, self.tests, self.names, self.values = problem, tests, list(names), dict(values)
        self.laboratory, self.parts = Laboratory(tests), {}
        self.count = sum(map(size_of, tests))
        limits = [bounds_of(name, problem.bounds) for name in self.names]
        self.low, self.high = (numpy.array([limit[k] for limit in limits]) for k in (0, 1))

    def at(self, z):
        return {**self.values, **{name: unseen(name, value) for name, value in zip(self.names, z)}}

    def seen_start(self, values):
        card = self.problem.card({**self.values, **values})
        z = numpy.array([seen(name, card[name]) for name in self.names])
        room = 1e-6 * (self.high - self.low)
        return numpy.clip(z, self.low + room, self.high - room)

    def residuals(self, z, laboratory=None):
        """Of all tests, or of those of one laboratory."""
        laboratory = laboratory or self.laboratory
        try:
            return numpy.concatenate(residuals_of(laboratory.tests, self.problem.answers(laboratory, self.at(z))))
        except Rejected:
            return numpy.full(sum(map(size_of, laboratory.tests)), REJECTED)

    def part(self, name):
        """The tests that a parameter matters in, as a laboratory, and which residuals are theirs."""
        chosen = [KINDS[test.kind].curve or name in KINDS[test.kind].fits for test in self.tests]
        rows = numpy.repeat(chosen, [size_of(test) for test in self.tests])
        if not any(chosen):
            return None, rows
        key = tuple(chosen)
        if key not in self.parts:
            self.parts[key] = Laboratory([test for test, mine in zip(self.tests, chosen) if mine])
        return self.parts[key], rows

    def jacobian(self, z, middle=None):
        """Central differences; to one side where that will do, or a bound or the library is in the way."""
        middle = self.residuals(z) if middle is None else middle
        columns = []
        for i, name in enumerate(self.names):
            laboratory, rows = self.part(name)
            column = numpy.zeros(self.count)
            if laboratory:
                column[rows] = self.slope(z, i, laboratory, middle[rows])
            columns.append(column)
        return numpy.stack(columns, axis=1)

    def slope(self, z, i, laboratory, middle):
        sides = []
        for sign in (1.0, -1.0):
            there = z.copy()
            there[i] += sign * STEP
            if (self.rough and sides) or not self.low[i] <= there[i] <= self.high[i]:
                continue
            found = self.residuals(there, laboratory)
            if not (found == REJECTED).all():
                sides.append((sign * STEP, found))
        if len(sides) == 2:
            return (sides[0][1] - sides[1][1]) / (2.0 * STEP)
        return (sides[0][1] - middle) / sides[0][0] if sides else numpy.zeros(len(middle))

    def refusal(self, start):
        """The library's words on a start."""
        try:
            self.problem.answers(self.laboratory, self.at(self.seen_start(start)))
        except Rejected as refused:
            return str(refused).rstrip(".")
        return "the tests cannot be made"

    def solve(self, starts):
        """The best of least squares from the best of the starts: (values, sum of squares, z)."""
        ranked = sorted(((float((r**2).sum()), i, z) for i, z in enumerate(map(self.seen_start, starts)) for r in [self.residuals(z)]))
        ranked = [entry for entry in ranked if entry[0] < self.count * REJECTED**2][:BEST_STARTS]
        if not ranked:
            raise Fault(f"the library refuses every card that the fit could start from ({self.refusal(starts[0])}); change --start or --fix.", NUMERICAL)
        best = None
        for _, _, z in ranked:
            found = optimize.least_squares(
                self.residuals, z, lambda x: self.jacobian(x), bounds=(self.low, self.high), x_scale="jac", ftol=ROUGH if self.rough else EXACT, xtol=1e-7, max_nfev=TRIES
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
    J = search.jacobian(z, r)
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


def grown(search, z, i, end, guess):
    """How much the sum of squares grows when parameter i is held at an end and the others are fitted again."""
    rest = [name for name in search.names if name != search.names[i]]
    held = Search(search.problem, search.tests, rest, {**search.values, search.names[i]: unseen(search.names[i], end)}, rough=True)
    start = numpy.delete(numpy.clip(guess, search.low + 1e-9, search.high - 1e-9), i)
    found = optimize.least_squares(
        held.residuals, start, lambda x: held.jacobian(x), bounds=(held.low, held.high), x_scale="jac", ftol=ROUGH, max_nfev=REFITS
    )
    return 2.0 * found.cost


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
            growth = grown(search, z, i, end, guess) - spread.squares
        part = numpy.sqrt(max(growth, 0.0) / spread.growth)
        if part >= 1.0 - NONLINEAR / 2:
            return z[i] + sign * half / max(part, 1.0)
        if end != guess[i]:
            return end
        half *= min(2.0, 1.1 / max(part, 0.1))
    return z[i] + sign * half


def at_bound(search, i, z):
    return min(z[i] - search.low[i], search.high[i] - z[i]) < 1e-4


def shown(name, value):
    p = PARAMETERS[name]
    large = p.dimension == "stress" and abs(value) >= 2e9
    scale, unit = (1e9, " GPa") if large else {"stress": (1e6, " MPa"), "compliance": (1e-9, " 1/GPa")}.get(p.dimension, (1.0, ""))
    return f"{value / scale:.4g}{unit}"


def range_of(search, z, spread, i):
    ends = []
    for sign in (-1.0, 1.0):
        ends.append(numpy.clip(end_of(search, z, spread, i, sign), search.low[i], search.high[i]))
    return tuple(sorted(unseen(search.names[i], end) for end in ends))


def together(search, values, simpler):
    """The joint fit from what the stages found; where the tests of one stage cannot be made with what the other found, from the simpler card."""
    try:
        return search.solve([values])
    except Fault:
        return search.solve([simpler])


def leave_open(problem, tests, names, values, simpler):
    """Fits all parameters together; those that the data leave open go back to their start, one after the other."""
    left_open = {}
    search = Search(problem, tests, names, values)
    values, squares, z = together(search, values, simpler)
    while search.names:
        spread = spread_of(search, z)
        squares = spread.squares
        excess = [spread.decided[i] / PARAMETERS[name].wide for i, name in enumerate(search.names)]
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
    count = sum(map(size_of, tests))
    if count < len(names):
        raise Fault(f"{count} data cannot determine {len(names)} parameters ({', '.join(names)}); give more tests, or hold some with --fix.")
    values, simpler = {}, {}
    first = [test for test in tests if test.kind in HYDROSTATIC]
    rest = [test for test in tests if test.kind not in HYDROSTATIC]
    for stage, chosen, starts in (("moduli and crushing", first, guess.crushing_starts), ("strength and shear", rest, guess.strength_starts)):
        mine = [name for name in free_of(chosen, problem.card({}), problem.fixed) if name in names and name not in values] if chosen else []
        if not mine:
            continue
        problem.say(f"{stage}: {', '.join(mine)}")
        offers = [{name: value for name, value in start.items() if name in mine} for start in [{}, *starts(chosen, problem.card(values))]]
        search = Search(problem, chosen, mine, values, rough=True)
        values = search.solve(unique(offers))[0]
        simpler = simpler or values
    card = problem.card(simpler)
    problem.say("all of them together")
    search, values, z, left_open = leave_open(problem, tests, names, values, {name: card[name] for name in names})
    problem.say("their ranges")
    spread = spread_of(search, z) if search.names else None
    ranges = {name: range_of(search, z, spread, i) for i, name in enumerate(search.names)}
    return Result({name: values[name] for name in names}, ranges, left_open, spread.rho if spread else 0.0, problem.card(values))


def unique(offers):
    out = []
    for offer in offers:
        if offer not in out:
            out.append(offer)
    return out
