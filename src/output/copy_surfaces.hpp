// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"

#include <filesystem>
#include <vector>

namespace barreno {

/// Brings the surface files of a deck into the folder of its run, under the names that its
/// effective deck gives them: the run can be resumed, and its deck run again, whatever becomes of
/// the originals. Root only. @throws FileError if one cannot be read, has changed since the deck
/// was read, or cannot be written
void copy_surfaces(const std::vector<SurfaceFile>& files, const std::filesystem::path& folder);

}  // namespace barreno
