// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#if defined(__AVX2__) && !defined(__CUDACC__) && !defined(__HIP__)
#include <immintrin.h>
#endif

/// One source for one point and for several at once: templates over R, which is double or Lanes.
///
/// Lanes are as many doubles as a vector register holds. Every lane goes its own way: its result
/// depends neither on the other lanes nor on its place or their number. Where there are no vector
/// extensions (devices), codes take the double.
namespace barreno {

#if (defined(__GNUC__) || defined(__clang__)) && !defined(__CUDACC__) && !defined(__HIP__)
#define BARRENO_HAS_LANES 1
// Wider ones than the machine's are compared and selected number by number: five times slower.
#if defined(__AVX2__) && !defined(__AVX512F__)
inline constexpr int lane_count = 4;
#else
inline constexpr int lane_count = 8;
#endif
// NOLINTNEXTLINE(modernize-use-using): the attribute needs it
typedef double Lanes __attribute__((vector_size(lane_count * sizeof(double))));
using LaneMask = decltype(Lanes{} < Lanes{});
/// Bits of lanes whose arithmetic may wrap around: of numbers that a selection drops.
// NOLINTNEXTLINE(modernize-use-using): the attribute needs it
typedef unsigned long long LaneBits __attribute__((vector_size(sizeof(Lanes))));
#else
#define BARRENO_HAS_LANES 0
#endif

template <class R>
struct MaskOfReal {
  using type = decltype(R{} < R{});
};
/// Outcome of a comparison: bool, or one for each lane.
template <class R>
using MaskOf = typename MaskOfReal<R>::type;

/// Elementary functions and selections that double and Lanes share.
namespace real {

BARRENO_FUNCTION double select(bool choice, double yes, double no) {
  return choice ? yes : no;
}
BARRENO_FUNCTION bool any(bool choice) {
  return choice;
}
BARRENO_FUNCTION bool all(bool choice) {
  return choice;
}
BARRENO_FUNCTION double sqrt(double x) {
  return std::sqrt(x);
}
BARRENO_FUNCTION double log(double x) {
  return std::log(x);
}
BARRENO_FUNCTION double exp(double x) {
  return std::exp(x);
}
BARRENO_FUNCTION double abs(double x) {
  return std::fabs(x);
}
/// x^y for x >= 0.
BARRENO_FUNCTION double pow(double x, double y) {
  return std::pow(x, y);
}

#if BARRENO_HAS_LANES
/// The same bits as another type.
template <class To, class From>
inline To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From), "bits go from size to size");
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

/// The same number in every lane. Lanes pass as they are: an addition of nothing is one that the
/// compiler must make, because of -0.
inline Lanes in_lanes(double number) {
  return Lanes{} + number;
}
inline const Lanes& in_lanes(const Lanes& numbers) {
  return numbers;
}
template <class Yes, class No>
inline Lanes select(const LaneMask& choice, const Yes& yes, const No& no) {
  return choice ? in_lanes(yes) : in_lanes(no);
}
inline bool any(const LaneMask& choice) {
#ifdef __AVX512F__
  // Compilers do not find this instruction in the general form.
  return _mm512_test_epi64_mask(bits_as<__m512i>(choice), bits_as<__m512i>(choice)) != 0;
#elif defined(__AVX2__)
  return _mm256_movemask_pd(bits_as<__m256d>(choice)) != 0;
#else
  long long sum = 0;
  for (int i = 0; i < lane_count; ++i) sum |= choice[i];
  return sum != 0;
#endif
}
inline bool all(const LaneMask& choice) {
  return !any(!choice);
}

inline Lanes sqrt(const Lanes& x) {
#ifdef __AVX512F__
  return bits_as<Lanes>(_mm512_maskz_sqrt_pd(0xff, bits_as<__m512d>(x)));
#elif defined(__AVX2__)
  return bits_as<Lanes>(_mm256_sqrt_pd(bits_as<__m256d>(x)));
#else
  Lanes root{};
  for (int i = 0; i < lane_count; ++i) root[i] = std::sqrt(x[i]);
  return root;
#endif
}

/// Adding it to a number below 2^51 rounds that to an integer, which then sits in the lowest bits.
inline constexpr double rounder = 6755399441055744.0;  // 1.5 2^52

inline Lanes abs(const Lanes& x) {
  constexpr unsigned long long all_but_sign = 0x7fffffffffffffffULL;
  return bits_as<Lanes>(bits_as<LaneBits>(x) & all_but_sign);
}

