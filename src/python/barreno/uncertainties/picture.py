# SPDX-License-Identifier: BSD-3-Clause
"""The tornado chart: what each range does to an answer, the largest first, above the interval of all."""

import math

from barreno.runs.pictures import save
from barreno.runs.plots import plt

MOST_BARS = 12
MOST_ANSWERS = 6
LOW_COLOUR, HIGH_COLOUR, ALL_COLOUR, CELLS_COLOUR = "C0", "C1", "0.45", "0.8"


def swing(effect):
    return max(abs(effect.at_low), abs(effect.at_high), abs(effect.at_high - effect.at_low))


def label_of(effect, one):
    share = f"{100.0 * effect.share:.0f} %" if effect.told else "not told from scatter"
    return f"{one.name()}, {one.text()}\n{share}"


def shown(answer, ranges):
    """Those that change the answer, the largest last."""
    changing = [i for i in range(len(ranges)) if swing(answer.runs.effects[i]) > 0.0]
    return sorted(changing, key=lambda i: swing(answer.runs.effects[i]))[-MOST_BARS:]


def draw_bars(axes, answer, ranges):
    order = shown(answer, ranges)
    centre = answer.factor * answer.runs.centre
    for row, i in enumerate(order):
        effect, faint = answer.runs.effects[i], 1.0 if answer.runs.effects[i].told else 0.35
        for change, colour in ((effect.at_low, LOW_COLOUR), (effect.at_high, HIGH_COLOUR)):
            axes.barh(row, answer.factor * change, left=centre, height=0.6, color=colour, alpha=faint)
    axes.axvline(centre, color="k", lw=0.8)
    axes.set_yticks(range(len(order)), [label_of(answer.runs.effects[i], ranges[i]) for i in order], fontsize=7)


def draw_intervals(axes, answer):
    """Below the bars: the interval of all ranges, and that with the error of the cells."""
    rows = [("all ranges, 90 %", answer.runs, ALL_COLOUR), *([("with error of cells", answer.whole, CELLS_COLOUR)] if answer.whole else [])]
    ticks, labels = list(axes.get_yticks()), [text.get_text() for text in axes.get_yticklabels()]
    for row, (label, spread, colour) in enumerate(rows, 1):
        axes.barh(-row, answer.factor * (spread.high - spread.low), left=answer.factor * spread.low, height=0.6, color=colour)
        axes.plot([answer.factor * spread.median] * 2, [-row - 0.3, -row + 0.3], "k", lw=1.5)
        ticks.append(-row)
        labels.append(label)
    axes.set_yticks(ticks, labels, fontsize=7)


def draw(file, answers, ranges):
    answers = answers[:MOST_ANSWERS]
    columns = min(2, len(answers))
    lines = math.ceil(len(answers) / columns)
    bars = max(len(shown(answer, ranges)) for answer in answers) + 2
    figure, panels = plt.subplots(lines, columns, figsize=(6.5 * columns, lines * (1.2 + 0.36 * bars)), layout="constrained", squeeze=False)
    for axes, answer in zip(panels.flat, answers):
        axes.use_sticky_edges = False
        draw_bars(axes, answer, ranges)
        draw_intervals(axes, answer)
        axes.set_xlabel(f"{answer.words} [{answer.unit}]" if answer.unit else answer.words)
        axes.grid(axis="x", alpha=0.3)
        axes.set_axisbelow(True)
    for axes in list(panels.flat)[len(answers) :]:
        axes.set_visible(False)
    ends = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in (LOW_COLOUR, HIGH_COLOUR)]
    panels[0, 0].legend(ends, ["at the low end of its range", "at the high end"], loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2,
        fontsize=8, frameon=False)
    save(figure, file)
