// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace barreno {

/// A file that rank 0 has laid out, into which every rank writes its own bytes. Every function
/// throws FileError with the path and the system's reason if it fails.
class RowFile {
public:
  /// @param path  of a file that exists; a link is not followed
  explicit RowFile(const std::filesystem::path& path);
  ~RowFile();
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  /// Writes bytes from a place of the file on, and notes their CRC-32.
  void write(const void* bytes, std::size_t count, unsigned long long place);
  /// Reads all that write() wrote, and compares.
  void read_back() const;
  /// Brings this rank's bytes to the disk (fsync).
  void sync() const;

private:
  struct Piece {
    unsigned long long place;
    std::size_t count;
    std::uint32_t crc;
  };
  [[noreturn]] void refuse(const char* why) const;
  void begin_flush();

  std::filesystem::path path_;
  int file_;
  std::vector<Piece> pieces_;
  std::size_t unflushed_ = 0;  ///< bytes since begin_flush()
};

}  // namespace barreno
