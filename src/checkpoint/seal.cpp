// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/seal.hpp"

#include "base/error.hpp"
#include "base/rank_work.hpp"
#include "checkpoint/crc32.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <libdeflate.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

using Block = std::array<char, user_block>;

/// What a seal says of the bytes behind the user block.
struct Digest {
  unsigned long long bytes = 0;
  std::uint32_t crc = 0;
};

/// Of so many bytes from a place behind the user block on, or of those that can be read.
Digest digest_of(int file, unsigned long long first, unsigned long long most) {
  std::vector<char> buffer(1 << 20);
  Digest digest{0, libdeflate_crc32(0, nullptr, 0)};
  while (digest.bytes < most) {
    const auto place = static_cast<off_t>(user_block + first + digest.bytes);
    const std::size_t part = std::min<unsigned long long>(buffer.size(), most - digest.bytes);
    const ssize_t count = pread(file, buffer.data(), part, place);
    if (count <= 0) break;  // a file that cannot be read to its end does not have its digest
    digest.crc = libdeflate_crc32(digest.crc, buffer.data(), static_cast<std::size_t>(count));
    digest.bytes += static_cast<unsigned long long>(count);
  }
  return digest;
}

/// The user block that belongs to the bytes behind it.
Block seal_of(const Digest& digest) {
  Block block{};
  std::snprintf(
      block.data(),
      block.size(),
      "barreno checkpoint\nbytes %llu\ncrc32 %08x\n",
      digest.bytes,
      digest.crc
  );
  return block;
}

Digest digest_of(int file) {
  return digest_of(file, 0, std::numeric_limits<unsigned long long>::max());
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
  return seal_of(digest_of(file)) == block ? std::string()
                                           : "its contents are not what was written";
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw FileError(
      "cannot write the checkpoint '" + path.string() + "' (" + std::strerror(errno) +
      "); free disk space or choose another folder with --out."
  );
}

/// Open for reading and writing.
class OpenFile {
public:
  explicit OpenFile(const std::filesystem::path& path)
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
      : path_(path), file_(open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    if (file_ < 0) refuse(path);
  }
  ~OpenFile() { close(file_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int handle() const { return file_; }
  /// Behind the user block.
  unsigned long long bytes() const {
    struct stat found {};
    if (fstat(file_, &found) != 0 || found.st_size < static_cast<off_t>(user_block)) refuse(path_);
    return static_cast<unsigned long long>(found.st_size) - user_block;
  }

private:
  std::filesystem::path path_;
  int file_;
};

void put_seal(int file, const Digest& digest, const std::filesystem::path& path) {
  const Block block = seal_of(digest);
  const bool fine =
      pwrite(file, block.data(), block.size(), 0) == static_cast<ssize_t>(block.size()) &&
      fsync(file) == 0;
  if (!fine) refuse(path);
}

}  // namespace

void seal_checkpoint(const std::filesystem::path& path) {
  const OpenFile file(path);
  put_seal(file.handle(), digest_of(file.handle()), path);
}

void seal_checkpoint(const Comm& comm, const std::filesystem::path& path) {
  const auto ranks = static_cast<unsigned long long>(comm.getSize());
  const auto rank = static_cast<unsigned long long>(comm.getRank());
  RankWork work(comm);
  std::vector<long long> mine{0, 0};
  work.run([&] {
    const OpenFile file(path);
    const unsigned long long all = file.bytes(), begin = all / ranks * rank;
    const unsigned long long end = rank + 1 == ranks ? all : begin + all / ranks;
    const Digest part = digest_of(file.handle(), begin, end - begin);
    if (part.bytes != end - begin) refuse(path);
    mine = {static_cast<long long>(part.bytes), static_cast<long long>(part.crc)};
  });
  work.agree();
  const std::vector<long long> parts = gather_to_root(comm, mine);
  work.run([&] {
    if (parts.empty()) return;
    Digest whole{0, libdeflate_crc32(0, nullptr, 0)};
    for (std::size_t r = 0; r < parts.size(); r += 2) {
      const auto bytes = static_cast<unsigned long long>(parts[r]);
      whole = {
          whole.bytes + bytes,
          combined_crc32(whole.crc, static_cast<std::uint32_t>(parts[r + 1]), bytes)};
    }
    const OpenFile file(path);
    put_seal(file.handle(), whole, path);
  });
  work.agree();
}

// A pipe of that name is not waited for.
SealedFile::SealedFile(const std::filesystem::path& path)
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)), fault_(broken_seal(file_)) {}

SealedFile::~SealedFile() {
  if (file_ >= 0) close(file_);
}

std::string seal_text(const std::filesystem::path& path) {
  std::string text(user_block, ' ');
  std::ifstream stream(path, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

void sync_folder(const std::filesystem::path& folder) {
  const std::filesystem::path name = folder.empty() ? "." : folder;
  const int handle = open(name.c_str(), O_RDONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (handle < 0) return;
  fsync(handle);
  close(handle);
}

}  // namespace barreno
