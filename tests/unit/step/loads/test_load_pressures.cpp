// SPDX-License-Identifier: BSD-3-Clause
// Pressures of loads: tables of time, and fluids in cavities.
#include "base/error.hpp"
#include "state/cavity.hpp"
#include "step/loads/load_pressures.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

PressureLoadSpec ramp() {
  PressureLoadSpec load;
  load.name = "ramp";
  load.pressure = {{1.0, 3.0}, {10.0, 50.0}};
  return load;
}

TEST(LoadPressure, FollowsItsTable) {
  EXPECT_EQ(load_pressure(ramp(), {}, 0.0), 10.0);
  EXPECT_EQ(load_pressure(ramp(), {}, 1.5), 20.0);
  EXPECT_EQ(load_pressure(ramp(), {}, 4.0), 50.0);
}

TEST(LoadPressure, OfAFluidFallsWithTheLogarithmOfItsVolume) {
  Cavity cavity;
  cavity.initial_volume = 2.0;
  cavity.volume = 2.0 * std::exp(0.5);
  cavity.bulk_modulus = 8.0;
  EXPECT_DOUBLE_EQ(load_pressure(ramp(), cavity, 0.0), 10.0 - 8.0 * 0.5);
  cavity.volume = 0.0;
  EXPECT_THROW(load_pressure(ramp(), cavity, 0.0), NumericalError);
}

TEST(SetLoadPressures, PutsThemWhereKernelsReadThem) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1e9, 0.3, 1e3)
  );
  testing::add_box(scene, "block", {3.0, 3.0, 0.0}, {4.0, 4.0, 0.0}, 1);
  for (int i = 0; i < 2; ++i) {
    scene.loads.push_back(ramp());
    scene.loads.back().faces[static_cast<std::size_t>(i)] = true;
  }
  scene.loads[1].pressure = {{0.0}, {7.0}};
  const State state = testing::in_tiles(scene, 1.0);
  set_load_pressures(scene.loads, state.cavities, 2.0, state.loads);
  EXPECT_EQ(state.loads.loads(0).pressure, 30.0);
  EXPECT_EQ(state.loads.loads(1).pressure, 7.0);
}

/// omega^2 = 8 n K / (rho a h) = 8 3 4 / (2 3 0.5) = 32, (omega dt / 2)^2 = 8.
TEST(StableStepWithFluids, IsShorterTheStifferTheFluid) {
  Cavity cavity;
  EXPECT_EQ(stable_step_with_fluids({cavity}, 0.5, 1.0), 1.0);
  cavity.volume = cavity.initial_volume = 5.0;
  cavity.initial_radius = 3.0;
  cavity.wall_density = 2.0;
  cavity.bulk_modulus = 4.0;
  EXPECT_DOUBLE_EQ(stable_step_with_fluids({Cavity{}, cavity}, 0.5, 1.0), 1.0 / 3.0);
  cavity.volume = 5.0 / 8.0;  // half the radius
  EXPECT_DOUBLE_EQ(stable_step_with_fluids({cavity}, 0.5, 1.0), 1.0 / std::sqrt(17.0));
}

}  // namespace
}  // namespace barreno
