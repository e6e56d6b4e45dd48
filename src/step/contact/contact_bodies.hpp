// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/boundary/symmetry_planes.hpp"

#include <vector>

namespace barreno {

/// Bodies that may meet, by their velocity fields, and the planes that mirror them.
struct ContactBodies {
  const Grid& grid;
  const VelocityFields& fields;
  const std::vector<Particles>& sets;
  const SymmetryPlanes& planes;
};

}  // namespace barreno
