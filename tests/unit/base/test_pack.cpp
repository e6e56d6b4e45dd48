// SPDX-License-Identifier: BSD-3-Clause
#include "base/pack.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace barreno {
namespace {

/// The entries of a pack as the arrays of nodes hold them.
template <int N>
struct Entries {
  alignas(64) double value[static_cast<std::size_t>(N)];
};

template <int N>
void expect(const Entries<N>& wanted, const Pack<N>& pack) {
  for (int i = 0; i < N; ++i) EXPECT_EQ(pack[i], wanted.value[i]) << "entry " << i << " of " << N;
}

/// Every operation on values whose results are exact, entry by entry.
template <int N>
void expect_arithmetic_by_entry() {
  Entries<N> a{}, b{}, sum{}, difference{}, scaled{};
  for (int i = 0; i < N; ++i) {
    a.value[i] = 1.0 + i;
    b.value[i] = 0.25 * i - 3.0;
    sum.value[i] = a.value[i] + b.value[i];
    difference.value[i] = a.value[i] - b.value[i];
    scaled.value[i] = -2.0 * a.value[i];
  }
  const Pack<N>& x = *as_packs<N>(static_cast<const double*>(a.value));
  const Pack<N>& y = *as_packs<N>(static_cast<const double*>(b.value));
  expect<N>(sum, x + y);
  expect<N>(difference, x - y);
  expect<N>(scaled, -2.0 * x);
  Pack<N> z = x;
  z += y;
  expect<N>(sum, z);
  z = x;
  z *= -2.0;
  expect<N>(scaled, z);
  expect<N>({}, Pack<N>{});
}

TEST(Pack, IsAddedAndScaledEntryByEntry) {
  expect_arithmetic_by_entry<4>();
  expect_arithmetic_by_entry<8>();
}

TEST(Pack, LiesInAnArrayAsItsEntriesDo) {
  static_assert(sizeof(Pack<4>) == 4 * sizeof(double) && sizeof(Pack<8>) == 8 * sizeof(double));
  alignas(64) double nodes[24];
  for (int i = 0; i < 24; ++i) nodes[i] = i;
  Pack<8>* const packs = as_packs<8>(nodes);
  packs[1] = packs[1] + packs[2];
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(nodes[i], i);
    EXPECT_EQ(nodes[8 + i], 24.0 + 2.0 * i);
  }
}

TEST(Pack, GivesTheEntriesOfAListInItsOrder) {
  Entries<8> a{{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}};
  const Pack<8> chosen = select<7, 7, 0, 3, 4, 1, 6, 5>(*as_packs<8>(a.value));
  expect<8>({{7.0, 7.0, 0.0, 3.0, 4.0, 1.0, 6.0, 5.0}}, chosen);
}

}  // namespace
}  // namespace barreno
