# SPDX-License-Identifier: BSD-3-Clause
"""Errors of depths with divided particles of the jet, from depth_shots.json and depth_scatter.json of verification/results;
and a part of docs/trade.md."""
import json
import statistics

from scipy.optimize import brentq
from tools.case_list import RESULTS
from tools.depth_shots import SHOTS, STEP, TIMES, UNLIKE, widest_slug

DECK = "the deck"
RESTED, AT_REST = "the deck, to rest", "depth at rest"  # of the tip, whose thread grows on
# Shots that the intervals are made from; others try them.
MADE_FROM = (DECK, RESTED, "former rock", "former rock, no confinement", "former rock, no steel casing",
    "former rock, losses returned")  # fmt: skip
FROM = 60  # us: the earlier hole is much wider than its slugs, and its depth that of any cells
REST = TIMES[-1]  # us: the hole as wide as the jet no longer grows
WHAT = ("depth", "probed depth", "volume")
FLOW = "efficiency"  # kept since the rock of a shot has Broken dilatancy
ANSWERS = (*WHAT, FLOW)
RESTING = ("volume", FLOW)  # only where something holds the rock
WORDS = {"depth": "the tip", "probed depth": "the hole as wide as the jet", "volume": "the volume of the hole",
    FLOW: "the core flow efficiency"}  # fmt: skip
UNITS = {"depth": ("mm", 1e3, 0), "probed depth": ("mm", 1e3, 0), "volume": ("cm3", 1e6, 1), FLOW: ("-", 1.0, 3)}  # factor, digits
STORED = {"probed depth": "wide_depth", "volume": "channel_volume", FLOW: "efficiency"}
LIKE = 1.1  # how far the program takes another jet for that of the deck (src/jet/divided_error.cpp)
# Standard deviations of one run by which two single runs may differ: where the interval of one is held against another (docs/trade.md).
APART = 3.0
HIGHEST_ORDER = 4.0  # more is a last change that is small by chance


def wide_depth(profile, probe):
    """How far a hole is as wide as a probe but for necks, by the rule of measure_channel (src/jet/channel.cpp), from the radii [mm] that
    are stored every STEP mm [m]."""
    wide = [radius >= probe for radius in profile]
    reach = round(10.0 * probe / STEP)
    wide += [False] * reach
    for row in range(len(profile)):
        side = min(reach, row)
        if 2 * sum(wide[row - side : row + side + 1]) <= 2 * side + 1:
            return 1e-3 * STEP * (row + 0.5)
    return 1e-3 * STEP * (len(profile) + 0.5)


def with_wide_depth(one, radius=1.0):
    """As the run says it; of runs that were made before that rule, and keep no zones, by their radii."""
    newer = "zones_in_body" in one
    return {**one, "wide_depth": one["probed_depth"] if newer else wide_depth(one["profile"], 1e3 * widest_slug() * radius)}


def shots():
    """{shot: {cells: what was measured}}"""
    found = json.loads((RESULTS / "depth_shots.json").read_text())
    return {shot: {float(cells): with_wide_depth(one, SHOTS[shot][1].get("radius", 1.0)) for cells, one in runs.items()}
        for shot, runs in found.items()}  # fmt: skip


def repeats():
    """{cells: runs of the deck that should agree}, of those cells with which there are several"""
    found = json.loads((RESULTS / "depth_scatter.json").read_text())
    return {float(cells): [{**one, "wide_depth": one["probed_depth"]} for one in runs.values()]
        for cells, runs in found.items() if len(runs) > 1}  # fmt: skip


def mean_at(cells, single, what, time):
    """Depth of the deck: the mean of runs that should agree, or that of the only run."""
    return statistics.mean(at(one, what, time) for one in repeats().get(cells, [single]))


def deviation(runs, what, time):
    """Standard deviation of one of several runs over their mean, in the program's own numbers, which are finer than stored radii."""
    depths = [one["probed_depth"] if what == "probed depth" else at(one, what, time) for one in runs]
    return statistics.stdev(depths) / statistics.mean(depths)


def scatter(what):
    """By how much single runs may differ, at the worst of all times and cells."""
    return APART * max(deviation(runs, what, time) for runs in repeats().values() for time in times_of(what))


