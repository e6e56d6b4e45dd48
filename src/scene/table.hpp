// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace barreno {

/// Piecewise-linear function of time, constant outside its range.
struct Table {
  std::vector<double> time{0.0}, value{0.0};
  double operator()(double t) const;
};

}  // namespace barreno
