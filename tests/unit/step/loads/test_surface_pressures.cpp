// SPDX-License-Identifier: BSD-3-Clause
// Pressures on the surfaces of balls, and fluid in their cavities.
#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "state/balance.hpp"
#include "state/surface_share.hpp"
#include "step/loads/load_pressures.hpp"
#include "step/loads/release_torn_faces.hpp"
#include "step/loads/surface_pressures.hpp"
#include "support/tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::start;
using testing::start_alone;

constexpr double density = 2300.0;

/// A quarter of a ball at the corner of the grid; in three dimensions an octant, whose cells are
/// twice as large.
Scene ball_scene(Mode mode, const Ball& ball, double cell, int particles_per_cell = 2) {
  const bool space = mode == Mode::three_dimensional;
  const double h = space ? 2.0 * cell : cell;
  Scene scene = box_scene(
      mode, h, {0.0, 0.0, 0.0}, {1.25, 1.25, 1.25}, testing::elastic(20e9, 0.25, density)
  );
  BodySpec body;
  body.name = "ball";
  body.shape = ball;
  body.particles_per_cell = particles_per_cell;
  scene.bodies.push_back(body);
  add_symmetry(scene, Face::x_lower);
  if (space) add_symmetry(scene, Face::z_lower);
  add_symmetry(scene, Face::y_lower);
  scene.step.linear_viscosity = 0.0;
  scene.step.quadratic_viscosity = 0.0;
  return scene;
}

void add_load(Scene& scene, bool inner, bool outer, double pressure) {
  PressureLoadSpec load;
  load.surfaces = {inner, outer};
  load.pressure = {{0.0}, {pressure}};
  scene.loads.push_back(load);
}

void add_fluid(Scene& scene, double bulk_modulus, double pressure = 0.0) {
  PressureLoadSpec load;
  load.kind = LoadKind::pore_fluid;
  load.surfaces = {true, false};
  load.bulk_modulus = bulk_modulus;
  load.pressure = {{0.0}, {pressure}};
  scene.loads.push_back(load);
}

/// Of the part of a cavity of radius a that the scene holds, its volume and the area of its wall.
double cavity(Mode mode, double a) {
  if (mode == Mode::three_dimensional) return pi * a * a * a / 6.0;
  return mode == Mode::axisymmetric ? 2.0 / 3.0 * pi * a * a * a : 0.25 * pi * a * a;
}
double powers_of(Mode mode) {
  return mode == Mode::plane_strain ? 2.0 : 3.0;
}

TEST(SurfaceShare, SharesAddUpToOneAndTheGradientIsTheirSlope) {
  const Ball ball{{0.1, -0.2, 0.3}, 1.0, 0.4};
  for (const double r : {0.4, 0.5, 0.77, 0.8, 0.9, 1.0}) {
    const Vector at{0.1 + 0.48 * r, -0.2 + 0.64 * r, 0.3 + 0.6 * r};
    const SurfaceShare in = surface_share(ball, BallSurface::inner, at, 3);
    const SurfaceShare out = surface_share(ball, BallSurface::outer, at, 3);
    EXPECT_DOUBLE_EQ(in.value + out.value, 1.0);
    for (std::size_t d = 0; d < 3; ++d) {
      constexpr double h = 1e-6;
      Vector before = at, after = at;
      before[d] -= h;
      after[d] += h;
      const double slope = (surface_share(ball, BallSurface::outer, after, 3).value -
                            surface_share(ball, BallSurface::outer, before, 3).value) /
                           (2.0 * h);
      EXPECT_NEAR(out.gradient[d], slope, 3e-5);
      EXPECT_DOUBLE_EQ(in.gradient[d], -out.gradient[d]);
    }
  }
  EXPECT_EQ(surface_share(ball, BallSurface::inner, {0.5, -0.2, 0.3}, 3).value, 1.0);
  EXPECT_EQ(surface_share(ball, BallSurface::outer, {1.1, -0.2, 0.3}, 3).value, 1.0);
}

/// The same pressure on all surfaces and in the body: the discrete equilibrium is exact, however
/// the surfaces cut the cells.
TEST(SurfacePressures, ConfinedBallStaysAtRest) {
  for (const Mode mode : all_modes)
    for (const double inner : {0.0, 0.3701})
      for (const int particles : {1, 2, 3}) {
        Scene scene = ball_scene(mode, {{0.0, 0.0, 0.0}, 1.013, inner}, 0.0625, particles);
        scene.bodies[0].initial_pressure = 70e6;
        add_load(scene, inner > 0.0, true, 70e6);
        State state = start(scene);
        advance_to(scene, 1e-3, state);
        // Speed of the free surface if the pressure were missing: p / (rho c).
        const double free_speed = 70e6 / (density * std::sqrt(24e9 / density));
        for (const auto& row : all_rows(state))
          EXPECT_LT(std::hypot(row[2], row[3]), 1e-9 * free_speed);
      }
}

