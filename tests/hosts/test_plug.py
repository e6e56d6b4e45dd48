#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Triaxial compression of a sandstone plug: CalculiX (UMAT, symmetric solver) and GetFEM (C interface, Newton) agree.

    test_plug.py LIBRARY FOLDER_OF_CCX
"""

import sys
import tempfile

import numpy

import barreno_library
import calculix
import calculix_plug
import getfem_module
import getfem_plug
import plug

TOLERANCE = 1e-5
MOST_ITERATIONS = 8  # Newton's, with a right tangent, also in the increment where most points begin to flow


def spread(stress):
    """All values of each component, sorted: the hosts number their points differently."""
    return numpy.sort(stress, axis=0)


def main():
    library, ccx, gf = sys.argv[1], calculix.program(sys.argv[2]), getfem_module.module()
    with tempfile.TemporaryDirectory() as folder:
        material = barreno_library.Material(plug.write_card(folder), library)
    force, stresses, states = calculix_plug.solve(ccx, library, material.state_count)
    other_force, other_stresses, other_states, iterations = getfem_plug.solve(material, gf)

    assert len(force) == len(other_force) == sum(count for count, _, _ in plug.STEPS)
    assert abs(force).max() > 1e4, "the platen must be pressed"
    assert states[-1][:, 2 + 3].max() > 1e-3, "the rock must flow"
    off_force = abs(force - other_force).max() / abs(force).max()
    off_stress = max(
        abs(spread(a[:, 2:]) - spread(b)).max() / abs(b).max() for a, b in zip(stresses, other_stresses)
    )
    off_state = abs(spread(states[-1][:, 2:]) - spread(other_states[-1])).max(axis=0) / abs(other_states[-1]).max(axis=0)
    print(f"force at the end {force[-1]:.6e} N (CalculiX), {other_force[-1]:.6e} N (GetFEM)")
    print(f"largest differences: force {off_force:.1e}, stresses {off_stress:.1e}, states at the end {off_state.max():.1e}")
    print(f"Newton iterations in GetFEM: {iterations}")
    assert off_force < TOLERANCE
    assert off_stress < TOLERANCE
    assert off_state.max() < 10 * TOLERANCE  # plastic strain is the small difference of large ones
    assert max(iterations) <= MOST_ITERATIONS


if __name__ == "__main__":
    main()
