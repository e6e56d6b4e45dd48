// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <filesystem>
#include <string>

namespace barreno {

/// What the command line says about the folder of a run.
struct RunFolderRequest {
  std::string out;         ///< --out; empty: runs/<deck name>-<counter>, new every time
  bool overwrite = false;  ///< --overwrite: the result that is in the folder is removed first
  std::string deck_name;   ///< file name of the deck without folder and extension
};

/// Chooses and creates the folder; collective, the same answer on every rank.
/// @throws FileError on every rank if it holds a result that may not be overwritten, or cannot be
/// had; then nothing is changed
std::filesystem::path create_run_folder(const Comm& comm, const RunFolderRequest& request);

/// Removes the results in a folder, and nothing else; for a run that holds its FolderLock.
/// Collective. @throws FileError on every rank if there is one that may not be overwritten
void clear_run_folder(const Comm& comm, const std::filesystem::path& folder, bool overwrite);

}  // namespace barreno
