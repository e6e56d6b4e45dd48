# SPDX-License-Identifier: BSD-3-Clause
"""The fit: three stages from many starts, ranges, and the parameters that the data leave open."""

from dataclasses import dataclass

import numpy

from barreno_fit import guess
from barreno_fit.faults import Fault
from barreno_fit.kinds import KINDS
from barreno_fit.parameters import PARAMETERS, free_of, seen, shown
from barreno_fit.ranges import LEAST_SCALE, Better, at_bound, range_of, spread_of
from barreno_fit.search import Problem, Search, residuals_of, size_of

HYDROSTATIC = ("hydrostatic", "bulk modulus", "crush pressure", "open pores")
SETTLED = 1.02  # of the sum of squares of the best fit: all parameters that go back to their start may not cost more
RESTARTS = 4  # from better minima that profiles find


@dataclass
class Result:
    """values: of the fitted parameters; ranges: name -> (low, high); open: name -> sentence."""

    values: dict
    ranges: dict
    left_open: dict
    rho: float
    card: dict


def joint_starts(values, names):
    """What the stages found, and the same with other shapes of the cap and of the limit surface, which a stage may have left at a bound."""
    starts = [values]
    for CR in (0.2, 0.5, 0.8):
        for slope in (0.03, 0.3):
            other = dict(values)
            if "CR" in names:
                other["CR"] = CR
            if "YSLOPE" in names and "FSLOPE" in values:
                other["YSLOPE"] = slope * values["FSLOPE"]
            starts.append(other)
    return unique(starts)


def together(search, values, simpler):
    """The joint fit from what the stages found; where the tests of one stage cannot be made with what the other found, from the simpler card."""
    try:
        return search.solve(joint_starts(values, search.names))
    except Fault:
        return search.solve([simpler])


def off_bounds(search, found):
    """Parameters that end at a bound are tried from the middle of what rock has: a valley may lie between."""
    for i, name in enumerate(search.names):
        if not at_bound(search, i, found[2]):
            continue
        other = {**found[0], name: search.problem.card({})[name]}
        try:
            tried = search.solve([other])
        except Fault:
            continue
        if tried[1] < found[1]:
            found = tried
    return found


def sentence(search, name, value, start, stuck, kept):
    if kept:
        return f"{name} is not determined by these data and is kept at its start, {shown(name, start)}."
    why = "stands at its bound" if stuck else "is not determined by these data, which only bound it,"
    return f"{name} {why} and is kept at {shown(name, value)} (its start, {shown(name, start)}, fits worse)."


def without(search, name, value, values):
    """The fit of the others with one parameter held: its search, and (values, sum of squares, z) or None where the library refuses."""
    rest = [other for other in search.names if other != name]
    trial = Search(search.problem, search.tests, rest, {**values, name: value})
    if not rest:
        return trial, ({**values, name: value}, float((trial.residuals(numpy.zeros(0)) ** 2).sum()), numpy.zeros(0))
    try:
        found = trial.solve([values])
    except Fault:
        return trial, None
    return trial, ({**found[0], name: value}, *found[1:])


def leave_open(search, found):
    """Those that the data leave open go back to their start, one after the other, or stay where they are if their start fits worse."""
    left_open, best = {}, found[1]
    while search.names:
        values, _, z = found
        spread = spread_of(search, z)
        excess = [spread.decided[i] / PARAMETERS[name].wide for i, name in enumerate(search.names)]
        stuck = [i for i in range(len(z)) if at_bound(search, i, z)]
        worst = stuck[0] if stuck else int(numpy.argmax(excess))
        if not stuck and excess[worst] <= 1.0:
            break
        name = search.names[worst]
        start = search.problem.card({})[name]
        possible = search.low[worst] <= seen(name, start) <= search.high[worst]
        trial, tried = without(search, name, start, values) if possible else (None, None)
        kept = bool(tried) and tried[1] <= SETTLED * best + LEAST_SCALE**2 * search.count
        left_open[name] = sentence(search, name, values[name], start, stuck, kept)
        if not kept:
            trial, tried = without(search, name, values[name], values)
        search, found = trial, tried or (values, found[1], numpy.delete(z, worst))
    return search, found, left_open


def ranges_of(search, found):
    """95 % ranges; where a profile finds a better minimum, that one is the solution and the ranges are made anew."""
    for last in range(RESTARTS + 1):
        values, _, z = found
        spread, ranges = spread_of(search, z), {}
        try:
            for i, name in enumerate(search.names):
                ranges[name] = range_of(search, z, spread, i, settled=last == RESTARTS)
            break
        except Better as better:
            found = search.solve([better.args[0]])
    return found, spread, ranges


def staged(problem, tests, names):
    """Crushing and bulk moduli from hydrostatic tests, then strength and shear from the others: values of both, and of the first alone."""
    values, simpler = {}, {}
    first = [test for test in tests if test.kind in HYDROSTATIC]
    rest = [test for test in tests if test.kind not in HYDROSTATIC]
    for stage, chosen, starts in (("moduli and crushing", first, guess.crushing_starts), ("strength and shear", rest, guess.strength_starts)):
        mine = [name for name in free_of(chosen, problem.card({}), problem.fixed) if name in names and name not in values] if chosen else []
        if not mine:
            continue
        problem.say(f"{stage}: {', '.join(mine)}")
        offers = [{name: value for name, value in start.items() if name in mine} for start in [{}, *starts(chosen, problem.card(values))]]
        values = Search(problem, chosen, mine, values).solve(unique(offers))[0]
        simpler = simpler or values
    return values, simpler


def fit(problem, tests):
    """Crushing and bulk moduli first, from hydrostatic tests; then strength and shear; then all together."""
    names = free_of(tests, problem.card({}), problem.fixed)
    if not names:
        raise Fault("nothing is left to fit (every parameter that these tests could determine is fixed, or 0 in the start); take a --fix out.")
    count = sum(map(size_of, tests))
    if count < len(names):
        raise Fault(f"{count} data cannot determine {len(names)} parameters ({', '.join(names)}); give more tests, or hold some with --fix.")
    values, simpler = staged(problem, tests, names)
    card = problem.card(simpler)
    problem.say("all of them together")
    search = Search(problem, tests, names, values)
    found = off_bounds(search, together(search, values, {name: card[name] for name in names}))
    search, found, left_open = leave_open(search, found)
    spread, ranges = None, {}
    if search.names:
        problem.say("their ranges")
        found, spread, ranges = ranges_of(search, found)
    for name in [name for name, (low, high) in ranges.items() if abs(seen(name, high) - seen(name, low)) > 2.0 * PARAMETERS[name].wide]:
        del ranges[name]
        left_open[name] = f"{name} is not determined by these data (its range is too wide) and is kept at {shown(name, found[0][name])}, which fits best."
    return Result({name: found[0][name] for name in names}, ranges, left_open, spread.rho if spread else 0.0, problem.card(found[0]))


def unique(offers):
    out = []
    for offer in offers:
        if offer not in out:
            out.append(offer)
    return out
