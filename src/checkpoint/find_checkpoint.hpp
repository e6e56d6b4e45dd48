// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "base/run_numbers.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace barreno {

/// The newest whole checkpoint of a run folder, found and kept open but not read yet.
struct Checkpoint {
  std::filesystem::path file;
  std::shared_ptr<const Hdf5File> open;  ///< the file whose seal was compared; on every rank
  std::string deck_text;                 ///< the effective deck that it belongs to
  RunNumbers numbers;                    ///< for_each_number, and "cavities"
  RunNumbers output;                     ///< where the other files were, see Output::position
  RunNumbers continued;                  ///< of a run that continues another one (read_continued)
  std::string continued_names;           ///< likewise
  std::vector<std::string> notes;        ///< why a newer file was passed over
  std::vector<std::filesystem::path> damaged;  ///< those files
};

/// The newest file whose seal and version are right: of checkpoint.h5.tmp, which a run that was
/// killed between sealing and renaming it has left, checkpoint.h5 and checkpoint_previous.h5. A
/// broken one is passed over with a note. Every rank reads an equal part of a file for its seal.
/// Collective. @throws FileError on every rank if there is none
Checkpoint find_checkpoint(const Comm& comm, const std::filesystem::path& folder);

/// Gives the found file the name checkpoint.h5, and those that were passed over the names
/// checkpoint_damaged.h5 and checkpoint_previous_damaged.h5, so that the next checkpoint does not
/// replace the only good one. Collective. @throws FileError on every rank
void settle_checkpoints(const Comm& comm, const Checkpoint& checkpoint);

/// The first line in which two effective decks differ, but for their end times: a sentence's part,
/// empty if there is none.
std::string deck_difference(const std::string& kept, const std::string& found);

}  // namespace barreno
