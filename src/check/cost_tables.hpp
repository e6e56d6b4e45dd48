// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace barreno {

/// What runs were measured to cost, from src/measured/update_costs.csv and cost_factors.csv, which
/// say how.

/// Time of a material's update, per particle-step.
struct UpdateCost {
  double elastic = 0.0, running = 0.0;  ///< ns in the first steps, and on average over a run
  bool is_early = false;                ///< the run ended early: in a longer one more rock flows
};

struct CostTables {
  std::string problem;  ///< why nothing is known, for a sentence; empty: it is
  std::map<std::string, UpdateCost> updates;  ///< by the row of a material (check/update_row.hpp)
  double domains = 0.0;                       ///< growth of the work on domains that deform
  double rotations = 0.0;                     ///< growth of that on rotations of three dimensions
  double nodes_of_parts = 0.0;  ///< nodes and cells of a part of a step, over those in the probe
  /// Parts of a perforation's steps over those that the flight of its first slug would ask for to
  /// the end.
  double parts_of_flight = 0.0;
  double field_nanoseconds = 0.0;  ///< of a particle in an instant of particles.e [ns]
  double row_nanoseconds = 0.0;    ///< of a particle in a row of history.csv [ns]
};

/// @param folder  of the files; empty: where they are installed. Files that are missing or broken
///                give a problem and no numbers; a material without a row is why_cost_unknown()'s.
CostTables read_cost_tables(const std::filesystem::path& folder = {});

/// Those that are installed, read once.
const CostTables& cost_tables();

}  // namespace barreno
