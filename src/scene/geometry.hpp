// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// The smallest box around a shape; a ball of axisymmetry counts from the axis outwards.
Box box_around(const Shape& shape, const GridSpec& grid);

/// Area in the plane that particles fill [length^2].
double area_of(const Shape& shape, const GridSpec& grid);

/// The shapes share more than a boundary; what is closer than a millionth of a cell touches.
bool overlap(const Shape& a, const Shape& b, const GridSpec& grid);

/// The shape is inside the box of the grid, to a millionth of a cell.
bool inside(const Shape& shape, const GridSpec& grid);

/// Lengths below this are round-off of a deck's numbers [length].
double touching(const GridSpec& grid);

}  // namespace barreno
