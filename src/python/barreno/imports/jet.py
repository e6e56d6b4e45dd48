# SPDX-License-Identifier: BSD-3-Clause
"""A jet of inserted particles as slugs: Uintah keeps pieces aside, and at its time moves each by a translation, with a new
velocity (InsertParticlesFile: time, colour, translation, velocity; pieces are named by their colours)."""

import math
import pathlib

from barreno.imports.files import found_beside
from barreno.runs.faults import FILE, Fault

ACROSS = 1e-3  # of the speed, from which a velocity is not along y


def read_rows(path):
    try:
        lines = pathlib.Path(path).read_text(encoding="latin-1").splitlines()
    except OSError as error:
        raise Fault(f"{path} cannot be read ({error.strerror}; named by InsertParticlesFile); bring the file to its place.", FILE) from None
    rows = []
    for number, line in enumerate(lines, 1):
        words = line.split()
        try:
            row = [float(word) for word in words]
        except ValueError:
            row = []
        if words and (len(row) != 8 or not all(map(math.isfinite, row))):
            raise Fault(f"{path}, line {number} has not eight numbers (time, colour, three of the translation, three of the velocity); "
                "correct it.")
        if words:
            rows.append(row)
    return rows


def cylinder_of(piece, space):
    """(radius, lower end, upper end) along y of a piece on the axis, or None."""
    shape = piece.shape
    if space.mode == "axisymmetric" and shape["Shape"] == "box" and shape["Lower"][0] == 0.0:
        return shape["Upper"][0], shape["Lower"][1], shape["Upper"][1]
    if shape["Shape"] == "cylinder" and "Start" in shape and shape["Start"][0] == shape["End"][0] and shape["Start"][2] == shape["End"][2]:
        return shape["Radius"], *sorted((shape["Start"][1], shape["End"][1]))
    return None


def slug_of(row, pieces, contents, space):
    """([time, speed, radius, length, density], where its nose is, +1 or -1, its material), or None."""
    time, colour, _, shift, _, vx, vy, vz = row
    meant = [piece for piece in pieces if piece.element.number("color", default=0.0) == colour]
    along = [cylinder_of(piece, space) for piece in meant]
    if len(meant) != 1 or along[0] is None or vy == 0.0 or max(abs(vx), abs(vz)) > ACROSS * abs(vy):
        return None
    radius, low, high = along[0]
    density = contents.materials[meant[0].material].get("Density")
    if density is None:  # of a card
        return None
    nose = (high if vy > 0 else low) + shift
    return [time, abs(vy), radius, high - low, density], nose, 1 if vy > 0 else -1, meant[0]


def read_jet(root, folder, contents, space, notes):
    """The list Jet, whose pieces are no bodies then."""
    flags = root.find("MPM")
    if not flags.flag("InsertParticles"):
        return {}
    path = found_beside(flags.text("InsertParticlesFile"), folder, "InsertParticlesFile")
    rows = read_rows(path)
    slugs = [slug_of(row, contents.pieces, contents, space) for row in rows]
    kinds = {(slug[2], slug[3].material) for slug in slugs if slug}
    if not rows or None in slugs or len(kinds) != 1:
        notes.lost(f"The particles that {path.name} inserts are left out (a jet is of one material, with slugs that are cylinders on the "
            "axis and fly along y, each of a colour of its own, and with density in the file); write a Jet.")
        return {}
    places = [slug[1] for slug in slugs]
    direction, material = kinds.pop()
    if max(places) - min(places) > 1e-6 * max(slug[0][3] for slug in slugs):
        notes.add(f"Slugs that {path.name} inserts with their noses between y = {min(places):g} and {max(places):g} are launched through "
            f"one plane, y = {places[0]:g}.")
    for piece in {id(slug[3]): slug[3] for slug in slugs}.values():
        contents.bodies.pop(piece.body, None)
    notes.add(f"{len(slugs)} insertions of {path.name} become slugs of a Jet, which enter through the plane as they fly instead of at "
        "once.")
    rows = sorted(slug[0] for slug in slugs)
    return {"Material": material, "Slugs": rows, "Launch Position": places[0], "Direction": "+y" if direction > 0 else "-y"}
