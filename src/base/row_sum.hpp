// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/points.hpp"
#include "base/reproducible_sum.hpp"
#include "base/rows.hpp"
#include "base/split_scales.hpp"

#include <cstring>

namespace barreno {

/// The sum of a few rows, in lanes and without any rounding that depends on their order: each
/// number is split into whole multiples of two fixed quanta, 2^-31 and 2^-76 of the expected size,
/// and sums of so few of these are exact in double. What is below is rounded number by number.
/// Source: J. Demmel, H. D. Nguyen, IEEE Trans. Comput. 64 (2015) 2060-2070.
template <class R>
struct RowSum {
  R high{}, low{};

  KOKKOS_INLINE_FUNCTION static MaskOf<R> fits(const R& number, const SplitScales& scales) {
    return real::abs(number) < scales.top;
  }
  /// @pre it fits
  KOKKOS_INLINE_FUNCTION void split(const R& number, const SplitScales& scales) {
    const R rounded = (number + scales.first) - scales.first;
    const R rest = number - rounded;
    high += rounded;
    low += (rest + scales.second) - scales.second;
  }
  /// @param beyond  takes numbers that are too large to be split
  KOKKOS_INLINE_FUNCTION void add(
      const R& number, const SplitScales& scales, ReproducibleSum& beyond
  ) {
    const MaskOf<R> small = fits(number, scales);
    if (real::all(small)) return split(number, scales);
    for (int i = 0; i < width<R>; ++i)
      if (entry(small, i) == 0) beyond += entry(number, i);
    split(real::select(small, number, 0.0), scales);
  }
  KOKKOS_INLINE_FUNCTION void add_to(ReproducibleSum& sum) const {
    double total_high = 0.0, total_low = 0.0;
    for (int i = 0; i < width<R>; ++i) {
      total_high += entry(high, i);
      total_low += entry(low, i);
    }
    sum += total_high;
    sum += total_low;
  }
};

/// Real numbers of a kernel that may take several rows at once.
#if BARRENO_HAS_LANES
using RowReal = Lanes;
#else
using RowReal = double;
#endif

/// Adds the numbers of a chunk of rows. Those from `count` on are ignored and overwritten by zeros.
KOKKOS_INLINE_FUNCTION void add_chunk(
    double (&numbers)[rows_per_chunk], int count, const SplitScales& scales, ReproducibleSum& sum
) {
  constexpr int step = width<RowReal>;
  for (int k = count; k % step != 0; ++k) numbers[k] = 0.0;
  const auto some = [&](int k) {
    RowReal value;
    std::memcpy(&value, numbers + k, sizeof value);
    return value;
  };
  RowSum<RowReal> part;
  MaskOf<RowReal> small = RowSum<RowReal>::fits(RowReal{}, scales);
  for (int k = 0; k < count; k += step) {
    const RowReal value = some(k);
    small = small & RowSum<RowReal>::fits(value, scales);
    part.split(value, scales);
  }
  if (!real::all(small)) {
    part = {};
    for (int k = 0; k < count; k += step) part.add(some(k), scales, sum);
  }
  part.add_to(sum);
}

/// A reducer of Kokkos for tallies with an add(from, to).
template <class Tally>
struct TallyReducer {
  using reducer = TallyReducer;
  using value_type = Tally;
  using result_view_type = Kokkos::View<value_type, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  explicit TallyReducer(value_type& value) : value_(&value) {}
  KOKKOS_INLINE_FUNCTION void join(value_type& to, const value_type& from) const { add(from, to); }
  KOKKOS_INLINE_FUNCTION void join(volatile value_type& to, const volatile value_type& from) const {
    join(const_cast<value_type&>(to), const_cast<const value_type&>(from));
  }
  KOKKOS_INLINE_FUNCTION void init(value_type& value) const { value = value_type{}; }
  KOKKOS_INLINE_FUNCTION value_type& reference() const { return *value_; }
  result_view_type view() const { return result_view_type(value_); }
  KOKKOS_INLINE_FUNCTION bool references_scalar() const { return true; }

private:
  value_type* value_;
};

}  // namespace barreno
