# SPDX-License-Identifier: BSD-3-Clause
"""Contact rigid and specified: one material moves as it is told, and takes the others along. It is a body with Motion."""

import math
import pathlib

from barreno.imports.files import found_beside
from barreno.runs.faults import FILE, Fault

TOLD = ("rigid", "specified", "specified_velocity", "specified_body", "specified_friction")
SHARP = 1e-6  # of a time, in which a velocity jumps
ALONG = 1e-9  # of the largest velocity, from which directions differ


def told_contacts(root):
    contacts = root.find("MaterialProperties").find("MPM").children("contact")
    return [contact for contact in contacts if contact.text("type", default="null").lower() in TOLD]


def told_material(contact):
    """The index of the material that moves."""
    return contact.index("master_material", "rigid_material", "material", default=0)


def rigid_materials(root):
    return {told_material(contact) for contact in told_contacts(root)}


def read_profile(path, columns):
    """Rows of time and velocity. @param columns  numbers in a row"""
    try:
        words = pathlib.Path(path).read_text(encoding="latin-1").split()
    except OSError as error:
        raise Fault(f"{path} cannot be read ({error.strerror}; named by a contact); bring the file to its place.", FILE) from None
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        numbers = [math.nan]
    rows = [numbers[i : i + columns] for i in range(0, len(numbers), columns)]
    if not all(map(math.isfinite, numbers)) or len(rows) < 2 or len(rows[-1]) != columns:
        raise Fault(f"{path} has not two or more rows of {columns} numbers (time and velocity of a rigid body); correct it.")
    if any(later[0] <= earlier[0] for earlier, later in zip(rows, rows[1:])):
        raise Fault(f"{path} has times that do not increase (a rigid body has one velocity at a time); correct it.")
    return [row[:4] for row in rows]


def rows_of(contact, start, folder):
    """(time, velocity) of the body, in pieces of straight lines. @param start  the velocity that it has without a file"""
    name = contact.text("filename", default="")
    rows = [[0.0, *start]]
    if name:
        columns = 10 if contact.flag("include_rotation") else 4
        rows = read_profile(found_beside(name, folder, "a contact"), columns)
    stop = contact.number("stop_time", default=math.inf)
    after = contact.vector("velocity_after_stop", default=(0.0, 0.0, 0.0))
    if not 0.0 < stop < 1e29:
        return rows
    before = [row for row in rows if row[0] < stop]
    return [*before, [stop, *velocity_at(rows, stop)], [stop * (1.0 + SHARP), *after]]


def velocity_at(rows, time):
    for (t0, *v0), (t1, *v1) in zip(rows, rows[1:]):
        if t0 <= time <= t1:
            return [a + (b - a) * (time - t0) / (t1 - t0) for a, b in zip(v0, v1)]
    return rows[-1][1:] if time > rows[-1][0] else rows[0][1:]


def motion_of(rows, space):
    """Parameters of a body, or None where the velocity changes its direction."""
    velocities = [space.point(row[1:]) for row in rows]
    largest = max(velocities, key=lambda velocity: sum(x * x for x in velocity))
    square = sum(x * x for x in largest)
    if square == 0.0:
        return {"Motion": largest}
    factors = [sum(a * b for a, b in zip(velocity, largest)) / square for velocity in velocities]
    for velocity, factor in zip(velocities, factors):
        if any(abs(a - factor * b) > ALONG * math.sqrt(square) for a, b in zip(velocity, largest)):
            return None
    if len(set(factors)) == 1:
        return {"Motion": [factor * x for factor, x in zip(factors[:1] * len(largest), largest)]}
    return {"Motion": largest, "Motion Times": [row[0] for row in rows], "Motion Factors": factors}


def look_at_limits(contact, space, name, notes):
    """What of the contact a rigid body of a deck, to which the others stick, does in another way."""
    direction = space.point(contact.vector("direction", default=(0.0, 0.0, 1.0)))
    if not all(direction):
        free = ", ".join("xyz"[i] for i, along in enumerate(direction) if not along)
        notes.lost(f"its contact leaves other materials free along {free}; in the deck they stick to it (add friction or frictionless "
            "under Contact).", name)
    if contact.flag("normal_only"):
        notes.lost("normal_only = true is left out (in the deck other materials stick to it); add frictionless under Contact.", name)
    if contact.flag("include_rotation"):
        notes.lost("include_rotation = true is left out (rigid bodies of a deck do not turn).", name)


def read_motions(root, folder, contents, space, notes):
    """Gives bodies of rigid materials their Motion."""
    for contact in told_contacts(root):
        index = told_material(contact)
        name = contents.names[index] if 0 <= index < len(contents.names) else None
        bodies = [body for body in contents.bodies.values() if body["Material"] == name]
        if not bodies:
            contact.cover()
            notes.lost(f"Contact {contact.text('type')} of material {index} is left out (no body of that material is in the deck).")
            continue
        look_at_limits(contact, space, name, notes)
        for body in bodies:
            move(body, contact, folder, space, name, notes)


def move(body, contact, folder, space, name, notes):
    start = [*body.pop("Velocity", ()), 0.0, 0.0, 0.0][:3] if "Velocity" in body else [0.0, 0.0, 0.0]
    rows = rows_of(contact, start, folder)
    if space.axes == 2 and any(row[3] for row in rows):
        notes.lost("its velocity along z is left out (the deck has a plane).", name)
    motion = motion_of(rows, space)
    if motion is None:
        notes.lost("its velocity changes its direction, which Motion cannot; it stands still in the deck: write its Motion.", name)
        motion = {"Motion": [0.0] * space.axes}
    body |= motion
    notes.add(f"contact {contact.text('type')} becomes a Motion of its bodies, which are rigid.", name)
