// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace barreno {

/// The range that a parameter usually lies in, in SI. A value outside it is allowed; more often a
/// unit was forgotten.
struct PlausibleRange {
  const char* parameter;
  double lower, upper;
  /// The range bounds the magnitude, and the sign is free.
  bool of_magnitude = false;
  bool holds(double value) const;
};

/// Whether a model, or a part of one, says ranges of its own: plausible_ranges().
template <class Of, class = void>
inline constexpr bool says_plausible_ranges = false;
template <class Of>
inline constexpr bool says_plausible_ranges<Of, std::void_t<decltype(Of::plausible_ranges())>> =
    true;

/// Ranges of the parameters of a model that have a dimension, Density first. Zero, where a
/// parameter may be zero, switches something off and lies in every range.
const std::vector<PlausibleRange>& plausible_ranges(const std::string& model);

/// The range of one parameter; null where none is known.
const PlausibleRange* find_plausible_range(const std::string& model, const std::string& parameter);

}  // namespace barreno
