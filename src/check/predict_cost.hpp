// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "check/cost_tables.hpp"
#include "check/probe_cost.hpp"
#include "output/prediction.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// The step that the scene allows before anything has deformed, speeds of bodies and jet included
/// [time].
/// @param viscous  with the artificial viscosity that compression brings
double stable_step_of_scene(const Scene& scene, bool viscous);
/// The same of each material in the smallest cells; infinity without particles of it.
std::vector<double> stable_steps_of_materials(const Scene& scene, bool viscous);

/// What a run will cost on a number of ranks: particle-steps by the stable step and by the launch
/// of each slug, times what the probe's particles took, times what flow will add to their
/// materials.
/// @param counts  particles of every body and slug (particle_counts, or those of a BodyCensus)
Prediction predict_cost(
    const Scene& scene,
    const Probe& probe,
    const std::vector<long long>& counts,
    int ranks,
    const CostTables& tables = cost_tables()
);

/// How many times as long as in the probe a verb will take over the run, as measured in runs:
/// stresses of what flows cost more than those of the first steps. 1 where the tables know nothing,
/// which why_cost_unknown() says.
double growth_of(
    const Scene& scene, const std::string& verb, const CostTables& tables = cost_tables()
);

/// Why the measurements say nothing of this scene's cost, for a sentence; empty if they do.
std::string why_cost_unknown(const Scene& scene, const CostTables& tables = cost_tables());

}  // namespace barreno
