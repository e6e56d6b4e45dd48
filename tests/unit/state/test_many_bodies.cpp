// SPDX-License-Identifier: BSD-3-Clause
// A scene of more bodies than fit into a byte: every particle knows its own.
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace barreno {
namespace {

constexpr int columns = 25, rows = 24;

/// Squares of a cell each, one cell apart, the i-th with a velocity of i.
Scene chessboard() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {2.0 * columns, 2.0 * rows, 1.0}, testing::copper()
  );
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i % columns, row = i / columns;
    const Vector lower{2.0 * column, 2.0 * row, 0.0};
    const Vector upper{lower[0] + 1.0, lower[1] + 1.0, 1.0};
    testing::add_box(scene, "grain " + std::to_string(i), lower, upper, 1).velocity = {
        1.0 * i, 0, 0};
  }
  return scene;
}

TEST(ManyBodies, EveryParticleKnowsItsOwn) {
  const Scene scene = chessboard();
  const State state = testing::start_alone(scene);
  const Particles& grains = state.particles.front();
  ASSERT_EQ(grains.count, columns * rows);
  std::vector<int> found(static_cast<std::size_t>(grains.count), 0);
  for (int p = 0; p < grains.count; ++p) {
    const int body = grains.body(p);
    ASSERT_EQ(body & debris_bit, 0);
    ASSERT_LT(body, grains.count);
    EXPECT_EQ(grains.velocity(p, 0), body);
    ++found[static_cast<std::size_t>(body)];
  }
  for (const int count : found) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace barreno
