// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

#include <functional>
#include <string>

namespace barreno {

/// What no run can have written into a checkpoint's single numbers (groups run and output): a
/// sentence's part that names the first such; empty if there is none.
std::string fault_of_numbers(const Scene& scene, const State& state, const Checkpoint& checkpoint);

/// The same of the group run alone.
std::string fault_of_run_numbers(
    const Scene& scene, const State& state, const Checkpoint& checkpoint
);

/// Runs a check of a checkpoint's tables. @throws FileError in the place of a WrongTable: it names
/// the file, and says what can be done
void name_checkpoint(const Checkpoint& checkpoint, const std::function<void()>& check);

/// Looks at what is small in a checkpoint before anything is done with it (its numbers, sums and
/// owners of tiles), at every value that indexes, divides or must be positive, and at the sizes of
/// all tables; read_checkpoint looks at the rows of particles. A seal tells damage, not who wrote
/// the file. Rank 0 reads. Collective.
/// @param state  as build_empty_state made it from the checkpoint's deck
/// @throws FileError on every rank, which names the table
void check_checkpoint(const Scene& scene, const State& state, const Checkpoint& checkpoint);

}  // namespace barreno
