# SPDX-License-Identifier: BSD-3-Clause
"""A quarter of a sandstone plug between glued platens in GetFEM: confined at the sides, then pressed.

    getfem_plug.py [CARD [INCREMENTS]]     platen force after each increment

Needs getfem_box.py beside it, and the Python package barreno.
"""

import itertools
import sys

import numpy

import getfem_box

CELLS = (4, 4, 4)
LENGTHS = (12.7e-3, 11.0e-3, 25.4e-3)  # m, between three planes of symmetry
CONFINEMENT = 20e6  # Pa, on the sides

# (increments, displacement of the platen at the end [m], pressure on the sides at the end [Pa]): ramps one after
# the other, small strains, loads on the undeformed faces.
STEPS = ((5, -3e-5, CONFINEMENT), (24, -3e-4, CONFINEMENT))


def increments():
    """(platen, pressure) at the end of each increment."""
    platen = pressure = 0.0
    for count, platen_end, pressure_end in STEPS:
        for i in range(1, count + 1):
            t = i / count
            yield platen + t * (platen_end - platen), pressure + t * (pressure_end - pressure)
        platen, pressure = platen_end, pressure_end


def force_of_unit_pressure(box):
    """Nodal forces of pressure 1 on the upper faces along x and y."""
    sides = 10
    for axis in (0, 1):
        box.mesh.set_region(sides + axis, box.mesh.outer_faces_with_direction(numpy.eye(3)[axis], 0.01))
    box.mesh.region_merge(sides, sides + 1)
    force = numpy.asarray(box.getfem.asm("generic", box.rule, 1, "-Normal.Test_u", sides, box.model))
    return force[box.own()]


def solve(material, getfem, count=None):
    """Force on the platen [N] and stress and state at the points after each increment, and Newton's iterations.
    @param count  of increments, all without it"""
    box = getfem_box.Box(getfem, CELLS, LENGTHS)
    platen_moves = box.on_face(2, True, 2)
    held = box.on_face(2, True, 0) | box.on_face(2, True, 1)
    for axis in range(3):
        held |= box.on_face(axis, False, axis)
    free = numpy.where(~(held | platen_moves))[0]
    sides = force_of_unit_pressure(box)
    stress, state = material.virgin(box.points)
    forces, stresses, states, iterations = [], [], [], []
    old_platen = 0.0
    for platen, pressure in itertools.islice(increments(), count):
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


def main():
    import getfem
    from barreno.materials import Material

    getfem.util("trace level", 0)
    getfem.util("warning level", 0)
    material = Material(sys.argv[1] if len(sys.argv) > 1 else "berea_sandstone")
    count = int(sys.argv[2]) if len(sys.argv) > 2 else None
    forces, _, _, iterations = solve(material, getfem, count)
    for number, (force, iteration) in enumerate(zip(forces, iterations), 1):
        print(f"increment {number}: {force:.6e} N, {iteration} iterations")


if __name__ == "__main__":
    main()
