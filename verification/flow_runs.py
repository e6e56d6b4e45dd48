#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How much flows into the whole hole, of runs that should agree and with two sizes of cells.

    flow_runs.py BARRENO [--cells N ...] [--courant F ...]    verification/results/flow_runs.json, and docs/flow.md

Deck: perforation.xml to 120 us. Minutes of one core for each run.
"""
import argparse
import json
import os
import pathlib
import sys

from tools import foreign_python  # noqa: F401
from tools.flow_efficiency import RING, efficiency_of
from tools.runs import run_deck
from tools.write_pages import write_pages

STORED = pathlib.Path(__file__).resolve().parent / "results" / "flow_runs.json"
SETTINGS = {"Time/End Time": "120 us", "Output/Field Interval": "0 us"}
DISTANCES = (1, 2, 3, 4, 6, 8, 10, 12, 14, 16)  # mm from the wall
PARTS = (0.25, 0.5, 0.75)  # of the hole's length in rock


def answers_of(rings, permeability):
    from barreno.flow.surge_table import skin_of

    efficiency = efficiency_of(rings, permeability)
    return {"efficiency": round(efficiency, 5), "skin": round(skin_of(efficiency, rings), 3)}


def flow_of(run, cell):
    """Of the hole with its broken grains, and with whole ones. @param cell  of the flow: RING and half of it [m]"""
    from barreno.flow.rings import permeability_of, rings_of

    rings = rings_of(run, None, cell)
    whole = permeability_of(rings.permeability > 0.0, rings.porosity, 0.0, rings.virgin)
    return {"broken": answers_of(rings, rings.permeability), "whole": answers_of(rings, whole),
        "length": round(rings.hole_length, 6), "radius": round(rings.hole_radius, 6)}  # fmt: skip


def rock_of(run):
    """Rings at three depths: skin, radii from the wall, and the permeability at DISTANCES with broken and with whole grains."""
    import numpy as np
    from barreno.report.hole import face_of, measure_hole
    from barreno.report.hole_section import face_of_rock
    from barreno.report.porosity import relative_permeability
    from barreno.report.zones import Rock, rings_at

    frame, deck = run.frame(None), run.deck
    hole = measure_hole(frame, deck, face_of(run.depth_table(), frame.file, deck))
    rock, top = Rock(frame, deck, hole.face), face_of_rock(frame, deck, hole.face)
    out = []
    for part in PARTS:
        ring = rings_at(rock, hole, top + part * (hole.length - top))
        away, wall = 1e3 * (ring.radius - ring.edges[0]), ring.edges[0]
        at = lambda values: [round(float(value), 4) for value in np.interp(DISTANCES, away, values)]  # noqa: E731
        out.append({"part": part, "skin": round(ring.skin, 3), "impaired": round(ring.impaired[1] - wall, 6),
            "crushed": round(ring.crushed[1] - wall, 6), "porosity": at(ring.porosity), "breakage": at(ring.breakage),
            "permeability": at(ring.permeability), "whole": at(relative_permeability(ring.porosity, ring.virgin))})  # fmt: skip
    return out


def measured(finished):
    from barreno.report.run import opened

    with opened(finished.folder) as run:
        return {"flow": {str(1e3 * cell): flow_of(run, cell) for cell in (RING, 0.5 * RING)}, "rock": rock_of(run),
            "cpu_seconds": finished.summary["cpu_seconds"]}


def keep(cells, courant, one):
    found = json.loads(STORED.read_text()) if STORED.exists() else {}
    found.setdefault(cells, {})[courant] = one
    STORED.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
    print(cells, courant, one["flow"], flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--cells", nargs="+", default=["1.2", "1.8"])
    parser.add_argument("--courant", nargs="+", default=["0.8", "0.79", "0.78"])
    options = parser.parse_args()
    os.environ["BARRENO_PROGRAM"] = str(options.barreno.resolve())
    for cells in options.cells:
        for courant in options.courant:
            settings = {**SETTINGS, "Jet/Cells Per Radius": cells, "Step/Courant Fraction": courant}
            keep(cells, courant, measured(run_deck(options.barreno.resolve(), "perforation.xml", settings)))
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
