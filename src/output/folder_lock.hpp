// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <filesystem>

namespace barreno {

inline constexpr const char* folder_lock_name = "run.lock";

/// Keeps other runs out of a run folder while this object lives: two runs that write the same files
/// would both be wrong.
///
/// The lock is the system's, on the file run.lock (open file description locks of fcntl, which also
/// work between hosts of a network disk): it ends with the processes that hold it, however they
/// end, and a file that stays behind locks nothing. Rank 0 holds byte 0 for itself and every rank
/// shares byte 1, so that the folder is free only when the last rank of a killed run is gone. The
/// file's text names process, host and time for whoever is refused.
class FolderLock {
public:
  /// Waits `wait_seconds` for another run to end, and says so on stderr. Collective.
  /// @throws FileError on every rank if the folder is still in use then, or cannot be written
  FolderLock(const Comm& comm, const std::filesystem::path& folder, double wait_seconds = max_wait);
  /// Frees the folder and removes the file.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

private:
  /// Ranks of a killed run live on for a moment.
  static constexpr double max_wait = 10.0;

  std::filesystem::path path_;
  int file_ = -1;
  bool root_;
};

}  // namespace barreno
