// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/gather.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

namespace barreno {
namespace {

const auto comm = [] { return Teuchos::DefaultComm<int>::getComm(); };

TEST(Gather, KeepsRankOrderAndUnequalLengths) {
  const int rank = comm()->getRank(), ranks = comm()->getSize();
  const std::vector<long long> mine(static_cast<std::size_t>(rank), 10LL * rank);  // rank 0: none
  const std::vector<long long> all = gather_to_root(*comm(), mine);
  std::vector<long long> expected;
  for (int r = 0; r < ranks; ++r)
    expected.insert(expected.end(), static_cast<std::size_t>(r), 10LL * r);
  if (rank == 0) {
    EXPECT_EQ(all, expected);
  } else {
    EXPECT_TRUE(all.empty());
  }
}

TEST(Gather, ReducesEntryByEntry) {
  const double rank = comm()->getRank(), ranks = comm()->getSize();
  std::vector<double> sums{1.0, rank}, smallest{rank, -rank}, largest{rank, -rank}, nothing;
  sum_over_ranks(*comm(), sums);
  min_over_ranks(*comm(), smallest);
  max_over_ranks(*comm(), largest);
  min_over_ranks(*comm(), nothing);
  EXPECT_EQ(sums, (std::vector<double>{ranks, 0.5 * ranks * (ranks - 1.0)}));
  EXPECT_EQ(smallest, (std::vector<double>{0.0, 1.0 - ranks}));
  EXPECT_EQ(largest, (std::vector<double>{ranks - 1.0, 0.0}));
}

TEST(Gather, BroadcastsTextsOfAnyLength) {
  const bool root = is_root(*comm());
  EXPECT_EQ(broadcast_from_root(*comm(), root ? "r\xC3\xB6t" : "something longer"), "r\xC3\xB6t");
  EXPECT_EQ(broadcast_from_root(*comm(), root ? "" : "x"), "");
}

TEST(RootWork, ThrowsTheRootsFirstErrorOnEveryRank) {
  RootWork work(*comm());
  int runs = 0;
  work.run([&] { ++runs; });
  EXPECT_NO_THROW(work.agree());
  work.run([] { throw FileError("the disk is full."); });
  work.run([&] { ++runs; });
  EXPECT_EQ(runs, is_root(*comm()) ? 1 : 0);
  try {
    work.agree();
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "the disk is full.");
  }
}

}  // namespace
}  // namespace barreno
