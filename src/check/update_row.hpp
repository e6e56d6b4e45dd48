// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "check/cost_growth.hpp"

#include <barreno/models.hpp>
#include <string>

namespace barreno {

/// Row of check/cost_growth.hpp for a material: the label of its update (stress_label), and where
/// one form serves laws of quite different cost, which of them.
std::string update_row(const Material& material);

/// What the material's update costs in the first steps and over a run. Throws std::out_of_range
/// where the table has no row.
const UpdateCost& update_cost(const Material& material);

}  // namespace barreno
