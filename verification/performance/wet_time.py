#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long perforation_120us.xml takes with water in the rock's pores, against dry.

    wet_time.py BARRENO [--document] [--rounds N] [--end "120 us"]

runs both on one rank, in turn, as far as the deck goes, keeps the shorter processor time of each, and the least and the greatest ratio of a
round; --document writes verification/results/wet_time.json and the table of docs/performance.md.
"""
import argparse
import json
import pathlib
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.write_pages import write_pages

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE.parent / "results" / "wet_time.json"
DECK = "perforation_120us.xml"
WATER = {"Materials/Sandstone/fluid_B0": "2.2 GPa"}
MOST = 1.5  # times the dry run's time


def measured(barreno, settings):
    from tools.runs import run_deck

    summary = run_deck(barreno, DECK, settings).summary
    rock = sum(phase["ns_per_particle_step"] for name, phase in summary["phases"].items() if name.startswith("update_stress Arenisca"))
    return {"seconds": summary["cpu_seconds"], "steps": summary["steps"], "particle_steps": summary["particle_steps"], "rock": rock}


def stored_part():
    data = json.loads(STORED.read_text())
    rows = [
        f"| {name} | {run['seconds']:.1f} | {run['steps']} | {1e-6 * run['particle_steps']:.1f} | "
        f"{1e9 * run['seconds'] / run['particle_steps']:.0f} |"
        for name, run in data["runs"].items()
    ]
    ratio = data["runs"]["wet"]["seconds"] / data["runs"]["dry"]["seconds"]
    least, most = min(data["ratios"]), max(data["ratios"])
    verdict = "met" if most <= MOST else "missed" if least > MOST else "met in some rounds"
    steps = data["runs"]["wet"]["particle_steps"] / data["runs"]["dry"]["particle_steps"]
    return [
        f"`{DECK}` to {data['end']}, one rank; dormant particles are not counted.",
        "",
        "| rock | seconds of one core | steps | particle-steps, millions | ns per particle-step |",
        "|---|---|---|---|---|",
        *rows,
        "",
        f"Wet rock takes {ratio:.2f} times as long as dry rock, {least:.2f} to {most:.2f} over {len(data['ratios'])} rounds. At most "
        f"{MOST} is required: {verdict}. "
        f"Wet rock is stiffer, and takes {steps:.2f} times as many particle-steps.",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--document", action="store_true")
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--end", default="120 us")
    options = parser.parse_args()
    found, ratios = {}, []
    for _ in range(options.rounds):
        seconds = {}
        for name, settings in (("dry", {}), ("wet", WATER)):
            run = measured(options.barreno.resolve(), {**settings, "Time/End Time": options.end})
            print(name, run, flush=True)
            seconds[name] = run["seconds"]
            if name not in found or run["seconds"] < found[name]["seconds"]:
                found[name] = run
        ratios.append(seconds["wet"] / seconds["dry"])
    data = {"end": options.end, "ratios": ratios, "runs": found}
    if options.document:
        STORED.write_text(json.dumps(data, indent=1) + "\n")
        write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
