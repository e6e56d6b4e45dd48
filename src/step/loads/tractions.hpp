// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <vector>

namespace barreno {

/// The tractions of a step: loads on surfaces, the particles whose faces they act on, and the nodes
/// that take their forces.
struct Tractions {
  const Grid& grid;
  const LoadTable& loads;
  const std::vector<Particles>& sets;
  const std::vector<Nodes>& nodes;
  const Subcycling& subcycling;
};
inline Tractions tractions_of(const State& state) {
  return {state.grid, state.loads, state.particles, state.nodes, state.subcycling};
}

}  // namespace barreno
