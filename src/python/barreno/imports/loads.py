# SPDX-License-Identifier: BSD-3-Clause
"""Pressures on bodies. Uintah's load acts on each particle at the surface that a piece marks, of whatever body: along the axis on
an end or a flat box, outward from a cylinder or sphere."""

NEAR = 1e-9  # of the size of a body
OUTWARD, ALONG = "outward", "along"  # ways in which a positive load pulls


def spans(low, high, body, axes, without, size):
    """All, a part, or nothing of a face: how far a piece between two corners covers it along the other axes."""
    others = [i for i in range(axes) if i != without]
    if any(low[i] >= body["Upper"][i] or high[i] <= body["Lower"][i] for i in others):
        return "nothing"
    whole = all(low[i] <= body["Lower"][i] + NEAR * size and high[i] >= body["Upper"][i] - NEAR * size for i in others)
    return "all" if whole else "a part"


def size_of(body):
    return max(abs(b - a) for a, b in zip(body["Lower"], body["Upper"]))


def faces_of_box(surface, body, space):
    """[(face, way, cover)] that a flat box lies on."""
    low, high = surface.vector("min", "lower")[: space.axes], surface.vector("max", "upper")[: space.axes]
    size, found = size_of(body), []
    for axis in range(space.axes):
        if abs(high[axis] - low[axis]) > NEAR * size:
            continue
        for corner, word in (("Lower", "lower"), ("Upper", "upper")):
            if abs(low[axis] - body[corner][axis]) <= NEAR * size:
                found.append((f"{'xyz'[axis]}_{word}", ALONG, spans(low, high, body, space.axes, axis, size)))
    return found


def faces_of_cylinder(surface, body, space):
    """In axisymmetry: the end of a body that a thin cylinder encloses, or the side at its radius."""
    bottom, top, radius = surface.vector("bottom"), surface.vector("top"), surface.number("radius")
    end, side = surface.flag("axisymmetric_end"), surface.flag("axisymmetric_side")
    if space.mode != "axisymmetric" or surface.flag("cylinder_end") or bottom[0] != top[0]:
        return []
    low, high = [0.0, min(bottom[1], top[1])], [radius, max(bottom[1], top[1])]
    size = size_of(body)
    if end and not side:
        way = ALONG if top[1] > bottom[1] else "against"
        return [(face, way, spans(low, high, body, 2, 1, size))
            for face, y in (("y_lower", body["Lower"][1]), ("y_upper", body["Upper"][1])) if low[1] <= y <= high[1]]
    if not end and abs(body["Upper"][0] - radius) <= NEAR * radius:
        return [("x_upper", OUTWARD, spans(low, high, body, 2, 0, size))]
    return []


def surfaces_of(surface, body, space):
    """[(entry that names the surface, sign of a pressure for a positive load, cover)] of a body."""
    if surface.tag == "sphere" and body["Shape"] == "ball":
        same = abs(surface.number("radius") - body["Radius"]) <= NEAR * body["Radius"]
        centre = space.point(surface.vector("origin", "center", default=(0.0, 0.0, 0.0)))
        near = all(abs(a - b) <= NEAR * body["Radius"] for a, b in zip(centre, body["Centre"]))
        return [({"Surfaces": ["outer"]}, -1.0, "all")] if same and near else []
    if body["Shape"] != "box" or surface.tag not in ("box", "cylinder"):
        return []
    faces = (faces_of_box if surface.tag == "box" else faces_of_cylinder)(surface, body, space)
    out = []
    for face, way, cover in faces:
        sign = -1.0 if way == OUTWARD else (1.0 if face.endswith("lower") else -1.0) * (1.0 if way == ALONG else -1.0)
        if cover != "nothing":
            out.append(({"Faces": [face]}, sign, cover))
    return out


def curve_of(pressure):
    points = pressure.find("load_curve").children("time_point")
    return [point.number("time") for point in points], [point.number("load") for point in points]


def amount_of(times, loads, sign):
    if len(set(loads)) == 1:
        return {"Pressure": sign * loads[0] + 0.0}
    return {"Times": times, "Pressures": [sign * load + 0.0 for load in loads]}


def bodies_of(pressure, contents):
    """All, or those of the material that the load curve names."""
    curve = pressure.find("load_curve")
    if not curve.has("material"):
        return contents.bodies
    index = curve.index("material")
    name = contents.names[index] if 0 <= index < len(contents.names) else None
    return {key: body for key, body in contents.bodies.items() if body["Material"] == name}


def surface_in(pressure):
    tags = [child.tag for child in pressure.find("geom_object").children()]
    known = [tag for tag in tags if tag in ("box", "cylinder", "sphere")]
    return pressure.find("geom_object").find(*(known or tags or ["box"])) if tags else None


def described(surface):
    label = surface.attribute("label") or surface.attribute("name") if surface else ""
    return f'on "{label}" ' if label else ""


def read_pressure(pressure, contents, space, out, notes):
    surface = surface_in(pressure)
    times, loads = curve_of(pressure)
    found = []
    if surface is not None and times and surface.children():
        found = [(name, *one) for name, body in bodies_of(pressure, contents).items() if "Motion" not in body
            for one in surfaces_of(surface, body, space)]
    if not found:
        leave_out(pressure, surface, notes)
        return
    described(surface)
    if pressure.flag("outward_normal"):
        found = [(name, where, -1.0, cover) for name, where, _, cover in found]
    for name, where, sign, cover in found:
        place = (name, *sum(where.values(), []))
        if cover != "all":
            notes.lost(f"The pressure {described(surface)}of PhysicalBC covers a part of {place[1]} of {name} and is left out there (a "
                "load of a deck is on a whole face); add a body for that part.")
        elif place in [(load["Body"], *load.get("Faces", ()), *load.get("Surfaces", ())) for load in out.values()]:
            notes.lost(f"A second pressure {described(surface)}on {place[1]} of {name} is left out (a face of a deck has one); add it to "
                "the first.")
        else:
            out[f"Pressure on {name} {len(out) + 1}"] = {"Kind": "pressure", "Body": name, **where, **amount_of(times, loads, sign)}


def leave_out(condition, surface, notes):
    on = described(surface) if surface is not None else ""
    condition.cover()
    notes.lost(f"The load <{condition.tag}> {on}of PhysicalBC is left out (a deck has pressures on faces of boxes and on balls, and none "
        "of these was met); add it under Loads or Confinement.")


def read_loads(root, contents, space, notes):
    out = {}
    curves = root.find("MPM").flag("use_load_curves")
    for condition in root.find("PhysicalBC").find("MPM").children():
        condition.mark()
        if condition.tag != "pressure":
            leave_out(condition, None, notes)
        elif curves:
            read_pressure(condition, contents, space, out, notes)
        else:
            condition.cover()
            notes.add("Pressures of PhysicalBC are left out, as Uintah does without use_load_curves.")
    return out
