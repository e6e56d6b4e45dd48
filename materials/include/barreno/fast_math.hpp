// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cstdint>
#include <cstring>

namespace barreno {

/// Elementary functions of positive normal numbers for point updates: inlined, without branches, to
/// a few units in the last place. The library's own keep the last bit right in all cases, and their
/// calls were a third of a metal's plastic update.

/// ln x, x positive and normal. x = 2^k m with m near 1, ln m = 2 atanh((m - 1)/(m + 1)) by its
/// power series.
BARRENO_FUNCTION double fast_log(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof(bits));
  // Shift the split to sqrt(1/2), so that m lies in [sqrt(1/2), sqrt 2).
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdULL;
  constexpr std::uint64_t one = 0x3ff0000000000000ULL;
  const std::uint64_t shifted = bits + (one - root_half);
  const auto k = static_cast<double>(static_cast<std::int64_t>(shifted >> 52U) - 1023);
  const std::uint64_t mantissa = (shifted & 0x000fffffffffffffULL) + root_half;
  double m = 0.0;
  std::memcpy(&m, &mantissa, sizeof(m));
  const double f = (m - 1.0) / (m + 1.0);
  const double s = f * f;
  const double s2 = s * s;
  const double even = 1.0 / 3 + s2 * (1.0 / 7 + s2 * (1.0 / 11 + s2 * (1.0 / 15 + s2 * (1.0 / 19))));
  const double odd = 1.0 / 5 + s2 * (1.0 / 9 + s2 * (1.0 / 13 + s2 * (1.0 / 17)));
  constexpr double ln2_high = 6.93147180369123816490e-01;
  constexpr double ln2_low = 1.90821492927058770002e-10;
  return k * ln2_high + (2.0 * f + (2.0 * f * s * (even + s * odd) + k * ln2_low));
}

/// e^x for |x| < 700: x = k ln 2 + r, e^r by its power series to r^13.
BARRENO_FUNCTION double fast_exp(double x) {
  constexpr double log2_e = 1.44269504088896340736;
  constexpr double ln2_high = 6.93147180369123816490e-01;
  constexpr double ln2_low = 1.90821492927058770002e-10;
  // Adding and taking away 1.5 * 2^52 rounds to the nearest whole number.
  constexpr double rounder = 6755399441055744.0;
  const double k = (x * log2_e + rounder) - rounder;
  const double r = (x - k * ln2_high) - k * ln2_low;
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double low = 1.0 + r + r2 * (1.0 / 2 + r * (1.0 / 6));
  const double middle = 1.0 / 24 + r * (1.0 / 120) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  const double high = 1.0 / 40320 + r * (1.0 / 362880) +
                      r2 * (1.0 / 3628800 + r * (1.0 / 39916800)) +
                      r4 * (1.0 / 479001600 + r * (1.0 / 6227020800.0));
  const double power = low + r4 * (middle + r4 * high);
  const auto scale_bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023) << 52U;
  double scale = 0.0;
  std::memcpy(&scale, &scale_bits, sizeof(scale));
  return power * scale;
}

/// x^y for positive normal x; 0 for x = 0 and y > 0, 1 for y = 0.
BARRENO_FUNCTION double fast_pow(double x, double y) {
  constexpr double smallest = 2.2250738585072014e-308;
  if (x < smallest) return y > 0.0 ? 0.0 : 1.0;
  return fast_exp(y * fast_log(x));
}

}  // namespace barreno
