// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/lane_pair.hpp"
#include "barreno/lanes.hpp"

#include <cstddef>
#include <limits>

/// One source for one point and for several at once: templates over R, which is double, Lanes
/// or LanePair.
///
/// Lanes are eight doubles in vector registers. Every lane goes its own way: its result depends
/// neither on the other lanes nor on its place. Where there are no vector extensions (devices),
/// codes take the double.
namespace barreno {

template <class R>
struct MaskOfReal {
  using type = decltype(R{} < R{});
};
/// Outcome of a comparison: bool, or one for each lane.
template <class R>
using MaskOf = typename MaskOfReal<R>::type;

/// What follows from the functions of double, Lanes and LanePair.
namespace real {

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
