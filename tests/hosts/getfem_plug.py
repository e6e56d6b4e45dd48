# SPDX-License-Identifier: BSD-3-Clause
"""The plug of plug.py in GetFEM."""

import numpy

import getfem_box
import plug


def force_of_unit_pressure(box):
    """Nodal forces of pressure 1 on the upper faces along x and y."""
    sides = 10
    for axis in (0, 1):
        box.mesh.set_region(sides + axis, box.mesh.outer_faces_with_direction(numpy.eye(3)[axis], 0.01))
    box.mesh.region_merge(sides, sides + 1)
    force = numpy.asarray(box.getfem.asm("generic", box.rule, 1, "-Normal.Test_u", sides, box.model))
    return force[box.own()]


def solve(material, getfem):
    """Force on the platen [N] and stress and state at the points after each increment, and Newton's iterations."""
    box = getfem_box.Box(getfem, plug.CELLS, plug.LENGTHS)
    platen_moves = box.on_face(2, True, 2)
    held = box.on_face(2, True, 0) | box.on_face(2, True, 1)
    for axis in range(3):
        held |= box.on_face(axis, False, axis)
    free = numpy.where(~(held | platen_moves))[0]
    sides = force_of_unit_pressure(box)
    stress, state = material.virgin(box.points)
    forces, stresses, states, iterations = [], [], [], []
    old_platen = 0.0
    for platen, pressure in plug.increments():
        du = (platen - old_platen) * platen_moves
        _, stress, state, residual, iteration = getfem_box.equilibrium(
            box, material, du, free, stress, state, pressure * sides
        )
        old_platen = platen
        iterations.append(iteration)
        forces.append(residual[platen_moves].sum())
        stresses.append(stress)
        states.append(state)
    return numpy.array(forces), stresses, states, iterations
