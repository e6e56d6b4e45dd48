# SPDX-License-Identifier: BSD-3-Clause
"""Mode, grid and conditions on its faces."""

import dataclasses
import math

from barreno_runs.faults import Fault

SIDES = {"x-": "x_lower", "x+": "x_upper", "y-": "y_lower", "y+": "y_upper", "z-": "z_lower", "z+": "z_upper"}
NEAR = 1e-9  # of a length, relative


@dataclasses.dataclass
class Space:
    """@param axes  how many coordinates the deck has"""

    mode: str
    lower: list
    upper: list
    cell: float

    @property
    def axes(self):
        return 3 if self.mode == "3D" else 2

    def point(self, vector):
        return vector[: self.axes]


def spacing_of(level, box, lower, upper):
    if level.has("spacing"):
        return level.vector("spacing")
    if box.has("spacing"):
        return box.vector("spacing")
    cells = box.vector("resolution")
    if min(cells) < 1:
        raise Fault(f"{box.where}/resolution has fewer than one cell along an axis; write three numbers of cells.")
    return [(high - low) / count for low, high, count in zip(lower, upper, cells)]


def read_box(level):
    """Corners of all boxes of a level together, and the spacing of its cells."""
    boxes = level.children("Box")
    if not boxes:
        raise Fault(f"{level.where} has no <Box> (the grid of the deck is that box); add it.")
    lowers, uppers = [box.vector("lower") for box in boxes], [box.vector("upper") for box in boxes]
    lower, upper = [min(x) for x in zip(*lowers)], [max(x) for x in zip(*uppers)]
    return lower, upper, spacing_of(level, boxes[0], lowers[0], uppers[0])


def read_space(root, notes):
    """@return the Space; the cells of a deck are squares or cubes, and fit the box"""
    levels = root.find("Grid").children("Level")
    if not levels:
        raise Fault(f"{root.where} has no <Grid> with a <Level> (the grid of the deck is that level's); add it.")
    if len(levels) > 1:
        notes.add(f"Of {len(levels)} levels of the grid the first is taken (cells of several sizes are regions of Refinement, which do not follow); add them in the deck.")
    lower, upper, spacing = read_box(levels[0])
    if root.find("MPM").flag("axisymmetric"):
        mode = "axisymmetric"
    else:
        mode = "plane strain" if round((upper[2] - lower[2]) / spacing[2]) <= 1 else "3D"
    space = Space(mode, [], [], 0.0)
    lower, upper, spacing = (space.point(vector) for vector in (lower, upper, spacing))
    space.cell = min(spacing)
    if max(spacing) > space.cell * (1 + NEAR):
        notes.add(f"Cells of {', '.join(f'{s:g}' for s in spacing)} become squares or cubes of the smallest of these (a deck has no others); the cost rises accordingly.")
    counts = [math.ceil((high - low) / space.cell * (1 - NEAR)) for low, high in zip(lower, upper)]
    space.lower, space.upper = lower, [low + count * space.cell for low, count in zip(lower, counts)]
    if any(abs(new - old) > NEAR * abs(old) for new, old in zip(space.upper, upper)):
        notes.add("The upper corner of the grid is moved out to a whole number of cells.")
    return space


def grid_of(space):
    return {"Mode": space.mode, "Lower": space.lower, "Upper": space.upper, "Cell Size": space.cell}


def condition_of(face, entry, space, notes):
    """One BCType as the deck has it, or nothing."""
    kind, label = entry.attribute("var").lower(), entry.attribute("label").lower()
    if kind == "symmetry" or label == "symmetric":
        return {"Kind": "symmetry"}
    if label != "velocity" or kind == "neumann":  # Neumann: nothing is prescribed, as without a condition
        if label not in ("velocity", "temperature"):
            notes.add(f"The condition {entry.attribute('label') or kind} on {face} has no counterpart; it is left out.")
        return None
    velocity = entry.vector("value", default=(0.0, 0.0, 0.0))
    if not any(velocity):
        return {"Kind": "fixed"}
    return {"Kind": "prescribed velocity", "Velocity": space.point(velocity)}


def read_conditions(root, space, notes):
    axis = space.mode == "axisymmetric" and space.lower[0] == 0.0
    out = {"Axis": {"Face": "x_lower", "Kind": "symmetry"}} if axis else {}
    for face in root.find("Grid").find("BoundaryConditions").children("Face"):
        side = face.attribute("side")
        if side not in SIDES:
            notes.add(f'A condition on a part of a face, <Face {" ".join(face.element.attrib)}>, is left out (those of a deck hold on whole faces of the grid).')
            continue
        if side[0] == "z" and space.axes == 2:
            continue  # the mode says it
        if axis and side == "x-":
            continue
        for entry in face.children("BCType"):
            condition = condition_of(side, entry, space, notes)
            if condition:
                out[f"Face {SIDES[side].replace('_', ' ')}"] = {"Face": SIDES[side], **condition}
    return out
