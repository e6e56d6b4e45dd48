# SPDX-License-Identifier: BSD-3-Clause
"""The fit: three stages from many starts, ranges, and the parameters that the data leave open."""

from dataclasses import dataclass

import numpy

from barreno.fit import guess
from barreno.fit.kinds import KINDS
from barreno.fit.parameters import PARAMETERS, free_of, seen, shown
from barreno.fit.profiles import Better
from barreno.fit.ranges import at_bound, range_of, shown_range, spread_of
from barreno.fit.search import EXACT, FEW, LEAST_SCALE, MANY, REJECTED, ROUGH, Problem, Search, size_of
from barreno.fit.weights import weigh
from barreno.runs.faults import Fault

HYDROSTATIC = ("hydrostatic", "bulk modulus", "crush pressure", "open pores")
SETTLED = 1.02  # of the sum of squares of the best fit: all parameters that go back to their start may not cost more
SHAPES = (0.5, 0.25, 0.75)  # of CR: the cap is held there in turn
OTHERS = (0.25, 0.4, 0.6, 0.75)  # of CR: the joint fit is tried from these
NEAR = 0.05  # of CR: a fit that ends so near to a shape is not tried from it
STRAIGHT = 0.03  # of FSLOPE: YSLOPE where the cap is held
HOPE = 10.0  # of the sum of squares: a fit with the cap held that is worse has no better minimum beside it
RESTARTS = 2  # from better minima that profiles find


@dataclass
class Result:
    """values: of the fitted parameters; ranges: name -> (low, high); open: name -> sentence."""

    values: dict
    ranges: dict
    left_open: dict
    rho: float
    card: dict


def elsewhere(search, found, CR):
    """The fit that is reached when the cap is held at another shape first, and then let go: (values, sum of squares, z), or None."""
    rest = [name for name in search.names if name != "CR"]
    held = Search(search.problem, search.tests, rest, {**found[0], "CR": CR})
    z = held.seen_start(found[0])
    if (held.residuals(z) == REJECTED).all():
        return None
    first = held.descend(z, ROUGH, FEW)
    if 2.0 * first.cost > HOPE * found[1]:
        return None
    best = search.descend(search.seen_start(held.at(first.x)), EXACT, MANY)
    return search.at(best.x), 2.0 * best.cost, best.x


def other_shapes(search, found):
    """A cap and a limit surface of the wrong shape can make up for each other: a minimum that the optimiser does not leave by itself."""
    if "CR" not in search.names:
        return found
    for CR in OTHERS:
        tried = None if abs(found[0]["CR"] - CR) < NEAR else elsewhere(search, found, CR)
        if tried and tried[1] < found[1]:
            found = tried
    return found


def together(search, starts, simpler):
    """The joint fit from what the stages found; where the tests of one stage cannot be made with what the other found, from the simpler
    card."""
    try:
        found = search.solve(starts)
    except Fault:
        found = search.solve([simpler])
    return other_shapes(search, found)


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


def ranges_of(search, found, names, settled):
    """95 % ranges of these parameters, with all others free, those that are left open too: what they are kept at is no measurement."""
    values, _, z = found
    spread = spread_of(search, z)
    chosen = [i for i, name in enumerate(search.names) if name in names]
    ends = {i: range_of(search, z, spread, i, settled) for i in chosen}
    return spread, {search.names[i]: shown_range(search, spread, i, ends[i]) for i in chosen}


def opened_and_ranged(search, found):
    """What is left open, and the ranges of the others; where a profile finds a better minimum, that one is the solution and all is made
    anew."""
    for last in range(RESTARTS + 1):
        rest, kept, left_open = leave_open(search, found)
        if not rest.names:
            return kept, None, {}, left_open
        try:
            spread, ranges = ranges_of(search, found, rest.names, last == RESTARTS)
            break
        except Better as better:
            found = search.solve([better.args[0]])
    if left_open:  # the kept values are another point of the same valley, and their own ranges belong to it
        beside = ranges_of(rest, kept, rest.names, True)[1]
        ranges = {name: (min(low, beside[name][0]), max(high, beside[name][1])) for name, (low, high) in ranges.items()}
    return kept, spread, ranges, left_open


