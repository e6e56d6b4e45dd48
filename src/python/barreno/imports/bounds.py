# SPDX-License-Identifier: BSD-3-Clause
"""Boxes around shapes of a deck, and what follows from them."""

import math

COMBINED = ("union", "difference", "intersection")


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


def used_shapes(bodies, lists):
    """The lists of Shapes that bodies need; those of bodies that are left out go."""
    needed, wanted = set(), [name for body in bodies.values() for name in body.get("Parts", ())]
    while wanted:
        name = wanted.pop()
        if name not in needed:
            needed.add(name)
            wanted += lists[name].get("Parts", ())
    return {name: shape for name, shape in lists.items() if name in needed}
