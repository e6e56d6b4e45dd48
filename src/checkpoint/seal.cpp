// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/seal.hpp"

#include "base/error.hpp"
#include "base/rank_work.hpp"
#include "base/work_counts.hpp"
#include "checkpoint/crc32.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
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

/// What a file says before its digest is known: its user block, and the bytes behind that.
struct Sealed {
  std::string fault;  ///< what is wrong with it
  Block block{};
  unsigned long long bytes = 0;
};

Sealed look_at(int file) {
  Sealed found;
  if (file < 0) return {std::string("it cannot be opened: ") + std::strerror(errno)};
  struct stat size {};
  if (fstat(file, &size) != 0 || !S_ISREG(size.st_mode)) return {"it is not a regular file"};
  if (pread(file, found.block.data(), user_block, 0) != static_cast<ssize_t>(user_block))
    return {"it is truncated"};
  if (std::strncmp(found.block.data(), "barreno checkpoint\n", 19) != 0)
    return {"it is not a checkpoint of this program"};
  found.bytes = static_cast<unsigned long long>(size.st_size) - user_block;
  return found;
}

/// An equal part of so many bytes for each rank.
struct Part {
  unsigned long long begin, end;
};
Part part_of(const Comm& comm, unsigned long long bytes) {
  const auto ranks = static_cast<unsigned long long>(comm.getSize());
  const auto rank = static_cast<unsigned long long>(comm.getRank());
  const unsigned long long each = bytes / ranks;
  return {each * rank, rank + 1 == ranks ? bytes : each * (rank + 1)};
}

/// That of the whole, on the root, from those of the ranks' parts. Collective.
Digest combined(const Comm& comm, const Digest& part) {
  const std::vector<long long> parts = gather_to_root(
      comm,
      std::vector<long long>{static_cast<long long>(part.bytes), static_cast<long long>(part.crc)}
  );
  Digest whole{0, libdeflate_crc32(0, nullptr, 0)};
  for (std::size_t r = 0; r < parts.size(); r += 2) {
    const auto bytes = static_cast<unsigned long long>(parts[r]);
    whole = {
        whole.bytes + bytes,
        combined_crc32(whole.crc, static_cast<std::uint32_t>(parts[r + 1]), bytes)};
  }
  return whole;
}

/// A rank that does not see what the root sees is told from a file that is damaged.
void refuse_another(
    const Comm& comm, const std::filesystem::path& path, const Sealed& mine, const Sealed& at_root
) {
  RankWork work(comm);
  work.run([&] {
    if (mine.fault.empty() && mine.bytes == at_root.bytes && mine.block == at_root.block) return;
    throw FileError(
        "cannot resume from '" + path.string() + "' (rank " + std::to_string(comm.getRank()) +
        " sees another file of that name than rank 0); put the folder where every node sees it."
    );
  });
  work.agree();
}

std::string broken_seal(const Comm& comm, const std::filesystem::path& path, int file) {
  const Sealed mine = look_at(file);
  Sealed at_root = mine;
  at_root.fault = broadcast_from_root(comm, mine.fault);
  if (!at_root.fault.empty()) return at_root.fault;
  const std::string block =
      broadcast_from_root(comm, std::string(mine.block.begin(), mine.block.end()));
  std::copy(block.begin(), block.end(), at_root.block.begin());
  at_root.bytes = std::stoull(broadcast_from_root(comm, std::to_string(mine.bytes)));
  refuse_another(comm, path, mine, at_root);
  const Part part = part_of(comm, at_root.bytes);
  const Digest digest = digest_of(file, part.begin, part.end - part.begin);
  work_counts().checkpoint_bytes += static_cast<long long>(digest.bytes);
  const Digest whole = combined(comm, digest);
  const bool right = is_root(comm) && seal_of(whole) == mine.block;
  return broadcast_from_root(
      comm, right ? std::string() : std::string("its contents are not what was written")
  );
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
  RankWork work(comm);
  Digest mine;
  work.run([&] {
    const OpenFile file(path);
    const Part part = part_of(comm, file.bytes());
    mine = digest_of(file.handle(), part.begin, part.end - part.begin);
    if (mine.bytes != part.end - part.begin) refuse(path);
  });
  work.agree();
  const Digest whole = combined(comm, mine);
  work.run([&] {
    if (!is_root(comm)) return;
    const OpenFile file(path);
    put_seal(file.handle(), whole, path);
  });
  work.agree();
}

// A pipe of that name is not waited for.
SealedFile::SealedFile(const Comm& comm, const std::filesystem::path& path)
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  try {
    fault_ = broken_seal(comm, path, file_);
  } catch (const FileError&) {
    if (file_ >= 0) close(file_);
    throw;
  }
}

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