/// ln x for normal x > 0: x = 2^k m with m in [sqrt(1/2), sqrt(2)), and ln m = 2 artanh s,
/// s = (m - 1)/(m + 1), by its power series, whose first term left out is 1e-18.
/// Error: 1 unit in the last place (tests/materials/test_real.cpp).
inline Lanes log(const Lanes& x) {
  constexpr double ln2_high = 0x1.62e42fefa3800p-1;  // ln 2 in two parts: k * ln2_high is exact
  constexpr double ln2_low = 0x1.ef35793c76730p-45;
  constexpr unsigned long long half_root = 0x3fe6a09e667f3bcdULL;  // bits of sqrt(1/2)
  const LaneBits shifted = bits_as<LaneBits>(x) - half_root;
  const LaneMask exponent = bits_as<LaneMask>(shifted) >> 52;
  const LaneBits bits = (shifted & 0x000fffffffffffffULL) + half_root;
  const Lanes f = bits_as<Lanes>(bits) - 1.0;
  const Lanes s = f / (2.0 + f);
  const Lanes z = s * s;
  // Even and odd terms apart: two short chains instead of a long one.
  const Lanes zz = z * z;
  Lanes even = zz * (1.0 / 19.0) + 1.0 / 15.0;
  Lanes odd = zz * (1.0 / 21.0) + 1.0 / 17.0;
  even = zz * even + 1.0 / 11.0;
  odd = zz * odd + 1.0 / 13.0;
  even = zz * even + 1.0 / 7.0;
  odd = zz * odd + 1.0 / 9.0;
  even = zz * even + 1.0 / 3.0;
  odd = zz * odd + 1.0 / 5.0;
  const Lanes sum = even + z * odd;
  const LaneMask lowest = exponent + bits_as<LaneMask>(Lanes{} + rounder);
  const Lanes k = bits_as<Lanes>(lowest) - rounder;
  // 2 s = f - s f: the leading part f is exact.
  const Lanes small = s * (2.0 * z * sum - f) + k * ln2_low;
  return k * ln2_high + (f + small);
}

/// e^x, 0 below -700 and e^700 above 700: x = k ln 2 + r, e^r by its power series to r^13.
/// Error: 1 unit in the last place (tests/materials/test_real.cpp).
inline Lanes exp(const Lanes& x) {
  constexpr double ln2_high = 0x1.62e42fefa3800p-1;
  constexpr double ln2_low = 0x1.ef35793c76730p-45;
  constexpr double per_ln2 = 1.4426950408889634;
  constexpr double largest = 700.0;
  const Lanes y = select(x > largest, largest, select(x < -largest, -largest, x));
  const Lanes shifted = y * per_ln2 + rounder;
  const Lanes k = shifted - rounder;
  const Lanes r = (y - k * ln2_high) - k * ln2_low;
  const Lanes rr = r * r;
  Lanes even = rr * (1.0 / 479001600.0) + 1.0 / 3628800.0;
  Lanes odd = rr * (1.0 / 6227020800.0) + 1.0 / 39916800.0;
  even = rr * even + 1.0 / 40320.0;
  odd = rr * odd + 1.0 / 362880.0;
  even = rr * even + 1.0 / 720.0;
  odd = rr * odd + 1.0 / 5040.0;
  even = rr * even + 1.0 / 24.0;
  odd = rr * odd + 1.0 / 120.0;
  even = rr * even + 0.5;
  odd = rr * odd + 1.0 / 6.0;
  const Lanes sum = even + r * odd;
  const Lanes one_plus = 1.0 + (r + rr * sum);
  const LaneBits power = (bits_as<LaneBits>(shifted) + 1023) << 52;
  return select(x < -largest, 0.0, one_plus * bits_as<Lanes>(power));
}

/// x^y for x >= 0, relative error about |y ln x| 2^-52.
inline Lanes pow(const Lanes& x, double y) {
  if (y == 0.0) return Lanes{} + 1.0;
  return select(x > 0.0, exp(y * log(x)), 0.0);
}
#endif

/// One point or lane of several, and what a function of its number gives for each: for what knows
/// but one point at a time.
template <class R>
inline constexpr int count_of = 1;
BARRENO_FUNCTION double lane(double x, int /*i*/) {
  return x;
}
BARRENO_FUNCTION bool lane(bool x, int /*i*/) {
  return x;
}
BARRENO_FUNCTION void set_lane(double& x, int /*i*/, double value) {
  x = value;
}
template <class F>
BARRENO_FUNCTION double each(const F& f, const double& /*like*/) {
  return f(0);
}
#if BARRENO_HAS_LANES
template <>
inline constexpr int count_of<Lanes> = lane_count;
inline double lane(const Lanes& x, int i) {
  return x[i];
}
inline bool lane(const LaneMask& x, int i) {
  return x[i] != 0;
}
inline void set_lane(Lanes& x, int i, double value) {
  x[i] = value;
}
template <class F>
inline Lanes each(const F& f, const Lanes& /*like*/) {
  Lanes x{};
  for (int i = 0; i < lane_count; ++i) x[i] = f(i);
  return x;
}
#endif

template <class R>
BARRENO_FUNCTION R larger(const R& a, double b) {
  return select(a > b, a, b);
}
template <class R>
BARRENO_FUNCTION R smaller(const R& a, double b) {
  return select(a < b, a, b);
}
/// Sum of even[k] x^2k + odd[k] x^(2k+1): two short chains instead of a long one.
template <std::size_t count, class R>
BARRENO_FUNCTION R
even_odd_sum(const double (&even)[count], const double (&odd)[count], const R& x) {
  const R xx = x * x;
  R even_sum = R{} + even[count - 1], odd_sum = R{} + odd[count - 1];
  for (std::size_t k = count - 1; k-- > 0;) {
    even_sum = xx * even_sum + even[k];
    odd_sum = xx * odd_sum + odd[k];
  }
  return even_sum + x * odd_sum;
}
/// False for infinities and NaN.
template <class R>
BARRENO_FUNCTION MaskOf<R> is_finite(const R& x) {
  return abs(x) <= std::numeric_limits<double>::max();
}

}  // namespace real
}  // namespace barreno
