// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include <cmath>

namespace barreno {

/// A sum of numbers that is the same to the last bit in every order of them, and so on any number
/// of ranks: each is rounded once to a whole multiple of 2^-80 (8e-25), and those are counted.
///
///   sum = part[0] + part[1] 2^-40 + part[2] 2^-80
///
/// It holds up to 2^62; carry() at least every million numbers.
struct WholeSum {
  static constexpr int parts = 3;
  static constexpr long long per_part = 1LL << 40;
  long long part[parts] = {};

  /// A number that is none or beyond 2^62 is left out: what made it is not finite either, and taken
  /// out of the run for that.
  KOKKOS_INLINE_FUNCTION void add(double number) {
    if (!(std::fabs(number) < 4611686018427387904.0)) return;
    for (int i = 0; i + 1 < parts; ++i) {
      const double whole = std::trunc(number);
      part[i] += static_cast<long long>(whole);
      number = (number - whole) * static_cast<double>(per_part);
    }
    part[parts - 1] += static_cast<long long>(std::nearbyint(number));
  }
  KOKKOS_INLINE_FUNCTION void add(const WholeSum& other) {
    for (int i = 0; i < parts; ++i) part[i] += other.part[i];
  }

  /// The same sum with all parts but the first in [0, 2^40): each sum has one such form.
  KOKKOS_INLINE_FUNCTION void carry() {
    for (int i = parts - 1; i > 0; --i) {
      long long over = part[i] / per_part;
      if (part[i] % per_part < 0) --over;
      part[i] -= over * per_part;
      part[i - 1] += over;
    }
  }

  /// The sum, rounded to a double.
  double value() const {
    WholeSum size = *this;
    size.carry();
    const double sign = size.part[0] < 0 ? -1.0 : 1.0;
    if (sign < 0.0) {  // its parts would cancel
      for (long long& p : size.part) p = -p;
      size.carry();
    }
    constexpr double scale = 1.0 / static_cast<double>(per_part);
    double sum = 0.0;
    for (int i = parts - 1; i >= 0; --i) sum = sum * scale + static_cast<double>(size.part[i]);
    return sign * sum;
  }
};

}  // namespace barreno
