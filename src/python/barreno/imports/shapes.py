# SPDX-License-Identifier: BSD-3-Clause
"""Geometry pieces as shapes of a deck: box, sphere, cylinder, cone, and what is combined of them."""

import math

from barreno.imports.bounds import COMBINED, bounds_of, is_cut_there, ring_of
from barreno.imports.deck import name_of, table
from barreno.runs.faults import Fault

# Pieces of Uintah, with and without a counterpart.
PIECES = (*COMBINED, "box", "sphere", "cylinder", "cone", "parallelepiped", "ellipsoid", "torus", "tri", "file", "smoothcyl",
    "smooth_sphere", "sphere_membrane", "corrugated", "shell",
          "plane", "null", "abaqus_mesh", "convex_polyhedron", "image", "naaba", "cubic_sphere", "svg", "linesegment")  # fmt: skip


class Left(Exception):
    """A piece that no shape of a deck is."""


def refuse_flat(bottom, top, radius):
    if bottom == top or not radius > 0.0:
        raise Left("a cylinder or cone without length or radius holds nothing")


def axis_of(bottom, top):
    """The coordinate along which a cylinder or cone stands, or None."""
    along = [i for i in range(3) if bottom[i] != top[i]]
    return along[0] if len(along) == 1 else None


class Shapes:
    """@param space  of the grid  @param lists  Shapes of the deck, filled with the parts of combined shapes"""

    def __init__(self, space, notes):
        self.space, self.notes, self.lists, self.labelled = space, notes, {}, {}

    def shape_of(self, piece):
        """Parameters of a body or of a shape. @raises Left"""
        label = piece.attribute("label") or piece.attribute("name")
        if label and not piece.children():
            if label not in self.labelled:
                raise Left(f'the piece <{piece.tag} label="{label}"> has no dimensions, and no piece of that label with a counterpart '
                    'stands before it')
            return self.labelled[label]
        makers = {"box": self.box, "sphere": self.ball, "cylinder": self.cylinder, "cone": self.cone, "parallelepiped": self.parallelepiped}
        if piece.tag in COMBINED:
            shape = self.combined(piece)
        elif piece.tag in makers:
            shape = makers[piece.tag](piece)
        else:
            raise Left(f"the piece <{piece.tag}> is none of box, sphere, cylinder, cone, union, difference and intersection")
        if label:
            self.labelled[label] = shape
        return shape

    def remember(self, piece):
        """Labels within a piece that becomes no body, for pieces that name them."""
        for child in piece.children():
            self.remember(child)
        if piece.tag in PIECES and piece.children() and (piece.element.get("label") or piece.element.get("name")):
            try:
                self.shape_of(piece)
            except (Left, Fault):  # whoever names the label is told so
                pass

    def width_in_plane(self, z, radius):
        """Of a disk about z, its half-width where the layer of the grid cuts it. @raises Left"""
        low, high = self.space.layer
        distance = max(low - z, z - high, 0.0)
        if distance >= radius:
            raise Left(f"it lies beside the plane of the grid, which reaches from z = {low:g} to {high:g}")
        if distance == 0.0:
            return radius
        distance = min(abs(z - (low + high) / 2.0), radius * (1.0 - 1e-6))  # from the middle of the layer, where its particles are
        return math.sqrt(radius**2 - distance**2)

    def check_in_plane(self, low, high):
        """Of a piece between two heights. @raises Left"""
        bottom, top = self.space.layer
        if self.space.axes == 2 and (high <= bottom or low >= top) and not (self.space.mode == "axisymmetric" and low <= bottom <= high):
            raise Left(f"it lies beside the plane of the grid, which reaches from z = {bottom:g} to {top:g}")
        if self.space.mode == "plane strain" and not low <= (bottom + top) / 2.0 <= high:
            self.notes.lost(f"pieces that fill a part of the plane's thickness alone, from z = {low:g} to {high:g}, fill all of it.")

    def body_of(self, piece):
        """The shape of a body, cut at the grid, beyond which Uintah makes no particles. @raises Left"""
        return self.inside(self.shape_of(piece))

    def inside(self, shape):
        low, high = bounds_of(shape, self.lists)
        outside = [(i, edge) for i in range(len(low))
            for edge, out in ((self.space.lower[i], low[i] < self.space.lower[i]),
                (self.space.upper[i], high[i] > self.space.upper[i])) if out]
        if not outside or all(is_cut_there(shape, i, edge) for i, edge in outside):
            return shape
        if any(low[i] >= self.space.upper[i] or high[i] <= self.space.lower[i] for i in range(len(low))):
            raise Left("it lies outside of the grid")
        if shape["Shape"] == "box":
            return {"Shape": "box", "Lower": [max(x) for x in zip(low, self.space.lower)],
                "Upper": [min(x) for x in zip(high, self.space.upper)]}
        names = [name_of("whole", self.lists, "part")]
        self.lists[names[0]] = shape
        names.append(name_of("inside of the grid", self.lists, "part"))
        self.lists[names[1]] = {"Shape": "box", "Lower": self.space.lower, "Upper": self.space.upper}
        return {"Shape": "intersection", "Parts": names}

    def box(self, piece):
        low, high = piece.vector("min", "lower"), piece.vector("max", "upper")
        self.check_in_plane(min(low[2], high[2]), max(low[2], high[2]))
        return {"Shape": "box", "Lower": self.space.point([min(x) for x in zip(low, high)]),
            "Upper": self.space.point([max(x) for x in zip(low, high)])}

    def ball(self, piece):
        centre = piece.vector("origin", "center", default=(0.0, 0.0, 0.0))
        radius = piece.number("radius")
        if self.space.axes == 2:
            radius = self.width_in_plane(centre[2], radius)
        return {"Shape": "ball", "Centre": self.space.point(centre), "Radius": radius}

    def cylinder(self, piece):
        bottom, top, radius = piece.vector("bottom"), piece.vector("top"), piece.number("radius")
        refuse_flat(bottom, top, radius)
        if self.space.mode == "3D":
            return {"Shape": "cylinder", "Start": bottom, "End": top, "Radius": radius}
        return self.slice_of(bottom, top, radius, radius)

    def cone(self, piece):
        bottom, top = piece.vector("bottom"), piece.vector("top")
        start, end = piece.number("bottom_radius", default=0.0), piece.number("top_radius", default=0.0)
        refuse_flat(bottom, top, max(start, end))
        if self.space.mode != "3D":
            return self.slice_of(bottom, top, start, end)
        if start == 0.0:  # the tip of a cone of the deck is at its end
            bottom, top, start, end = top, bottom, end, start
        return {"Shape": "cone", "Start": bottom, "End": top, "Radius": start, **({"End Radius": end} if end else {})}

    def slice_of(self, bottom, top, start, end):
        """A cylinder or cone in the plane of the grid: Uintah cuts it there, also in axisymmetry."""
        axis = axis_of(bottom, top)
        if axis is None:
            raise Left("a cylinder or cone that is not along an axis is no shape of two dimensions")
        if axis != 2:
            start, end = (self.width_in_plane(bottom[2], radius) if radius else 0.0 for radius in (start, end))
        else:
            self.check_in_plane(*sorted((bottom[2], top[2])))
            if start != end or self.space.mode == "axisymmetric":
                raise Left("a cylinder or cone normal to the plane is a disk in plane strain alone, and only if its radius is constant")
            return {"Shape": "cylinder", "Centre": bottom[:2], "Radius": start}
        across = 1 - axis
        if self.space.mode == "axisymmetric" and (axis != 1 or bottom[0] != 0.0):
            raise Left("in axisymmetry a cylinder or cone must stand on the axis x = 0")
        if start == end:
            low, high = sorted((bottom[axis], top[axis]))
            corners = [[0.0, 0.0], [0.0, 0.0]]
            corners[0][axis], corners[1][axis] = low, high
            corners[0][across] = 0.0 if self.space.mode == "axisymmetric" else bottom[across] - start
            corners[1][across] = bottom[across] + start
            return {"Shape": "box", "Lower": corners[0], "Upper": corners[1]}
        return self.trapezoid(bottom, top, start, end, axis)

    def trapezoid(self, bottom, top, start, end, axis):
        across, whole = 1 - axis, self.space.mode != "axisymmetric"
        corners = []
        for place, radius, sign in ((bottom, start, 1), (top, end, 1), (top, end, -1), (bottom, start, -1)):
            corner = [0.0, 0.0]
            corner[axis], corner[across] = place[axis], place[across] + sign * radius if whole or sign > 0 else 0.0
            if corner not in corners:
                corners.append(corner)
        return {"Shape": "polygon", "Corners": table(corners), "Points": corners}

    def parallelepiped(self, piece):
        p1, others = piece.vector("p1"), [piece.vector(name) for name in ("p2", "p3", "p4")]
        edges = [[b - a for a, b in zip(p1, other)] for other in others]
        along = [[i for i in range(3) if not math.isclose(edge[i], 0.0, abs_tol=1e-12 * max(map(abs, edge)))] for edge in edges]
        if sorted(len(axes) for axes in along) != [1, 1, 1] or len({axes[0] for axes in along}) != 3:
            raise Left("a <parallelepiped> with edges that are not along the axes is no box")
        ends = [sum(x) for x in zip(p1, *edges)]
        low, high = [min(x) for x in zip(p1, ends)], [max(x) for x in zip(p1, ends)]
        self.check_in_plane(low[2], high[2])
        return {"Shape": "box", "Lower": self.space.point(low), "Upper": self.space.point(high)}

    def combined(self, piece):
        found = [child for child in piece.children() if child.tag in PIECES] or piece.children()
        return self.combination(piece.tag, self.parts_of(piece.tag, found))

    def parts_of(self, kind, found):
        """Pieces beside the plane add nothing to a union and cut nothing from the first of a difference."""
        parts = []
        for position, child in enumerate(found):
            try:
                parts.append(self.shape_of(child))
            except Left as reason:
                if "beside the plane" not in str(reason) or kind == "intersection" or (kind == "difference" and position == 0):
                    raise
        if len(found) < 2 and kind != "union":
            raise Left(f"<{kind}> has fewer than two pieces")
        if not parts:
            raise Left(f"<{kind}> has no piece in the plane of the grid")
        return parts

    def combination(self, kind, parts):
        if len(parts) == 1:
            return parts[0]
        if kind == "difference" and (ring := ring_of(parts)):
            return ring
        names = []
        for part in parts:
            names.append(name_of(f"{kind} part", self.lists, "part"))
            self.lists[names[-1]] = part
        return {"Shape": kind, "Parts": names}
