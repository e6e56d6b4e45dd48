// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/body_particles.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Scene at t = 0: the grid and the bodies' particles, each on the rank that owns its tile, sorted.
/// Bodies under an initial pressure start in equilibrium: stress, history and density of that
/// pressure.
/// @throws NumericalError if a material cannot hold its body's initial pressure elastically
State build_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// A particle at rest: found once for all that start alike.
struct StartPoint {
  Sym3 stress;
  std::vector<double> history;
  double volume_ratio = 1.0;
};

/// @param body  whose pressures the point is under; null: none
StartPoint start_point(const Scene& scene, int material, const BodySpec* body);

/// Add one particle to its set; counts nothing in the ledger.
/// @return its row
int add_particle(
    const Scene& scene,
    Particles& particles,
    const NewParticle& made,
    int body,
    const StartPoint& start,
    const Vector& velocity
);

}  // namespace barreno
