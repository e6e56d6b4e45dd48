# SPDX-License-Identifier: BSD-3-Clause
"""Lines of the screen, and the numbers of uncertainty.json."""

import math

from barreno.compare.results import list_of
from barreno.runs.tables import aligned
from barreno.uncertainties.spread import FAIR, LEVEL, confidence_of_span, is_selected
from barreno.uncertainties.words import LATIN

MOST_NAMED = 3  # contributors in a sentence
LEAST_NAMED = 0.05  # share


def digits_for(low, high):
    """Decimals that tell the ends of an interval apart, by two digits of its width."""
    width = high - low
    return 0 if not width > 0.0 else max(0, min(9, 1 - math.floor(math.log10(width))))


def numbers_of(answer, *values, spread=None):
    """Texts in the unit of an answer, all with as many decimals."""
    spread = spread or answer.best()
    decimals = digits_for(answer.factor * spread.low, answer.factor * spread.high)
    return [f"{answer.factor * value:.{decimals}f}" for value in values]


def interval_text(answer, spread):
    low, high = numbers_of(answer, spread.low, spread.high, spread=spread)
    return f"{low} to {high}"


def percent(share):
    return f"{100.0 * share:.0f} %"


def answer_table(answers):
    lines = [["answer", "median", f"{percent(LEVEL)} of cases", "with error of cells", "least and largest run"]]
    for answer in answers:
        whole = interval_text(answer, answer.whole) if answer.whole else "unknown"
        lines.append([f"{answer.words} [{answer.unit}]" if answer.unit else answer.words,
            *numbers_of(answer, answer.runs.median, spread=answer.runs), interval_text(answer, answer.runs), whole,
            " to ".join(numbers_of(answer, min(answer.values), max(answer.values), spread=answer.runs))])
    return aligned(lines)


def share_text(effect):
    return percent(effect.share) if effect.told else f"({percent(effect.share)})"


def share_table(answers, ranges):
    lines = [["share of the variance", "range", "known", *(answer.words for answer in answers)]]
    selected = is_selected(len(answers[0].values), len(ranges))
    for i, one in enumerate(ranges):
        if selected and not any(answer.runs.effects[i].told for answer in answers):
            continue
        lines.append([one.name(), one.text(), one.known, *(share_text(answer.runs.effects[i]) for answer in answers)])
    if answers[0].runs.rest is not None:
        rest = "interaction, scatter and other ranges" if selected else "interaction and scatter"
        lines.append([rest, "", "", *(percent(answer.runs.rest) for answer in answers)])
    return aligned(lines)


def contributors(answer, ranges):
    """The largest shares that scatter does not explain, as words."""
    named = [(effect.share, one.name()) for effect, one in zip(answer.runs.effects, ranges) if effect.told and effect.share >= LEAST_NAMED]
    return [f"{percent(share)} from {name}" for share, name in sorted(named, reverse=True)[:MOST_NAMED]]


def sentence(answer, ranges):
    """Depth 131 mm, 122 to 140 mm at 90 % (...); of its variance 62 % from Sandstone/FSLOPE and 20 % from Jet/Velocity."""
    best, unit = answer.best(), f" {answer.unit}" if answer.unit else ""
    (median,) = numbers_of(answer, best.median)
    if answer.whole:
        (runs,) = numbers_of(answer, answer.runs.median)
        counted = f"with the measured error of the cells; the runs themselves {runs}{unit}"
    else:
        counted = f"the error of the cells is not in it: {answer.cells_unknown}"
    named = contributors(answer, ranges)
    most = f"of its variance {list_of(named)}" if named else "no range stands out from the scatter"
    head = f"{answer.words[0].upper()}{answer.words[1:]} {median}{unit}"
    return f"{head}, {interval_text(answer, best)}{unit} at {percent(LEVEL)} ({counted}); {most}."


def doubts(answers):
    """What the numbers do not bear."""
    doubtful = [(answer, answer.runs.foretold) for answer in answers if answer.runs.foretold is not None and answer.runs.foretold < FAIR]
    if not doubtful:
        return []
    said = list_of([f"{answer.words} {percent(max(foretold, 0.0))}" for answer, foretold in doubtful])
    return [f"The shares say little where straight effects of the ranges foretell less than {percent(FAIR)} of the variance of runs "
        f"that they were not made of: {said}. More runs (--runs) or fewer ranges (--hold) help, and so does --design one-at-a-time where "
        "answers bend."]


def selection_lines(count, ranges):
    if not is_selected(count, len(ranges)):
        return []
    return [f"{count} runs are too few for a share of each of {len(ranges)} ranges: only those that stand out have one. The rest counts as "
        "scatter, and is in the intervals."]


def method_lines(design, count, ranges):
    if design != LATIN:
        return ["One at a time: interactions and scatter are not in the intervals and shares."]
    return [*selection_lines(count, ranges),
        f"Shares in brackets: no more than scatter may give. Least and largest of {count} runs hold {percent(LEVEL)} of all cases "
        f"with a confidence of {percent(confidence_of_span(count))}."]


def lines_of(answers, ranges, design, count):
    if not answers:
        return ["No answer can be looked at."]
    told = [answer for answer in answers[1:] if contributors(answer, ranges)]
    sentences = [sentence(answer, ranges) for answer in (answers[0], *told)]
    remarks = [*method_lines(design, count, ranges), *doubts(answers), *sentences]
    return [*answer_table(answers), "", *share_table(answers, ranges), "", *remarks]


def spread_numbers(spread, ranges):
    effects = {one.path: {"share": effect.share, "at_low": effect.at_low, "at_high": effect.at_high, "told_from_scatter": effect.told}
        for one, effect in zip(ranges, spread.effects)}
    return {"low": spread.low, "median": spread.median, "high": spread.high, "rest": spread.rest, "foretold": spread.foretold,
        "centre": spread.centre, "effects": effects}


def as_numbers(answers, ranges):
    """Of uncertainty.json, SI."""
    found = {}
    for answer in answers:
        found[answer.name] = {
            "words": answer.words, "level": LEVEL, "runs": len(answer.values), "least": min(answer.values), "largest": max(answer.values),
            "confidence_of_least_and_largest": confidence_of_span(len(answer.values)), "ranges": spread_numbers(answer.runs, ranges),
            "with_cells": spread_numbers(answer.whole, ranges) if answer.whole else None, "cells_unknown": answer.cells_unknown,
            "sentence": sentence(answer, ranges),
        }  # fmt: skip
    return found
