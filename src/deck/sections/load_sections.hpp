// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/face.hpp"
#include "deck/section_of.hpp"
#include "deck/sections/condition_kinds.hpp"
#include "deck/sections/load_kinds.hpp"
#include "deck/table.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <array>
#include <string>
#include <vector>

namespace barreno {

/// Prescribed motion of one face of the grid box.
struct ConditionSpec {
  std::string name;
  Face face = Face::x_lower;
  ConditionKind kind = ConditionKind::symmetry;
  Vector velocity{};           ///< of a kind that moves [length/time]
  Table factor{{0.0}, {1.0}};  ///< of velocity, as time goes on [-]
};
template <>
const SectionTable<ConditionSpec>& table_of<ConditionSpec>();

/// Surfaces of a ball: that of its hollow and that around it.
enum class BallSurface { inner, outer };
inline Words<BallSurface> words_of(BallSurface /*of*/) {
  return {{"inner", BallSurface::inner}, {"outer", BallSurface::outer}};
}

/// Pressure that follows a body's own surface (pushes inward if > 0): faces of a box, surfaces of a
/// ball.
struct PressureLoadSpec {
  std::string name;
  int body = 0;     ///< index into Scene::bodies
  FaceSet faces{};  ///< of a Box
  Table pressure;   ///< at the start if the kind is pore_fluid [stress]
  LoadKind kind = LoadKind::pressure;
  std::array<bool, 2> surfaces{};  ///< of a Ball, indexed by BallSurface
  double bulk_modulus = 0.0;       ///< pore_fluid: p = p0 - K ln(V / V0) [stress]
};
template <>
const SectionTable<PressureLoadSpec>& table_of<PressureLoadSpec>();

/// Bodies that start in equilibrium under a pressure.
struct ConfinementSection {
  double pressure = 0.0;            ///< [stress]
  std::vector<std::string> bodies;  ///< by name
};
template <>
const SectionTable<ConfinementSection>& table_of<ConfinementSection>();

}  // namespace barreno
