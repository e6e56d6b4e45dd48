// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <filesystem>
#include <string>

namespace barreno {

/// Writes length and CRC-32 of all bytes behind the user block into it, and brings the file to the
/// disk (fsync). @throws FileError
void seal_checkpoint(const std::filesystem::path& path);
/// The same, where every rank reads an equal part of the file. Collective. @throws FileError on
/// every rank
void seal_checkpoint(const Comm& comm, const std::filesystem::path& path);

/// A file whose length and digest were compared with its seal, every rank reading an equal part of
/// it, kept open: who reads it later can make sure that it is this file, and not one that has taken
/// its name since.
class SealedFile {
public:
  /// Collective. @throws FileError on every rank, where not all see the same file
  SealedFile(const Comm& comm, const std::filesystem::path& path);
  ~SealedFile();
  SealedFile(const SealedFile&) = delete;
  SealedFile& operator=(const SealedFile&) = delete;
  /// What is wrong with it, the same on every rank; empty if the seal is right.
  const std::string& fault() const { return fault_; }
  int handle() const { return file_; }  ///< of the system

private:
  int file_;
  std::string fault_;
};

/// Brings the names in a folder to the disk.
void sync_folder(const std::filesystem::path& folder);

}  // namespace barreno
