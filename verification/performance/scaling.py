#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Strong and weak scaling over ranks, and what ranks send.

    scaling.py BARRENO [--repeats N] [--quick] [--document]

Times are those of the steps alone (the timer `advance` of summary.json, slowest rank). One rank, two ranks and two runs of one rank
each at once take turns; the speed-up is the median of the rounds, since the speed of a machine that others share changes by a
third within minutes. The two runs at once say what the machine allows. Messages, bytes and reductions are counted by a preloaded library
(tools/message_costs.c) in a run of its own: the difference of two end times over the difference of their steps, so that starting does not
count. The bandwidth of memory is measured in the same minute, by one process and by two at once. --document writes docs/performance.md and
verification/results/scaling.json.
"""
import argparse
import concurrent.futures
import json
import pathlib
import statistics
import subprocess
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from performance import scaling_decks
from performance.scaling_decks import Problem

from tools.resumed import must_work, program  # noqa: I001
from tools.runs import ROOT, Run, scratch_folder
from tools.write_pages import write_pages

TOOLS = ROOT / "verification" / "tools"
RESULT = ROOT / "verification" / "results" / "scaling.json"
KINDS = ("sends", "waits", "reductions", "others")
LEAST = {"block": 1.85, "perforation": 1.8}


def build(scratch):
    library, triad = scratch / "message_costs.so", scratch / "triad"
    subprocess.run(["mpicc", "-O1", "-shared", "-fPIC", "-o", library, TOOLS / "message_costs.c"], check=True)
    subprocess.run(["cc", "-O3", "-march=native", "-o", triad, TOOLS / "triad.c"], check=True)
    return library, triad


def bandwidth(triad, processes):
    """Of all processes together [GB/s]."""
    running = [subprocess.Popen([triad, "1.5"], stdout=subprocess.PIPE, text=True) for _ in range(processes)]
    return sum(float(process.communicate()[0]) for process in running)


def run_once(barreno, problem: Problem, ranks, end, environment=None):
    folder = pathlib.Path(scratch_folder()) / "run"
    words = ["run", problem.deck, "--out", folder, "--set", f"Time/End Time={end}", "--set", f"Output/Field Interval={end}",
             "--set", "Output/Checkpoint Wall Interval=0 s"]  # fmt: skip
    must_work(program(barreno, ranks, *words, environment={"OMPI_MCA_mpi_yield_when_idle": "0", **(environment or {})}))
    return Run(folder)


def step_seconds(run):
    return run.summary["phases"]["advance"]["largest_rank_seconds"]


def run_twice_at_once(barreno, problem):
    with concurrent.futures.ThreadPoolExecutor(2) as both:
        return list(both.map(lambda _: run_once(barreno, problem, 1, problem.end), range(2)))


def one_round(barreno, one_rank: Problem, two_ranks: Problem):
    one, two = run_once(barreno, one_rank, 1, one_rank.end), run_once(barreno, two_ranks, 2, two_ranks.end)
    apart = statistics.mean(step_seconds(run) for run in run_twice_at_once(barreno, one_rank))
    return one, two, apart


def median_round(barreno, one_rank, two_ranks, repeats):
    """Of an odd number of rounds the one whose ratio of times is the median; least and largest ratio; median of what two runs at once
    allow."""
    rounds = sorted((one_round(barreno, one_rank, two_ranks) for _ in range(repeats)),
        key=lambda r: step_seconds(r[0]) / step_seconds(r[1]))
    ratios = [step_seconds(one) / step_seconds(two) for one, two, _ in rounds]
    one, two, _ = rounds[len(rounds) // 2]
    allowed = statistics.median(2.0 * step_seconds(one) / apart for one, _, apart in rounds)
    return one, two, (ratios[0], ratios[-1]), allowed


def counts(folder, ranks):
    """By rank: calls, bytes and seconds of every kind."""
    tables = []
    for rank in range(ranks):
        lines = (folder / f"messages.{rank}").read_text().split("\n")
        tables.append({words[0]: [float(x) for x in words[1:]] for words in (line.split() for line in lines if line)})
    return tables


def messages(barreno, library, problem, ranks):
    """Per step: means over ranks of messages, bytes and reductions. Least part of the steps that a rank spends in MPI."""
    found = []
    for end in (problem.short, problem.end):
        folder = pathlib.Path(scratch_folder())
        run = run_once(barreno, problem, ranks, end, {"LD_PRELOAD": str(library), "MESSAGES_FILE": str(folder / "messages")})
        found.append((run, counts(folder, ranks)))
    (short, before), (long, after) = found
    steps = long.summary["steps"] - short.summary["steps"]

    def per_step(kind, column):
        return [(b[kind][column] - a[kind][column]) / steps for a, b in zip(before, after)]

    def mean(values):
        return sum(values) / len(values)

    waiting = min(sum(rank[kind][2] for kind in KINDS) for rank in after)
    return {
        "messages": mean(per_step("sends", 0)),
        "bytes": mean(per_step("sends", 1)),
        "reductions": mean(per_step("reductions", 0)),
        "reduced_bytes": mean(per_step("reductions", 1)),
        "other_collectives": mean(per_step("others", 0)),
        "waiting": waiting / step_seconds(long),
        "steps": long.summary["steps"],
        "particles": long.summary["particles"],
    }


def lost(one, two):
    """Verbs of the run on two ranks that take more than half of what they take on one, the largest first."""
    a, b = one.summary["phases"], two.summary["phases"]
    more = {name: b[name]["largest_rank_seconds"] - 0.5 * a.get(name, {}).get("largest_rank_seconds", 0.0)
        for name in b if name != "advance"}
    return sorted(((name, seconds) for name, seconds in more.items() if seconds > 0.0), key=lambda item: -item[1])[:6]


def measure(barreno, repeats, quick):
    scratch = pathlib.Path(scratch_folder())
    library, triad = build(scratch)
    cells = (16, 32, 16) if quick else (24, 48, 24)
    small = scaling_decks.block(scratch, (cells[0], cells[1] // 2, cells[2]), 60)
    large = scaling_decks.block(scratch, cells, 60)
    jet = scaling_decks.perforation()
    if quick:
        jet = Problem("perforation_120us.xml to 4 us", jet.deck, "2 us", "4 us")
    result = {"triad": {n: bandwidth(triad, n) for n in (1, 2)}, "strong": [], "messages": []}
    ratio = result["triad"][2] / result["triad"][1]
    for word, problem in (("block", large), ("perforation", jet)):
        one, two, bounds, allowed = median_round(barreno, problem, problem, repeats)
        least = min(LEAST[word], 0.95 * ratio)
        speedup = step_seconds(one) / step_seconds(two)
        result["strong"].append({
            "name": problem.name, "particles": one.summary["particles"], "steps": one.summary["steps"],
            "one": step_seconds(one), "two": step_seconds(two), "speedup": speedup, "bounds": bounds, "allowed": allowed,
            "least": least, "lost": lost(one, two),
        })  # fmt: skip
        result["messages"].append({"name": problem.name, **messages(barreno, library, problem, 2)})
    one, two, _, _ = median_round(barreno, small, large, repeats)
    result["weak"] = {"one": step_seconds(one) / one.summary["steps"], "two": step_seconds(two) / two.summary["steps"],
                      "name": f"{small.name} on one rank, {large.name} on two"}  # fmt: skip
    result["messages"].append({"name": small.name, **messages(barreno, library, small, 2)})
    return result


def stored_part():
    return page(json.loads(RESULT.read_text()))


def page(result):
    one, two = (result["triad"].get(n) or result["triad"][str(n)] for n in (1, 2))  # JSON has words for keys
    lines = [f"Triad: {one:.1f} GB/s by one process, {two:.1f} GB/s by two at once, a ratio of {two / one:.2f}.", "",
             "| strong scaling | particles | steps | one rank | two ranks | speed-up | range over rounds | required | two runs at once |",
             "|---|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for s in result["strong"]:
        lines.append(f"| {s['name']} | {s['particles']:,.0f} | {s['steps']} | {s['one']:.2f} s | {s['two']:.2f} s | {s['speedup']:.2f} "
                     f"| {s['bounds'][0]:.2f} to {s['bounds'][1]:.2f} | {s['least']:.2f} | {s['allowed']:.2f} |")
    lines += ["", "Largest losses on two ranks: seconds of a verb less half of those on one rank.", "", "| run | verb | lost, s |",
        "|---|---|---|",
              *(f"| {s['name']} | {name} | {seconds:.2f} |" for s in result["strong"] for name, seconds in s["lost"]),
              "", f"Weak scaling ({result['weak']['name']}): {1e3 * result['weak']['one']:.2f} ms and {1e3 * result['weak']['two']:.2f} ms "
                  "per step, "
              f"an efficiency of {result['weak']['one'] / result['weak']['two']:.2f}.",
              "", "Per step and rank, on two ranks. The share of time in MPI is the minimum over ranks and includes output.", "",
              "| run | messages | KB sent | reductions | bytes reduced | other collectives | time in MPI |",
              "|---|---|---|---|---|---|---|"]  # fmt: skip
    for m in result["messages"]:
        lines.append(f"| {m['name']} | {m['messages']:.2f} | {1e-3 * m['bytes']:.1f} | {m['reductions']:.2f} | {m['reduced_bytes']:.0f} "
                     f"| {m['other_collectives']:.3f} | {100 * m['waiting']:.1f} % |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--quick", action="store_true", help="smaller problems: whether it works")
    parser.add_argument("--document", action="store_true")
    arguments = parser.parse_args()
    result = measure(pathlib.Path(arguments.barreno).resolve(), arguments.repeats, arguments.quick)
    lines = page(result)
    print("\n".join(lines))
    if arguments.document:
        RESULT.write_text(json.dumps(result, indent=1) + "\n")
        write_pages()
    failed = [s["name"] for s in result["strong"] if s["speedup"] < s["least"]]
    sys.exit(f"below the requirement: {', '.join(failed)}" if failed and not arguments.quick else 0)


if __name__ == "__main__":
    main()
