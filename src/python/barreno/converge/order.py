# SPDX-License-Identifier: BSD-3-Clause
"""Order and interval of one number that was computed with cells of several sizes.

Three levels h1 < h2 < h3 with values f1, f2, f3, r21 = h2/h1 and r32 = h3/h2. If f = f0 + C h^p, the order p solves

    (f3 - f2)/(f2 - f1) = r21^p (r32^p - 1)/(r21^p - 1)

(Celik et al., J. Fluids Eng. 130, 078001, 2008, eq. 3, in another form), f0 = f1 + (f1 - f2)/(r21^p - 1), and the Grid Convergence Index
is the interval f1 +- F |f1 - f2|/(r21^p - 1) (Roache, J. Fluids Eng. 116, 405, 1994). F = 1.25 with the observed order of three levels. The
order in the last two is at most the formal one, because chance gives a sequence a high order and too narrow an interval; where the observed
order is above it by more than a tenth, the levels confirm no order, and F = 3 as for two levels and the formal order (Roache; Oberkampf and
Roy, Verification and Validation in Scientific Computing, 2010, section 8.6). Cells that do not resolve what a number depends on are in no
sequence with others: where the two smaller sizes resolve it and agree, they alone give an interval.
"""

import dataclasses
import math

SAFETY, UNCONFIRMED_SAFETY = 1.25, 3.0
NEAR_FORMAL = 1.1  # observed over formal order up to which the levels confirm the latter
LEAST_ORDER = 0.5
LARGEST_ROOT = 50.0
ROUND_OFF = 1e-12

CONVERGES, EQUAL, OSCILLATES, DIVERGES = "converges", "equal", "oscillates", "diverges"
OUT_OF_RANGE, UNRESOLVED, FEW, TWO_AGREE = "order out of range", "unresolved", "two levels", "two agree"
AGREE = 0.02  # of a value: how far two levels may differ that stand for themselves


@dataclasses.dataclass
class Verdict:
    """What a sequence says. Without an order there is no limit, and low to high is the spread of the levels."""

    kind: str
    value: float  # with the smallest cells
    low: float
    high: float
    order: float | None = None  # as observed
    order_used: float | None = None
    limit: float | None = None  # extrapolated


def right_side(p, r21, r32):
    """r21^p (r32^p - 1)/(r21^p - 1): grows with p, from ln r32/ln r21 at p = 0."""
    return math.exp(p * math.log(r21)) * math.expm1(p * math.log(r32)) / math.expm1(p * math.log(r21))


def observed_order(cells, values):
    """Order p > 0 of three levels, the smallest cells first; inf if the two smallest agree; None without one."""
    (h1, h2, h3), (f1, f2, f3) = cells, values
    if not h1 < h2 < h3:
        raise ValueError(f"cells {cells} do not grow")
    if f2 == f1:
        return math.inf if f3 != f2 else None
    ratio = (f3 - f2) / (f2 - f1)
    r21, r32 = h2 / h1, h3 / h2
    if not ratio > math.log(r32) / math.log(r21):
        return None
    low, high = 0.0, LARGEST_ROOT
    if right_side(high, r21, r32) < ratio:
        return math.inf
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if right_side(middle, r21, r32) < ratio else (low, middle)
    return 0.5 * (low + high)


def spread(kind, values, order=None):
    """Of a sequence without an order: the value of the smallest cells, give or take how far the levels differ."""
    width = max(values) - min(values)
    return Verdict(kind, values[0], values[0] - width, values[0] + width, order)


def two_that_agree(cells, values, formal):
    """Of two levels that resolve what a third does not: the value of the smallest cells, give or take what cells of first order would leave
    of it, with the factor of two levels. Two values may be equal by chance: their difference counts as if it fell with no more than twice
    the formal order."""
    difference = max(abs(values[0] - values[1]), abs(values[1] - values[2]) * (cells[1] / cells[2]) ** (2.0 * formal))
    width = UNCONFIRMED_SAFETY * difference / (cells[1] / cells[0] - 1.0)
    return Verdict(TWO_AGREE, values[0], values[0] - width, values[0] + width)


def judge(cells, values, formal=2.0, resolved=3):
    """The verdict on a sequence, the smallest cells first; the three smallest count.
    @param resolved  how many of these, from the smallest on, resolve what the number depends on"""
    cells, values = cells[:3], values[:3]
    scale = max(abs(value) for value in values)
    if max(values) - min(values) <= ROUND_OFF * scale:
        return Verdict(EQUAL, values[0], values[0], values[0], limit=values[0])
    if len(values) < 3:
        return spread(FEW, values)
    order = observed_order(cells, values)
    if resolved == 2 and abs(values[0] - values[1]) <= AGREE * abs(values[0]):
        return two_that_agree(cells, values, formal)
    if resolved < 3:
        return spread(UNRESOLVED, values, order)
    if (values[2] - values[1]) * (values[1] - values[0]) < 0.0:
        return spread(OSCILLATES, values)
    if order is None:
        return spread(DIVERGES, values)
    if not LEAST_ORDER <= order <= 2.0 * formal:
        return spread(OUT_OF_RANGE, values, order)
    used = min(order, formal)
    step = (values[0] - values[1]) / math.expm1(used * math.log(cells[1] / cells[0]))
    width = (SAFETY if order <= NEAR_FORMAL * formal else UNCONFIRMED_SAFETY) * abs(step)
    return Verdict(CONVERGES, values[0], values[0] - width, values[0] + width, order, used, values[0] + step)


def sentence(verdict, formal=2.0):
    """Why there is no limit; empty where there is one."""
    if verdict.kind in (CONVERGES, EQUAL):
        return ""
    if verdict.kind == TWO_AGREE:
        return ("not extrapolated: the largest cells are wider than the radius of the jet and are left out, and two levels show no order; "
            f"these two agree to {100.0 * AGREE:g} %, and "
                f"the interval is {UNCONFIRMED_SAFETY:g} times what cells of first order would leave")  # fmt: skip
    if verdict.kind == OUT_OF_RANGE:
        seen = "above any bound" if math.isinf(verdict.order) else f"{verdict.order:.2f}"
        why = f"the observed order, {seen}, is outside of {LEAST_ORDER:g} to {2.0 * formal:g}"
    else:
        why = {
            OSCILLATES: "the differences between the levels change their sign",
            DIVERGES: "the differences between the levels do not fall as the cells are made smaller",
            FEW: "two levels show no order",
            UNRESOLVED: "the largest cells are wider than the radius of the jet, so the sequence has no order yet",
        }[verdict.kind]
    return (
        f"not extrapolated: {why}; the interval is the spread of the levels about the value of the smallest cells, without a level of "
        "confidence"
    )
