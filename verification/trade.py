#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error against cost for every knob of a run.

    trade.py BARRENO [--document]     all problems and knobs: verification/results/trade.json, and with --document
                                      docs/trade.md, verification/results/trade_runs.md and docs/pictures/trade_*.png
    trade.py BARRENO --only KNOB      the same for one knob, for example fidelity; the rest stays as it was measured
    trade.py BARRENO --tiny           two problems, few knobs: only whether what must hold does
    trade.py BARRENO --judge          errors, checks and page of the last measurement anew, where what they are compared with has changed
    trade.py --draw                   the page and the pictures of the last measurement

Cost is the user time of the processor on one core: particle-steps times the ns of the largest run of a choice, the least of three
where that is short, start-up taken off. Other work on the machine hardly shows in it; wall seconds do show it.
Exit code 1 if a figure does not hold.
"""
import argparse
import json
import pathlib
import re
import resource
import subprocess
import sys

from tools import foreign_python  # noqa: F401
from tools.choices import shape_functions, words
from tools.runs import DECKS, mpi_environment, run_deck
from tools.trade_checks import demands, verdict_lines
from tools.trade_problems import PROBLEMS, Lost, has
from tools.uniform_cells import REFERENCE, depth_of
from verify import failures
from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "results" / "trade.json"
SHORT = 1.5  # s of the processor: below it, three runs
FIDELITIES = ("fast", "balanced", "reference")
JET_WORDS = {"Shape Function": "Step/Shape Function", "cells per radius of the jet": "Jet/Cells Per Radius",
             "particles per cell of bodies": "Bodies/Rock/Particles Per Cell", "Subcycles": "Step/Subcycles",
             "Largest Strain": "Step/Largest Strain"}  # fmt: skip
FINEST_SHAPES = ("default", "quadratic B-spline", "CPDI")  # whose depths are measured with FINEST cells too
FINEST = 0.5  # mm
DEPTH_TIME = 20  # us


BREAKING_WORDS = {"cells": "Jet/Cells Per Radius", "splits": "Jet/Splits"}  # of a jet whose metal breaks


def choices_in(barreno, deck, name):
    """{path: value} of what a fidelity chooses for a deck, as `check` prints it."""
    command = [str(barreno), "check", str(DECKS / deck), "--fidelity", name]
    plan = subprocess.run(command, env=mpi_environment(), capture_output=True, text=True, check=True).stdout
    line = re.search(rf"Note: Fidelity {name}: (.*)\.\n", plan).group(1)
    return dict(part.split(" = ") for part in line.split(", "))


def fidelity_words(barreno, name):
    """(words of Step and others, particles per cell) of a fidelity, with the cells and steps of the deck."""
    said, with_jet = choices_in(barreno, "shock_copper.xml", name), choices_in(barreno, "perforation_quick.xml", name)
    out = {path.removeprefix("Step/"): value for path, value in said.items() if path.startswith("Step/")}
    out["Tolerance"] = with_jet["Materials/Sandstone/Tolerance"]
    out["Jet"] = with_jet["Jet/Particles Per Cell"]
    (per_cell,) = {value for path, value in said.items() if path.endswith("/Particles Per Cell")}
    return out, int(per_cell)


def jet_words(barreno, name):
    """What it chooses differently, or only, for a deck with a jet that leaves its cells open."""
    said = choices_in(barreno, "perforation_120us.xml", name)
    return {word: said.get(path, "as the deck's") for word, path in JET_WORDS.items()}


def breaking_words(barreno, name):
    """The same of a jet whose metal breaks."""
    said = choices_in(barreno, "perforation.xml", name)
    return {word: said[path] for word, path in BREAKING_WORDS.items()}


def said_errors(barreno):
    """(fidelity, problem, level) -> the error that `check` names."""
    command = [str(barreno), "check", str(DECKS / "perforation_quick.xml")]
    plan = subprocess.run(command, env=mpi_environment(), capture_output=True, text=True, check=True).stdout
    where = (("shock", 0.5), ("box", 32))
    out = {}
    for name in FIDELITIES:
        values = re.search(rf"^  {name} .*errors: (\S+) %, (\S+) %, depth .*$", plan, re.MULTILINE).groups()
        out.update({(name, *place): 0.01 * float(value) for place, value in zip(where, values)})
    return out


def variants(barreno, tiny):
    """(knob, name, words, particles per cell): the default first, then one knob at a time, then the fidelities."""
    out = [("default", "default", {}, 2)]
    shapes = ("CPDI", "quadratic B-spline", "cubic B-spline") if tiny else shape_functions(barreno)[1:]
    out += [("shape function", shape, {"Shape Function": shape}, 2) for shape in shapes]
    if not tiny:
        out += [("particles per cell", f"{n} per direction", {}, n) for n in (1, 3, 4)]
        out += [("Courant Fraction", value, {"Courant Fraction": value}, 2) for value in ("1", "0.6", "0.4", "0.2")]
        out += [("Arenisca tolerance", value, {"Tolerance": value}, 2) for value in ("0.1", "0.001", "1e-4")]
        out += [("particles per cell of the jet", value, {"Jet": value}, 2) for value in ("2", "6")]
        out += [("transfer", "FLIP, 1 % PIC", {"PIC Fraction": "0.01"}, 2)]
        out += [("transfer", f"XPIC({m})", {"Transfer": "XPIC", "XPIC Order": m}, 2) for m in ("2", "3", "5")]
        out += [("transfer", word, {"Transfer": word}, 2) for word in ("PIC", "APIC")]
        out += [("transfer", "APIC, CPDI", {"Transfer": "APIC", "Shape Function": "CPDI"}, 2)]
        out += [("order of the step", word, {"Order": word}, 2) for word in words(barreno, "Step", "Order")[1:]]
        for a1, a2 in (("0", "0"), ("0.1", "1"), ("0.6", "4")):
            out.append(("artificial viscosity", f"A1 = {a1}, A2 = {a2}", {"Linear Viscosity": a1, "Quadratic Viscosity": a2}, 2))
    return out + [("fidelity", name, *fidelity_words(barreno, name)) for name in FIDELITIES]


def applies(problem, knob, chosen):
    """Smooth motions have no shock to smear."""
    if knob == "artificial viscosity" and problem.name not in ("shock", "depth"):
        return False
    return knob == "fidelity" or all(has(problem.name, word) for word in chosen)


def user_seconds(call):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    out = call()
    return out, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def point(barreno, problem, level, variant, repeat=False):
    """One measurement, as the results hold it; the least time of three if it is repeated and short."""
    knob, name, chosen, per_cell = variant
    out = {"problem": problem.name, "knob": knob, "name": name, "level": level}
    if knob == "fidelity":  # which may be another one by the time that the page is written
        out["chosen"] = [chosen, per_cell]
    try:
        (error, second, run), seconds = user_seconds(lambda: problem.measure(barreno, level, chosen, per_cell))
        wall = run.summary["wall_seconds"]
        for _ in range(2 if repeat and seconds < SHORT else 0):
            (_, _, again), more = user_seconds(lambda: problem.measure(barreno, level, chosen, per_cell))
            seconds, wall = min(seconds, more), min(wall, again.summary["wall_seconds"])
    except Lost as why:
        return {**out, "failed": str(why)}
    return {**out, "error": error, "second": second, "work": run.summary["particle_steps"], "seconds": seconds, "wall": wall}


def add_costs(points, start_up):
    """User time of every point from the ns of the largest run of its choice: short runs are little else than start-up."""
    for p in points:
        if "work" in p:
            of_choice = [q for q in points if "work" in q and all(q[key] == p[key] for key in ("problem", "knob", "name"))]
            largest = max(of_choice, key=lambda q: q["work"])
            p["ns"] = 1e9 * max(largest["seconds"] - start_up, 1e-3) / largest["work"]
            p["cpu"] = 1e-9 * p["ns"] * p["work"]


def start_up_seconds(barreno):
    """User time of a run with hardly a step, the least of three."""
    nothing = lambda: run_deck(barreno, "shock_copper.xml", {"Time/End Time": "1e-12"})  # noqa: E731
    return min(user_seconds(nothing)[1] for _ in range(3))


def levels_of(problem, variant, tiny):
    knob, name, _, _ = variant
    if tiny:
        return problem.tiny
    # In axisymmetry its stable steps are the shortest by far.
    if problem.name == "depth" and name == "linear":
        return problem.levels[:1]
    return problem.levels + (problem.finest if knob in ("default", "shape function", "fidelity") else ())


def measure(barreno, tiny, only):
    points = []
    for problem in PROBLEMS:
        for variant in variants(barreno, tiny):
            if only and variant[0] != only:
                continue
            levels = levels_of(problem, variant, tiny) if applies(problem, variant[0], variant[2]) else ()
            for level in levels:
                points.append(point(barreno, problem, level, variant, not tiny and level == levels[-1]))
                print(json.dumps(points[-1]), flush=True)
    if only:
        stored = as_measured(json.loads(STORED.read_text())["points"])
        rest = [p for p in stored if p["knob"] != only]
    else:
        rest = []
        points += finest_depths(barreno) if not tiny else []
    if not tiny:
        add_costs(points, start_up_seconds(barreno))  # of the others another start-up was taken off
    return rest + points


def finest_depths(barreno):
    chosen = [v for v in variants(barreno, False) if v[0] in ("default", "shape function") and v[1] in FINEST_SHAPES]
    return [point(barreno, PROBLEMS[-1], FINEST, variant) for variant in chosen]


def as_measured(points):
    """Points as `point` gives them: of a jet the depth stands where its error comes."""
    for p in points:
        if "depth" in p:
            p["error"] = p.pop("depth")
    return points


def judge_depths(points):
    """Errors of all depths against that of perforation_120us.xml with uniform cells of 0.25 mm, and what that is worth."""
    reference = depth_of(REFERENCE, DEPTH_TIME)
    for p in points:
        if p["problem"] == "depth" and "error" in p:
            p["depth"] = p["second"] = p["error"]
            p["error"] = abs(p["depth"] - reference) / reference
    return {"reference": reference, "cells": REFERENCE, "time": DEPTH_TIME}


def judged(points, tiny, barreno):
    """All that is stored."""
    chosen = {name: fidelity_words(barreno, name) for name in FIDELITIES}
    data = {"points": points, "chosen": chosen, "with_jet": {name: jet_words(barreno, name) for name in FIDELITIES},
        "breaking": {name: breaking_words(barreno, name) for name in FIDELITIES}}
    if not tiny:
        data["depth"] = judge_depths(points)
    data["checks"] = demands(points, tiny, said_errors(barreno))
    return data


def draw_pages(data):
    from tools.trade_page import draw  # not for a measurement alone: it takes a second

    draw(data)
    write_pages()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", nargs="?", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--tiny", action="store_true")
    parser.add_argument("--only", metavar="KNOB")
    parser.add_argument("--judge", action="store_true")
    parser.add_argument("--draw", action="store_true")
    options = parser.parse_args()
    if options.draw:
        data = json.loads(STORED.read_text())
        draw_pages(data)
        return 0
    if options.barreno is None:
        parser.error("name the program, for example build/release/src/barreno")
    barreno = options.barreno.resolve()
    points = as_measured(json.loads(STORED.read_text())["points"]) if options.judge else measure(barreno, options.tiny, options.only)
    data = judged(points, options.tiny, barreno)
    print("\n".join(verdict_lines(data["checks"], options.tiny)))
    if not options.tiny:
        STORED.write_text(json.dumps(data, indent=1) + "\n")
    if options.document or options.judge:
        draw_pages(data)
    failed = failures("trade", data["checks"], not options.tiny)
    for line in failed:
        print(line, file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
