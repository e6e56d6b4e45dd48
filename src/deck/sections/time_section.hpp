// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"

#include <optional>

namespace barreno {

/// The word of End Time with which a run ends when the hole of its jet is at rest.
inline constexpr const char* at_rest_word = "at rest";

struct TimeSpec {
  double end_time = 0.0;               ///< [time]
  bool at_rest = false;                ///< in place of an end time
  std::optional<double> longest_time;  ///< of a run to rest [time]
  /// Below which the metal of the jet does not dig; without: cut_off_velocity() [length/time]
  std::optional<double> cut_off_velocity;
};
template <>
const SectionTable<TimeSpec>& table_of<TimeSpec>();

}  // namespace barreno