def times_of(what):
    return [time for time in TIMES if time >= FROM] if what == "depth" else [REST]


def at(one, what, time):
    if what == "depth":
        return one["depth"][min(TIMES.index(time), len(one["depth"]) - 1)]  # of shots that end earlier the last
    return one[STORED[what]]


def knows(one, what):
    return what == "depth" or STORED[what] in one


def answers_of(runs):
    """What all runs of a shot know."""
    return [what for what in ANSWERS if all(knows(one, what) for one in runs.values())]


def changes(runs, coarse, fine, what):
    """Depth of the deck with some cells over that with smaller ones, less 1, at every time that counts."""
    return [mean_at(coarse, runs[coarse], what, time) / mean_at(fine, runs[fine], what, time) - 1.0 for time in times_of(what)]


def doubt(runs, what):
    """How far the smallest cells may be from the truth: as far as the next larger ones are from them; of what shows no order, whose last
    change may be small by chance, as far as either of the two before."""
    *_, earlier, before, finest = sorted(runs)
    ordered = order_of({cells: mean_at(cells, one, what, REST) for cells, one in runs.items()}) is not None
    others = (before,) if ordered else (earlier, before)
    return max(abs(change) for cells in others for change in changes(runs, cells, finest, what))


def is_bare(shot):
    """Whether nothing holds the rock of a shot, the volume of whose hole does not rest."""
    return SHOTS[shot][0].get("Confinement") == ""


def ranges_of(shot, cells, what):
    """Errors of a shot beside the deck with some cells, at every time that counts."""
    runs, others = shots()[DECK], shots()[shot]
    own, finest = max(others), max(runs)
    if what not in answers_of(others):
        return []
    if cells in others and cells < own:
        lacks = changes(runs, own, finest, what) if own < finest else [0.0 for _ in times_of(what)]
        return [at(others[cells], what, time) / at(others[own], what, time) * (1.0 + lack) - 1.0
            for time, lack in zip(times_of(what), lacks)]  # fmt: skip
    if what not in RESTING or cells < own or len(others) < 2:
        return []
    before = sorted(others)[-2]  # it may fall with smaller cells where that of the deck grows
    reach = abs(at(others[before], what, REST) / at(others[own], what, REST) - 1.0)
    return [-reach, reach]


def errors():
    """{cells per radius: {what: (value, low, high)}}: the last error of the deck; and the range of those of MADE_FROM at every time that
    counts, widened by what the smallest cells of the deck lack and by the scatter of runs. The smallest cells of another shot have the
    error that they have in the deck, if that was run with smaller ones; of its volume they may be as far from the truth as the next
    larger ones are from them. The volume of a hole without confinement does not rest, and makes none, nor does the flow into it."""
    found, runs = {}, shots()[DECK]
    finest = max(runs)
    for cells in sorted(shots()[RESTED]):  # smaller ones were not run to rest
        for what in answers_of(runs):
            of_deck = changes(runs, cells, finest, what)
            ranges = [*of_deck, 0.0]  # what was found may be right
            for shot in MADE_FROM[1:]:
                if what not in RESTING or not is_bare(shot):
                    ranges += ranges_of(shot, cells, what)
            more = doubt(runs, what) + scatter(what)
            found.setdefault(cells, {})[what] = (of_deck[-1], min(ranges) - more, max(ranges) + more)
            if what == "depth":
                found[cells][AT_REST] = resting_error(cells)
    return found


def resting_error(cells):
    """Of the tip of the deck at rest: the error, widened by the last change, then or before, and by the scatter of runs."""
    runs = shots()[RESTED]
    *_, before, finest = sorted(runs)
    error = runs[cells]["tip"] / runs[finest]["tip"] - 1.0
    more = max(abs(runs[before]["tip"] / runs[finest]["tip"] - 1.0), doubt(shots()[DECK], "depth")) + scatter("depth")
    return error, min(error, 0.0) - more, max(error, 0.0) + more


def covered(depth, error, truth):
    """Whether the interval of a depth holds another depth."""
    _, low, high = error
    return depth / (1.0 + high) <= truth <= depth / (1.0 + low)


