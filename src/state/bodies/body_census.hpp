// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "grid/partition.hpp"
#include "state/bodies/body_particles.hpp"

#include <Teuchos_RCP.hpp>

#include <vector>

namespace barreno {

/// What is known of the particles of a scene before any is made. Ids follow from the counts, so
/// that they do not depend on the ranks.
struct BodyCensus {
  std::vector<long long> counts;  ///< particles of every body, then of every slug of the jet
  std::vector<ParticleId> first;  ///< their first ids, and one past the last (first_ids)
  /// By body: of its particles, those that are in the shares of lower ranks (lattice_shares.hpp).
  std::vector<long long> before;
  std::vector<ParcelCost> parcels;  ///< their particles
};

/// Every rank counts boxes by the places along their axes, and its equal share of the cells of
/// other bodies. Collective.
BodyCensus take_census(const Scene& scene, const Teuchos::RCP<const Comm>& comm);

}  // namespace barreno
