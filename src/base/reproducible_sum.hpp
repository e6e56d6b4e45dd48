// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>

#include <cstdint>
#include <cstring>

namespace barreno {

/// A sum of numbers that is the same to the last bit in every order of them, and so on any number
/// of ranks: it is counted in whole numbers, without any rounding of the sum.
///
///   sum = part[0] 2^120 + part[1] 2^80 + ... + part[8] 2^-200
///
/// So it holds numbers of any units: those below 2^132 are exact down to 2^-200 (6e-61), to which
/// smaller digits are rounded one by one. carry() at least every million numbers.
struct ReproducibleSum {
  static constexpr int parts = 9;
  static constexpr int bits_per_part = 40;
  static constexpr int bits_below_one = 200;
  long long part[parts] = {};

  /// A number that is not finite, or beyond 2^132, is left out: what made it is not finite either,
  /// and taken out of the run for that.
  KOKKOS_INLINE_FUNCTION ReproducibleSum& operator+=(double number) {
    if (number == 0.0) return *this;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    // number = +-mantissa 2^(exponent - 1075), and its lowest bit is so many above the quantum.
    int place = static_cast<int>(bits >> 52U & 0x7ffU) - 1075 + bits_below_one;
    std::uint64_t mantissa = (bits & ((std::uint64_t{1} << 52U) - 1)) | std::uint64_t{1} << 52U;
    constexpr int places = bits_per_part * (parts - 2);
    if (place >= places || place < -53) return *this;
    if (place < 0) {
      mantissa = (mantissa + (std::uint64_t{1} << static_cast<unsigned>(-place - 1))) >>
                 static_cast<unsigned>(-place);
      place = 0;
    }
    const int i = parts - 1 - place / bits_per_part;
    const auto shift = static_cast<unsigned>(place % bits_per_part);
    const std::uint64_t rest = mantissa >> (bits_per_part - shift);
    constexpr std::uint64_t mask = (std::uint64_t{1} << bits_per_part) - 1;
    const auto low = static_cast<long long>(mantissa << shift & mask);
    const auto middle = static_cast<long long>(rest & mask);
    const auto high = static_cast<long long>(rest >> bits_per_part);
    const bool negative = bits >> 63U != 0;
    part[i] += negative ? -low : low;
    part[i - 1] += negative ? -middle : middle;
    part[i - 2] += negative ? -high : high;
    return *this;
  }
  KOKKOS_INLINE_FUNCTION ReproducibleSum& operator-=(double number) { return *this += -number; }
  KOKKOS_INLINE_FUNCTION ReproducibleSum& operator+=(const ReproducibleSum& other) {
    for (int i = 0; i < parts; ++i) part[i] += other.part[i];
    return *this;
  }
  KOKKOS_INLINE_FUNCTION ReproducibleSum& operator-=(const ReproducibleSum& other) {
    for (int i = 0; i < parts; ++i) part[i] -= other.part[i];
    return *this;
  }

  /// The same sum with all parts but the first in [0, 2^40): each sum has one such form.
  KOKKOS_INLINE_FUNCTION void carry() {
    for (int i = parts - 1; i > 0; --i) {
      const long long over = part[i] >> bits_per_part;  // rounds down
      part[i] -= over * (1LL << bits_per_part);
      part[i - 1] += over;
    }
  }

  /// The sum, rounded to a double.
  double value() const {
    ReproducibleSum size = *this;
    size.carry();
    const double sign = size.part[0] < 0 ? -1.0 : 1.0;
    if (sign < 0.0) {  // its parts would cancel
      for (long long& p : size.part) p = -p;
      size.carry();
    }
    constexpr double scale = 1.0 / static_cast<double>(1LL << bits_per_part);
    double sum = 0.0;
    for (int i = parts - 1; i >= 0; --i) sum = sum * scale + static_cast<double>(size.part[i]);
    constexpr int whole_parts = bits_below_one / bits_per_part;
    for (int i = 0; i < parts - 1 - whole_parts; ++i)
      sum *= static_cast<double>(1LL << bits_per_part);
    return sign * sum;
  }
  operator double() const {
    return value();
  }  // NOLINT(google-explicit-constructor): it is read as one
};

/// As reducers ask for it (TallyReducer).
KOKKOS_INLINE_FUNCTION void add(const ReproducibleSum& part, ReproducibleSum& sum) {
  sum += part;
}

}  // namespace barreno
