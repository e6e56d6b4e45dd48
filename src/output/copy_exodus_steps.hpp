// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/exodus_file.hpp"

#include <filesystem>
#include <vector>

namespace barreno {

/// @throws FileError if an old file is not whole, or holds fewer time steps
void refuse_fewer_steps(const std::filesystem::path& file, int steps);

/// Copies the first time steps of a file of the same layout. @return the displacements of the last
/// one, an array per direction
/// @throws FileError if the old file is not whole, or holds fewer steps
std::vector<std::vector<double>> copy_exodus_steps(
    const std::filesystem::path& from, const ExodusLayout& layout, int steps, ExodusFile& to
);

}  // namespace barreno
