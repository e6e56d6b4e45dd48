// SPDX-License-Identifier: BSD-3-Clause
#include "deck/table.hpp"

#include <algorithm>

namespace barreno {

double Table::operator()(double t) const {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (after == time.begin()) return value.front();
  if (after == time.end()) return value.back();
  const auto i = static_cast<std::size_t>(after - time.begin());
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + share * (value[i] - value[i - 1]);
}

}  // namespace barreno
