# SPDX-License-Identifier: BSD-3-Clause
"""Materials and the bodies made of them."""

import dataclasses

from barreno_import.deck import name_of
from barreno_import.materials import ROOM, Unknown, check_cards, read_material
from barreno_import.shapes import Left, Shapes


@dataclasses.dataclass
class Piece:
    """A geom_object. @param body  its list in Bodies, or its shape where a jet takes it"""

    element: object
    material: str
    index: int
    body: str
    shape: dict


@dataclasses.dataclass
class Contents:
    materials: dict = dataclasses.field(default_factory=dict)
    bodies: dict = dataclasses.field(default_factory=dict)
    shapes: dict = dataclasses.field(default_factory=dict)
    pieces: list = dataclasses.field(default_factory=list)
    names: list = dataclasses.field(default_factory=list)  # by the index that Uintah gives materials; None: left out


def particles_of(piece, space, where, notes):
    counts = [round(count) for count in space.point(piece.vector("res", default=(2, 2, 2)))]
    if len(set(counts)) > 1:
        notes.add(f"{where}: of {' x '.join(map(str, counts))} particles per cell the largest is taken along each axis (a deck has one number).")
    return max(1, *counts)


def body_of(piece, shape, material, space, where, notes):
    out = {"Material": material, **shape, "Particles Per Cell": particles_of(piece, space, where, notes)}
    velocity = space.point(piece.vector("velocity", default=(0.0, 0.0, 0.0)))
    if any(velocity):
        out["Velocity"] = velocity
    return out


def check_temperature(piece, parameters, where, notes):
    """The metal of a deck starts at its Room Temperature, below which it does not harden."""
    if parameters.get("Model") != "Johnson-Cook" or not piece.has("temperature"):
        return
    start, room = piece.number("temperature"), parameters.get("Room Temperature", ROOM)
    if start != room:
        notes.add(f"{where}: the start at {start:g} K is left out (metals start at their Room Temperature, {room:g} K, that of the flow rule).")


def label_of(piece):
    named = next(iter(piece.children()), None)
    return (named.attribute("label") or named.attribute("name")) if named else ""


def read_pieces(material, name, contents, shapes, space, notes):
    index = len(contents.names) - 1
    for piece in material.children("geom_object"):
        body = name_of(label_of(piece) or name, contents.bodies, "Body")
        forms = [child for child in piece.children() if child.tag not in PROPERTIES]
        try:
            if len(forms) != 1:
                raise Left(f"a <geom_object> holds {len(forms)} pieces, not one")
            shape = shapes.body_of(forms[0])
        except Left as reason:
            notes.add(f"The body {body} of {name} is left out ({reason}); add its shape in the deck.")
            continue
        where = f"Body {body}"
        check_temperature(piece, contents.materials[name], where, notes)
        contents.bodies[body] = body_of(piece, shape, name, space, where, notes)
        contents.pieces.append(Piece(piece, name, index, body, shape))


PROPERTIES = ("res", "velocity", "temperature", "color", "volumeFraction", "affineTransformation_A0", "affineTransformation_A1", "affineTransformation_A2",
              "affineTransformation_b", "numLevelsParticleFilling", "concentration", "pos_charge", "neg_charge", "permittivity")  # fmt: skip


def refuse_turned(material, name, notes):
    if any(piece.has("affineTransformation_A0") for piece in material.children("geom_object")):
        notes.add(f"{name}: affine transformations of pieces are left out (shapes of a deck are given where they are); turn the shape.")


def read_contents(root, space, cards, notes):
    """@return the Contents"""
    contents, shapes = Contents(), Shapes(space, notes)
    materials = root.find("MaterialProperties").find("MPM").children("material")
    names = []
    for number, material in enumerate(materials, 1):
        names.append(name_of(material.attribute("name"), names, f"Material {number}"))
    check_cards(cards, names)
    for material, name in zip(materials, names):
        try:
            contents.materials[name] = read_material(material, name, cards, notes)
        except Unknown as reason:
            contents.names.append(None)
            notes.add(f'The material {name} is left out with its bodies ({reason}); choose a card for it with --card "{name}=CARD".')
            continue
        contents.names.append(name)
        refuse_turned(material, name, notes)
        read_pieces(material, name, contents, shapes, space, notes)
    contents.shapes = shapes.lists
    return contents