/// What a pressure on the inner surface does to v = x, over the exact p dV.
double work_error(Mode mode, double h) {
  constexpr double a = 0.4173, p = 1e3, dt = 1e-9;
  Scene scene = ball_scene(mode, {{0.0, 0.0, 0.0}, 1.0, a}, h);
  add_load(scene, true, false, p);
  State state = start(scene);
  advance_to(scene, 1.0, state, 1);  // sorted, with nodes; hardly moved by a small pressure
  const Patch& patch = state.grid.patch;
  const int dimension = dimensions(mode);
  const double size = scene.grid.cell_size;
  for (int tile = 0; tile < state.grid.active; ++tile)
    for (int slot = 0; slot < patch.size; ++slot) {
      double* const node =
          &state.nodes[0].motion(first_motion(patch, tile)) + slot * motion_components(dimension);
      const auto place = state.grid.tile_frame(tile).position;
      const int n = patch.nodes;
      const int index[3] = {slot % n, slot / n % n, slot / (n * n)};
      for (int d = 0; d < dimension; ++d) {
        node[d] = size * (place[d] * patch.tile_cells - patch.reach + index[d]);
        node[dimension + d] = 0.0;
      }
    }
  set_tile_steps(state.grid, dt);
  std::vector<double> work{tally_surface_pressures(tractions_of(state), state.ledger)};
  sum_over_ranks(*state.grid.comm, work);
  // x grows the cavity by its powers of the radius times its volume.
  return work[0] / (p * dt * powers_of(mode) * cavity(mode, a)) - 1.0;
}

TEST(SurfacePressures, WorkConvergesToThatOfTheSurface) {
  for (const Mode mode : all_modes) {
    EXPECT_LT(std::abs(work_error(mode, 0.125)), 2e-2);
    const double fine = mode == Mode::three_dimensional ? 0.0625 / 4.0 : 0.03125;
    EXPECT_LT(std::abs(work_error(mode, fine)), 1.5e-3);
  }
}

struct StepSums {
  double work = 0.0, impulse = 0.0, growth = 0.0;
};
/// Of steps of their own in the tiles, with all nodes in one motion.
StepSums sums_of_steps(const Scene& scene, const std::vector<double>& steps) {
  State state = testing::in_tiles(scene, 0.0);
  for (std::size_t tile = 0; tile < steps.size(); ++tile)
    testing::set_tile_step(state.grid, static_cast<int>(tile), steps[tile]);
  set_load_pressures(scene.loads, state.cavities, 0.0, state.loads);
  release_torn_faces(state.grid, state.nodes, state.particles, state.loads);
  testing::set_motion(state, {3.0, 5.0, 0.0}, {1.0, 2.0, 0.0});
  StepSums sums;
  sums.work = tally_surface_pressures(tractions_of(state), state.ledger);
  sums.impulse = state.ledger.load_impulse;
  grow_cavities(tractions_of(state), state.cavities);
  sums.growth = state.cavities[0].volume - state.cavities[0].initial_volume;
  return sums;
}

/// Steps of 0 everywhere but in one tile give the part of that tile.
TEST(SurfacePressures, EveryTileTakesItsOwnStep) {
  Scene scene = ball_scene(Mode::plane_strain, {{0.0, 0.0, 0.0}, 1.0, 0.4}, 0.0625);
  add_fluid(scene, 1e9, 1e6);
  const auto tiles = static_cast<std::size_t>(testing::in_tiles(scene, 1.0).grid.active);
  ASSERT_GT(tiles, 3U);
  std::vector<double> steps(tiles);
  StepSums sum;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    steps[tile] = 1e-3 * static_cast<double>(tile + 1);
    std::vector<double> one(tiles, 0.0);
    one[tile] = steps[tile];
    const StepSums part = sums_of_steps(scene, one);
    sum.work += part.work;
    sum.impulse += part.impulse;
    sum.growth += part.growth;
  }
  const StepSums all = sums_of_steps(scene, steps);
  EXPECT_GT(std::abs(all.work), 1.0);
  EXPECT_NEAR(all.work / sum.work, 1.0, 1e-12);
  EXPECT_NEAR(all.impulse / sum.impulse, 1.0, 1e-12);
  EXPECT_NEAR(all.growth / sum.growth, 1.0, 1e-12);
}

/// A pressure in the cavity of a ball that is not cut does not push it along.
TEST(SurfacePressures, ClosedSurfaceHasNoResultant) {
  for (const Mode mode : all_modes) {
    constexpr double inner = 0.2;
    Scene scene = ball_scene(mode, {{0.0, 0.613, 0.0}, 0.5, inner}, 0.03125);
    scene.conditions.pop_back();
    add_load(scene, true, false, 1e3);
    State state = start(scene);
    advance_to(scene, 1.0, state, 1);
    std::vector<double> impulse{state.ledger.load_impulse};
    sum_over_ranks(*state.grid.comm, impulse);
    const double area = mode == Mode::axisymmetric        ? pi * inner * inner
                        : mode == Mode::three_dimensional ? 0.25 * pi * inner * inner
                                                          : inner;
    EXPECT_NEAR(impulse[0] / (1e3 * area * state.clock.dt), 0.0, 5e-3);
  }
}

