// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/bodies/body_census.hpp"
#include "state/bodies/body_particles.hpp"
#include "state/state.hpp"

#include <barreno/tensor.hpp>
#include <vector>

namespace barreno {

/// Scene at t = 0: the grid and the bodies' particles, each on the rank that owns its tile, sorted.
/// Bodies under an initial pressure start in equilibrium: stress, history and density of that
/// pressure.
/// Every rank makes the particles of its own tiles. Collective.
/// @param census  of the same scene and ranks
/// @throws NumericalError on every rank, if a material cannot hold its body's initial pressure
///         elastically, or an explosive has a part that is never lit
State build_state(
    const Scene& scene, const BodyCensus& census, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
);
/// The same without particles, all tiles being rank 0's: what a checkpoint is read into.
State build_empty_state(
    const Scene& scene, const BodyCensus& census, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
);
/// Scene at t = 0 with a census of its own.
State build_state(const Scene& scene, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// A particle before it moves: found once for all that start alike.
struct StartPoint {
  Sym3 stress;
  std::vector<double> history;
  double volume_ratio = 1.0;
  int per_cell = 1;  ///< particles of the body per cell and direction
};

/// @param body  whose pressures the point is under; null: none
StartPoint start_point(const MaterialSpec& material, const BodySpec* body);

/// The same of a metal with voids, without pressure: solid over mean density is `expansion`.
/// @pre  the material holds voids, or expansion is 1
StartPoint expanded_start_point(const MaterialSpec& material, double expansion);

/// Add particles to the set of their material, unplaced; counts nothing in the ledger.
/// @param body  of all: index into Scene::bodies, or their number for the jet
/// @return row of the first
int add_particles(
    const MaterialSpec& material,
    const std::vector<NewParticle>& made,
    int body,
    const StartPoint& start,
    Particles& particles
);

/// What the loads of a scene need of a particle: its loaded faces, and its shares in the pressures
/// on the surfaces of its ball.
/// @param made  the particle as its body was filled
void put_load_shares(
    const Scene& scene, int body, const NewParticle& made, int p, Particles& particles
);

}  // namespace barreno
