# SPDX-License-Identifier: BSD-3-Clause
"""Contact between materials."""

import itertools
import re

from barreno.imports.motion import TOLD, told_material

FRICTION = ("friction", "friction_bard", "friction_LR", "friction_LRVar", "penalty")
STUCK = ("single_velocity", "singleVelocity")
MOST_PAIRS = 3  # that a sentence names


def materials_of(contact, contents, notes):
    """Names of the materials of a contact, all where it names none."""
    text = contact.text("materials", default="")
    indices = [int(part) for part in re.findall(r"\d+", text)] if text else range(len(contents.names))
    absent = [str(index) for index in indices if index >= len(contents.names)]
    if absent:
        notes.add(f"A contact names materials that the file does not have ({', '.join(absent)}; it has {len(contents.names)}, counted from "
            "0); the others are taken.")
    return [contents.names[i] for i in indices if i < len(contents.names) and contents.names[i] in contents.materials]


def rub(contact, names, out, notes):
    friction = contact.number("mu", default=0.0)
    if contact.has("variable_friction"):
        contact.find("variable_friction").cover()
        notes.lost("variable_friction is left out (a pair of materials of a deck has one Friction Coefficient).")
    for one, other in itertools.combinations(names, 2):
        entry = {"Material": one, "Other Material": other, "Kind": "friction" if friction else "frictionless"}
        out[f"{one} and {other}"] = {**entry, **({"Friction Coefficient": friction} if friction else {})}


def note_free_pairs(contents, touching, notes):
    """Without a contact materials pass through each other in Uintah."""
    free = [f"{one} and {other}" for one, other in itertools.combinations(contents.materials, 2) if frozenset((one, other)) not in touching]
    if free:
        named = "; ".join(free[:MOST_PAIRS]) + (f"; and {len(free) - MOST_PAIRS} more pairs" if len(free) > MOST_PAIRS else "")
        notes.lost(f"No contact of the file holds for {named}: in Uintah they pass through each other, in the deck they stick (add "
            "friction or frictionless under Contact).")


def pairs_of(contact, names, contents):
    """Of materials that the contact speaks of: one that moves as it is told touches each of the others."""
    pairs = {frozenset(pair) for pair in itertools.combinations(names, 2)}
    if contact.text("type", default="null").lower() not in TOLD:
        return pairs
    index = told_material(contact)
    return {pair for pair in pairs if 0 <= index < len(contents.names) and contents.names[index] in pair}


def read_contact(root, contents, notes):
    out, touching = {}, set()
    for contact in root.find("MaterialProperties").find("MPM").children("contact"):
        kind = contact.text("type", default="null")
        names = materials_of(contact, contents, notes)
        touching |= pairs_of(contact, names, contents)
        if kind.lower() in TOLD:  # motion.py has read it
            continue
        several = len(names) > 1
        if kind not in FRICTION:
            for tag in ("mu", "stop_time"):  # which Uintah does not read there
                contact.find(tag).own_text()
        if kind in FRICTION:
            rub(contact, names, out, notes)
        elif kind == "null" and several:
            notes.lost(f"Contact null of {', '.join(names)} becomes sticking (materials of a deck that share a node never pass through "
                "each other).")
        elif kind == "approach" and several:
            notes.lost("Contact approach becomes sticking (surfaces of a deck that may separate have friction, or none: add it under "
                "Contact).")
        elif kind not in (*STUCK, "null", "approach"):
            contact.cover()
            notes.lost(f"Contact {kind} is left out (a deck has friction, frictionless and stick; a body with a prescribed velocity has "
                "Motion).")
    note_free_pairs(contents, touching, notes)
    return out
