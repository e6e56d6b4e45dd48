#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Comparison of the integrators: error against cost, over shape functions (and transfers and orders, where decks know the words).

    integrators.py [PNG]     draw the last measurement (docs/pictures/integrators.png)

Cost: particles x steps x CPU time per particle-step, which is measured at the finest level, start-up taken off.
"""
import json
import pathlib
import resource
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy as np

from tools.case import Result
from tools.choices import shape_functions, words
from tools.manufactured_runs import Failed, box_run, displacement_error, vortex_run

HERE = pathlib.Path(__file__).resolve().parent
PICTURE = HERE.parents[1] / "docs" / "pictures" / "integrators.png"
STORED = HERE.parent / "results" / "integrators.json"
DEAR = 2.5  # CPDI may cost so many times GIMP
FLOOR = 0.022 * 2**0.5  # GIMP's least error / A at A = 0.1 in a prototype in one dimension, for two directions
BOX, VORTEX = "box, A = 0.1", "vortex, A = 0.2"


def schemes(barreno):
    """name -> deck words."""
    out = {shape: {"Step/Shape Function": shape} for shape in shape_functions(barreno)}
    for parameter in ("Transfer", "Order"):
        for word in words(barreno, "Step", parameter)[1:]:  # the first is the default
            out[f"GIMP, {word}"] = {"Step/Shape Function": "GIMP", f"Step/{parameter}": word}
    return out


def attempts(barreno, scheme, full):
    """problem -> (scale of the error, [(cell size, run of that level with further deck words)])."""
    shape, more = scheme["Step/Shape Function"], {k: v for k, v in scheme.items() if k != "Step/Shape Function"}
    cells = (8, 16, 32) if full else (8, 16)
    box = [(1.0 / n, lambda extra, n=n: box_run(barreno, "plane strain", shape, 0.1, n, 2, {**more, **extra})) for n in cells]
    if not full:
        return {BOX: (0.1, box)}
    vortex = [(h, lambda extra, h=h: vortex_run(barreno, shape, 0.2, h, extra={**more, **extra})) for h in (0.1, 0.05)]
    return {BOX: (0.1, box), VORTEX: (1.0, vortex)}


def cpu_seconds(attempt, extra):
    """What the attempt returns, and the processor time that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = attempt(extra)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return out, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(barreno, scheme, full):
    """problem -> levels of (cell size, error over the scale, particle-steps), and ns per particle-step of the finest one."""
    out = {}
    for problem, (scale, levels) in attempts(barreno, scheme, full).items():
        found, cost = [], float("nan")
        for h, attempt in levels:
            (run, motion), seconds = cpu_seconds(attempt, {})
            if isinstance(run, Failed):
                break
            work = run.summary["particles"] * run.summary["steps"]
            found.append((h, displacement_error(run, motion)[0] / scale, work))
            if full and h == levels[-1][0]:
                _, start = cpu_seconds(attempt, {"Time/End Time": "1e-9"})
                cost = (seconds - start) / work * 1e9
        out[problem] = (found, cost)
    return out


def cost_at(levels, cost, wanted):
    """CPU seconds for an error, between levels on logarithmic axes; nothing where it is not at these levels."""
    for (_, coarse, little), (_, fine, much) in zip(levels, levels[1:]):
        if fine <= wanted <= coarse:
            share = np.log(coarse / wanted) / np.log(coarse / fine)
            return float(np.exp(np.log(little) + share * np.log(much / little)) * cost * 1e-9)
    return None


def text_of(seconds):
    return "not at these levels" if seconds is None else f"{seconds:.3g}"


def run(barreno, full):
    result = Result(
        "Comparison of the integrators: error against cost",
        "The cost of accuracy with each integrator where the solution is smooth.",
        "manufactured solutions (see Axis-aligned displacement and Generalized vortex), plane strain, two particles per cell and "
        "direction, the default Largest Domain; rms displacement error over A (box) or in metres (vortex). Cost: CPU seconds on one "
        "core, particles x steps x time per particle-step of the finest level.",
        ["integrator", "motion", "cell [m]", "rms error", "particle-steps", "ns per particle-step", "CPU seconds"],
        [],
    )
    costs, lines = {}, ["| integrator | CPU seconds for an error of 5 % | 2 % | 1 % (box, A = 0.1) |", "|---|---|---|---|"]
    for name, scheme in schemes(barreno).items():
        for problem, (levels, cost) in measure(barreno, scheme, full).items():
            result.rows += [[name, problem, h, error, work, cost, work * cost * 1e-9] for h, error, work in levels]
            if problem == BOX:
                costs[name] = cost
                lines.append(f"| {name} | " + " | ".join(text_of(cost_at(levels, cost, e)) for e in (5e-2, 2e-2, 1e-2)) + " |")
                if name == "CPDI":
                    result.demand(f"{name}, {problem}: least error, below what GIMP can reach", min(level[1] for level in levels), FLOOR)
    if full:
        result.demand("CPDI over GIMP, time per particle-step", costs["CPDI"] / costs["GIMP"], DEAR)
    result.notes = "\n".join(lines) + (
        "\n\nThe picture is drawn by `verification/cases/integrators.py` from the last "
        "measurement. At strains of 0.31 (box) the curves of fixed supports and point masses turn back: more cells cost more and are less "
        "accurate; domains that follow their particles keep converging."
    )
    return result


def draw(file):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = json.loads(STORED.read_text())["rows"]
    problems = list(dict.fromkeys(row[1] for row in rows))
    figure, axes = plt.subplots(1, len(problems), figsize=(1.8 + 4.6 * len(problems), 4.2), layout="constrained", squeeze=False)
    names = list(dict.fromkeys(row[0] for row in rows))
    for one, problem in zip(axes[0], problems):
        for i, name in enumerate(names):
            points = [(row[6], row[3]) for row in rows if row[0] == name and row[1] == problem]
            if points:
                # More schemes than colours: those of the second ten are dashed.
                one.loglog(*zip(*points), "o-" if i < 10 else "s--", ms=4, color=f"C{i % 10}", label=name)
        one.set_title(problem, fontsize=10)
        one.set_xlabel("processor time [s]")
        one.grid(alpha=0.3)
    axes[0][0].set_ylabel("rms displacement error, over A")
    axes[0][-1].set_ylabel("rms displacement error [m]" if len(problems) > 1 else "")
    axes[0][-1].legend(*axes[0][0].get_legend_handles_labels(), fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    figure.savefig(file, dpi=110)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else PICTURE)
