// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>

#include <cmath>

namespace barreno {

/// Scales by which numbers of about one magnitude are split (RowSum). They must not depend on
/// which rows a rank has.
struct SplitScales {
  double first = 1.0, second = 1.0;  ///< adding and subtracting these rounds to a quantum
  double top = 0.0;                  ///< numbers from here on are not split

  KOKKOS_INLINE_FUNCTION SplitScales() : SplitScales(1.0) {}
  /// @param size  numbers are expected to be smaller; up to 2^13 times as much is split too
  KOKKOS_INLINE_FUNCTION explicit SplitScales(double size) {
    constexpr int digits_above = 31, digits_below = 76;
    const double power = std::exp2(std::ceil(std::log2(size)));
    const auto rounder = [&](int digits) { return 1.5 * std::ldexp(power, 52 - digits); };
    first = rounder(digits_above);
    second = rounder(digits_below);
    top = std::ldexp(power, 13);
  }
};

/// Most rows of a RowSum, so that its parts are exact.
inline constexpr int max_summed_rows = 512;

}  // namespace barreno
