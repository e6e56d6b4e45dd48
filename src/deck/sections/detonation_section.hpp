// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/schema.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace barreno {

class LightingMap;

/// Way of a detonation from its detonators to a point.
enum class Lighting { straight, around_obstacles };
inline Words<Lighting> words_of(Lighting /*of*/) {
  return {{"straight", Lighting::straight}, {"around obstacles", Lighting::around_obstacles}};
}

enum class DetonatorKind { point, line, ring, plane };
inline Words<DetonatorKind> words_of(DetonatorKind /*of*/) {
  return {
      {"point", DetonatorKind::point},
      {"line", DetonatorKind::line},
      {"ring", DetonatorKind::ring},
      {"plane", DetonatorKind::plane}};
}

/// What lights the explosive at once, at its time.
struct DetonatorSpec {
  std::string name;
  DetonatorKind kind = DetonatorKind::point;
  Vector position{};    ///< the point, an end of the line, the ring's centre, on the plane
  Vector end{};         ///< the line's other end
  Vector normal{};      ///< of the plane, axis of the ring; any length until add_detonation
  double radius = 0.0;  ///< of the ring [length]
  double time = 0.0;    ///< [time]
};
template <>
const SectionTable<DetonatorSpec>& table_of<DetonatorSpec>();

struct DetonationSpec {
  std::vector<std::string> body_names;
  Lighting lighting = Lighting::straight;
  std::vector<int> bodies;  ///< indices into Scene::bodies; none: nothing detonates
  std::vector<DetonatorSpec> detonators;
  double speed = 0.0;                      ///< D of the explosive [length/time]
  std::shared_ptr<const LightingMap> map;  ///< of lighting around obstacles
};
template <>
const SectionTable<DetonationSpec>& table_of<DetonationSpec>();

/// Detonation with its Detonators.
input::Section detonation_section();

}  // namespace barreno
