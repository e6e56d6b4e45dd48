# SPDX-License-Identifier: BSD-3-Clause
"""GetFEM as a host: a box of bricks, Newton on the library's unsymmetric tangent, all Gauss points in one batch."""

import numpy

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


class Box:
    """Mesh, unknowns and the terms of the residual; 2 by 2 by 2 Gauss points in each brick."""

    def __init__(self, getfem, cells, lengths):
        gf = self.getfem = getfem
        axes = [numpy.linspace(0.0, length, n + 1) for n, length in zip(cells, lengths)]
        self.mesh = gf.Mesh("cartesian", *axes)
        self.lengths = lengths
        self.unknowns = gf.MeshFem(self.mesh, 3)
        self.unknowns.set_fem(gf.Fem("FEM_QK(3,1)"))
        self.rule = gf.MeshIm(self.mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))
        self.tensors = gf.MeshImData(self.rule, -1, [3, 3])
        self.points = self.tensors.nbpts()
        self.model = gf.Model("real")
        self.model.add_fem_variable("u", self.unknowns)
        self.model.add_fem_data("du", self.unknowns)
        self.model.add_im_data("Sig", self.tensors)
        self.model.add_im_data("Ct", gf.MeshImData(self.rule, -1, [3, 3, 3, 3]))

    def on_face(self, axis, upper, component):
        """Mask of the displacements of one component on a face of the box."""
        place = self.unknowns.basic_dof_nodes()[axis] - (self.lengths[axis] if upper else 0.0)
        return (abs(place) < 1e-9) & (numpy.arange(self.unknowns.nbdof()) % 3 == component)

    def own(self):
        """Place of the displacements among the model's unknowns."""
        first, count = self.model.interval_of_variable("u")
        return slice(first, first + count)

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
        own = self.own()
        return residual[own], numpy.asarray(matrix.full())[own, own]


def equilibrium(box, material, du, free, stress, state, load=0.0):
    """Newton's method for the free displacements of an increment; `du` begins with those that are prescribed.
    Returns du, stress, state, residual and the number of iterations."""
    du = du.copy()
    for iteration in range(30):
        new_stress, new_state, tangent, status = material.update(box.strain(du), stress, state)
        assert not status.any(), "a point failed"
        residual, matrix = box.residual_and_matrix(new_stress, tangent)
        residual = residual - load
        if numpy.linalg.norm(residual[free]) < 1e-7 * abs(residual).max():
            return du, new_stress, new_state, residual, iteration
        du[free] -= numpy.linalg.solve(matrix[numpy.ix_(free, free)], residual[free])
    raise AssertionError("no equilibrium")
