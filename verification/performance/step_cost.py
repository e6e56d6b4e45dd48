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

STORED = pathlib.Path(__file__).resolve().parents[1] / "results" / "step_cost.json"
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "verification" / "tools"), str(ROOT / "verification")]

LEAST_PHASE = 1.0  # ns; phases below are left out of the table
SCENE = re.compile(r"(.*): (\d+) ns per particle-step.*, (\d+) bytes per particle")
PHASE = re.compile(r"  (\S.*\S) +([\d.]+) ns")
NUMBERS = ("ns", "nodes", "least bytes", "least operations", "limit ns", "fraction", "project ns", "interpolate ns", "memory bytes")


def read_benchmark(text):
    """{"triad": GB/s, "scenes": [{name, ns, bytes, phases}], "shapes": [{mode, shape function, NUMBERS}]} of what it prints."""
    scenes, shapes = [], []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if found := SCENE.fullmatch(line):
            scenes.append({"name": found[1], "ns": float(found[2]), "bytes": float(found[3]), "phases": {}})
        elif (found := PHASE.fullmatch(line)) and found[1] != "advance":
            scenes[-1]["phases"][found[1]] = float(found[2])
        elif line.startswith("|") and len(cells) == 2 + len(NUMBERS) and cells[2][0].isdigit():
            shapes.append({"mode": cells[0], "shape function": cells[1], **dict(zip(NUMBERS, map(float, cells[2:])))})
    triad = re.search(r"^triad ([\d.]+) GB/s", text)
    if not (triad and scenes and shapes):
        sys.exit("step_cost.py: the benchmark printed no triad, no scene or no shape function; run it by hand to see what it says.")
    return {"triad": float(triad[1]), "scenes": scenes, "shapes": shapes}


def table_of(cost):
    lines = [f"Triad: {cost['triad']:.1f} GB/s.", "", "| scene | verb | ns per particle-step |", "|---|---|---|"]
    for scene in cost["scenes"]:
        lines.append(f"| {scene['name']} | whole step | {scene['ns']:.0f} |")
        lines += [f"| | {verb} | {ns:.1f} |" for verb, ns in scene["phases"].items() if ns >= LEAST_PHASE]
    columns = ("mode", "shape function", "ns", "nodes", "least bytes", "least operations", "limit ns", "fraction")
    lines += ["", "| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    return lines + ["| " + " | ".join(f"{row[c]:g}" if isinstance(row[c], float) else row[c] for c in columns) + " |" for row in cost["shapes"]]


def stored_part():
    return table_of(json.loads(STORED.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--text", type=pathlib.Path)
    options = parser.parse_args()
    if options.text:
        text = options.text.read_text()
    else:
        done = subprocess.run([options.build / "verification" / "barreno_benchmark"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"step_cost.py: the benchmark ended with {done.returncode}: {done.stderr[-400:]}")
        text = done.stdout
    cost = read_benchmark(text)
    print("\n".join(table_of(cost)))
    if options.document:
        from pages import write_pages  # it asks this file for its part

        STORED.write_text(json.dumps(cost, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
