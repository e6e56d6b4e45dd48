// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/particles.hpp"

#include <cstddef>
#include <vector>

namespace barreno {

/// How far the jet has been launched.
struct JetState {
  int body = 0;                      ///< what Particles::body holds of its particles
  std::vector<ParticleId> slug_ids;  ///< first id of every slug
  std::size_t next_slug = 0;         ///< first slug that is still to be launched
};

}  // namespace barreno
