# SPDX-License-Identifier: BSD-3-Clause
"""Conditions on faces of the grid."""

SIDES = {"x-": "x_lower", "x+": "x_upper", "y-": "y_lower", "y+": "y_upper", "z-": "z_lower", "z+": "z_upper"}


def condition_of(face, entry, space, notes):
    """One BCType as the deck has it, or nothing."""
    kind, label = entry.attribute("var").lower(), entry.attribute("label").lower()
    if kind == "symmetry" or label == "symmetric":
        entry.find("value").own_text()  # which Uintah does not read there
        return {"Kind": "symmetry"}
    if label == "velocity" and kind != "neumann":  # Neumann: nothing is prescribed, as without a condition
        return velocity_of(face, entry, space, notes)
    if label == "temperature" and kind == "dirichlet":
        entry.find("value").own_text()  # heat.py has read it
        return None
    if label in ("velocity", "temperature"):
        entry.find("value").own_text()
        notes.add_neutral(f"BCType {entry.attribute('var')} {entry.attribute('label')}")
    else:
        entry.cover()
        notes.lost(f"the condition {entry.attribute('var')} {entry.attribute('label') or kind} has no counterpart; it is left out.", face)
    return None


def velocity_of(face, entry, space, notes):
    velocity = entry.vector("value", default=(0.0, 0.0, 0.0))
    if space.axes == 2 and face[0] == "z":
        notes.lost(f"The velocity {entry.attribute('var')} on {face}, a face normal to the plane, is left out (a deck in {space.mode} "
            "moves in its plane alone).")
        return None
    if not any(velocity):
        return {"Kind": "fixed"}
    return {"Kind": "prescribed velocity", "Velocity": space.in_plane(velocity, f"The velocity on {face}", "", notes)}


def is_for_all(face, entry, count, notes):
    """A condition for one material, where there are several, is none of a deck."""
    index, label = entry.attribute("id").lower() or "all", entry.attribute("label").lower()
    if index == "all" or (count == 1 and index == "0") or label not in ("velocity", "symmetric"):
        return True
    notes.lost(f"a {label} condition holds for the material {index} alone and is left out (those of a deck hold for all materials).", face)
    entry.cover()
    return False


def add_condition(out, side, condition, axis, notes):
    if axis and side == "x-":
        if condition["Kind"] != "symmetry":
            notes.lost(f"The condition {condition['Kind']} on x- is left out (that face is the axis, which has symmetry).")
        return
    name, entry = f"Face {SIDES[side].replace('_', ' ')}", {"Face": SIDES[side], **condition}
    if name in out and {out[name]["Kind"], entry["Kind"]} == {"fixed", "symmetry"}:  # Uintah does both: nothing moves there
        out[name] = {"Face": SIDES[side], "Kind": "fixed"}
    elif out.get(name, entry) != entry:
        notes.lost(f"{side} has several conditions: {condition['Kind']} is left out, {out[name]['Kind']} is taken (a face of a deck has "
            "one).")
    out.setdefault(name, entry)


def read_conditions(root, space, notes):
    axis = space.mode == "axisymmetric" and space.lower[0] == 0.0
    out = {"Axis": {"Face": "x_lower", "Kind": "symmetry"}} if axis else {}
    count = len([child for child in root.find("MaterialProperties").find("MPM").children() if child.tag == "material"])
    for conditions in root.find("Grid").children("BoundaryConditions"):
        for face in conditions.children("Face"):
            side = face.attribute("side")
            if side not in SIDES:
                face.cover()
                notes.lost(f"A condition on a part of a face, <Face {' '.join(face.element.attrib)}>, is left out (those of a deck hold on "
                    "whole faces of the grid).")
                continue
            for entry in face.children("BCType"):
                condition = condition_of(side, entry, space, notes) if is_for_all(side, entry, count, notes) else None
                if condition and not (side[0] == "z" and space.axes == 2):  # the mode says it
                    add_condition(out, side, condition, axis, notes)
    return out