def with_shapes(search, offers):
    """Where a few steps lead from the best of the offers while the cap is held at each of some shapes and the limit surface at a line that
    is nearly straight: moduli that are a little off drive a free cap into a corner that the joint fit does not leave."""
    out, rest = [], [name for name in search.names if name not in ("CR", "YSLOPE")]
    if "CR" not in search.names or not rest:
        return out
    for CR in SHAPES:
        ranked = []
        for i, offer in enumerate(offer for offer in offers if offer.get("CR") == 0.5):
            straight = {"YSLOPE": STRAIGHT * offer["FSLOPE"]} if {"FSLOPE", "YSLOPE"} <= set(offer) else {}
            offer = {**offer, **straight, "CR": CR}
            held = Search(search.problem, search.tests, rest, {**search.values, **offer})
            z = held.seen_start(offer)
            ranked.append((float((held.residuals(z) ** 2).sum()), i, held, z))
        squares, _, held, z = min(ranked, default=(numpy.inf, 0, None, None))
        if squares < search.count * REJECTED**2:
            out.append(held.at(held.descend(z, ROUGH, FEW).x))
    return out


def staged(problem, tests, names):
    """Crushing and bulk moduli from hydrostatic tests, then strength and shear from the others: starts of the joint fit, and the values of
    the first stage alone."""
    values, simpler, shapes = {}, {}, []
    first = [test for test in tests if test.kind in HYDROSTATIC]
    rest = [test for test in tests if test.kind not in HYDROSTATIC]
    for stage, chosen, starts in (("moduli and crushing", first, guess.crushing_starts),
            ("strength and shear", rest, guess.strength_starts)):
        mine = [name for name in free_of(chosen, problem.card({}), problem.fixed) if name in names and name not in values] if chosen else []
        if not mine:
            continue
        problem.say(f"{stage}: {', '.join(mine)}")
        offers = unique([{name: value for name, value in start.items() if name in mine}
            for start in [{}, *starts(chosen, problem.card(values))]])
        search = Search(problem, chosen, mine, values)
        shapes = with_shapes(search, offers)
        values = search.solve(offers, FEW if shapes else MANY)[0]
        simpler = simpler or values
    return [values, *shapes], simpler


def fit(problem, tests):
    """Crushing and bulk moduli first, from hydrostatic tests; then strength and shear; then all together."""
    names = free_of(tests, problem.card({}), problem.fixed)
    if not names:
        raise Fault("nothing is left to fit (every parameter that these tests could determine is fixed, or 0 in the start); take a --fix "
            "out.")
    count = sum(map(size_of, tests))
    if count < len(names):
        raise Fault(f"{count} data cannot determine {len(names)} parameters ({', '.join(names)}); give more tests, or hold some with "
            "--fix.")
    starts, simpler = staged(problem, tests, names)
    card = problem.card(simpler)
    problem.say("all of them together")
    search = Search(problem, tests, names, starts[0])
    found = off_bounds(search, together(search, starts, {name: card[name] for name in names}))
    found = weigh(search, found)
    search.visited.clear()  # with other weights
    found = other_shapes(search, found)
    problem.say("their ranges")
    found, spread, ranges, left_open = opened_and_ranged(search, found)
    for name in [name for name, (low, high) in ranges.items() if abs(seen(name, high) - seen(name, low)) > 2.0 * PARAMETERS[name].wide]:
        del ranges[name]
        left_open[name] = (
            f"{name} is not determined by these data (its range is too wide) and is kept at {shown(name, found[0][name])}, which fits best."
        )
    return Result({name: found[0][name] for name in names}, ranges, left_open, spread.rho if spread else 0.0, problem.card(found[0]))


def unique(offers):
    out = []
    for offer in offers:
        if offer not in out:
            out.append(offer)
    return out
