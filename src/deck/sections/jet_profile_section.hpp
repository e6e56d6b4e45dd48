// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"

#include <optional>

namespace barreno {

/// A jet whose metal has flown freely from one point, the virtual origin, since a time 0: metal of
/// velocity v is at x = v t. docs/jets.md
struct JetProfileSpec {
  double tip_velocity = 0.0, tail_velocity = 0.0;  ///< [length/time]
  double virtual_origin = 0.0;        ///< distance S of the origin before the launch plane [length]
  std::optional<double> mass;         ///< of the jet, without the liner's slug [mass]
  std::optional<double> tip_radius;   ///< of the metal as it crosses the launch plane [length]
  std::optional<double> tail_radius;  ///< between both, linear in v [length]
  std::optional<double> density;      ///< mean density as it crosses; left out: the metal's
  std::optional<double> break_up_time;  ///< since the origin, from which pieces do not stretch
  int rows = 200;                       ///< slugs that the jet is cut into
  std::optional<double> slug_velocity, slug_mass, slug_radius;  ///< of the liner's slug
};
template <>
const SectionTable<JetProfileSpec>& table_of<JetProfileSpec>();

}  // namespace barreno
