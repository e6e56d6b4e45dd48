// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/checkpoint_contents.hpp"
#include "state/continued.hpp"
#include "state/state.hpp"

#include <filesystem>
#include <string>

namespace barreno {

inline constexpr int checkpoint_version = 10;
inline constexpr const char* checkpoint_name = "checkpoint.h5";
inline constexpr const char* checkpoint_temporary_name = "checkpoint.h5.tmp";
inline constexpr const char* previous_checkpoint_name = "checkpoint_previous.h5";

/// Writes the state to `folder`/checkpoint.h5, the one before becomes checkpoint_previous.h5. The
/// new file is written aside, closed, read back and compared with its checksums, sealed, brought to
/// the disk, and only then renamed: whatever happens, one whole checkpoint remains.
///
/// Rows are written as they are stored, rank after rank, so that the same number of ranks goes on
/// with the same rows. Rank 0 lays the file out, every rank writes its own rows (write_rows());
/// docs/checkpoints.md has the file's contents. Collective. @throws FileError on every rank
///
/// @param deck_text  the effective deck
/// @param output     where the other files of the run are (Output::position)
/// @param continued  what the run started with, if it continues another one
void write_checkpoint(
    const std::filesystem::path& folder,
    const std::string& deck_text,
    const RunNumbers& output,
    const State& state,
    const Continued& continued = {}
);

/// Gives a sealed checkpoint.h5.tmp its name; what had that name becomes checkpoint_previous.h5.
/// Root only. @throws FileError
void rename_checkpoint(const std::filesystem::path& folder);

}  // namespace barreno
