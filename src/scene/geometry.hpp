// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/fill.hpp"
#include "scene/scene.hpp"

#include <array>
#include <cmath>

namespace barreno {

/// Some faces of the grid; a list without memory of its own, for the step.
struct FaceList {
  std::array<Face, 6> face{};
  std::size_t count = 0;
  const Face* begin() const { return face.data(); }
  const Face* end() const { return face.data() + count; }
};

/// Euclidean norm.
inline double length_of(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}
inline double distance(const Vector& a, const Vector& b) {
  return length_of({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

/// Faces of the grid that go through a ball's centre or hold a cone's line: only the part inside is
/// filled.
FaceList cutting_faces(const Shape& shape, const GridSpec& grid);

/// The smallest box around the part of a shape that is filled. The grid ends half-spaces, and in
/// axisymmetry the axis ends all shapes but boxes and polygons.
Box box_around(const Shape& shape, const GridSpec& grid);

/// Area in the plane, in three dimensions volume, that particles fill at most; exact for single
/// shapes [length^dimension].
double max_measure(const Shape& shape, const GridSpec& grid);

/// The grid's own lattice of particles around a shape, so that they sit in their cells alike
/// everywhere.
Lattice lattice_of(const Shape& shape, const GridSpec& grid, double size);

/// The shapes share more than a boundary (a ball's hollow is not part of it). Exact for boxes and
/// balls, to a millionth of a cell; other shapes are tried at points about half a `spacing` apart.
bool overlap(const Shape& a, const Shape& b, const GridSpec& grid, double spacing);

/// The shape is inside the box of the grid, to a millionth of a cell.
bool inside(const Shape& shape, const GridSpec& grid);

/// Lengths below this are round-off of a deck's numbers [length].
double length_tolerance(const GridSpec& grid);

}  // namespace barreno
