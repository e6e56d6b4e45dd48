// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/points.hpp"
#include "base/rows.hpp"
#include "base/whole_sum.hpp"

#include <cmath>

namespace barreno {

/// Sizes that numbers of about one size are split by, see RowSum. They must not depend on which
/// rows a rank has.
struct SplitSizes {
  double first = 1.0, second = 1.0;  ///< adding and subtracting these rounds to a quantum
  double top = 0.0;                  ///< numbers from here on are not split

  SplitSizes() : SplitSizes(1.0) {}
  /// @param size  what numbers are expected to be smaller than; 2^13 times as much is split too
  explicit SplitSizes(double size) {
    constexpr int digits_above = 31, digits_below = 76;
    const double power = std::exp2(std::ceil(std::log2(size)));
    const auto rounder = [&](int digits) { return 1.5 * std::ldexp(power, 52 - digits); };
    first = rounder(digits_above);
    second = rounder(digits_below);
    top = std::ldexp(power, 13);
  }
};

/// Most rows of a RowSum, so that its parts are exact.
inline constexpr int most_summed_rows = 512;

/// The sum of a few rows, in lanes and without any rounding that depends on their order: each
/// number is split into whole multiples of two fixed quanta, 2^-31 and 2^-76 of the expected size,
/// and sums of so few of these are exact in double. What is below is rounded number by number.
/// Source: J. Demmel, H. D. Nguyen, IEEE Trans. Comput. 64 (2015) 2060-2070.
template <class R>
struct RowSum {
  R high{}, low{};

  /// @param beyond  takes numbers that are too large to be split
  KOKKOS_INLINE_FUNCTION void add(R number, const SplitSizes& sizes, WholeSum& beyond) {
    const MaskOf<R> fits = real::abs(number) < sizes.top;
    if (!real::all(fits)) {
      for (int i = 0; i < width<R>; ++i)
        if (entry(fits, i) == 0) beyond += entry(number, i);
      number = real::select(fits, number, 0.0);
    }
    const R rounded = (number + sizes.first) - sizes.first;
    const R rest = number - rounded;
    high += rounded;
    low += (rest + sizes.second) - sizes.second;
  }
  KOKKOS_INLINE_FUNCTION void add_to(WholeSum& sum) const {
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

/// The numbers of a run of rows; those from `count` on are not looked at.
KOKKOS_INLINE_FUNCTION void add_run(
    const double (&numbers)[rows_per_run], int count, const SplitSizes& sizes, WholeSum& sum
) {
  RowSum<RowReal> part;
  for (int k = 0; k < count; k += width<RowReal>) {
    RowReal some{};
    const int left = count - k < width<RowReal> ? count - k : width<RowReal>;
    std::memcpy(&some, numbers + k, static_cast<std::size_t>(left) * sizeof(double));
    part.add(some, sizes, sum);
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
