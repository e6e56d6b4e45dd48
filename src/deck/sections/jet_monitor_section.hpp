// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

#include <string>
#include <vector>

namespace barreno {

/// A plane across y that a jet goes through, and what of it becomes a jet table.
struct JetMonitorSpec {
  std::vector<std::string> body_names;
  double position = 0.0;        ///< y of the plane [length]
  double direction = 1.0;       ///< +1 or -1 along y
  double interval = 0.0;        ///< what crosses within it is a slug [time]
  double smallest_speed = 0.0;  ///< slower ones are not of the jet [length/time]
  double largest_radius = 0.0;  ///< wider ones are not of the jet; 0: all are [length]
  std::vector<int> bodies;      ///< indices into Scene::bodies; none: nothing is monitored
  double density = 0.0;         ///< of their material [mass/length^3]
  /// How many times the modelled part makes the whole jet: 2 for each symmetry plane along its
  /// axis in three dimensions.
  double copies = 1.0;

  bool present() const { return !bodies.empty(); }
};
template <>
const SectionTable<JetMonitorSpec>& table_of<JetMonitorSpec>();

}  // namespace barreno
