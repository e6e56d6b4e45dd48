// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/memory_file.hpp"

#include <algorithm>
#include <cerrno>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

/// Bytes of one write.
constexpr std::size_t most_bytes = 1 << 20;

bool write_piece(int target, const char* bytes, std::size_t count, off_t place) {
  while (count > 0) {
    const ssize_t written = pwrite(target, bytes, count, place);
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
    place += written;
  }
  return true;
}

/// The bytes from begin to end.
bool copy_piece(int source, int target, off_t begin, off_t end) {
  if (begin == end) return true;
  std::vector<char> bytes(std::min(most_bytes, static_cast<std::size_t>(end - begin)));
  while (begin < end) {
    const std::size_t wanted = std::min(bytes.size(), static_cast<std::size_t>(end - begin));
    const ssize_t count = pread(source, bytes.data(), wanted, begin);
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;
    if (count <= 0 || !write_piece(target, bytes.data(), static_cast<std::size_t>(count), begin))
      return false;
    begin += count;
  }
  return true;
}

}  // namespace

MemoryFile::MemoryFile() : file_(memfd_create("checkpoint", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (file_ >= 0) close(file_);
}

bool MemoryFile::replace(int file) const {
  struct stat status {};
  if (fstat(file, &status) != 0) return false;
  return copy_piece(file, file_, 0, status.st_size) && dup2(file_, file) == file;
}

bool MemoryFile::copy_to(int target) const {
  struct stat status {};
  if (fstat(file_, &status) != 0) return false;
  off_t begin = lseek(file_, 0, SEEK_DATA);
  while (begin >= 0 && begin < status.st_size) {
    const off_t end = lseek(file_, begin, SEEK_HOLE);
    if (end < 0 || !copy_piece(file_, target, begin, end)) return false;
    begin = lseek(file_, end, SEEK_DATA);
  }
  if (begin < 0 && errno != ENXIO) return false;  // ENXIO: no data behind the last piece
  return ftruncate(target, status.st_size) == 0;
}

}  // namespace barreno
