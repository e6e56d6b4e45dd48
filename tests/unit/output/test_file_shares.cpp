// SPDX-License-Identifier: BSD-3-Clause
#include "output/file_shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace barreno {
namespace {

/// Two materials whose ids take turns, with gaps, and one with a single particle.
const std::vector<IdRange> slots{{0, 101, 7}, {1, 1, 40}, {0, 60, 5}, {2, 3'000'000'000LL, 1}};

/// That ids ascend within a block, from `last` on, and that each has this place alone.
void expect_places(const FileShares& shares, std::size_t block, int file, long long& last) {
  const std::vector<long long> ids = ids_of(shares, block, file);
  for (std::size_t e = 0; e < ids.size(); ++e) {
    ASSERT_GT(ids[e], last);
    last = ids[e];
    const FilePosition place = position_of(shares, block, ids[e]);
    ASSERT_EQ(place.file, file) << ids[e];
    ASSERT_EQ(place.element, e);
  }
}

TEST(FileShares, EveryParticleHasOnePlaceForAnyNumberOfFiles) {
  for (const int files : {1, 2, 3, 7, 12, 13, 100, 100'000}) {
    const FileShares shares = divide_among_files(slots, 4, files);
    std::size_t found = 0;
    for (std::size_t b = 0; b < 4; ++b) {
      const auto least = static_cast<std::size_t>(shares.blocks[b].count / files);
      long long last = 0;
      for (int file = 0; file < files; ++file) {
        expect_places(shares, b, file, last);
        const std::size_t count = ids_of(shares, b, file).size();
        ASSERT_TRUE(count == least || count == least + 1) << count;
        found += count;
      }
    }
    EXPECT_EQ(found, 53U);
  }
}

TEST(FileShares, ThereIsOneFileUnlessAskedOrLarge) {
  using Files = ParticleFiles;
  EXPECT_EQ(count_files(Files::by_number, most_in_one_file, 7), 1);
  EXPECT_EQ(count_files(Files::by_number, most_in_one_file + 1, 7), 7);
  EXPECT_EQ(count_files(Files::one, 1'000'000'000'000LL, 7), 1);
  EXPECT_EQ(count_files(Files::one_per_rank, 0, 7), 7);
  EXPECT_EQ(OutputSpec{}.files, Files::by_number);
}

TEST(FileShares, HoldersComeInOrderAndEachHasAboutAsManyFiles) {
  for (const int files : {1, 2, 5, 64})
    for (const int ranks : {1, 2, 3, 5, 63, 64, 65}) {
      const FileShares shares = divide_among_files(slots, 4, files);
      std::vector<int> held(static_cast<std::size_t>(ranks), 0);
      int last = 0;
      for (int file = 0; file < files; ++file) {
        const int holder = writing_rank(shares, file, ranks);
        ASSERT_GE(holder, last);
        ASSERT_LT(holder, ranks);
        last = holder;
        ++held[static_cast<std::size_t>(holder)];
      }
      EXPECT_LE(*std::max_element(held.begin(), held.end()), (files + ranks - 1) / ranks);
    }
}

TEST(FileShares, NamesAreOfOneLength) {
  EXPECT_EQ(name_in_set("a/particles.e", divide_among_files(slots, 4, 1), 0), "a/particles.e");
  EXPECT_EQ(name_in_set("a/particles.e", divide_among_files(slots, 4, 2), 1), "a/particles.e.2.1");
  EXPECT_EQ(
      name_in_set("a/particles.e", divide_among_files(slots, 4, 12), 3), "a/particles.e.12.03"
  );
}

TEST(FileShares, RefusesAParticleThatHasNoPlace) {
  const FileShares shares = divide_among_files(slots, 4, 3);
  for (const ParticleId id : {59, 65, 100, 108})
    EXPECT_THROW(position_of(shares, 0, id), std::logic_error) << id;
  EXPECT_THROW(position_of(shares, 3, 1), std::logic_error);
}

}  // namespace
}  // namespace barreno
