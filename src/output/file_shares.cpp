// SPDX-License-Identifier: BSD-3-Clause
#include "output/file_shares.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace barreno {
namespace {

/// How many particles of the block have a smaller id.
long long ordinal_of(const FileShares::Block& block, ParticleId id) {
  auto after = std::upper_bound(
      block.ranges.begin(),
      block.ranges.end(),
      id,
      [](ParticleId value, const FileShares::Range& range) { return value < range.first; }
  );
  if (after == block.ranges.begin() || id >= std::prev(after)->first + std::prev(after)->count)
    throw std::logic_error("particle " + std::to_string(id) + " has no place in the files");
  --after;
  return after->before + (id - after->first);
}

}  // namespace

int count_files(ParticleFiles asked, long long places, int ranks) {
  if (asked == ParticleFiles::one) return 1;
  if (asked == ParticleFiles::by_number && places <= most_in_one_file) return 1;
  return ranks;
}

FileShares divide_among_files(
    const std::vector<IdRange>& ranges, std::size_t materials, int files
) {
  std::vector<IdRange> sorted = ranges;
  std::sort(sorted.begin(), sorted.end(), [](const IdRange& a, const IdRange& b) {
    return a.first < b.first;
  });
  FileShares shares;
  shares.files = files;
  shares.blocks.resize(materials);
  for (const IdRange& range : sorted) {
    if (range.first < 1) throw std::logic_error("particle ids must be positive");
    FileShares::Block& block = shares.blocks[static_cast<std::size_t>(range.material)];
    block.ranges.push_back({range.first, range.count, block.count});
    block.count += range.count;
  }
  return shares;
}

std::vector<long long> ids_of(const FileShares& shares, std::size_t block, int file) {
  const long long begin = share_begin(shares, block, file);
  const long long end = share_begin(shares, block, file + 1);
  std::vector<long long> ids;
  ids.reserve(static_cast<std::size_t>(end - begin));
  for (const FileShares::Range& range : shares.blocks[block].ranges) {
    const long long from = std::max(begin, range.before);
    const long long to = std::min(end, range.before + range.count);
    for (long long i = from; i < to; ++i) ids.push_back(range.first + (i - range.before));
  }
  return ids;
}

FilePosition position_of(const FileShares& shares, std::size_t block, ParticleId id) {
  const long long ordinal = ordinal_of(shares.blocks[block], id);
  // The last file whose share does not begin after it.
  const auto file =
      static_cast<int>(((ordinal + 1) * shares.files - 1) / shares.blocks[block].count);
  return {file, static_cast<std::size_t>(ordinal - share_begin(shares, block, file))};
}

std::filesystem::path name_in_set(
    const std::filesystem::path& path, const FileShares& shares, int file
) {
  if (shares.files == 1) return path;
  const std::string files = std::to_string(shares.files);
  std::string number = std::to_string(file);
  number.insert(0, files.size() - number.size(), '0');
  return path.string() + "." + files + "." + number;
}

}  // namespace barreno
