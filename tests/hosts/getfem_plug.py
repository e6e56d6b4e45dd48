# SPDX-License-Identifier: BSD-3-Clause
"""The plug of plug.py in GetFEM: Newton on the library's unsymmetric tangent, all Gauss points in one batch."""

import numpy

import plug

PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]  # the order of barreno_material.h


def tensors(components):
    """(n, 6) -> (n, 3, 3)"""
    full = numpy.empty((len(components), 3, 3))
    for a, (i, j) in enumerate(PAIRS):
        full[:, i, j] = full[:, j, i] = components[:, a]
    return full


def stiffness(tangent):
    """(n, 6, 6) -> C_ijkl (n, 3, 3, 3, 3)"""
    full = numpy.empty((len(tangent), 3, 3, 3, 3))
    for a, (i, j) in enumerate(PAIRS):
        for b, (k, l) in enumerate(PAIRS):
            for x, y in {(i, j), (j, i)}:
                for p, q in {(k, l), (l, k)}:
                    full[:, x, y, p, q] = tangent[:, a, b]
    return full


class Plug:
    """Mesh, unknowns and the terms of the residual; 2 by 2 by 2 Gauss points in each brick."""

    def __init__(self, getfem):
        gf = self.getfem = getfem
        gf.util("trace level", 0)
        gf.util("warning level", 0)
        axes = [numpy.linspace(0.0, length, n + 1) for n, length in zip(plug.CELLS, plug.LENGTHS)]
        mesh = gf.Mesh("cartesian", *axes)
        self.unknowns = gf.MeshFem(mesh, 3)
        self.unknowns.set_fem(gf.Fem("FEM_QK(3,1)"))
        self.rule = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))
        self.tensors = gf.MeshImData(self.rule, -1, [3, 3])
        self.points = self.tensors.nbpts()
        self.model = gf.Model("real")
        self.model.add_fem_variable("u", self.unknowns)
        self.model.add_fem_data("du", self.unknowns)
        self.model.add_im_data("Sig", self.tensors)
        self.model.add_im_data("Ct", gf.MeshImData(self.rule, -1, [3, 3, 3, 3]))
        self.sides = self._force_of_unit_pressure(mesh)
        self._conditions()

    def _force_of_unit_pressure(self, mesh):
        sides = 10
        for axis in (0, 1):
            mesh.set_region(sides + axis, mesh.outer_faces_with_direction(numpy.eye(3)[axis], 0.01))
        mesh.region_merge(sides, sides + 1)
        force = numpy.asarray(self.getfem.asm("generic", self.rule, 1, "-Normal.Test_u", sides, self.model))
        return force[self._own()]

    def _own(self):
        """Place of the displacements among the model's unknowns."""
        first, count = self.model.interval_of_variable("u")
        return slice(first, first + count)

    def _conditions(self):
        place = self.unknowns.basic_dof_nodes()
        count = self.unknowns.nbdof()
        component = numpy.arange(count) % 3
        at = lambda axis, x: abs(place[axis] - x) < 1e-9
        self.platen = at(2, plug.LENGTHS[2]) & (component == 2)
        held = at(2, plug.LENGTHS[2]) & (component < 2)
        for axis in range(3):
            held |= at(axis, 0.0) & (component == axis)
        self.free = numpy.where(~(held | self.platen))[0]

    def strain(self, du):
        """Strain increment at the points, (n, 6)."""
        self.model.set_variable("du", du)
        flat = numpy.asarray(self.model.interpolation("Sym(Grad_du)", self.tensors)).reshape(-1, order="F")
        flat = flat.reshape(self.points, 9)
        return numpy.stack([flat[:, i + 3 * j] for i, j in PAIRS], 1)

    def residual_and_matrix(self, stress, tangent):
        gf = self.getfem
        # Within a point the components are in Fortran's order.
        self.model.set_variable("Sig", tensors(stress).transpose(0, 2, 1).reshape(-1))
        self.model.set_variable("Ct", stiffness(tangent).transpose(0, 4, 3, 2, 1).reshape(-1))
        residual = numpy.asarray(gf.asm("generic", self.rule, 1, "Sig:Grad_Test_u", -1, self.model))
        matrix = gf.asm("generic", self.rule, 2, "(Ct:Grad_Test2_u):Grad_Test_u", -1, self.model)
        own = self._own()
        return residual[own], numpy.asarray(matrix.full())[own, own]


def solve(material, getfem):
    """Force on the platen [N] and stress and state at the points after each increment, and Newton's iterations."""
    box = Plug(getfem)
    stress, state = material.virgin(box.points)
    forces, stresses, states, iterations = [], [], [], []
    old_platen = 0.0
    for platen, pressure in plug.increments():
        du = numpy.zeros(box.unknowns.nbdof())
        du[box.platen] = platen - old_platen
        for iteration in range(30):
            new_stress, new_state, tangent, status = material.update(box.strain(du), stress, state)
            assert not status.any(), "a point failed"
            residual, matrix = box.residual_and_matrix(new_stress, tangent)
            residual = residual - pressure * box.sides
            if numpy.linalg.norm(residual[box.free]) < 1e-7 * abs(residual).max():
                break
            du[box.free] -= numpy.linalg.solve(matrix[numpy.ix_(box.free, box.free)], residual[box.free])
        else:
            raise AssertionError(f"no equilibrium at platen {platen}")
        old_platen, stress, state = platen, new_stress, new_state
        iterations.append(iteration)
        forces.append(residual[box.platen].sum())
        stresses.append(stress)
        states.append(state)
    return numpy.array(forces), stresses, states, iterations
