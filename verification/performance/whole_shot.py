#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long the main job takes on one core, and what a change of the program has saved.

    whole_shot.py BARRENO --before PROGRAM [--document] [--end "300 us"]

runs perforation.xml, with its former rock, with fast and balanced by both programs at the same time, one core each; --document writes
verification/results/whole_shot.json and the table of docs/performance.md. Losses stay lost, but for the last row of BARRENO alone.
"""
import argparse
import concurrent.futures
import json
import pathlib
import sys
import tempfile

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE.parent / "results" / "whole_shot.json"
DECK = "perforation.xml"
LOST, RETURNED = {"Step/Return Losses": "false"}, {"Step/Return Losses": "true"}
ROWS = {"fast": ("fast", LOST), "balanced": ("balanced", LOST), "balanced, losses returned": ("balanced", RETURNED)}
VERBS = ("solve_velocity", "carry_tile_steps")


def measured(barreno, fidelity, settings, end):
    from tools.depth_shots import FORMER, HEATED
    from tools.runs import run_deck

    with tempfile.TemporaryDirectory() as folder:
        entries = {"Fidelity": fidelity, **FORMER, **HEATED, "Time/End Time": end, "Output/Field Interval": "0 us", **settings}
        summary = run_deck(barreno, DECK, entries, folder=pathlib.Path(folder) / "run").summary
    verbs = {name: summary["phases"][name]["seconds"] for name in VERBS if name in summary["phases"]}
    whole = {name: summary[name] for name in ("steps", "particle_steps")}
    return {"seconds": summary["cpu_seconds"], **whole, "depth": summary["penetration"]["depth"], **verbs}


def stored_part():
    data = json.loads(STORED.read_text())
    said = f"`{DECK}` with `berea_sandstone_bounded`, to {data['end']}, one core; nodes solved in every part of a step (before), and " \
        "steady nodes once."
    lines = [said, "",
        "| fidelity | program | seconds | steps | particle-steps, millions | solve_velocity [s] | carry_tile_steps [s] | depth [mm] |",
        "|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for row, programs in data["rows"].items():
        for program, one in programs.items():
            verbs = " | ".join(f"{one[verb]:.1f}" if verb in one else "" for verb in VERBS)
            lines.append(f"| {row} | {program} | {one['seconds']:.1f} | {one['steps']} | {1e-6 * one['particle_steps']:.0f} | {verbs} | "
                f"{1e3 * one['depth']:.0f} |")  # fmt: skip
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--before", type=pathlib.Path, required=True)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--end", default="300 us")
    options = parser.parse_args()
    programs, rows = {"before": options.before, "now": options.barreno}, {}
    for row, (fidelity, settings) in ROWS.items():
        named = {name: program for name, program in programs.items() if settings is LOST or name == "now"}
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = {name: pool.submit(measured, program.resolve(), fidelity, settings, options.end) for name, program in named.items()}
        rows[row] = {name: run.result() for name, run in runs.items()}
        print(row, rows[row], flush=True)
    if options.document:
        STORED.write_text(json.dumps({"end": options.end, "rows": rows}, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
