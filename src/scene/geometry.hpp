// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Faces of the grid that go through a ball's centre: only the part inside is filled.
std::vector<Face> cutting_faces(const Ball& ball, const GridSpec& grid);

/// The smallest box around the part of a shape that is filled.
Box box_around(const Shape& shape, const GridSpec& grid);

/// What particles fill: an area in the plane, a volume in three dimensions [length^dimensions].
double area_of(const Shape& shape, const GridSpec& grid);

/// The shapes share more than a boundary (a ball's hollow is not part of it); what is closer than a
/// millionth of a cell touches.
bool overlap(const Shape& a, const Shape& b, const GridSpec& grid);

/// The shape is inside the box of the grid, to a millionth of a cell.
bool inside(const Shape& shape, const GridSpec& grid);

/// Lengths below this are round-off of a deck's numbers [length].
double touching(const GridSpec& grid);

}  // namespace barreno
