# SPDX-License-Identifier: BSD-3-Clause
"""Residuals of a card in the tests, and least squares over some of its parameters."""

from dataclasses import dataclass, field

import numpy
from scipy import optimize

from barreno.fit.answers import Laboratory
from barreno.fit.card import TOLERANCE, in_a_test
from barreno.fit.faults import Rejected
from barreno.fit.kinds import KINDS
from barreno.fit.parameters import PARAMETERS, bounds_of, seen, tie, unseen
from barreno.fit.specimens import opened
from barreno.runs.faults import NUMERICAL, Fault

BEST_STARTS = 3
STEP = 4e-3  # of a difference, in what the optimiser sees
REJECTED = 1e3  # residual where the library refuses
LEAST_MODEL = 1e-6  # of a datum: a model's value below is taken as this
ROUGH, EXACT = 1e-3, 1e-5  # relative change of the sum of squares at which a trial of a start ends, and a fit
LEAST_SCALE = 0.05  # of the uncertainty: below it a fit is exact, and its scatter no measure of what data determine
FEW, MANY = 8, 25  # evaluations of a trial of a start, and of a fit


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
    """Of each test and channel: (model - data) over the uncertainty. In curves that is relative to the largest value of the channel, and
    has a scale of the channel's own (weights.py); in tables it is ln(model/data) over the relative uncertainty."""
    out = []
    for test, answer in zip(tests, answers):
        for name in test.channels:
            data, model = test.columns[name], answer[name]
            if KINDS[test.kind].curve:
                out.append((model - data) / (test.uncertainty * test.scales.get(name, 1.0) * numpy.abs(data).max()))
            else:
                out.append(numpy.log(numpy.maximum(model, LEAST_MODEL * data) / data) / test.uncertainty)
    return out


def size_of(test):
    return test.rows * len(test.channels)


class Search:
    """Least squares over some parameters and tests; the other parameters stand in `values`."""

    def __init__(self, problem, tests, names, values):
        self.problem, self.tests, self.names, self.values = problem, tests, list(names), dict(values)
        self.laboratory, self.parts = Laboratory(tests), {}
        self.count, self.last = sum(map(size_of, tests)), None
        self.visited = []  # (z, sum of squares) of the cards that were tried in all tests
        limits = [bounds_of(name, problem.bounds) for name in self.names]
        self.low, self.high = (numpy.array([limit[k] for limit in limits]) for k in (0, 1))

    def at(self, z):
        return {**self.values, **{name: unseen(name, value) for name, value in zip(self.names, z)}}

    def wide(self):
        """Half widths of open ranges."""
        return numpy.array([PARAMETERS[name].wide for name in self.names])

    def seen_start(self, values):
        card = self.problem.card({**self.values, **values})
        z = numpy.array([seen(name, card[name]) for name in self.names])
        room = 1e-6 * (self.high - self.low)
        return numpy.clip(z, self.low + room, self.high - room)

    def residuals(self, z, laboratory=None):
        """Of all tests, or of those of one laboratory."""
        laboratory = laboratory or self.laboratory
        try:
            found = numpy.concatenate(residuals_of(laboratory.tests, self.problem.answers(laboratory, self.at(z))))
        except Rejected:
            return numpy.full(sum(map(size_of, laboratory.tests)), REJECTED)
        if laboratory is self.laboratory:
            self.visited.append((z.copy(), float(found @ found)))
        return found

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

    def jacobian(self, z, middle=None, central=False):
        """Differences to one side, or central ones; to the side that is left where a bound or the library is in the way."""
        if middle is None:
            middle = self.last[1] if self.last and numpy.array_equal(self.last[0], z) else self.residuals(z)
        columns = []
        for i, name in enumerate(self.names):
            laboratory, rows = self.part(name)
            column = numpy.zeros(self.count)
            if laboratory:
                column[rows] = self.slope(z, i, laboratory, middle[rows], central)
            columns.append(column)
        return numpy.stack(columns, axis=1)

    def slope(self, z, i, laboratory, middle, central):
        sides = []
        for sign in (1.0, -1.0):
            there = z.copy()
            there[i] += sign * STEP
            if (sides and not central) or not self.low[i] <= there[i] <= self.high[i]:
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

    def descend(self, z, part, most):
        """Least squares from z, until the sum of squares changes by less than a part of itself."""
        function = lambda x: self.kept(x)  # noqa: E731
        return optimize.least_squares(
            function, z, lambda x: self.jacobian(x), bounds=(self.low, self.high), x_scale="jac", ftol=part, xtol=1e-7, max_nfev=most
        )

    def kept(self, z):
        """Residuals at z, which the derivatives there need again."""
        self.last = (z.copy(), self.residuals(z))
        return self.last[1]

    def solve(self, starts, most=MANY):
        """Least squares: a few steps from the best of the starts, `most` from the best of those: (values, sum of squares, z)."""
        ranked = sorted(((float((r**2).sum()), i, z) for i, z in enumerate(map(self.seen_start, starts)) for r in [self.residuals(z)]))
        ranked = [entry for entry in ranked if entry[0] < self.count * REJECTED**2][:BEST_STARTS]
        if not ranked:
            raise Fault(f"the library refuses every card that the fit could start from ({self.refusal(starts[0])}); change --start or "
                "--fix.", NUMERICAL)
        z = ranked[0][2]
        if len(ranked) > 1:
            z = min((self.descend(entry[2], ROUGH, FEW) for entry in ranked), key=lambda found: found.cost).x
        best = self.descend(numpy.clip(z, self.low + 1e-9, self.high - 1e-9), EXACT, most)
        return self.at(best.x), 2.0 * best.cost, best.x
