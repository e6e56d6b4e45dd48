# SPDX-License-Identifier: BSD-3-Clause
"""Materials and the bodies made of them."""

import dataclasses

from barreno.imports.bounds import used_shapes
from barreno.imports.deck import name_of
from barreno.imports.materials import NEVER_MELTS, ROOM, Unknown, check_cards, read_material
from barreno.imports.motion import rigid_materials
from barreno.imports.shapes import PIECES, Left, Shapes


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
    left: list = dataclasses.field(default_factory=list)  # names of materials that are left out


def particles_of(piece, space, where, notes):
    counts = [round(count) for count in space.point(piece.vector("res", default=(2, 2, 2)))]
    if len(set(counts)) > 1:
        notes.add(f"of {' x '.join(map(str, counts))} particles per cell the largest is taken along each axis (a deck has one number).",
            where)
    return max(1, *counts)


def body_of(piece, shape, material, space, where, notes):
    out = {"Material": material, **shape, "Particles Per Cell": particles_of(piece, space, where, notes)}
    velocity = space.in_plane(piece.vector("velocity", default=(0.0, 0.0, 0.0)), "the velocity", where, notes)
    if any(velocity):
        out["Velocity"] = velocity
    return out


def check_temperature(piece, parameters, where, notes):
    """The metal of a deck starts at its Room Temperature, below which it does not harden."""
    if parameters.get("Model") != "Johnson-Cook" or parameters.get("Melt Temperature") == NEVER_MELTS or not piece.has("temperature"):
        return
    start, room = piece.number("temperature"), parameters.get("Room Temperature", ROOM)
    if start != room:
        notes.lost(f"the start at {start:g} K is left out (metals start at their Room Temperature, {room:g} K, that of the flow rule).",
            where)


def label_of(piece):
    named = next((child for child in piece.children() if child.tag in PIECES), None)
    return (named.attribute("label") or named.attribute("name")) if named else ""


def shape_of(piece, shapes):
    """Of a geom_object, whose several pieces are one together. @raises Left"""
    forms = [child for child in piece.children() if child.tag in PIECES]
    forms = forms or [child for child in piece.children() if child.tag not in PROPERTIES]
    if not forms:
        raise Left("a <geom_object> holds no piece")
    if len(forms) == 1:
        return shapes.body_of(forms[0])
    return shapes.inside(shapes.combination("union", shapes.parts_of("union", forms)))


def look_at_properties(piece, where, notes):
    """Those that say what a deck has anyway."""
    if piece.has("volumeFraction") and piece.number("volumeFraction") != 1.0:
        notes.lost(f"volumeFraction = {piece.number('volumeFraction'):g} is left out (particles of a deck fill the body).", where)


def read_pieces(material, name, contents, shapes, space, notes):
    index = len(contents.names) - 1
    for piece in material.children("geom_object"):
        body = name_of(label_of(piece) or name, contents.bodies, "Body")
        where = f"Body {body}"
        try:
            shape = shape_of(piece, shapes)
        except Left as reason:
            for child in piece.children():
                shapes.remember(child)
            piece.cover()
            notes.lost(f"left out ({reason}); add its shape in the deck.", f"{where} of {name}")
            continue
        look_at_properties(piece, where, notes)
        check_temperature(piece, contents.materials[name], where, notes)
        contents.bodies[body] = body_of(piece, shape, name, space, where, notes)
        contents.pieces.append(Piece(piece, name, index, body, shape))


PROPERTIES = ("res", "velocity", "temperature", "color", "volumeFraction", "affineTransformation_A0", "affineTransformation_A1",
    "affineTransformation_A2",
              "affineTransformation_b", "numLevelsParticleFilling", "concentration", "pos_charge", "neg_charge",
              "permittivity")  # fmt: skip


def refuse_turned(material, name, notes):
    turned = [piece for piece in material.children("geom_object") if piece.has("affineTransformation_A0", "affineTransformation_b")]
    for piece in turned:
        for child in piece.children("affineTransformation_A0", "affineTransformation_A1", "affineTransformation_A2",
                "affineTransformation_b"):
            child.cover()
    if turned:
        notes.lost(f"affine transformations of pieces are left out (shapes of a deck are given where they are); turn the shape.", name)


def leave_out(material, name, reason, contents, shapes, notes):
    """Its pieces stay known by their labels."""
    for piece in material.children("geom_object"):
        for child in piece.children():
            shapes.remember(child)
    material.cover()
    contents.names.append(None)
    contents.left.append(name)
    notes.lost(f'The material {name} is left out with its bodies ({reason}); choose a card for it with --card "{name}=CARD".')


def read_contents(root, space, cards, notes):
    """@return the Contents"""
    contents, shapes = Contents(), Shapes(space, notes)
    materials = root.find("MaterialProperties").find("MPM").children("material")
    names = []
    for number, material in enumerate(materials, 1):
        names.append(name_of(material.attribute("name"), names, f"Material {number}"))
    check_cards(cards, names)
    rigid = {names[index] for index in rigid_materials(root) if index < len(names)}
    for material, name in zip(materials, names):
        try:
            contents.materials[name] = read_material(material, name, name in rigid, cards, notes)
        except Unknown as reason:
            leave_out(material, name, reason, contents, shapes, notes)
            continue
        contents.names.append(name)
        refuse_turned(material, name, notes)
        read_pieces(material, name, contents, shapes, space, notes)
    contents.shapes = used_shapes(contents.bodies, shapes.lists)
    return contents
