// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

namespace barreno {

/// Force per mass on every particle: gravity, or what a manufactured motion needs
/// (scene/body_force.hpp).
enum class BodyForceKind { none, gravity, axis_aligned, vortex, ring };
inline Words<BodyForceKind> words_of(BodyForceKind /*of*/) {
  return {
      {"gravity", BodyForceKind::gravity},
      {"axis-aligned displacement", BodyForceKind::axis_aligned},
      {"generalized vortex", BodyForceKind::vortex},
      {"expanding ring", BodyForceKind::ring}};
}

struct BodyForceSpec {
  BodyForceKind kind = BodyForceKind::none;
  Vector acceleration{};   ///< gravity only [acceleration]
  double amplitude = 0.0;  ///< A of a manufactured motion [length]; of the vortex its angle [-]
  double angle = 0.0;      ///< what the deck says of the vortex [-]
  int dimensions = 2;
  bool axisymmetric = false;
  double density = 0.0, young = 0.0, lambda = 0.0, shear = 0.0;  ///< of its material
  Vector centre{};                                               ///< of its disk [length]
  double inner_radius = 0.0, outer_radius = 0.0;                 ///< [length]
};
template <>
const SectionTable<BodyForceSpec>& table_of<BodyForceSpec>();

}  // namespace barreno
