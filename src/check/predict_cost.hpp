// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
/// The same of each material in the smallest cells.
std::vector<double> stable_steps_of_materials(const Scene& scene, bool viscous);

/// What a run will cost on a number of ranks: particle-steps by the stable step and by the launch
/// of each slug, times what the probe's particles took, times what flow will add to their
/// materials.
/// @param counts  particles of every body and slug (particle_counts, or those of a BodyCensus)
Prediction predict_cost(
    const Scene& scene, const Probe& probe, const std::vector<long long>& counts, int ranks
);

/// How many times as long as in the probe a verb will take over the run, as measured in runs
/// (check/cost_growth.hpp): stresses of what flows cost more than those of the first steps.
double growth_of(const Scene& scene, const std::string& verb);

}  // namespace barreno
