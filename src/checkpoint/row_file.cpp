// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/row_file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <libdeflate.h>
#include <unistd.h>

namespace barreno {
namespace {

/// Written bytes that are worth to be handed to the disk.
constexpr std::size_t flush_bytes = 1 << 23;

}  // namespace

RowFile::RowFile(const std::filesystem::path& path)
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    : path_(path), file_(open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC)) {
  if (file_ < 0) refuse(std::strerror(errno));
}

RowFile::~RowFile() {
  if (file_ >= 0) close(file_);
}

void RowFile::refuse(const char* why) const {
  throw FileError(
      "cannot write the checkpoint '" + path_.string() + "' (" + why +
      "); free disk space or choose another folder with --out."
  );
}

void RowFile::write(const void* bytes, std::size_t count, unsigned long long place) {
  const char* next = static_cast<const char*>(bytes);
  for (std::size_t left = count; left > 0;) {
    const auto at = static_cast<off_t>(place + (count - left));
    const ssize_t written = pwrite(file_, next, left, at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(std::strerror(errno));
    if (written == 0) refuse("the disk did not accept all of it");
    next += written;
    left -= static_cast<std::size_t>(written);
  }
  pieces_.push_back({place, count, libdeflate_crc32(0, bytes, count)});
  unflushed_ += count;
  if (unflushed_ >= flush_bytes) begin_flush();
}

/// The disk takes what is written while more is packed. This keeps nothing safe (sync() does, and
/// has less to wait for), so nothing is lost where it cannot be had.
void RowFile::begin_flush() {
  unflushed_ = 0;
#ifdef SYNC_FILE_RANGE_WRITE
  sync_file_range(file_, 0, 0, SYNC_FILE_RANGE_WRITE);
#endif
}

void RowFile::read_back() const {
  std::vector<char> bytes;
  for (const Piece& piece : pieces_) {
    bytes.resize(std::max(bytes.size(), piece.count));
    std::size_t found = 0;
    while (found < piece.count) {
      const auto at = static_cast<off_t>(piece.place + found);
      const ssize_t count = pread(file_, bytes.data() + found, piece.count - found, at);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;  // then the digest is another one
      found += static_cast<std::size_t>(count);
    }
    if (found != piece.count || libdeflate_crc32(0, bytes.data(), found) != piece.crc)
      refuse("what is read back is not what was written");
  }
}

void RowFile::sync() const {
  if (fsync(file_) != 0) refuse(std::strerror(errno));
}

}  // namespace barreno
