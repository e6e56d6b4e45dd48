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
#include <fstream>
#include <libdeflate.h>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

using Block = std::array<char, user_block>;

/// The user block that belongs to the bytes behind it.
Block seal_of(std::ifstream& stream) {
  std::vector<char> buffer(1 << 20);
  std::uint32_t digest = libdeflate_crc32(0, nullptr, 0);
  unsigned long long bytes = 0;
  stream.seekg(static_cast<std::streamoff>(user_block));
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    digest = libdeflate_crc32(digest, buffer.data(), count);
    bytes += count;
  }
  Block block{};
  std::snprintf(
      block.data(), block.size(), "barreno checkpoint\nbytes %llu\ncrc32 %08x\n", bytes, digest
  );
  return block;
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw FileError(
      "cannot write the checkpoint '" + path.string() + "' (" + std::strerror(errno) +
      "); free the disk or give another place with --out."
  );
}

}  // namespace

void seal_checkpoint(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const Block block = seal_of(stream);
  const int file = open(path.c_str(), O_WRONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (file < 0) refuse(path);
  const bool fine =
      pwrite(file, block.data(), block.size(), 0) == static_cast<ssize_t>(block.size()) &&
      fsync(file) == 0;
  const int why = errno;
  close(file);
  errno = why;
  if (!fine) refuse(path);
}

std::string broken_seal(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "it cannot be opened";
  Block found{};
  stream.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (!stream) return "it is cut off";
  if (std::strncmp(found.data(), "barreno checkpoint\n", 19) != 0)
    return "it is no checkpoint of this program";
  return seal_of(stream) == found ? std::string() : "its bytes are not those that were written";
}

void sync_folder(const std::filesystem::path& folder) {
  const std::filesystem::path name = folder.empty() ? "." : folder;
  const int handle = open(name.c_str(), O_RDONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (handle < 0) return;
  fsync(handle);
  close(handle);
}

}  // namespace barreno
