// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

namespace barreno {

/// Shapes as plain data. In two dimensions a shape is a figure in the plane and the third
/// coordinate is not looked at; lengths are those of the coordinates.

using Vector = std::array<double, 3>;

struct Box {
  Vector lower{}, upper{};
};

/// A sphere, in two dimensions a disk. Faces of the grid that go through its centre cut it.
struct Ball {
  Vector centre{};
  double radius = 0.0;
  double inner_radius = 0.0;  ///< of its hollow; 0: solid
};

/// Round about the line from start to end; three dimensions only. Equal radii make a cylinder, an
/// end radius of zero a tip. The bore is for cylinders. Faces of the grid that hold the whole line
/// cut it.
struct Cone {
  Vector start{}, end{};
  double start_radius = 0.0, end_radius = 0.0;
  double inner_radius = 0.0;  ///< of the bore; 0: solid
};

/// A figure without crossing edges, extruded along an axis; corners are given in the other two
/// coordinates, in their order. In two dimensions the axis is z and the ends are not looked at.
struct Polygon {
  std::vector<std::array<double, 2>> corners;
  int axis = 2;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// All points x with (x - point) . normal < 0.
struct HalfSpace {
  Vector point{};
  Vector normal{};  ///< a unit vector, pointing out
};

class Surface;
/// What a closed surface of triangles encloses; three dimensions only.
struct Faceted {
  std::shared_ptr<const Surface> surface;
};

enum class Operation {
  unite,      ///< all parts
  subtract,   ///< the first part without the others
  intersect,  ///< what all parts share
};
struct Shape;
struct Combination {
  Operation operation = Operation::unite;
  std::vector<Shape> parts;
};

using AnyShape = std::variant<Box, Ball, Cone, Polygon, HalfSpace, Faceted, Combination>;
/// A type of its own, because a combination holds shapes.
struct Shape : AnyShape {
  using AnyShape::AnyShape;
};

}  // namespace barreno
