# SPDX-License-Identifier: BSD-3-Clause
"""What was aimed at for the depth of a jet, and how much of it is reached: a table of docs/trade.md, from results files."""
import json

from tools.case_list import RESULTS, stored
from tools.demands import judge_all, open_demands
from tools.rest_aims import rows as rows_at_rest
from tools.uniform_cells import depths, doubt

VERIFY = "verification/verify.py BARRENO --full"
RUNS = "verification/depth_runs.py BARRENO"

# (aim, its condition) -> case, and the requirements of it that count, by the beginning of their names.
CASES = {
    ("rate against Bernoulli", "long rods, metals without strength, 2 and 4 cells per radius, equal and refined"): ("steady_penetration",
        ""),
    ("left behind over the uniform grid's own", "a pulse into smaller cells, one step and two parts"): ("border_pulse", ""),
    ("difference of depth", "refined against uniform cells of 0.25 mm"): ("levels", "difference of depth"),
    ("difference of the channel's radius", "refined against uniform cells of 0.25 mm"): ("levels", "difference of the channel's radius"),
    ("CPU time, uniform over refined", "cells of 0.25 mm"): ("levels", "processor time"),
    ("difference of depth, 10 to 90 us", "*balanced* against cells of 0.25 mm"): ("fidelities", "balanced: depths"),
    ("CPU time [s]", "*balanced*, one core"): ("fidelities", "balanced: processor time"),
    ("difference of depth, 10 to 90 us", "*fast* against cells of 0.25 mm"): ("fidelities", "fast: depths"),
    ("CPU time [s]", "*fast*, one core"): ("fidelities", "fast: processor time"),
    ("CPU time, one step over several lengths", "cells of 1 mm"): ("subcycling", "1 mm: processor time"),
    ("difference of depth at 60 and 120 us", "steps of several lengths, cells of 1 mm"): ("subcycling", "1 mm: difference of depth"),
    ("pressure: difference to neighbours, relative", "steel around the hole"): ("casing_pressure", "difference to the neighbours"),
    ("energy lost, over energy put in", "to 12 us, Return Losses, cells of 1 mm"): ("returned_losses",
        "Return Losses: energy lost by 12 us"),
    ("velocity lost", "a slug in a channel of 2.3 radii, 2.4 cells per radius, 200 radii long"): ("slug_flight", "rock: velocity lost"),
    ("energy lost", "the same slug"): ("slug_flight", "rock: energy lost"),
}
OTHERS = ("ledger remainder", "energy balance", "axial momentum")  # of these cases, requirements of another kind

# What tests hold, with their bounds; all fail the tests of every build where they do not hold.
TESTS = (
    ("error of a constant velocity, relative", "across levels, every mode and shape function", "1e-13",
     "at most 1e-11: round-off is divided by the mass of nodes that particles hardly reach", "ctest -R step.levels"),
    ("error of linear fields", "nodes that follow coarser ones, every mode", "1e-13", "equal to the last digit", "ctest -R grid.tiles"),
    ("velocity over that of a free face", "preloaded body at rest on three levels (two in space)", "1e-9", "at most 1e-9",
        "ctest -R step.levels"),
    ("change of momentum", "across levels", "1e-13", "at most 1e-13", "ctest -R step.levels"),
    ("order of a standing wave", "a bar that is half refined", "2", "at least 1.8, as on equal cells", "ctest -R step.levels"),
)  # fmt: skip


def counted(case, start):
    """[(check, verdict, words)] of a case's requirements that an aim means."""
    judged, _ = judge_all(stored(case)["checks"], open_demands(case, True))
    return [one for one in judged if one[0]["what"].startswith(start) and not one[0]["what"].endswith(OTHERS)]


