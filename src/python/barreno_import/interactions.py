# SPDX-License-Identifier: BSD-3-Clause
"""Contact between materials, and pressures on bodies."""

import itertools

NEAR = 1e-9  # of the size of a body
FRICTION = ("friction", "friction_bard", "friction_LR", "friction_LRVar", "penalty")
STUCK = ("single_velocity", "singleVelocity", "null")


def materials_of(contact, contents):
    """Names of the materials of a contact, all where it names none."""
    text = contact.text("materials", default="")
    indices = [int(part) for part in text.strip("[] ").split(",") if part.strip().isdigit()] if text else range(len(contents.names))
    return [contents.names[i] for i in indices if i < len(contents.names) and contents.names[i] in contents.materials]


def read_contact(root, contents, notes):
    out = {}
    for contact in root.find("MaterialProperties").find("MPM").children("contact"):
        kind = contact.text("type", default="null")
        names = materials_of(contact, contents)
        if kind in FRICTION:
            friction = contact.number("mu", default=0.0)
            for one, other in itertools.combinations(names, 2):
                entry = {"Material": one, "Other Material": other, "Kind": "friction" if friction else "frictionless"}
                out[f"{one} and {other}"] = {**entry, **({"Friction Coefficient": friction} if friction else {})}
        elif kind == "null" and len(names) > 1:
            notes.add(f"Contact null of {', '.join(names)} becomes sticking (materials of a deck that share a node never pass through each other).")
        elif kind == "approach":
            notes.add("Contact approach becomes sticking (surfaces of a deck that may separate have friction, or none: add it under Contact).")
        elif kind not in STUCK:
            notes.add(f"Contact {kind} is left out (a deck has friction, frictionless and stick; a body with a prescribed velocity has Motion).")
    return out


def face_of(box, body, axes):
    """(face, axis) of a body's box that a flat box lies on, or None."""
    low, high = (box.vector("min", "lower")[:axes], box.vector("max", "upper")[:axes])
    size = max(abs(b - a) for a, b in zip(body["Lower"], body["Upper"]))
    for axis in range(axes):
        if abs(high[axis] - low[axis]) > NEAR * size:
            continue
        for corner, word in (("Lower", "lower"), ("Upper", "upper")):
            beside = all(low[i] < body["Upper"][i] and high[i] > body["Lower"][i] for i in range(axes) if i != axis)
            if abs(low[axis] - body[corner][axis]) <= NEAR * size and beside:
                return f"{'xyz'[axis]}_{word}", axis
    return None


def side_of(cylinder, body, space):
    """The face x_upper of a box in axisymmetry whose radius is that of a cylinder along the axis."""
    radius = cylinder.number("radius")
    if space.mode == "axisymmetric" and not cylinder.flag("cylinder_end") and abs(body["Upper"][0] - radius) <= NEAR * radius:
        return "x_upper", 0
    return None


def curve_of(pressure):
    points = pressure.find("load_curve").children("time_point")
    return [point.number("time") for point in points], [point.number("load") for point in points]


def load_of(pressure, contents, space):
    """(name of a body, load of the deck), or None. Uintah's load points along the axis, or outward from a cylinder or sphere."""
    surface = next(iter(pressure.find("geom_object").children()), None)
    times, loads = curve_of(pressure)
    if surface is None or not times:
        return None
    for name, body in contents.bodies.items():
        outward, where = True, None
        if surface.tag == "sphere" and body["Shape"] == "ball" and abs(surface.number("radius") - body["Radius"]) <= NEAR * body["Radius"]:
            where = {"Surfaces": ["outer"]}
        elif body["Shape"] == "box" and surface.tag in ("box", "cylinder"):
            found = face_of(surface, body, space.axes) if surface.tag == "box" else side_of(surface, body, space)
            if found:
                where, outward = {"Faces": [found[0]]}, found[0].endswith("upper")
        if where:
            sign = -1.0 if outward else 1.0
            amount = {"Pressure": sign * loads[0] + 0.0} if len(set(loads)) == 1 else {"Times": times, "Pressures": [sign * load + 0.0 for load in loads]}
            return name, {"Kind": "pressure", "Body": name, **where, **amount}
    return None


def read_loads(root, contents, space, notes):
    out = {}
    conditions = root.find("PhysicalBC").find("MPM").children()
    if not root.find("MPM").flag("use_load_curves"):
        if conditions:
            notes.add("Loads of PhysicalBC are left out, as Uintah does without use_load_curves.")
        return out
    for condition in conditions:
        found = load_of(condition, contents, space) if condition.tag == "pressure" else None
        if found is None:
            notes.add(f"The load <{condition.tag}> of PhysicalBC is left out (a deck has pressures on faces of boxes and on balls, and none of these was met); add it under Loads or Confinement.")
            continue
        name, load = found
        out[f"Pressure on {name} {len(out) + 1}"] = load
    return out
