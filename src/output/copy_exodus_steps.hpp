// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/exodus_file.hpp"

#include <filesystem>
#include <vector>

namespace barreno {

/// Reads the coordinates and radii of a file that goes on, which are those of the start.
/// @param steps   so many it must have
/// @param layout  of the same file but for these two
/// @throws FileError if the old file is not whole, or holds fewer steps or other nodes
void read_exodus_start(
    const std::filesystem::path& from, int steps, int dimensions, ExodusLayout& layout
);

/// Copies the first time steps of a file of the same layout. @return the displacements of the last
/// one, an array per direction
/// @throws FileError if the old file is not whole, or holds fewer steps
std::vector<std::vector<double>> copy_exodus_steps(
    const std::filesystem::path& from, const ExodusLayout& layout, int steps, ExodusFile& to
);

}  // namespace barreno
