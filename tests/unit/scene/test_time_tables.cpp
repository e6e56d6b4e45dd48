// SPDX-License-Identifier: BSD-3-Clause
// Tables of time as kernels read them.
#include "scene/time_tables.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(TimeTables, AreTheTablesToTheBit) {
  const std::vector<Table> tables{
      {{0.0}, {3.0}},
      {{0.1, 0.7, 0.7, 1.3}, {1.0, 0.3, -2.0, 0.1}},
      {{-1.0, 0.0, 1.0 / 3.0}, {0.7, 0.7, 5.0}}};
  const TimeTables view = make_time_tables(tables);
  for (int i = 0; i < 3; ++i)
    for (double t = -1.5; t < 1.7; t += 0.03125 / 3.0)
      EXPECT_EQ(view(i, t), tables[static_cast<std::size_t>(i)](t)) << i << " at " << t;
  EXPECT_EQ(view(1, 0.7), -2.0);
}

}  // namespace
}  // namespace barreno
