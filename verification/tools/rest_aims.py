# SPDX-License-Identifier: BSD-3-Clause
"""What was aimed at for a hole at rest, and how much of it is reached: rows of docs/trade.md, from depth_shots.json and
depth_scatter.json of verification/results."""

from tools import depth_shots_table as shots_of

SHOTS = "verification/depth_shots.py BARRENO"
FIDELITIES = {"balanced": (1.8, 0.05), "fast": (1.2, 0.10)}  # cells per radius; how far an answer may be from that of the smallest cells
SECONDS = {"balanced": 1.3 * 360.0}  # what 330 us took when this was asked for, times 1.3
LOST = 0.03
LAST_TWO = {"depth": 0.03, "probed depth": 0.03, "volume": 0.08}


def row(aim, condition, bar, measured, verdict, more=""):
    return f"| {aim} | {condition} | {bar} | {measured} | {verdict} | `{SHOTS}{more}` |"


def deck():
    """{cells per radius: run}, {what: {cells per radius: the mean of runs that should agree}}"""
    runs = shots_of.shots()[shots_of.DECK]
    means = {what: {cells: shots_of.mean_at(cells, one, what, shots_of.REST) for cells, one in runs.items()} for what in shots_of.WHAT}
    return runs, means


def last_two_rows(means):
    for what, bar in LAST_TWO.items():
        *_, before, last = sorted(means[what])
        change = means[what][last] / means[what][before] - 1.0
        verdict = "holds" if abs(change) <= bar else "missed"
        condition = f"{before:g} to {last:g} cells per radius"
        yield row(f"at rest, {shots_of.WORDS[what]}: last change", condition, f"<= {bar:g}", f"{change:+.3f}", verdict)


def order_rows(means):
    for what in shots_of.WHAT:
        sizes = sorted(means[what])[-3:]
        order = shots_of.order_of(means[what])
        values = [means[what][size] for size in sizes]
        within = (max(values) - min(values)) / values[-1]
        missed = f"missed: the changes do not fall from size to size; the last three lie within {100 * within:.1f} %"
        verdict = "holds" if order is not None and order >= 1.0 else missed
        yield row(f"at rest, {shots_of.WORDS[what]}: observed order", " ".join(f"{size:g}" for size in sizes), ">= 1",
            "none" if order is None else f"{order:.2g}", verdict)  # fmt: skip


def fidelity_rows(runs, means):
    for name, (cells, bar) in FIDELITIES.items():
        for what in shots_of.WHAT:
            change = means[what][cells] / means[what][max(runs)] - 1.0
            verdict = "holds" if abs(change) <= bar else "missed"
            condition = f"*{name}* ({cells:g}) against {max(runs):g} cells per radius"
            yield row(f"at rest, {shots_of.WORDS[what]}", condition, f"<= {bar:g}", f"{change:+.3f}", verdict)
        if name in SECONDS:
            seconds = shots_of.shots()[shots_of.RETURNED][cells]["cpu_seconds"]
            yield row("seconds of one core", f"*{name}*, to {shots_of.REST} us", f"<= {SECONDS[name]:.0f}", f"{seconds:.0f}",
                "holds" if seconds <= SECONDS[name] else "missed")  # fmt: skip


def loss_rows(runs):
    """*balanced* gives losses back; what that changes beside it."""
    cells, _ = FIDELITIES["balanced"]
    returned = shots_of.shots()[shots_of.RETURNED][cells]
    for one, words in ((returned, "*balanced*, which returns losses"), (runs[cells], "the same without Return Losses")):
        verdict = "holds" if one["lost"] <= LOST else "missed" if one is returned else "not the default"
        yield row("at rest, energy lost over energy put in", words, f"<= {LOST:g}", f"{one['lost']:.3g}", verdict)


def interval_row():
    tried = [one for one in shots_of.trials() if one[0] not in (*shots_of.MADE_FROM, shots_of.LATER) and shots_of.is_like(one[0])]
    held = sum(one[-1] for one in tried)
    shots = len({one[0] for one in tried})
    condition, verdict = f"{shots} shots that they were not made from", "holds" if held == len(tried) else "missed"
    return row("intervals that hold what smaller cells give", condition, "all", f"{held} of {len(tried)}", verdict)


def rows():
    runs, means = deck()
    return [*last_two_rows(means), *order_rows(means), *fidelity_rows(runs, means), *loss_rows(runs), interval_row()]
