// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/exchange.hpp"
#include "base/rank_work.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace barreno {
namespace {

const auto comm = [] { return Teuchos::DefaultComm<int>::getComm(); };

TEST(Exchange, BringsEveryRankWhatEachSentIt) {
  const int rank = comm()->getRank(), ranks = comm()->getSize();
  // Rank r sends r + s values to rank s, none from the first rank to itself.
  std::vector<double> send, expected;
  std::vector<int> counts;
  for (int to = 0; to < ranks; ++to) {
    counts.push_back(rank + to);
    for (int i = 0; i < rank + to; ++i) send.push_back(100.0 * rank + 10.0 * to + i);
  }
  for (int from = 0; from < ranks; ++from)
    for (int i = 0; i < rank + from; ++i) expected.push_back(100.0 * from + 10.0 * rank + i);
  EXPECT_EQ(exchange(*comm(), send, counts), expected);
}

/// Whether `from` sends to `to` in the round: to few, and in some rounds to nobody.
bool sends(int round, int from, int to) {
  return (7 * round + 3 * from + 5 * to) % 4 == 0 && round % 5 != 0;
}

TEST(Exchange, KeepsRoundsApartWhereRanksRunAhead) {
  const int rank = comm()->getRank(), ranks = comm()->getSize();
  for (int round = 0; round < 200; ++round) {
    if (round % ranks == rank) std::this_thread::sleep_for(std::chrono::microseconds(200));
    std::vector<double> send, expected;
    std::vector<int> counts;
    for (int to = 0; to < ranks; ++to) {
      counts.push_back(sends(round, rank, to) ? 2 : 0);
      if (counts.back() > 0) send.insert(send.end(), {1.0 * round, 1.0 * rank});
    }
    for (int from = 0; from < ranks; ++from)
      if (sends(round, from, rank)) expected.insert(expected.end(), {1.0 * round, 1.0 * from});
    ASSERT_EQ(exchange(*comm(), send, counts), expected) << "round " << round;
  }
}

TEST(RankWork, ThrowsTheFirstRanksErrorOnEveryRank) {
  const int rank = comm()->getRank(), ranks = comm()->getSize();
  for (int failing = 0; failing < ranks; ++failing) {
    RankWork work(*comm());
    int runs = 0;
    work.run([&] { ++runs; });
    EXPECT_NO_THROW(work.agree());
    work.run([&] {
      if (rank >= failing) throw FileError("rank " + std::to_string(rank) + " has no disk.");
    });
    work.run([&] { ++runs; });
    EXPECT_EQ(runs, rank >= failing ? 1 : 2);
    try {
      work.agree();
      FAIL() << "no error";
    } catch (const FileError& error) {
      EXPECT_EQ(error.what(), "rank " + std::to_string(failing) + " has no disk.");
    }
  }
}

}  // namespace
}  // namespace barreno
