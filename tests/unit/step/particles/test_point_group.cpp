// SPDX-License-Identifier: BSD-3-Clause
// Rows of fields as points of a model, one at a time and several in lanes.
#include "step/particles/point_group.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <type_traits>

namespace barreno {
namespace {

/// Row p holds 10 p + c in component c.
Field numbered(int components) {
  Field field{"numbers", dimension::none, components, {}};
  field.values = FieldView("numbers", 20, static_cast<std::size_t>(components));
  for (int p = 0; p < 20; ++p)
    for (int c = 0; c < components; ++c) field(p, c) = 10.0 * p + c;
  return field;
}

TEST(PointGroup, OnePointIsItsRow) {
  const PointGroup<LinearElastic, double> point{3, 1};
  const Field field = numbered(6);
  EXPECT_EQ(point.get(field, 2), 32.0);
  const Sym3 plane = point.get_tensor(field, 4), space = point.get_tensor(field, 6);
  EXPECT_EQ(plane.xy, 33.0);
  EXPECT_EQ(plane.yz, 0.0);
  EXPECT_EQ(plane.zx, 0.0);
  EXPECT_EQ(space.yz, 34.0);
  EXPECT_EQ(space.zx, 35.0);
  point.put_tensor({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, field, 4);
  EXPECT_EQ(field(3, 3), 4.0);
  EXPECT_EQ(field(3, 4), 34.0);  // as it was
}

TEST(PointGroup, AFailedPointKeepsItsHistory) {
  const Field field = numbered(JohnsonCook::history_count);
  const PointGroup<JohnsonCook, double> point{1, 1};
  JohnsonCook::History history = point.get_history(field);
  double* const values = history_values<JohnsonCook, double>(history);
  for (int c = 0; c < JohnsonCook::history_count; ++c) EXPECT_EQ(values[c], 10.0 + c);
  values[0] = -1.0;
  point.put_history(false, history, field);
  EXPECT_EQ(field(1, 0), 10.0);
  point.put_history(true, history, field);
  EXPECT_EQ(field(1, 0), -1.0);
}

#if BARRENO_HAS_LANES
static_assert(std::is_same_v<RealFor<NeoHookean>::type, double>);
static_assert(std::is_same_v<RealFor<LinearElastic>::type, Lanes>);
static_assert(std::is_same_v<RealFor<JohnsonCook>::type, Lanes>);
static_assert(updates_in_parts<Arenisca, Lanes> && !updates_in_parts<Arenisca, double>);
static_assert(!updates_in_parts<JohnsonCook, Lanes>);

/// Three rows from the second on: spare lanes repeat the last, and are not written.
TEST(PointGroup, LanesHoldNeighbouringRows) {
  const Field field = numbered(JohnsonCook::history_count);
  const PointGroup<JohnsonCook, Lanes> points{1, 3};
  const Lanes first = points.get(field, 0);
  for (int i = 0; i < lane_count; ++i) EXPECT_EQ(first[i], i < 3 ? 10.0 * (1 + i) : 30.0);

  auto history = points.get_history(field);
  history_values<JohnsonCook, Lanes>(history)[0] = first + 0.5;
  const auto good = mask_of<Lanes>([](int i) { return i != 1; });
  points.put_history(good, history, field);
  EXPECT_EQ(field(1, 0), 10.5);
  EXPECT_EQ(field(2, 0), 20.0);
  EXPECT_EQ(field(3, 0), 30.5);
  EXPECT_EQ(field(4, 0), 40.0);
}
#endif

}  // namespace
}  // namespace barreno
