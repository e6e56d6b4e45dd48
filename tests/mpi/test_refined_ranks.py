#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Refined cells with steps of several lengths: the same bits on 1, 2 and 3 ranks, and where no tile is left out of a step.

    test_refined_ranks.py BARRENO

input_xml/perforation_120us.xml under its confinement, whose round-off moves nodes by about as much as dormant tiles may move.
"""
import sys

import numpy as np

from tools.runs import run_deck

SETTINGS = {
    "Grid/Cell Size": "1 mm", "Jet/Cells Per Radius": 4, "Step/Subcycles": 4, "Time/End Time": "1.5 us",
    "Bodies/Casing/Particles Per Cell": 1, "Bodies/Rock/Particles Per Cell": 1}
OTHERS = {"2 ranks": (2, {}), "3 ranks": (3, {}), "no tile left out": (1, {"Step/Skip Dormant Tiles": "false"})}


def main():
    one = run_deck(sys.argv[1], "perforation_120us.xml", SETTINGS)
    history, particles = one.table("history.csv"), one.particles()
    assert one.summary["skipped_particle_steps"] > one.summary["particle_steps"], "most particles are dormant"
    for name, (ranks, more) in OTHERS.items():
        other = run_deck(sys.argv[1], "perforation_120us.xml", {**SETTINGS, **more}, ranks)
        apart = [column for column, values in other.table("history.csv").items() if not np.array_equal(values, history[column])]
        assert not apart, f"{name}: {apart} of history.csv differ"
        apart = [field for field, values in other.particles().items()
                 if field != "rank" and not np.array_equal(values, particles[field], equal_nan=True)]
        assert not apart, f"{name}: {apart} of particles.e differ"
        print(f"{name}: the same bits of {len(history)} columns and {len(particles['corners'])} particles")


if __name__ == "__main__":
    main()
