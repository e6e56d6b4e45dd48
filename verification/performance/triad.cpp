// SPDX-License-Identifier: BSD-3-Clause
#include "triad.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace barreno {

double measure_triad() {
  constexpr std::size_t n = 20000000;
  std::vector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  double best = 0.0;
  for (int repeat = 0; repeat < 6; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    const double s = 3.0 + repeat;
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    // The first pass meets cold pages. Reading a result keeps the loop from being dropped.
    if (repeat > 0 && a[n / 2] > 0.0)
      best = std::max(best, 24.0 * static_cast<double>(n) / seconds.count());
  }
  return best;
}

}  // namespace barreno
