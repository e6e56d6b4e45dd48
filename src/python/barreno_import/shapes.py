# SPDX-License-Identifier: BSD-3-Clause
"""Geometry pieces as shapes of a deck: box, sphere, cylinder, cone, and what is combined of them."""

import math

from barreno_import.deck import name_of, table

COMBINED = ("union", "difference", "intersection")


class Left(Exception):
    """A piece that no shape of a deck is."""


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
        if label and not piece.children() and label in self.labelled:
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

    def body_of(self, piece):
        """The shape of a body, cut at the grid, beyond which Uintah makes no particles. @raises Left"""
        shape = self.shape_of(piece)
        low, high = bounds_of(shape, self.lists)
        outside = [(i, edge) for i in range(len(low)) for edge, out in ((self.space.lower[i], low[i] < self.space.lower[i]), (self.space.upper[i], high[i] > self.space.upper[i])) if out]
        if not outside or all(is_cut_there(shape, i, edge) for i, edge in outside):
            return shape
        if any(low[i] >= self.space.upper[i] or high[i] <= self.space.lower[i] for i in range(len(low))):
            raise Left("it lies outside of the grid")
        if shape["Shape"] == "box":
            return {"Shape": "box", "Lower": [max(x) for x in zip(low, self.space.lower)], "Upper": [min(x) for x in zip(high, self.space.upper)]}
        names = [name_of("whole", self.lists, "part")]
        self.lists[names[0]] = shape
        names.append(name_of("inside of the grid", self.lists, "part"))
        self.lists[names[1]] = {"Shape": "box", "Lower": self.space.lower, "Upper": self.space.upper}
        return {"Shape": "intersection", "Parts": names}

    def box(self, piece):
        low, high = piece.vector("min", "lower"), piece.vector("max", "upper")
        return {"Shape": "box", "Lower": self.space.point(low), "Upper": self.space.point(high)}

    def ball(self, piece):
        centre = piece.vector("origin", "center", default=(0.0, 0.0, 0.0))
        return {"Shape": "ball", "Centre": self.space.point(centre), "Radius": piece.number("radius")}

    def cylinder(self, piece):
        bottom, top, radius = piece.vector("bottom"), piece.vector("top"), piece.number("radius")
        if self.space.mode == "3D":
            return {"Shape": "cylinder", "Start": bottom, "End": top, "Radius": radius}
        return self.slice_of(bottom, top, radius, radius)

    def cone(self, piece):
        bottom, top = piece.vector("bottom"), piece.vector("top")
        start, end = piece.number("bottom_radius", default=0.0), piece.number("top_radius", default=0.0)
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
        if axis == 2:
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
        return {"Shape": "box", "Lower": self.space.point(low), "Upper": self.space.point(high)}

    def combined(self, piece):
        parts = [self.shape_of(child) for child in piece.children()]
        if len(parts) < 2:
            raise Left(f"<{piece.tag}> has fewer than two pieces")
        if piece.tag == "difference" and (ring := ring_of(parts)):
            return ring
        names = []
        for part in parts:
            names.append(name_of(f"{piece.tag} part", self.lists, "part"))
            self.lists[names[-1]] = part
        return {"Shape": piece.tag, "Parts": names}


def bounds_of(shape, lists):
    """Corners of the smallest box around a shape, or of a larger one."""
    kind = shape["Shape"]
    if kind == "box":
        return shape["Lower"], shape["Upper"]
    if kind == "polygon":
        return [min(x) for x in zip(*shape["Points"])], [max(x) for x in zip(*shape["Points"])]
    if kind in COMBINED:
        boxes = [bounds_of(lists[name], lists) for name in shape["Parts"]]
        if kind == "difference":
            return boxes[0]
        nearest, farthest = (min, max) if kind == "union" else (max, min)
        return [nearest(x) for x in zip(*(box[0] for box in boxes))], [farthest(x) for x in zip(*(box[1] for box in boxes))]
    if "Centre" in shape:
        return [x - shape["Radius"] for x in shape["Centre"]], [x + shape["Radius"] for x in shape["Centre"]]
    return bounds_of_axis(shape)


def bounds_of_axis(shape):
    """Of a cylinder or cone: each end is a disk normal to the axis."""
    line = [b - a for a, b in zip(shape["Start"], shape["End"])]
    length = math.sqrt(sum(x * x for x in line))
    across = [math.sqrt(max(0.0, 1.0 - (x / length) ** 2)) for x in line]
    second = shape.get("End Radius", 0.0) if shape["Shape"] == "cone" else shape["Radius"]
    ends = [(shape["Start"], shape["Radius"]), (shape["End"], second)]
    return [min(p[i] - r * across[i] for p, r in ends) for i in range(3)], [max(p[i] + r * across[i] for p, r in ends) for i in range(3)]


def is_cut_there(shape, axis, edge):
    """A face of the grid through its centre or centre line cuts a body by itself."""
    places = [shape[key] for key in ("Centre", "Start", "End") if key in shape]
    return bool(places) and all(place[axis] == edge for place in places)


def ring_of(parts):
    """A box without another that reaches through it along one axis, and from its lower side on along the other: a tube in
    axisymmetry, say. It is a box itself, which may bear loads."""
    if len(parts) != 2 or any(part["Shape"] != "box" or len(part["Lower"]) != 2 for part in parts):
        return None
    outer, inner = parts
    for axis in (0, 1):
        other = 1 - axis
        through = inner["Lower"][other] <= outer["Lower"][other] and inner["Upper"][other] >= outer["Upper"][other]
        if through and inner["Lower"][axis] <= outer["Lower"][axis] < inner["Upper"][axis] < outer["Upper"][axis]:
            lower = list(outer["Lower"])
            lower[axis] = inner["Upper"][axis]
            return {"Shape": "box", "Lower": lower, "Upper": outer["Upper"]}
    return None
