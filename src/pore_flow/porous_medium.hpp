// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <vector>

namespace barreno {

/// What the pore flow reads of a run: the rock, and what fills the cells beside it.
struct PorousMedium {
  const PoreFlowSpec& flow;
  const std::vector<MaterialSpec>& materials;
  const Grid& grid;
  const std::vector<Particles>& particles;
  int jet_material = -1;  ///< flows: what it fills is open to the fluid
  double time = 0.0, end_time = 0.0;

  const MaterialSpec& material_of(const Particles& set) const {
    return materials[static_cast<std::size_t>(set.material)];
  }
};

inline PorousMedium porous_medium(const Scene& scene, const State& state) {
  return {
      scene.pore_flow,
      scene.materials,
      state.grid,
      state.particles,
      scene.jet.present ? scene.jet.material : -1,
      state.clock.time,
      scene.end_time};
}

}  // namespace barreno
