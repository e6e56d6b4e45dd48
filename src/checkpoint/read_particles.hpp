// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "scene/scene.hpp"
#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// What rows of particles are compared with while they are read.
struct KnownRun {
  const Scene& scene;
  const std::vector<IdRange>& ids;  ///< that particles may have (particle_id_ranges)
  const Checkpoint& checkpoint;     ///< its tables have their sizes (check_checkpoint)
  const Grid& grid;
  const JetState& jet;
};

/// Reads this rank's rows of a material, table by table and each row once, and looks at every value
/// before it is taken: a number that indexes, divides or must be positive. Particles that are to be
/// removed in the next step may have any values. What is in a set is replaced. Collective.
/// @param rows  ascending; of all ranks together, every row once
/// @throws WrongTable, FileError  on every rank: of the lowest row of the first table that has one
void read_particles(
    const KnownRun& run, const std::vector<std::size_t>& rows, Particles& particles
);

}  // namespace barreno
