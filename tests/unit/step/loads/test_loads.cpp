// SPDX-License-Identifier: BSD-3-Clause
// Faces that absorb waves, and walls that move by a table.
#include "base/gather.hpp"
#include "state/balance.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::elastic;
using testing::start;
using testing::start_alone;

constexpr double density = 2300.0, young = 20e9, poisson = 0.25, preload = 30e6;

PressureLoadSpec load_on(const std::vector<Face>& faces, LoadKind kind, double pressure) {
  PressureLoadSpec load;
  load.kind = kind;
  for (const Face face : faces) load.faces[static_cast<std::size_t>(face)] = true;
  load.pressure = {{0.0}, {pressure}};
  return load;
}

/// A confined block whose upper and outer faces absorb; coarser in three dimensions, where its back
/// absorbs too.
Scene absorbing(Mode mode) {
  const bool space = mode == Mode::three_dimensional;
  const double h = space ? 2e-3 : 1e-3;
  Scene scene =
      box_scene(mode, h, {0.0, 0.0, 0.0}, {0.020, 0.040, 0.016}, elastic(young, poisson, density));
  add_box(scene, "core", {0.0, 0.0052, 0.0}, {0.0117, 0.0277, 0.0077}, 2).initial_pressure =
      preload;
  if (space) {
    scene.loads.push_back(load_on({Face::z_upper}, LoadKind::non_reflecting, preload));
    add_symmetry(scene, Face::z_lower);
  }
  scene.loads.push_back(load_on({Face::x_upper, Face::y_upper}, LoadKind::non_reflecting, preload));
  scene.loads.push_back(load_on({Face::y_lower}, LoadKind::pressure, preload));
  add_symmetry(scene, Face::x_lower);
  return scene;
}

TEST(NonReflecting, PreloadedBlockStaysAtRest) {
  for (const Mode mode : all_modes) {
    const Scene scene = absorbing(mode);
    State state = start(scene);
    advance_to(scene, 1e-4, state);
    const double free_speed = preload / (density * std::sqrt(24e9 / density));
    for (const auto& row : all_rows(state))
      EXPECT_LT(std::hypot(row[2], row[3]), 1e-9 * free_speed);
  }
}

/// A block that flies on its own along y: the first step feels rho c_p v_n on the face across,
/// rho c_s v_t on the faces along.
TEST(NonReflecting, FacesFeelTheImpedanceOfBothWaves) {
  constexpr double speed = 10.0, width = 0.008, height = 0.012, depth = 0.006;
  const double shear = young / (2.0 * (1.0 + poisson)), axial = 24e9;
  for (const Mode mode : {Mode::plane_strain, Mode::three_dimensional})
    for (const Face face : {Face::y_upper, Face::x_upper, Face::z_upper}) {
      const bool space = mode == Mode::three_dimensional;
      if (face == Face::z_upper && !space) continue;
      Scene scene = box_scene(
          mode, 1e-3, {0.0, 0.0, 0.0}, {0.020, 0.040, 0.020}, elastic(young, poisson, density)
      );
      add_box(
          scene, "core", {0.004, 0.008, 0.004}, {0.004 + width, 0.008 + height, 0.004 + depth}, 2
      )
          .velocity = {0.0, speed, 0.0};
      scene.loads.push_back(load_on({face}, LoadKind::non_reflecting, 0.0));
      scene.step.initial_step = 1e-12;  // in which nothing is slowed down yet
      State state = start(scene);
      advance_to(scene, 1.0, state, 1);
      const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
      const double thick = space ? depth : 1.0;
      const double area = face == Face::y_upper   ? width * thick
                          : face == Face::x_upper ? height * thick
                                                  : width * height;
      const double force =
          -std::sqrt(density * (face == Face::y_upper ? axial : shear)) * speed * area;
      EXPECT_NEAR(ledger.load_impulse / (force * state.clock.dt), 1.0, 1e-5);
      EXPECT_LT(ledger.boundary_work, 0.0);
    }
}

/// Waves in the whole block: absorbed without instability, the books balanced, the same bits alone.
TEST(NonReflecting, AbsorbsAndGivesTheSameBitsOnAnyRankCount) {
  for (const Mode mode : all_modes) {
    Scene scene = absorbing(mode);
    scene.step.courant_fraction = 1.0;
    scene.step.linear_viscosity = 0.0;
    scene.step.quadratic_viscosity = 0.0;
    scene.bodies[0].velocity = {0.0, 20.0, 0.0};
    scene.bodies[0].velocity_wave_number = {0.0, 560.0, 0.0};
    State together = start(scene), alone = start_alone(scene);
    advance_to(scene, 1e-4, together);
    advance_to(scene, 1e-4, alone);
    EXPECT_EQ(all_rows(together), all_rows(alone));
    const Ledger ledger = sum_over_ranks(*together.grid.comm, together.ledger);
    EXPECT_GT(together.clock.step, mode == Mode::three_dimensional ? 150 : 300);
    EXPECT_LT(ledger.kinetic, 1e-2 * ledger.initial_kinetic);
    EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-12);
  }
}

/// A bar on a wall that starts smoothly, moves and stops again: it ends where the wall has brought
/// it, the books balanced.
TEST(MovingWall, FollowsItsTable) {
  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.008, 0.040, 0.0},
      elastic(young, poisson, density)
  );
  add_box(scene, "rod", {0.0, 0.0, 0.0}, {0.0042, 0.0121, 0.0}, 2);
  add_symmetry(scene, Face::x_lower);
  ConditionSpec wall;
  wall.name = "wall";
  wall.face = Face::y_lower;
  wall.kind = ConditionKind::prescribed_velocity;
  wall.velocity = {0.0, 5.0, 0.0};
  wall.factor = {{0.0, 4e-5, 8e-5}, {0.0, 1.0, 0.0}};
  scene.conditions.push_back(wall);
  scene.step.damping = 5e4;
  State state = start(scene);
  const auto before = all_rows(state);
  advance_to(scene, 4e-4, state);
  const auto after = all_rows(state);
  constexpr double travel = 5.0 * 4e-5;
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_NEAR((after[i][1] - before[i][1]) / travel, 1.0, 1e-2);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_GT(ledger.boundary_work, 0.0);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 2e-3);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-12);
  State alone = start_alone(scene);
  advance_to(scene, 4e-4, alone);
  EXPECT_EQ(after, all_rows(alone));
}

}  // namespace
}  // namespace barreno
