// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// A file without a name in the memory of this machine. It takes the place of the file that HDF5
/// has created, so that no write of
/// HDF5 meets a full or broken disk: HDF5 cannot close a file whose writes failed, and the process
/// would crash in HDF5 when it ends. Holes cost no memory.
class MemoryFile {
public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  bool failed() const { return file_ < 0; }
  /// Takes the place of an open file, with its contents so far. @return false on failure
  bool replace(int file) const;
  /// Copies the contents, holes left out, into an empty file. @return false, with errno, on failure
  bool copy_to(int target) const;

private:
  int file_;
};

}  // namespace barreno
