# SPDX-License-Identifier: BSD-3-Clause
"""What was aimed at for the depth of a jet, and how much of it is reached: a table of docs/trade.md, from results files."""
import json

from case_list import RESULTS, stored
from demands import judge_all, open_demands
from uniform_cells import depths, doubt

VERIFY = "verification/verify.py BARRENO --full"
RUNS = "verification/depth_runs.py BARRENO"

# Aim -> case, and the requirements of it that count, by the beginning of their names.
CASES = {
    "long rods into metals without strength, two and four cells per radius, equal and refined cells: rate against Bernoulli": ("steady_penetration", ""),
    "a pulse that runs into smaller cells: what it leaves behind over the uniform grid's own, one step and two parts": ("border_pulse", ""),
    "refined against uniformly fine cells of 0.25 mm: depth": ("levels", "difference of depth"),
    "the same: radius of the channel": ("levels", "difference of the channel's radius"),
    "the same: processor time of the uniform cells over that of the refined ones": ("levels", "processor time"),
    "*balanced* against cells of 0.25 mm: depths from 10 to 90 us": ("fidelities", "balanced: depths"),
    "*balanced*: processor time of one core [s]": ("fidelities", "balanced: processor time"),
    "*fast* against cells of 0.25 mm: depths from 10 to 90 us": ("fidelities", "fast: depths"),
    "*fast*: processor time of one core [s]": ("fidelities", "fast: processor time"),
    "steps of several lengths alone, cells of 1 mm: processor time of one step for all over theirs": ("subcycling", "1 mm: processor time"),
    "the same: depth at 60 and 120 us": ("subcycling", "1 mm: difference of depth"),
    "pressure of the steel around the hole: difference to the neighbours over pressure": ("casing_pressure", "difference to the neighbours"),
    "what stress_integration and transfer take of the energy put in, to 12 us, with Return Losses, cells of 1 mm": ("returned_losses", "Return Losses: energy lost by 12 us"),
}
OTHERS = ("ledger remainder", "energy balance", "axial momentum")  # of these cases, requirements of another kind

# What tests hold, with their bounds; all fail the tests of every build where they do not hold.
TESTS = (
    ("constant velocity across levels, in every mode and with every shape function", "1e-13", "at most 1e-11 of the speed: round-off is divided by the mass of nodes that particles hardly reach", "ctest -R step.levels"),
    ("linear fields at nodes that follow those of coarser cells, in every mode", "1e-13", "equal to the last digit", "ctest -R grid.tiles"),
    ("a preloaded body on three levels (two in space) at rest: velocity over that of a free face", "1e-9", "at most 1e-9", "ctest -R step.levels"),
    ("momentum across levels", "1e-13", "at most 1e-13", "ctest -R step.levels"),
    ("order of a standing wave in a bar that is half refined", "2", "at least 1.8, as on equal cells", "ctest -R step.levels"),
)


def counted(case, start):
    """[(check, verdict, words)] of a case's requirements that an aim means."""
    judged, _ = judge_all(stored(case)["checks"], open_demands(case, True))
    return [one for one in judged if one[0]["what"].startswith(start) and not one[0]["what"].endswith(OTHERS)]


def nearest(judged):
    """The one that is nearest to its limit, or farthest beyond it."""
    return max(judged, key=lambda one: one[0]["limit"] / one[0]["value"] if one[0]["at_least"] else one[0]["value"] / one[0]["limit"])


def case_row(aim, case, start):
    judged = counted(case, start)
    check, verdict, words = nearest(judged)
    limits = sorted({one[0]["limit"] for one in judged})
    bar = f"{'>=' if check['at_least'] else '<='} " + " or ".join(f"{limit:g}" for limit in limits)
    return f"| {aim} | {bar} | {check['value']:.3g}{' at worst' if len(judged) > 1 else ''} | {verdict}{': ' + words if words else ''} | `{VERIFY} {case}` |"


def two_ranks_row():
    strong = next(one for one in json.loads((RESULTS / "scaling.json").read_text())["strong"] if one["name"].startswith("perforation"))
    return f"| two ranks over one, {strong['name']}, equal cells | >= 1.7 | {strong['speedup']:.2f} | {'holds' if strong['speedup'] >= 1.7 else 'missed: docs/performance.md'} | `verification/performance/scaling.py BARRENO` |"


def losses_row():
    data = stored("perforation")
    whole = dict(zip(data["columns"], data["rows"][0]))
    lost = whole["energy that stress_integration and transfer took, over what was put in"]
    verdict = "holds" if lost <= 0.02 else "missed: it falls with the step alone; metals get theirs back with Return Losses, rock has no heat (docs/method.md 2.13)"
    return f"| the same to 120 us without it | <= 0.02 | {lost:.3g} | {verdict} | `{VERIFY} perforation` |"


def reference_row(data):
    finest = min(cells for cells, _ in depths())
    time = max(time for cells, time in depths() if cells == finest)
    minutes = data["wall_seconds"] / 60.0
    verdict = f"{'holds' if minutes <= 10.0 and doubt() <= 0.02 else 'missed'}; the interval is the largest difference from cells of {finest:g} mm, which were run to {time:g} us"
    measured = f"+-{100 * doubt():.2g} %; {minutes:.1f} minutes"
    return f"| *reference*: interval of the depth and time on two ranks | 2 %, 10 minutes | {measured} | {verdict} | `{RUNS} reference` |"


def refined_ranks_row(data):
    verdict = "holds" if data["speedup"] >= 1.7 else "missed"
    return f"| two ranks over one, perforation_refined.xml to 10 us | >= 1.7 | {data['speedup']:.2f} | {verdict} | `{RUNS} ranks` |"


def rod_row(data):
    change = max((rate / data["rates"][0] - 1.0 for rate in data["rates"]), key=abs)
    verdict = "holds" if abs(change) <= 0.02 else "missed"
    aim = "long rod into sandstone over 100 jet diameters, four cells per radius: rate of ten diameters against that of the second ten"
    return f"| {aim} | 2 % | {100 * change:.2g} % at worst | {verdict} | `{RUNS} rod` |"


def section():
    lines = ["## What is reached", "", "Aims for the depth of a jet, each with its command; BARRENO is the built program. Of several requirements the one nearest to its limit is shown.", "",
             "| aim | bar | measured | verdict | command |", "|---|---|---|---|---|"]  # fmt: skip
    lines += [case_row(aim, *which) for aim, which in CASES.items()]
    lines += [losses_row(), two_ranks_row()]
    lines += [f"| {aim} | {bar} | {bound} | held by a test | `{command}` |" for aim, bar, bound, command in TESTS]
    runs = json.loads((RESULTS / "depth_runs.json").read_text())
    lines += [reference_row(runs["reference"]), rod_row(runs["rod"]), refined_ranks_row(runs["ranks"])]
    return "\n".join(lines) + "\n"
