# SPDX-License-Identifier: BSD-3-Clause
"""Contact between materials."""

import itertools
import re

from barreno_import.motion import TOLD

FRICTION = ("friction", "friction_bard", "friction_LR", "friction_LRVar", "penalty")
STUCK = ("single_velocity", "singleVelocity")


def materials_of(contact, contents, notes):
    """Names of the materials of a contact, all where it names none."""
    text = contact.text("materials", default="")
    indices = [int(part) for part in re.findall(r"\d+", text)] if text else range(len(contents.names))
    for index in indices:
        if index >= len(contents.names):
            notes.lost(f"A contact names the material {index}, which the file does not have ({len(contents.names)} in all, counted from 0); the others are taken.")
    return [contents.names[i] for i in indices if i < len(contents.names) and contents.names[i] in contents.materials]


def rub(contact, names, out, notes):
    friction = contact.number("mu", default=0.0)
    if contact.has("variable_friction"):
        contact.find("variable_friction").cover()
        notes.lost("variable_friction is left out (a pair of materials of a deck has one Friction Coefficient).")
    for one, other in itertools.combinations(names, 2):
        entry = {"Material": one, "Other Material": other, "Kind": "friction" if friction else "frictionless"}
        out[f"{one} and {other}"] = {**entry, **({"Friction Coefficient": friction} if friction else {})}


def read_contact(root, contents, notes):
    out = {}
    for contact in root.find("MaterialProperties").find("MPM").children("contact"):
        kind = contact.text("type", default="null")
        if kind.lower() in TOLD:  # motion.py has read it
            materials_of(contact, contents, notes)
            continue
        names = materials_of(contact, contents, notes)
        several = len(names) > 1
        if kind not in FRICTION:
            contact.find("mu").own_text()  # which Uintah does not read there
        if kind in FRICTION:
            rub(contact, names, out, notes)
        elif kind == "null" and several:
            notes.lost(f"Contact null of {', '.join(names)} becomes sticking (materials of a deck that share a node never pass through each other).")
        elif kind == "approach" and several:
            notes.lost("Contact approach becomes sticking (surfaces of a deck that may separate have friction, or none: add it under Contact).")
        elif kind not in (*STUCK, "null", "approach"):
            contact.cover()
            notes.lost(f"Contact {kind} is left out (a deck has friction, frictionless and stick; a body with a prescribed velocity has Motion).")
    return out
