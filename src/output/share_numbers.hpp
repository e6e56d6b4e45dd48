// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/step_limits.hpp"
#include "state/step_shares.hpp"

#include <string>
#include <utility>
#include <vector>

namespace barreno {

/// What of the particle-steps belongs to a name [-].
using NamedShare = std::pair<std::string, double>;

/// By size of cell, "0.5 mm"; none where all steps were on a grid of equal cells with one step for
/// all.  @param cell_size  Grid/Cell Size [length]
std::vector<NamedShare> shares_by_cell_size(double cell_size, const StepShares& shares);

/// By length of step, "2 parts" of a step that was taken in parts (Step/Subcycles); none without.
std::vector<NamedShare> shares_by_step_length(const StepShares& shares);

/// By what set the length of the steps, of the time that they took.
std::vector<NamedShare> shares_of_limits(const Scene& scene, const StepLimits& limits);

/// "0.5 mm 83 %, 1 mm 17 %"
std::string share_text(const std::vector<NamedShare>& shares);

}  // namespace barreno
