#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmark and stores what a step costs: whole, by phase, and against the least that the machine allows.

    step_cost.py build/release [--document] [--text FILE]

build/release: a build folder with verification/barreno_benchmark. --document writes verification/results/step_cost.json and the tables of
docs/performance.md. --text reads what the benchmark printed before instead of running it. Exit code 1 if the benchmark fails or prints
something else.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.write_pages import write_pages

STORED = pathlib.Path(__file__).resolve().parents[1] / "results" / "step_cost.json"

LEAST_PHASE = 1.0  # ns; phases below are left out of the table
SCENE = re.compile(r"(.*): (\d+) ns per particle-step.*, (\d+) bytes per particle")
PHASE = re.compile(r"  (\S.*\S) +([\d.]+) ns")
ALONE = re.compile(r"Johnson-Cook, flowing, points alone in lanes: ([\d.]+) ns.*")
SMALL = re.compile(r"the same with (\d+) particles: (\d+) ns.*")
COPPER, BLOCK, METAL = "axisymmetric GIMP, Johnson-Cook", "3D GIMP, elastic", "update_stress Johnson-Cook"
# What issues ask for [ns], stated for a machine with this bandwidth [GB/s]; fractions of the memory limit.
DEMANDS = ((COPPER, METAL, 35.0, 17.0), (COPPER, None, 95.0, 17.0), (BLOCK, "update_deformation", 40.0, 13.5), (BLOCK, None, 190.0, 13.5))
FRACTIONS = (("axisymmetric", 0.45), ("plane strain", 0.45), ("3D", 0.32))
WHY = (
    "Memory does not limit these steps. A scene that the last cache holds costs about as much per particle as one that the cache does not "
    "hold. "
    "The fractions fall where the machine reads faster, since the steps do not become shorter. The virtual machine hides the processor's "
    "own "
    "counters (`perf stat -e cycles,instructions` says *not supported*), so timing shows the limit.",
    "",
    "A flowing point takes two evaluations of the flow stress on average, three logarithms, two exponentials, 14 divisions and a square "
    "root. "
    "valgrind counts about 1260 instructions of 256 bits for a group of points (`valgrind --tool=callgrind`, built with -march=x86-64-v3). "
    "A tenth of them select by masks. Without one of the two powers (m = 1) a point was 2 ns faster; without the rate (C = 0, one "
    "evaluation less) "
    "5 ns. Four changes gained nothing: several groups taken through each part in turn, a first evaluation of its own, fewer checks of the "
    "input, "
    "and columns of particles padded against collisions in the caches.",
)
NUMBERS = ("ns", "nodes", "least bytes", "least operations", "limit ns", "fraction", "project ns", "interpolate ns", "memory bytes")


def read_benchmark(text):
    """{"triad": GB/s, "scenes": [{name, ns, bytes, phases}], "shapes": [{mode, shape function, NUMBERS}], "metal alone": ns,
    "small": {particles, ns}} of what it prints."""
    scenes, shapes, more = [], [], {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if found := SCENE.fullmatch(line):
            scenes.append({"name": found[1], "ns": float(found[2]), "bytes": float(found[3]), "phases": {}})
        elif (found := PHASE.fullmatch(line)) and found[1] != "advance":
            scenes[-1]["phases"][found[1]] = float(found[2])
        elif found := ALONE.fullmatch(line):
            more["metal alone"] = float(found[1])
        elif found := SMALL.fullmatch(line):
            more["small"] = {"particles": int(found[1]), "ns": float(found[2])}
        elif line.startswith("|") and len(cells) == 2 + len(NUMBERS) and cells[2][0].isdigit():
            shapes.append({"mode": cells[0], "shape function": cells[1], **dict(zip(NUMBERS, map(float, cells[2:])))})
    triad = re.search(r"^triad ([\d.]+) GB/s", text)
    if not (triad and scenes and shapes):
        sys.exit("step_cost.py: the benchmark printed no triad, no scene or no shape function; run it by hand to see what it says.")
    return {"triad": float(triad[1]), "scenes": scenes, "shapes": shapes, **more}


def table_of(cost):
    lines = [f"Triad: {cost['triad']:.1f} GB/s.", "", "| scene | verb | ns per particle-step |", "|---|---|---|"]
    for scene in cost["scenes"]:
        lines.append(f"| {scene['name']} | whole step | {scene['ns']:.0f} |")
        lines += [f"| | {verb} | {ns:.1f} |" for verb, ns in scene["phases"].items() if ns >= LEAST_PHASE]
    columns = ("mode", "shape function", "ns", "nodes", "least bytes", "least operations", "limit ns", "fraction")
    lines += ["", "| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    return lines + ["| " + " | ".join(f"{row[c]:g}" if isinstance(row[c], float) else row[c] for c in columns) + " |"
        for row in cost["shapes"]]


def verdict(measured, most):
    return "met" if measured <= most else f"missed, by a factor of {measured / most:.2f}"


def demands_of(cost):
    scenes = {scene["name"]: scene for scene in cost["scenes"]}
    lines = ["", "| demand | condition | asked for | measured | verdict |", "|---|---|---|---|---|"]
    for name, verb, most, bandwidth in DEMANDS:
        measured = scenes[name]["phases"][verb] if verb else scenes[name]["ns"]
        here = cost["triad"] / bandwidth
        answer = f"{verdict(measured, most)}, with memory {here:.1f} times as fast"
        lines.append(
            f"| time of {verb or 'a step'} | {name} | {most:g} ns at {bandwidth:g} GB/s | {measured:.0f} ns at {cost['triad']:.1f} GB/s | "
            f"{answer} |"
        )
    for mode, least in FRACTIONS:
        row = next(row for row in cost["shapes"] if row["mode"] == mode and row["shape function"] == "GIMP")
        answer = "met" if row["fraction"] >= least else "missed"
        lines.append(f"| fraction of the memory limit | {mode} GIMP, Johnson-Cook | {least} | {row['fraction']:.2f} | {answer} |")
    small = cost["small"]
    lines += [
        "",
        f"Points of flowing copper alone, all in the first cache, take {cost['metal alone']:.1f} ns. The rest of update_stress reads and "
        "writes, "
        "computes artificial viscosity and stable step, and sums up energies.",
        f"The same cylinder with {small['particles']:,} particles, which the last cache holds, takes {small['ns']:.0f} ns "
        f"({100.0 * (small['ns'] / scenes[COPPER]['ns'] - 1.0):+.0f} %).",
        "",
        *WHY,
    ]
    return lines


def stored_part():
    cost = json.loads(STORED.read_text())
    return table_of(cost) + demands_of(cost)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--text", type=pathlib.Path)
    options = parser.parse_args()
    if options.text:
        text = options.text.read_text()
    else:
        program = options.build / "verification" / "barreno_benchmark"
        if not program.exists():
            sys.exit(f"there is no '{program}'; build the target barreno_benchmark.")
        done = subprocess.run([program], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"step_cost.py: the benchmark ended with {done.returncode}: {done.stderr[-400:]}")
        text = done.stdout
    cost = read_benchmark(text)
    print("\n".join(table_of(cost) + demands_of(cost)))
    if options.document:
        STORED.write_text(json.dumps(cost, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
