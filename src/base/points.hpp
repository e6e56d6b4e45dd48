// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <barreno/real.hpp>
#include <cstring>
#include <type_traits>

namespace barreno {

/// Kernels over R (barreno/real.hpp) take width<R> neighbouring rows at a time: one as double,
/// several as Lanes. The last ones of a chunk may be fewer; their spare lanes repeat the last row.
template <class R>
inline constexpr int width = 1;

KOKKOS_INLINE_FUNCTION double entry(double value, int) {
  return value;
}
KOKKOS_INLINE_FUNCTION double load(const FieldView& values, int c, int first, int, double) {
  return values(first, c);
}
KOKKOS_INLINE_FUNCTION void store(double value, const FieldView& values, int c, int first, int) {
  values(first, c) = value;
}

#if BARRENO_HAS_LANES
template <>
inline constexpr int width<Lanes> = lane_count;

inline double entry(const Lanes& value, int i) {
  return value[i];
}
inline long long entry(const LaneMask& value, int i) {
  return value[i];
}
inline Lanes load(const FieldView& values, int c, int first, int count, const Lanes&) {
  Lanes out;
  if (count == lane_count)
    std::memcpy(&out, &values(first, c), sizeof out);
  else
    for (int i = 0; i < lane_count; ++i) out[i] = values(first + (i < count ? i : count - 1), c);
  return out;
}
inline void store(const Lanes& value, const FieldView& values, int c, int first, int count) {
  if (count == lane_count)
    std::memcpy(&values(first, c), &value, sizeof value);
  else
    for (int i = 0; i < count; ++i) values(first + i, c) = value[i];
}

template <>
inline constexpr int width<LanePair> = 2 * lane_count;

inline double entry(const LanePair& value, int i) {
  return i < lane_count ? value.low[i] : value.high[i - lane_count];
}
inline long long entry(const LanePairMask& value, int i) {
  return i < lane_count ? value.low[i] : value.high[i - lane_count];
}
inline LanePair load(const FieldView& values, int c, int first, int count, const LanePair&) {
  if (count > lane_count)
    return {
        load(values, c, first, lane_count, Lanes{}),
        load(values, c, first + lane_count, count - lane_count, Lanes{})};
  return {load(values, c, first, count, Lanes{}), load(values, c, first + count - 1, 1, Lanes{})};
}
inline void store(const LanePair& value, const FieldView& values, int c, int first, int count) {
  store(value.low, values, c, first, count < lane_count ? count : lane_count);
  if (count > lane_count) store(value.high, values, c, first + lane_count, count - lane_count);
}
#endif

/// Component c of `count` rows from `first` on.
template <class R>
KOKKOS_INLINE_FUNCTION R load(const FieldView& values, int c, int first, int count) {
  return load(values, c, first, count, R{});
}

/// Whether R has halves, low and high, and of which type.
template <class R, class = void>
inline constexpr bool in_halves = false;
template <class R>
inline constexpr bool in_halves<R, std::void_t<decltype(R::low)>> = true;
template <class R>
using HalfOf = decltype(R::low);

/// decide(i) for every lane as a mask.
template <class R, class Decide>
KOKKOS_INLINE_FUNCTION MaskOf<R> mask_of(const Decide& decide) {
  if constexpr (width<R> == 1) {
    return decide(0);
  } else if constexpr (in_halves<R>) {
    constexpr int half = width<R> / 2;
    return {
        mask_of<HalfOf<R>>(decide), mask_of<HalfOf<R>>([&](int i) { return decide(half + i); })};
  } else {
    MaskOf<R> out;
    for (int i = 0; i < width<R>; ++i) out[i] = decide(i) ? -1 : 0;
    return out;
  }
}

}  // namespace barreno
