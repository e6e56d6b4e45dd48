// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/drive_mixed.hpp"
#include "drive/drive_point.hpp"

#include <barreno/tensor.hpp>
#include <vector>

namespace barreno {

/// A driven point at one instant, in the axes of the material, whatever kind of path it came along.
struct DrivenState {
  double time;                  ///< [s]
  Sym3 strain;                  ///< logarithmic, from the first row [-]
  Sym3 stress;                  ///< Cauchy, tension positive [Pa]
  std::vector<double> history;  ///< in the order of the model's history table
};

/// Strains are ln U, F F0^-1 = R U with F0 that of the first row.
std::vector<DrivenState> states_of(const std::vector<DrivenRow>& rows);
std::vector<DrivenState> states_of(const std::vector<MixedAnswer>& answers);

}  // namespace barreno
