// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/body_particles.hpp"
#include "state/state.hpp"

namespace barreno {

/// Scene at t = 0: the grid and the bodies' particles, each on the rank that owns its tile, sorted.
/// Bodies under an initial pressure start in equilibrium: stress, history and density of that
/// pressure.
/// @throws NumericalError if a material cannot hold its body's initial pressure elastically
State build_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// Add one particle to its set; counts nothing in the ledger.
/// @return its row
int add_particle(
    const Scene& scene,
    Particles& particles,
    const NewParticle& made,
    unsigned body,
    const Vector& velocity
);

}  // namespace barreno
