#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""1, 8 and 16 ranks, more than there are cores, give the same bits, 8 resumed too, and each has its part of the work alone.

    test_many_ranks.py BARRENO

The scene and the counts are those of verification/performance/many_ranks.py, smaller.
"""
import pathlib
import sys

from performance.many_ranks import measure, page

CELLS, RESUMED = 24, 8
# Over an equal share: at the borders of a rank's share of a lattice cells are asked for by two ranks, and tiles stay whole.
MOST_PLACES, MOST_PARTICLES, MOST_BYTES = 2.0, 1.5, 1.5


def main():
    rows, wrong = measure(pathlib.Path(sys.argv[1]).resolve(), CELLS, (1, 8, 16), resumed_on=(RESUMED,))
    print("\n".join(page(rows)))
    assert not wrong, "; ".join(wrong)
    one = rows[0]
    assert one["particles_made"] == one["particles"], one
    for row in rows:
        ranks = row["ranks"]
        assert row["particles_made"] == one["particles"], row
        assert row["largest_rank_particles_made"] < MOST_PARTICLES * one["particles"] / ranks, row
        assert row["largest_rank_candidate_points"] < MOST_PLACES * one["candidate_points"] / ranks, row
    # The seal, the values and a rank's own rows: three times the file, of which all but the small tables is shared.
    again = next(row for row in rows if row["ranks"] == RESUMED)
    assert again["largest_rank_checkpoint_bytes"] < 3 * MOST_BYTES * again["checkpoint_bytes"] / RESUMED, again


if __name__ == "__main__":
    main()