def nearest(judged):
    """The one that is nearest to its limit, or farthest beyond it."""
    return max(judged, key=lambda one: one[0]["limit"] / one[0]["value"] if one[0]["at_least"] else one[0]["value"] / one[0]["limit"])


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def case_row(aim, case, start):
    judged = counted(case, start)
    check, verdict, words = nearest(judged)
    limits = sorted({one[0]["limit"] for one in judged})
    bar = f"{'>=' if check['at_least'] else '<='} " + " or ".join(f"{limit:g}" for limit in limits)
    measured = f"{check['value']:.3g}{' at worst' if len(judged) > 1 else ''}"
    return row(*aim, bar, measured, f"{verdict}{': ' + words if words else ''}", f"`{VERIFY} {case}`")


def two_ranks_row():
    strong = next(one for one in json.loads((RESULTS / "scaling.json").read_text())["strong"] if one["name"].startswith("perforation"))
    verdict = "holds" if strong["speedup"] >= 1.7 else "missed: docs/performance.md"
    command = "`verification/performance/scaling.py BARRENO`"
    return row("speed, two ranks over one", f"{strong['name']}, equal cells", ">= 1.7", f"{strong['speedup']:.2f}", verdict, command)


def losses_row():
    data = stored("perforation")
    whole = dict(zip(data["columns"], data["rows"][0]))
    lost = whole["energy that stress_integration and transfer took, over what was put in"]
    missed = ("missed: it falls with the step alone. Return Losses returns it to metals and to rock with heat (docs/method.md 2.13), which "
        "this rock has not")
    aim = ("energy lost, over energy put in", "to 120 us, without Return Losses")
    return row(*aim, "<= 0.02", f"{lost:.3g}", "holds" if lost <= 0.02 else missed, f"`{VERIFY} perforation`")


def reference_row(data):
    finest = min(cells for cells, _ in depths())
    time = max(time for cells, time in depths() if cells == finest)
    minutes = data["wall_seconds"] / 60.0
    verdict = (
        f"{'holds' if minutes <= 10.0 and doubt() <= 0.02 else 'missed'}; the interval is the largest difference from cells of {finest:g} "
        f"mm, run to {time:g} us; at 120 us, where the run ends, the program says \"unknown\""
    )
    measured = f"+-{100 * doubt():.2g} %; {minutes:.1f} minutes"
    return row("interval of the depth; time", "*reference*, two ranks", "2 %, 10 minutes", measured, verdict, f"`{RUNS} reference`")


def refined_ranks_row(data):
    verdict = "holds" if data["speedup"] >= 1.7 else "missed"
    return row("speed, two ranks over one", "perforation_refined.xml to 10 us", ">= 1.7", f"{data['speedup']:.2f}", verdict,
        f"`{RUNS} ranks`")


def rod_row(data):
    change = max((rate / data["rates"][0] - 1.0 for rate in data["rates"]), key=abs)
    verdict = "holds" if abs(change) <= 0.02 else "missed"
    aim = ("rate of ten diameters over the second ten, less 1", "long rod into sandstone, 100 jet diameters, 4 cells per radius")
    return row(*aim, "2 %", f"{100 * change:.2g} % at worst", verdict, f"`{RUNS} rod`")


def section():
    lines = ["## What is reached", "", "Aims for the depth of a jet, each with its command; BARRENO is the built program. Of several "
        "requirements the one nearest to its limit",
             "is shown.", "", "| aim | condition | bar | measured | verdict | command |", "|---|---|---|---|---|---|"]  # fmt: skip
    lines += [case_row(aim, *which) for aim, which in CASES.items()]
    lines += [losses_row(), two_ranks_row()]
    lines += [row(aim, condition, bar, bound, "held by a test", f"`{command}`") for aim, condition, bar, bound, command in TESTS]
    runs = json.loads((RESULTS / "depth_runs.json").read_text())
    lines += [reference_row(runs["reference"]), rod_row(runs["rod"]), refined_ranks_row(runs["ranks"])]
    return "\n".join([*lines, *rows_at_rest()]) + "\n"
