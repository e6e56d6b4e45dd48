// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <vector>

namespace barreno {

/// The bodies as a step finds them: particles in the cells of their grid, with the accounts of what
/// is lost on the way and of what each rank spends on them.
struct Continuum {
  Grid& grid;
  std::vector<Particles>& sets;
  OwnLedger& ledger;  ///< its `removed`
  Effort& effort;     ///< of this rank
};
inline Continuum continuum_of(State& state) {
  return {state.grid, state.particles, state.ledger, state.effort};
}

}  // namespace barreno
