#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One thread or two: the same numbers, in CalculiX and through the C interface.

    test_threads.py LIBRARY FOLDER_OF_CCX
"""

import concurrent.futures
import sys

import numpy

import barreno_library
import calculix
import calculix_plug

PRINTED = 1e-6  # .dat shows seven digits, of which a sum over threads may turn the last


def check_interface(library):
    """Batches of both threads at once, in one material, bit for bit those of one thread."""
    random = numpy.random.default_rng(1)
    count, rounds = 4000, 5
    for card in ("berea_sandstone", "copper"):
        material = barreno_library.Material(barreno_library.CARDS / f"{card}.xml", library)
        strain = random.normal(0.0, 3e-3, (count, 6))

        def advance(part):
            stress, state = material.virgin(len(part))
            for _ in range(rounds):
                stress, state, tangent, status = material.update(part, stress, state, dt=1e-6)
                assert not status.any()
            return stress, state, tangent

        alone = advance(strain)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            halves = list(pool.map(advance, (strain[: count // 2], strain[count // 2 :])))
        for whole, *parts in zip(alone, *halves):
            assert numpy.array_equal(whole, numpy.concatenate(parts)), card
        assert abs(alone[0]).max() > 1e7
        print(f"C interface, {card}: {count} points, two threads, the same bits")


def check_calculix(ccx, path, state_count):
    runs = [calculix_plug.solve(ccx, path, state_count, threads) for threads in (1, 2)]
    worst = 0.0
    for one, two in zip(runs[0][1] + runs[0][2], runs[1][1] + runs[1][2]):
        assert abs(one).max() > 0.0
        worst = max(worst, (abs(one - two).max(axis=0) / numpy.maximum(abs(one).max(axis=0), 1e-30)).max())
    print(f"CalculiX, one and two threads: stresses and states differ by {worst:.1e}")
    assert worst < PRINTED


def main():
    library = barreno_library.load(sys.argv[1])
    check_interface(library)
    ccx = calculix.program(sys.argv[2])
    check_calculix(ccx, sys.argv[1], barreno_library.Material("berea_sandstone", library).state_count)


if __name__ == "__main__":
    main()
