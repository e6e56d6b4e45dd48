// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/seal.hpp"

#include "base/error.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <libdeflate.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

using Block = std::array<char, user_block>;

/// The user block that belongs to the bytes behind it.
Block seal_of(int file) {
  std::vector<char> buffer(1 << 20);
  std::uint32_t digest = libdeflate_crc32(0, nullptr, 0);
  unsigned long long bytes = 0;
  for (;;) {
    const auto place = static_cast<off_t>(user_block + bytes);
    const ssize_t count = pread(file, buffer.data(), buffer.size(), place);
    if (count <= 0) break;  // a file that cannot be read to its end does not have its digest
    digest = libdeflate_crc32(digest, buffer.data(), static_cast<std::size_t>(count));
    bytes += static_cast<unsigned long long>(count);
  }
  Block block{};
  std::snprintf(
      block.data(), block.size(), "barreno checkpoint\nbytes %llu\ncrc32 %08x\n", bytes, digest
  );
  return block;
}

std::string broken_seal(int file) {
  if (file < 0) return std::string("it cannot be opened: ") + std::strerror(errno);
  struct stat found {};
  if (fstat(file, &found) != 0 || !S_ISREG(found.st_mode)) return "it is not a regular file";
  Block block{};
  if (pread(file, block.data(), block.size(), 0) != static_cast<ssize_t>(block.size()))
    return "it is truncated";
  if (std::strncmp(block.data(), "barreno checkpoint\n", 19) != 0)
    return "it is not a checkpoint of this program";
  return seal_of(file) == block ? std::string() : "its contents are not what was written";
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw FileError(
      "cannot write the checkpoint '" + path.string() + "' (" + std::strerror(errno) +
      "); free disk space or choose another folder with --out."
  );
}

}  // namespace

void seal_checkpoint(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDWR);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (file < 0) refuse(path);
  const Block block = seal_of(file);
  const bool fine =
      pwrite(file, block.data(), block.size(), 0) == static_cast<ssize_t>(block.size()) &&
      fsync(file) == 0;
  const int why = errno;
  close(file);
  errno = why;
  if (!fine) refuse(path);
}

// A pipe of that name is not waited for.
SealedFile::SealedFile(const std::filesystem::path& path)
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)), fault_(broken_seal(file_)) {}

SealedFile::~SealedFile() {
  if (file_ >= 0) close(file_);
}

void sync_folder(const std::filesystem::path& folder) {
  const std::filesystem::path name = folder.empty() ? "." : folder;
  const int handle = open(name.c_str(), O_RDONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (handle < 0) return;
  fsync(handle);
  close(handle);
}

}  // namespace barreno
