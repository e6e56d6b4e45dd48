// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "grid/partition.hpp"
#include "state/bodies/body_particles.hpp"

#include <functional>
#include <vector>

namespace barreno {

/// Adds the particles of a body that is a box to those of the parcels that hold them. Looks at the
/// places along the axes alone.
void count_box_in_parcels(
    const Scene& scene, const BodySpec& body, const Grid& grid, std::vector<ParcelCost>& parcels
);

/// The particles of a box in the tiles of this rank, in the order of their ids, which count from 0
/// over the whole box. The places of other tiles are not looked at.
void for_each_own_box_particle(
    const Scene& scene,
    const BodySpec& body,
    const Grid& grid,
    const std::function<void(const NewParticle&)>& visit
);

}  // namespace barreno