/// Error of the volume by which the fluid grows as its wall moves outward with v_a (a / r)^2, over
/// that volume, for a short time.
double growth_error(Mode mode, double h) {
  constexpr double a = 0.4173, speed = 10.0, time = 1e-6;
  Scene scene = ball_scene(mode, {{0.0, 0.0, 0.0}, 1.0, a}, h);
  scene.bodies[0].radial_velocity = speed;
  add_fluid(scene, 1.0);
  State state = start(scene);
  const double start_volume = state.cavities[0].volume;
  EXPECT_DOUBLE_EQ(start_volume, cavity(mode, a));
  advance_to(scene, time, state);
  const double area = powers_of(mode) * cavity(mode, a) / a;
  return (state.cavities[0].volume - start_volume) / (area * speed * time) - 1.0;
}

/// Nodes outside the surface have the mean velocity of the particles that they reach, which are
/// all on one side: a velocity that is put on the particles is seen with an error of the first
/// order.
TEST(SurfacePressures, CavityGrowsWithItsWall) {
  for (const Mode mode : all_modes) {
    const double coarse = std::abs(growth_error(mode, 0.0625));
    const double fine = std::abs(growth_error(mode, 0.015625));
    // Cells are twice as large in three dimensions.
    EXPECT_LT(coarse, mode == Mode::three_dimensional ? 0.3 : 0.15);
    EXPECT_LT(fine, 0.35 * coarse);
  }
}

/// A fluid much stiffer than the solid does not make the steps unstable, and keeps its energy.
TEST(SurfacePressures, AStiffFluidIsStable) {
  for (const Mode mode : {Mode::axisymmetric, Mode::three_dimensional}) {
    Scene scene = ball_scene(mode, {{0.0, 0.0, 0.0}, 1.0, 0.4}, 0.0625);
    scene.bodies[0].radial_velocity = -1.0;
    add_fluid(scene, 1e13);
    State state = start(scene);
    advance_to(scene, 1e-3, state);
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    EXPECT_GT(state.clock.step, 200);
    EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-12);
    EXPECT_NEAR(state.cavities[0].volume / state.cavities[0].initial_volume, 1.0, 1e-4);
    EXPECT_LT(ledger.kinetic, ledger.initial_kinetic);
  }
}

TEST(SurfacePressures, ACavityThatHasClosedEndsTheRun) {
  Scene scene = ball_scene(Mode::axisymmetric, {{0.0, 0.0, 0.0}, 1.0, 0.4}, 0.125);
  add_fluid(scene, 1e9);
  State state = start(scene);
  state.cavities[0].volume = 0.0;
  EXPECT_THROW(set_load_pressures(scene.loads, state.cavities, 0.0, state.loads), NumericalError);
}

/// The fluid's pressure is one number for all ranks, to the last bit.
TEST(SurfacePressures, PoreFluidGivesTheSameBitsOnAnyRankCount) {
  for (const Mode mode : {Mode::axisymmetric, Mode::three_dimensional}) {
    Scene scene = ball_scene(mode, {{0.0, 0.0, 0.0}, 1.0, 0.4}, 0.03125);
    scene.bodies[0].radial_velocity = -30.0;
    add_fluid(scene, 2.2e9, 1e6);
    add_load(scene, false, true, 3e6);
    State together = start(scene), alone = start_alone(scene);
    advance_to(scene, 2e-4, together);
    advance_to(scene, 2e-4, alone);
    EXPECT_GT(together.clock.step, 25);
    EXPECT_LT(alone.cavities[0].volume, 0.999 * alone.cavities[0].initial_volume);
    EXPECT_EQ(together.cavities[0].volume, alone.cavities[0].volume);
    EXPECT_EQ(all_rows(together), all_rows(alone));
  }
}

TEST(SurfacePressures, DebrisLosesItsShareAndStretchedParticlesKeepIt) {
  Scene scene = ball_scene(Mode::axisymmetric, {{0.0, 0.0, 0.0}, 1.0, 0.4}, 0.125);
  add_load(scene, true, false, 1e6);
  State state = start(scene);
  Particles& particles = state.particles.front();
  double debris = 0.0;
  for (int p = 0; p < particles.count; ++p) {
    particles.deformation_gradient(p, 0) = 3.0;
    if (particles.id(p) % 5 != 0) continue;
    particles.body(p) |= debris_bit;
    debris += 1.0;
  }
  advance_to(scene, 1e-9, state, 1);
  EXPECT_EQ(state.ledger.unloaded, debris);
}

}  // namespace
}  // namespace barreno
