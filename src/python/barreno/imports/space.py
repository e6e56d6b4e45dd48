# SPDX-License-Identifier: BSD-3-Clause
"""Mode and grid."""

import dataclasses
import math

from barreno.runs.faults import Fault

MOST_CELLS = 1e9  # along an axis
NEAR = 1e-9  # of a length, relative


@dataclasses.dataclass
class Space:
    """@param axes  how many coordinates the deck has"""

    mode: str
    lower: list
    upper: list
    cell: float
    layer: tuple = (0.0, 0.0)  # of the file's grid along z, for grids of two coordinates

    @property
    def axes(self):
        return 3 if self.mode == "3D" else 2

    def point(self, vector):
        return vector[: self.axes]

    def in_plane(self, vector, what, subject, notes):
        """The coordinates that the deck has. What is lost of the third is said."""
        if self.axes == 2 and vector[2] != 0.0:
            notes.lost(f"{what} has the component {vector[2]:g} along z, which is left out (the deck is {self.mode}).", subject)
        return self.point(vector)


def spacing_of(level, box, lower, upper):
    """Where both stand, Uintah takes the spacing; the numbers of cells say the same then."""
    for place in (level, box):
        if place.has("spacing"):
            spacing = place.vector("spacing")
            if min(spacing) <= 0.0:
                raise Fault(f"{place.where}/spacing is [{', '.join(f'{s:g}' for s in spacing)}], which is not positive everywhere; write "
                    "three lengths of a cell.")
            if box.has("resolution"):
                box.vector("resolution")
            return spacing
    if any(high <= low for low, high in zip(lower, upper)):
        raise Fault(f"{box.where} has an upper corner that is not above its lower corner along every axis; correct lower or upper.")
    cells = box.vector("resolution")
    if min(cells) < 1:
        raise Fault(f"{box.where}/resolution has fewer than one cell along an axis; write three numbers of cells.")
    return [(high - low) / count for low, high, count in zip(lower, upper, cells)]


def read_box(level, notes):
    """Corners of all boxes of a level together, and the spacing of its cells."""
    boxes = level.children("Box")
    if not boxes:
        raise Fault(f"{level.where} has no <Box> (the grid of the deck is that box); add it.")
    lowers, uppers = [box.vector("lower") for box in boxes], [box.vector("upper") for box in boxes]
    lower, upper = [min(x) for x in zip(*lowers)], [max(x) for x in zip(*uppers)]
    if any(high <= low for low, high in zip(lower, upper)):
        raise Fault(f"{level.where}/Box has an upper corner that is not above its lower corner along every axis; correct lower or upper.")
    for box in boxes[1:]:
        if box.has("resolution", "spacing"):
            other = spacing_of(level, box, box.vector("lower"), box.vector("upper"))
            if any(abs(a - b) > NEAR * a for a, b in zip(other, spacing_of(level, boxes[0], lowers[0], uppers[0]))):
                notes.lost("boxes of the grid have cells of several sizes; those of the first box are taken everywhere (cells of several "
                    "sizes are regions of Refinement); add them in the deck.")
    return lower, upper, spacing_of(level, boxes[0], lowers[0], uppers[0])


def read_space(root, notes):
    """@return the Space; the cells of a deck are squares or cubes, and fit the box"""
    levels = root.find("Grid").children("Level")
    if not levels:
        raise Fault(f"{root.where} has no <Grid> with a <Level> (the grid of the deck is that level's); add it.")
    if len(levels) > 1:
        notes.lost(f"Of {len(levels)} levels of the grid the first is taken (cells of several sizes are regions of Refinement, which do "
            "not follow); add them in the deck.")
    for level in levels[1:]:
        level.cover()
    lower, upper, spacing = read_box(levels[0], notes)
    if not all((high - low) / min(spacing) < MOST_CELLS for low, high in zip(lower, upper)):
        raise Fault(f"{levels[0].where} has more than {MOST_CELLS:g} cells along an axis (a grid of a deck has fewer); correct lower, "
            "upper or the cells.")
    if root.find("MPM").flag("axisymmetric"):
        mode = "axisymmetric"
    else:
        mode = "plane strain" if round((upper[2] - lower[2]) / spacing[2]) <= 1 else "3D"
    space = Space(mode, [], [], 0.0, (lower[2], upper[2]))
    if mode == "axisymmetric" and round((upper[2] - lower[2]) / spacing[2]) > 1:
        notes.add("The grid has several cells along z; in axisymmetry the plane of its first layer is meant.")
    lower, upper, spacing = (space.point(vector) for vector in (lower, upper, spacing))
    space.cell = min(spacing)
    if max(spacing) > space.cell * (1 + NEAR):
        notes.add(f"Cells of {', '.join(f'{s:g}' for s in spacing)} become squares or cubes of the smallest of these (a deck has no "
            "others); the cost rises accordingly.")
    counts = [math.ceil((high - low) / space.cell * (1 - NEAR)) for low, high in zip(lower, upper)]
    space.lower, space.upper = lower, [low + count * space.cell for low, count in zip(lower, counts)]
    if any(abs(new - old) > NEAR * abs(old) for new, old in zip(space.upper, upper)):
        notes.add("The upper corner of the grid is moved out to a whole number of cells.")
    return space


def grid_of(space):
    return {"Mode": space.mode, "Lower": space.lower, "Upper": space.upper, "Cell Size": space.cell}
