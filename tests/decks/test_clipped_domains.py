#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""CPDI particles whose domain is cut at Largest Domain: marked in particles.e, as many as history.csv counts.

    test_clipped_domains.py BARRENO
"""
import pathlib
import sys
import tempfile

import numpy as np

from tools.runs import run_deck

LARGEST = 0.4  # corners of the undeformed particles are 0.354 cells from their centre
HALF = 0.25  # [cells]


def check(shape, cut, farthest):
    """The bar stretches along x alone: its domain is cut where farthest(F_xx) is beyond the limit."""
    settings = {"Step/Shape Function": shape, "Step/Largest Domain": LARGEST}
    with tempfile.TemporaryDirectory() as name:
        run = run_deck(sys.argv[1], "stretched_bar.xml", settings, folder=pathlib.Path(name) / "run")
        history = run.table("history.csv")
        counts = []
        for step in range(run.instants()):
            particles = run.particles(step)
            marks = particles["domain_clipped"]
            assert set(np.unique(marks)) <= {0.0, 1.0}, f"{shape}: marks are {np.unique(marks)}"
            row = np.argmin(np.abs(history["time"] - particles["time"]))
            assert abs(history["time"][row] - particles["time"]) < 1e-12, f"{shape}: no row at {particles['time']} s"
            count = int(marks[particles["status"] > 0.5].sum())
            assert count == history["clipped"][row], f"{shape}: {count} marks, history.csv has {history['clipped'][row]}"
            # Off by round-off at most: nobody is within a thousandth of the limit.
            beyond = farthest(particles["volume_ratio"]) > cut
            assert np.array_equal(marks > 0.5, beyond), f"{shape}: marked are not those beyond {cut} cells"
            counts.append(count)
        assert counts[0] == 0 and max(counts) > len(marks) / 4, f"{shape}: counts are {counts}"
        assert run.summary["clipped_particles"] == counts[-1]
    print(f"{shape}: clipped {counts}")


def main():
    check("CPDI", LARGEST, lambda stretch: HALF * np.hypot(stretch, 1.0))
    check("contiguous GIMP", LARGEST, lambda stretch: HALF * stretch)


if __name__ == "__main__":
    main()
