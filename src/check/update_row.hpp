// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "check/cost_tables.hpp"

#include <barreno/models.hpp>
#include <optional>
#include <string>

namespace barreno {

/// Row of CostTables::updates for a material: the label of its update (stress_label), and where
/// one form serves laws of quite different cost, which of them.
std::string update_row(const Material& material);

/// What the material's update costs in the first steps and over a run; nothing where the tables
/// have no row.
std::optional<UpdateCost> update_cost(
    const Material& material, const CostTables& tables = cost_tables()
);

}  // namespace barreno
