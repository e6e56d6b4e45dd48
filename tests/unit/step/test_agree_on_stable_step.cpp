// SPDX-License-Identifier: BSD-3-Clause
// What the ranks agree on before a step.
#include "step/stable_step.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(AgreeOnStableStep, TakesTheLeastOfTheRanksAndWhatAnyHasSeen) {
  const State state = testing::start(testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {8.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  ));
  const auto& comm = *state.grid.comm;
  const bool last = comm.getRank() == comm.getSize() - 1;
  Placement placement;
  placement.someone_left = last;
  EXPECT_EQ(agree_on_stable_step(comm, last ? 0.25 : 0.5, placement), 0.25);
  EXPECT_TRUE(placement.someone_left);
  EXPECT_FALSE(placement.new_tile);
  EXPECT_EQ(placement.interrupt, 0);
}

TEST(AgreeOnStableStep, NamesTheSetThatHasIt) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {8.0, 8.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  scene.materials.push_back(scene.materials[0]);
  State state = testing::start(scene);
  const auto& comm = *state.grid.comm;
  const bool first = comm.getRank() == 0;
  state.particles[0].stable_step = 0.5;
  state.particles[1].stable_step = first ? 0.25 : 0.75;
  Placement placement;
  int set = -1;
  const double mine = first ? 0.25 : 0.5;
  const auto agree = [&](double stable_step) {
    return agree_on_stable_step(comm, state.particles, stable_step, state.agreed, placement, set);
  };
  EXPECT_EQ(agree(mine), 0.25);
  EXPECT_EQ(set, 1);
  EXPECT_EQ(agree(0.125), 0.125) << "of tiles at rest";
  EXPECT_EQ(set, -1);
}

}  // namespace
}  // namespace barreno
