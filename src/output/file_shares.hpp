// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/output_section.hpp"
#include "state/id_ranges.hpp"

#include <filesystem>
#include <vector>

namespace barreno {

/// Elements of a set of files: in every file a block per material, sorted by id. A particle has its
/// place from its id alone, for the whole run, wherever it moves.
struct FileShares {
  /// Consecutive ids, and how many of the block come before them.
  struct Range {
    ParticleId first = 1;
    long long count = 0;
    long long before = 0;
  };
  struct Block {
    std::vector<Range> ranges;  ///< ascending
    long long count = 0;        ///< in all files
  };
  int files = 1;
  std::vector<Block> blocks;  ///< as Scene::materials
};

/// How many files a run begins with.
/// @param places  of particles in all of them
int count_files(ParticleFiles asked, long long places, int ranks);

FileShares divide_among_files(const std::vector<IdRange>& ranges, std::size_t materials, int files);

/// Each file takes consecutive particles of a block, as many as the others to one: those from here
/// on up to the next file's.
inline long long share_begin(const FileShares& shares, std::size_t block, int file) {
  return shares.blocks[block].count * file / shares.files;
}
std::vector<long long> ids_of(const FileShares& shares, std::size_t block, int file);

struct FilePosition {
  int file = 0;
  std::size_t element = 0;  ///< within the block of that file
};
FilePosition position_of(const FileShares& shares, std::size_t block, ParticleId id);

/// The rank that writes a file. A set keeps its number of files when its run is resumed on other
/// ranks: then some have several, or none.
inline int writing_rank(const FileShares& shares, int file, int ranks) {
  if (shares.files <= ranks) return file;
  return static_cast<int>(static_cast<long long>(file) * ranks / shares.files);
}

/// particles.e if it is the only one, else particles.e.N.FILE, all of one length, as epu and
/// ParaView expect.
std::filesystem::path name_in_set(
    const std::filesystem::path& path, const FileShares& shares, int file
);

}  // namespace barreno
