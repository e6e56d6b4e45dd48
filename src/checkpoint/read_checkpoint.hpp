// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "scene/scene.hpp"
#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Sets a state that build_empty_state made from the same deck to that of the checkpoint, each row
/// of particles being read by one rank, once, and looked at before it is taken (read_particles). On
/// as many ranks as wrote it every rank gets its own rows and sums back, and the run goes on bit
/// for bit; on another number tiles are shared anew and rank 0 takes the sums of all. Collective.
/// @param ids  that particles may have (particle_id_ranges)
/// @pre check_checkpoint found nothing wrong
/// @throws FileError on every rank
void read_checkpoint(
    const Scene& scene, const std::vector<IdRange>& ids, const Checkpoint& checkpoint, State& state
);

}  // namespace barreno
