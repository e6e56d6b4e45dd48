// SPDX-License-Identifier: BSD-3-Clause
#include "state/step_shares.hpp"

#include <algorithm>
#include <cassert>

namespace barreno {

std::vector<double> values_of(const StepShares& shares) {
  std::vector<double> values(shares.of_level, shares.of_level + max_level + 1);
  values.insert(values.end(), shares.of_length, shares.of_length + step_lengths);
  return values;
}

StepShares shares_of(const std::vector<double>& values) {
  assert(values.size() == max_level + 1 + step_lengths);
  StepShares shares;
  std::copy_n(values.begin(), max_level + 1, shares.of_level);
  std::copy_n(values.begin() + max_level + 1, step_lengths, shares.of_length);
  return shares;
}

}  // namespace barreno
