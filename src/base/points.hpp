// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <barreno/real.hpp>
#include <cstring>

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
#endif

/// Component c of `count` rows from `first` on.
template <class R>
KOKKOS_INLINE_FUNCTION R load(const FieldView& values, int c, int first, int count) {
  return load(values, c, first, count, R{});
}

/// decide(i) for every lane as a mask.
template <class R, class Decide>
KOKKOS_INLINE_FUNCTION MaskOf<R> mask_of(const Decide& decide) {
  if constexpr (width<R> == 1) {
    return decide(0);
  } else {
    MaskOf<R> out;
    for (int i = 0; i < width<R>; ++i) out[i] = decide(i) ? -1 : 0;
    return out;
  }
}

}  // namespace barreno
