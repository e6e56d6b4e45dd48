// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "deck/table.hpp"

#include <vector>

namespace barreno {

/// Several functions of time (Table) as kernels read them.
struct TimeTables {
  ArrayView<int> first;  ///< entry of every table, and the end
  ArrayView<double> time, value;

  /// The same number as Table::operator().
  KOKKOS_INLINE_FUNCTION double operator()(int table, double t) const {
    const int begin = first(table);
    const int end = first(table + 1);
    int after = begin;  // first entry later than t
    for (int count = end - begin; count > 0;) {
      const int half = count / 2;
      const bool later = t < time(after + half);
      after += later ? 0 : half + 1;
      count = later ? half : count - half - 1;
    }
    if (after == begin) return value(begin);
    if (after == end) return value(end - 1);
    const double share = (t - time(after - 1)) / (time(after) - time(after - 1));
    return value(after - 1) + share * (value(after) - value(after - 1));
  }
};

TimeTables make_time_tables(const std::vector<Table>& tables);

}  // namespace barreno
