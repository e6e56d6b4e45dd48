// SPDX-License-Identifier: BSD-3-Clause
// Values of the host as kernels read them, and room that grows.
#include "base/view_of.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(ViewOf, HoldsTheValuesInTheirOrder) {
  const ArrayView<int> view = view_of("values", std::vector<int>{3, 1, 2});
  ASSERT_EQ(view.extent(0), 3U);
  EXPECT_EQ(view(0), 3);
  EXPECT_EQ(view(1), 1);
  EXPECT_EQ(view(2), 2);
  EXPECT_EQ(view_of("nothing", std::vector<double>{}).extent(0), 0U);
}

TEST(MakeRoom, GrowsOnlyWhereItMust) {
  ArrayView<double> view;
  make_room("room", 4, view);
  EXPECT_EQ(view.extent(0), 8U);
  const double* const values = view.data();
  make_room("room", 8, view);
  EXPECT_EQ(view.data(), values);
  make_room("room", 9, view);
  EXPECT_EQ(view.extent(0), 18U);
}

}  // namespace
}  // namespace barreno
