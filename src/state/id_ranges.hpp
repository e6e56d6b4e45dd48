// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace barreno {

/// Consecutive ids that particles of one material have or will have.
struct IdRange {
  int material = 0;      ///< index into Scene::materials
  ParticleId first = 1;  ///< ids are positive
  long long count = 0;
};

/// Ids of all particles of the run, those that the jet is still to launch included. Files keep a
/// place for each from the start, so that their layout does not change during the run.
/// @param first  ids of all bodies and slugs, and one past the last (first_ids)
std::vector<IdRange> particle_id_ranges(const Scene& scene, const std::vector<ParticleId>& first);

}  // namespace barreno
