// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "scene/scene.hpp"
#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <string>

namespace barreno {

/// What no run can have written into a checkpoint's single numbers (groups run and output): a
/// sentence's part that names the first such; empty if there is none.
std::string fault_of_numbers(const Scene& scene, const State& state, const Checkpoint& checkpoint);

/// Looks at every table of a checkpoint before anything is done with it: its size, its kind, and
/// every value that indexes, divides or must be positive. A seal tells damage, not who wrote the
/// file. Particles that are to be removed in the next step may have any values. Every rank looks at
/// an equal part of the rows of particles. Collective.
/// @param ids    that particles may have (particle_id_ranges)
/// @param state  as build_state made it from the checkpoint's deck
/// @throws FileError on every rank, which names the table
void check_checkpoint(
    const Scene& scene,
    const std::vector<IdRange>& ids,
    const State& state,
    const Checkpoint& checkpoint
);

}  // namespace barreno
