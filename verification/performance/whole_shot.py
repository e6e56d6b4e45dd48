#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long the main job takes on one core, and what a change of the program has saved.

    whole_shot.py BARRENO --before PROGRAM [--document] [--end "400 us"]

runs perforation.xml with fast and balanced by both programs at the same time, one core each; --document writes
verification/results/whole_shot.json and the table of docs/performance.md.
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
FIDELITIES = ("fast", "balanced")
VERBS = ("solve_velocity", "interpolate_motion")


def measured(barreno, fidelity, end):
    from tools.runs import run_deck

    with tempfile.TemporaryDirectory() as folder:
        entries = {"Fidelity": fidelity, "Time/End Time": end, "Output/Field Interval": "0 us"}
        summary = run_deck(barreno, DECK, entries, folder=pathlib.Path(folder) / "run").summary
    verbs = {name: summary["phases"][name]["seconds"] for name in VERBS if name in summary["phases"]}
    whole = {name: summary[name] for name in ("steps", "particle_steps", "retried_steps")}
    hole = {name: summary["penetration"][name] for name in ("depth", "probed_depth", "channel_volume")}
    return {"seconds": summary["cpu_seconds"], **whole, **hole, **verbs}


def stored_part():
    data = json.loads(STORED.read_text())
    lines = [f"`{DECK}` to {data['end']}, one core each, before and now at the same time.", "",
        "| fidelity | program | seconds | steps (repeated) | particle-steps, millions | solve_velocity [s] | interpolate_motion [s] | "
        "tip [mm] | hole as wide as the jet [mm] | volume [cm3] |", "|---|---|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for row, programs in data["rows"].items():
        for program, one in programs.items():
            verbs = " | ".join(f"{one[verb]:.1f}" for verb in VERBS)
            lines.append(f"| {row} | {program} | {one['seconds']:.1f} | {one['steps']} ({one['retried_steps']:.0f}) | "
                f"{1e-6 * one['particle_steps']:.0f} | {verbs} | {1e3 * one['depth']:.0f} | {1e3 * one['probed_depth']:.0f} | "
                f"{1e6 * one['channel_volume']:.1f} |")  # fmt: skip
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--before", type=pathlib.Path, required=True)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--end", default="400 us")
    options = parser.parse_args()
    programs, rows = {"before": options.before, "now": options.barreno}, {}
    for fidelity in FIDELITIES:
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = {name: pool.submit(measured, program.resolve(), fidelity, options.end) for name, program in programs.items()}
        rows[fidelity] = {name: run.result() for name, run in runs.items()}
        print(fidelity, rows[fidelity], flush=True)
    if options.document:
        STORED.write_text(json.dumps({"end": options.end, "rows": rows}, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
