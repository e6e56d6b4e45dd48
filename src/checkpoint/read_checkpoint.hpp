// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "state/state.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// The newest whole checkpoint of a run folder, found but not read yet.
struct Checkpoint {
  std::filesystem::path file;
  std::string deck_text;           ///< the effective deck that it belongs to
  RunNumbers numbers;              ///< for_each_number, and "cavities"
  RunNumbers output;               ///< where the other files were, see Output::position
  std::vector<std::string> notes;  ///< why a newer file was passed over
};

/// The newest file whose seal and version are right; a broken one is passed over with a note.
/// Collective. @throws FileError on every rank if there is none
Checkpoint find_checkpoint(const Comm& comm, const std::filesystem::path& folder);

/// Sets a state that build_state made from the same deck to that of the checkpoint. On as many
/// ranks as wrote it every rank gets its own rows and sums back, and the run goes on bit for bit;
/// on another number tiles are shared anew and rank 0 takes the sums of all. Collective.
/// @throws FileError on every rank
void read_checkpoint(const Checkpoint& checkpoint, State& state);

/// The first line in which two effective decks differ, but for their end times: a sentence's part,
/// empty if there is none.
std::string deck_difference(const std::string& kept, const std::string& found);

}  // namespace barreno
