// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/table.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/schema.hpp>
#include <optional>
#include <string>

namespace barreno {

/// Prescribed motion of a rigid body: velocity * factor(t).
struct MotionSpec {
  bool prescribed = false;
  Vector velocity{};  ///< [length/time]
  Table factor{{0.0}, {1.0}};
};
template <>
const SectionTable<MotionSpec>& table_of<MotionSpec>();

struct BodySpec {
  std::string name;
  int material = 0;  ///< index into Scene::materials
  Shape shape;  ///< in two dimensions a figure in the plane; in axisymmetry in the half plane {r,
                ///< axial}
  int particles_per_cell = 2;     ///< per direction
  Vector velocity{};              ///< [length/time]
  double initial_pressure = 0.0;  ///< the body starts in equilibrium under this pressure [stress]
  double expansion = 1.0;  ///< solid over mean density at the start, of materials with voids [-]
  std::optional<double> pore_pressure;  ///< at the start; without: as its material has it [stress]
  /// Initial velocity v = amplitude * sin(wave_number . x): the standing wave of the bar tests.
  Vector velocity_wave_number{};  ///< all zero: uniform velocity [1/length]
  double spin = 0.0;              ///< about the body's own middle, plane strain only [1/time]
  /// Of a hollow ball's inner surface, outward; the field keeps every volume [length/time].
  double radial_velocity = 0.0;
  MotionSpec motion;
};
template <>
const SectionTable<BodySpec>& table_of<BodySpec>();

/// A body's entries are those of its shape and of its motion too.
input::Section bodies_section();

}  // namespace barreno
