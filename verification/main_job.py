#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the main job answers, beside the shot to 120 us that came before it, and how long each takes on two ranks.

    main_job.py BARRENO    verification/results/main_job.json, and the table of README.md

Some minutes of two cores, on which nothing else should run.
"""
import argparse
import json
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools.flow_efficiency import efficiency_of_run
from tools.penetration import between_particles_and_grid
from tools.runs import run_deck
from tools.write_pages import write_pages

STORED = pathlib.Path(__file__).resolve().parent / "results" / "main_job.json"
DECKS = ("perforation_120us.xml", "perforation.xml")
KEPT = ("depth", "probed_depth", "depth_in_body", "entrance_diameter_in_body", "channel_volume", "channel_radius_mid", "zones_in_body",
    "depth_error", "probed_depth_error", "channel_volume_error", "core_flow_efficiency_error",
    "least_certain", "rest")  # fmt: skip


def measured(barreno, deck):
    """Answers of a run, and what it cost."""
    finished = run_deck(barreno, deck, {"Output/Field Interval": "0 us"}, ranks=2)
    summary = finished.summary
    found = {name: summary["penetration"][name] for name in KEPT if name in summary["penetration"]}
    return {**found, "efficiency": efficiency_of_run(finished.folder), "end": summary["time"], "seconds": summary["wall_seconds"],
        "bytes": summary["peak_resident_bytes"], "lost": between_particles_and_grid(finished)}  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    barreno = parser.parse_args().barreno.resolve()
    STORED.write_text(json.dumps({deck: measured(barreno, deck) for deck in DECKS}, indent=1) + "\n")
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