def trials():
    """(shot, cells, smallest cells, what, depth, interval, depth with the smallest cells, whether the interval holds it) of all shots"""
    known = errors()
    for shot, runs in shots().items():
        finest = max(runs)
        for cells in sorted(runs):
            if cells == finest or cells not in known:
                continue
            for what in [of for of in answers_of(runs) if of not in RESTING or not is_bare(shot)]:
                of_rest = shot == RESTED and what == "depth"
                depth, truth = (runs[c]["tip"] if of_rest else at(runs[c], what, REST) for c in (cells, finest))
                error = known[cells][AT_REST if of_rest else what]
                interval = depth / (1.0 + error[2]), depth / (1.0 + error[1])
                yield shot, cells, finest, what, depth, interval, truth, covered(depth, error, truth)


AGREE = """
Runs that should agree: the deck with Courant Fractions from 0.765 to 0.8 (`verification/depth_shots.py BARRENO --courant`), at {rest} us:
"""


def scatter_table():
    head = ("cells per radius", "runs", "depth, mean [mm]", "deviation", "as wide as the jet, mean [mm]", "deviation",
        "volume of the channel, mean [cm3]", "deviation", "core flow efficiency, mean", "deviation")  # fmt: skip
    lines = [AGREE.format(rest=REST).strip(), "", "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for cells, runs in sorted(repeats().items()):
        row = [f"{cells:g}", str(len(runs))]
        for what in ANSWERS:
            _, factor, digits = UNITS[what]
            mean = statistics.mean(at(one, what, REST) for one in runs)
            row += [f"{factor * mean:.{digits}f}", f"{100 * deviation(runs, what, REST):.1f} %"]
        lines.append("| " + " | ".join(row) + " |")
    return lines


FORMER, LATER, RETURNED = "former rock", "former rock, to 560 us", "losses returned"
HEAD = """## Depth at rest

The hole of `input_xml/perforation.xml` at {rest} us, by the size of the cells: its tip, how far it is as wide as the widest slug of the jet,
its volume, and the core flow efficiency with radial flow (`verification/depth_shots.py BARRENO "the deck" --cells N`; means where several
runs are there):
"""
BEFORE = """The same of the former rock at 300 us, `berea_sandstone_bounded`, which neither breaks nor melts and has no limit of strength
(`verification/depth_shots.py BARRENO "former rock" --cells N`):
"""
RESTED_HEAD = """The same runs until the hole is at rest ([jets.md](jets.md#at-rest), `verification/depth_shots.py BARRENO "{shot}" --cells N`), single
runs of the program as it is now, as is that with 4.5 cells above:
"""
WORTH = """![Radius of the hole against depth, with several sizes of cells](pictures/hole_of_cells.png)

What this is worth:

- *The hole as wide as the jet, its volume and the flow into it* are known to the intervals below, and hardly grow after {rest} us
  ([jets.md](jets.md#at-rest)). With the former rock, whose hole is narrower, they hardly did after 300 us ({grown}). A hole
  narrows slowly where it ends, and necks come and go: one of a few millimetres decided between depths of 473 and 570 mm. So `probed_depth`
  (depth.csv, summary.json and the screen) passes necks of up to five diameters of that slug, where the hole is as wide on either side.
- *The tip is that of a thread* of spent metal, thinner than the jet. Its depth is known to the interval below to {rest} us, and to one of its
  own where the run ends at rest. The thread may grow on after that.
- *Single runs scatter*, those of small cells as much as others, because each slug meets what the one before has left (below).
- *Small cells further from the path* change nothing beyond that scatter (below: small cells to 13 mm from the axis).
- *Made before the rows of a cell decided on their step together* ([method](method.md) 4.1): steps and times are less now, the answers those
  of before ([performance](performance.md#a-whole-shot)).
"""


def listed(words):
    *first, last = words
    return f"{', '.join(first)} and {last}"


def deck_table(shot=DECK):
    """A shot with each size of cells."""
    runs, several = shots()[shot], repeats() if shot == DECK else {}
    known = answers_of(runs)
    head = ("cells per radius of the tip", "runs", "tip [mm]", "as wide as the jet [mm]", "volume [cm3]",
        *(["core flow efficiency"] if FLOW in known else []), "lost by the method", "steps", "processor time of one [s]")  # fmt: skip
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for cells, one in sorted(runs.items()):
        number = len(several.get(cells, [one]))
        means = {what: mean_at(cells, one, what, REST) if shot == DECK else at(one, what, REST) for what in known}
        values = [f"{UNITS[what][1] * mean:.{UNITS[what][2]}f}" for what, mean in means.items()]
        more = [f"{100 * one['lost']:.1f} %", str(one["steps"]), f"{one['cpu_seconds']:.0f}"]
        lines.append(f"| {cells:g} | {number} | " + " | ".join(values + more) + " |")
    return lines


def rested_table():
    """The deck at rest with each size of cells, and what the program says of the tip."""
    head = ("cells per radius of the tip", "at rest after [us]", "tip [mm]", "its error, and interval", "as wide as the jet [mm]",
        "volume [cm3]", "core flow efficiency", "steps", "processor time [s]")  # fmt: skip
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for cells, one in sorted(shots()[RESTED].items()):
        value, low, high = resting_error(cells)
        tip = 1e3 * one["tip"]
        values = [f"{1e6 * one['end']:.0f}", f"{tip:.0f}", f"{100 * value:+.0f} %, {tip / (1 + high):.0f} to {tip / (1 + low):.0f} mm",
            f"{1e3 * one['probed_depth']:.0f}", f"{1e6 * one['channel_volume']:.1f}", f"{one['efficiency']:.3f}", str(one["steps"]),
            f"{one['cpu_seconds']:.0f}"]  # fmt: skip
        lines.append(f"| {cells:g} | " + " | ".join(values) + " |")
    return lines


def order_of(values):
    """p of f = f_0 + a n^-p through the last three sizes n, or None where none between 0 and HIGHEST_ORDER explains them."""
    (n1, f1), (n2, f2), (n3, f3) = sorted(values.items())[-3:]
    if (f2 - f1) * (f3 - f2) <= 0.0:
        return None
    ratio = (f3 - f2) / (f2 - f1)
    misfit = lambda p: (n2**-p - n3**-p) / (n1**-p - n2**-p) - ratio  # noqa: E731
    return brentq(misfit, 1e-6, HIGHEST_ORDER) if misfit(1e-6) * misfit(HIGHEST_ORDER) < 0.0 else None


def converged():
    """What the last smaller cells do to the hole of the deck, in words."""
    runs = shots()[DECK]
    *_, before, last = sorted(runs)
    by = {what: 100.0 * (mean_at(last, runs[last], what, REST) / mean_at(before, runs[before], what, REST) - 1.0)
        for what in answers_of(runs)}  # fmt: skip
    words = listed([f"{WORDS[what]}{' changes' if what == WHAT[0] else ''} by {change:+.1f} %" for what, change in by.items()])
    orders = {what: order_of({cells: mean_at(cells, one, what, REST) for cells, one in runs.items()}) for what in by}
    known = [f"{order:.1f} for {WORDS[what]}" for what, order in orders.items() if order is not None]
    without = [WORDS[what] for what, order in orders.items() if order is None]
    sentence = f"From {before:g} to {last:g} cells per radius {words}."
    if known:
        sentence += f" The last three sizes give an order of convergence of {listed(known) if len(known) > 1 else known[0]}."
    if without:
        names = listed(without) if len(without) > 1 else without[0]
        sentence += f" The changes of {names} do not fall steadily from size to size: no order can be measured."
    return sentence


def answer():
    found = shots()
    ends = {cells: [1e3 * found[shot][cells]["wide_depth"] for shot in (FORMER, LATER)] for cells in sorted(found[LATER])}
    grown = [f"{then:.0f} mm then and {later:.0f} mm at 560 us with {cells:g} cells per radius" for cells, (then, later) in ends.items()]
    worth = WORTH.format(rest=REST, grown=", ".join(grown))
    rested = [RESTED_HEAD.format(shot=RESTED), *rested_table()]
    former = [BEFORE, *deck_table(FORMER)]
    return "\n".join([HEAD.format(rest=REST), *deck_table(), "", converged(), "", *rested, "", *former, "", worth])


TRIALS = """### Other shots, and whether the intervals hold

Shots with divided particles at {rest} us, those of slower or faster jets as much later or earlier (`verification/depth_shots.py BARRENO`).
The former rock is `berea_sandstone_bounded`, without damage, heat and a limit of strength; its shots end at 300 us. Without confinement
broken rock flies apart, and the volume of its hole goes on growing: no interval is given. The table has what some cells give, the interval that the program gives with it, and what the smallest cells of that shot give. The intervals are made
from {made}; all other shots try them.
"""


def is_like(shot):
    """Whether the program takes the jet of a shot for that of the deck; of others it says that their error is unknown."""
    entries, factors = SHOTS[shot]
    return not UNLIKE & set(entries) and all(1.0 / LIKE <= factor <= LIKE * (1.0 + 1e-9) for factor in factors.values())


def verdict(shot, held):
    missed = [WORDS[what] for what in ANSWERS if not held[what]]
    words = "not " + (listed(missed) if len(missed) > 1 else missed[0]) if missed else "yes"
    return words if is_like(shot) else f"another jet: unknown; it would{'' if not missed else ' ' + words}"


def table():
    head = ("shot", "cells per radius", *(f"{WORDS[what]} [{UNITS[what][0]}]" for what in ANSWERS), "smallest cells", "holds")
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    rows = {}
    for one in trials():
        rows.setdefault(one[:3], {})[one[3]] = one[4:]
    for (shot, cells, finest), found in rows.items():
        texts = []
        for what in ANSWERS:
            _, factor, digits = UNITS[what]
            write = lambda value: f"{factor * value:.{digits}f}"  # noqa: E731
            if what in found:
                depth, (low, high), truth, _ = found[what]
                texts.append(f"{write(depth)}, {write(low)} to {write(high)}, {write(truth)}")
            elif what in answers_of(shots()[shot]):
                texts.append(", unknown, ".join(write(at(shots()[shot][size], what, REST)) for size in (cells, finest)))
            else:
                texts.append("")
        held = {what: what not in found or found[what][-1] for what in ANSWERS}
        lines.append(f"| {shot} | {cells:g} | " + " | ".join(texts) + f" | {finest:g} | {verdict(shot, held)} |")
    return lines


def summary():
    """How many intervals hold what smaller cells give, apart from the shots that made them and from jets that the program refuses."""
    for what in ANSWERS:
        all_of = [one for one in trials() if one[3] == what and one[0] not in (*MADE_FROM, LATER) and is_like(one[0])]
        held = sum(one[-1] for one in all_of)
        if all_of:
            yield (f"Intervals of {WORDS[what]} in shots that they were not made from: {held} of {len(all_of)} "
                f"hold{'s' if len(all_of) == 1 else ''} what smaller cells give.")  # fmt: skip


CRUSHED = """### The rock around the hole

Half-way down the rock, in runs of the same shot (`zones_in_body` of summary.json), with losses that stay lost and that are returned:
"""
SKIN = """How far the rock is crushed hardly follows the cells. The skin at one depth does, and it scatters: the least porosity of a ring a few cells
wide decides it. Take no skin of a single run to better than the range of this table; the flow into the whole hole (`barreno flow`,
[flow](flow.md)) is a mean over its length.
"""


def crushed_table():
    head = ("losses", "cells per radius", "depth [mm]", "wall [mm]", "crushed to [mm]", "least porosity", "skin")
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for shot, words in ((DECK, "stay lost"), (RETURNED, "returned")):
        for cells, one in sorted(shots()[shot].items()):
            zones = (one.get("zones_in_body") or {}).get("Rock")
            if zones:
                depth, wall, crushed = (1e3 * zones[name] for name in ("depth", "radius", "crushed_to"))
                least, skin = zones["least_porosity"], zones["skin"]
                lines.append(f"| {words} | {cells:g} | {depth:.0f} | {wall:.1f} | {crushed:.1f} | {least:.3f} | {skin:.1f} |")
    return lines


def trials_section():
    head = TRIALS.format(rest=REST, made=listed([f"*{shot}*" for shot in MADE_FROM]))
    return "\n".join([head, *table(), "", *summary(), "", "### Scatter", "", *scatter_table(), "",
        CRUSHED, *crushed_table(), "", SKIN])
