// SPDX-License-Identifier: BSD-3-Clause
#include "base/field.hpp"
#include "base/launch.hpp"
#include "base/points.hpp"
#include "base/types.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace barreno {
namespace {

/// values(p, c) = 10 p + c
Field counting_field(int rows, int components) {
  Field field{"counted", {}, components, FieldView("counted", extent<12>, extent<2>)};
  for (int p = 0; p < rows; ++p)
    for (int c = 0; c < components; ++c) field(p, c) = 10.0 * p + c;
  return field;
}

TEST(Field, OfASceneThatDoesNotNeedItHasNoComponents) {
  const Field none;
  EXPECT_EQ(none.components, 0);
  EXPECT_EQ(none.values.size(), 0U);
}

TEST(Field, KeepsAComponentInOneColumn) {
  const Field field = counting_field(12, 2);
  EXPECT_EQ(&field(5) - &field(4), 1);
  EXPECT_EQ(field(4, 1), 41.0);
}

TEST(Points, AreLoadedAndStoredOneByOne) {
  const Field field = counting_field(12, 2);
  EXPECT_EQ(load<double>(field.values, 1, 7, 1), 71.0);
  store(-1.0, field.values, 1, 7, 1);
  EXPECT_EQ(field(7, 1), -1.0);
  EXPECT_EQ(field(8, 1), 81.0);
  EXPECT_TRUE(mask_of<double>([](int i) { return i == 0; }));
}

#if BARRENO_HAS_LANES
TEST(Points, FillSpareLanesWithTheLastRow) {
  const Field field = counting_field(12, 2);
  const auto whole = load<Lanes>(field.values, 0, 2, lane_count);
  const auto part = load<Lanes>(field.values, 0, 9, 3);
  for (int i = 0; i < lane_count; ++i) {
    EXPECT_EQ(entry(whole, i), 10.0 * (2 + i));
    EXPECT_EQ(entry(part, i), 10.0 * (9 + (i < 3 ? i : 2)));
  }
}

TEST(Points, DoNotStoreSpareLanes) {
  const Field field = counting_field(12, 2);
  store(Lanes{} - 1.0, field.values, 0, 4, 3);
  for (int p = 0; p < 12; ++p) EXPECT_EQ(field(p), p >= 4 && p < 7 ? -1.0 : 10.0 * p) << p;
  store(Lanes{} - 2.0, field.values, 1, 1, lane_count);
  EXPECT_EQ(field(0, 1), 1.0);
  EXPECT_EQ(field(lane_count, 1), -2.0);
  EXPECT_EQ(field(lane_count + 1, 1), 10.0 * (lane_count + 1) + 1.0);
}

TEST(Points, DecideLaneByLane) {
  const LaneMask odd = mask_of<Lanes>([](int i) { return i % 2 == 1; });
  for (int i = 0; i < lane_count; ++i) EXPECT_EQ(entry(odd, i), i % 2 == 1 ? -1 : 0);
}
#endif

struct Doubling {
  ArrayView<double> values;
  KOKKOS_INLINE_FUNCTION void operator()(int i) const { values(i) *= 2.0; }
};
struct Summing {
  ArrayView<double> values;
  KOKKOS_INLINE_FUNCTION void operator()(int i, double& sum) const { sum += values(i); }
};

TEST(Launch, ReachesEveryRowOfItsRangeAndNoOther) {
  const ArrayView<double> values("values", 5);
  Kokkos::deep_copy(values, 1.0);
  launch("doubling", range(4), Doubling{values});
  Kokkos::fence();
  EXPECT_EQ(values(3), 2.0);
  EXPECT_EQ(values(4), 1.0);
  double sum = 0.0;
  launch_reduction("summing", range(5), Summing{values}, sum);
  EXPECT_EQ(sum, 9.0);
}

TEST(Launch, MakesTheNameOfAKernelOnce) {
  const std::string& first = kernel_label<Doubling>("doubling");
  EXPECT_EQ(first, "doubling");
  EXPECT_EQ(&kernel_label<Doubling>("doubling"), &first);
  EXPECT_NE(&kernel_label<Summing>("summing"), &first);
}

}  // namespace
}  // namespace barreno
