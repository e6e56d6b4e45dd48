// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace barreno {

/// Numbers of a run by name, exact as doubles.
using RunNumbers = std::map<std::string, std::vector<double>>;

/// The number of that name, 0 if there is none.
inline double number_of(const RunNumbers& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  return found == numbers.end() || found->second.empty() ? 0.0 : found->second.front();
}

}  // namespace barreno
