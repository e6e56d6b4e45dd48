# SPDX-License-Identifier: BSD-3-Clause
"""Which runs are made: shares of the ranges, a row for each run."""

from barreno.runs.faults import Fault
from barreno.sweeps.sample import hypercube
from barreno.uncertainties.spread import SPARE
from barreno.uncertainties.words import LATIN

LEAST_SELECTED = 12  # runs that show which of many ranges stand out
NEAR = 0.02  # of a range: the deck's value is no nearer to an end, or it would tell nothing that the end does not


def least_runs(design, ranges):
    return min(ranges + SPARE, LEAST_SELECTED) if design == LATIN else 2 * ranges + 1


def check_count(design, ranges, runs):
    least = least_runs(design, ranges)
    if runs < least:
        of_all = least == ranges + SPARE
        latin_needs = "one for each range, one for the mean and two for the scatter" if of_all else "fewer show no range among so many"
        why = latin_needs if design == LATIN else "both ends of each range and the middle"
        raise Fault(f"--runs {runs} is too few for {ranges} ranges (--design {design} needs {least}: {why}); give --runs {least}, or hold "
            "some parameters with --hold.")


def middle_of(one):
    """The deck's own value, where it tells something."""
    share = one.share_of_own()
    return share if NEAR <= share <= 1.0 - NEAR else 0.5


def latin(ranges, runs, seed):
    return [list(map(float, row)) for row in hypercube(len(ranges), runs, seed)]


def one_at_a_time(ranges):
    """The middle; then, for each range, its low and its high end."""
    middle = [middle_of(one) for one in ranges]
    rows = [middle]
    for i in range(len(ranges)):
        rows += [[*middle[:i], end, *middle[i + 1 :]] for end in (0.0, 1.0)]
    return rows


def shares_of(options, ranges):
    check_count(options.design, len(ranges), options.runs)
    return latin(ranges, options.runs, options.seed) if options.design == LATIN else one_at_a_time(ranges)
