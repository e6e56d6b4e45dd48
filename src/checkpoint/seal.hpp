// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace barreno {

/// Writes length and CRC-32 of all bytes behind the user block into it, and brings the file to the
/// disk (fsync). @throws FileError
void seal_checkpoint(const std::filesystem::path& path);

/// What is wrong with a sealed file: empty if its length and its digest are those of the seal.
std::string broken_seal(const std::filesystem::path& path);

/// Brings the names in a folder to the disk.
void sync_folder(const std::filesystem::path& folder);

}  // namespace barreno
