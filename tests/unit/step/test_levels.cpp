// SPDX-License-Identifier: BSD-3-Clause
// Whole steps on grids with cells of several sizes, on any number of ranks.
#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "grid/tiles.hpp"
#include "scene/tile_levels.hpp"
#include "shape/visit_kernels.hpp"
#include "state/balance.hpp"
#include "step/boundary/symmetry_planes.hpp"
#include "step/nodes/sum_halos.hpp"
#include "step/prepare_step.hpp"
#include "step/transfer/project_sets.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::start;

void refine(Scene& scene, const Box& box, int level) {
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{box, level}});
}

/// Bodies are that wide: in space a third of what they are in the plane, to save time.
double width_in(Mode mode) {
  return mode == Mode::three_dimensional ? 0.0083 : 0.0203;
}

int level_in(Mode mode) {
  return mode == Mode::three_dimensional ? 1 : 2;
}

/// Two elastic bodies that meet where cells are 4 times smaller than around them.
Scene collision(Mode mode) {
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.048, 0.012}, testing::elastic(70e9, 0.3, 2700.0)
  );
  add_box(scene, "lower", {0.0, 0.013, 0.0}, {width_in(mode), 0.0189, 0.0042}, 2).velocity = {
      0, 120, 0};
  add_box(scene, "upper", {0.0, 0.020, 0.0}, {width_in(mode), 0.0267, 0.0053}, 2).velocity = {
      0, -80, 0};
  add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  refine(scene, {{0.0, 0.017, 0.0}, {0.003, 0.022, 0.003}}, level_in(mode));
  return scene;
}

class Levels : public ::testing::TestWithParam<Mode> {};

/// The unknowns hold what the particles gave them, no more and no less.
TEST_P(Levels, NodesHoldTheMassAndMomentumOfTheParticles) {
  const Scene scene = collision(GetParam());
  State state = start(scene);
  prepare_step(scene, 1.0, state);
  set_tile_steps(state.grid, 1e-8);
  project_sets(state.grid, state.particles, state.nodes, state.effort);
  sum_halos(SymmetryPlanes(scene.conditions, state.grid), state.grid, state.nodes);
  const Grid& grid = state.grid;
  const Patch& patch = grid.patch;
  std::array<long double, 2> of_rank{};
  for (int tile = 0; tile < grid.active; ++tile)
    for (int slot = 0; slot < patch.size; ++slot) {
      if (grid.from_parent(static_cast<std::size_t>(tile * patch.size + slot)) != 0) continue;
      const auto first = first_sum(patch, tile) + static_cast<std::size_t>(slot * sum_components);
      of_rank[0] += state.nodes[0].sums(first);
      of_rank[1] += state.nodes[0].sums(first + 2);
    }
  std::array<double, 2> sums{static_cast<double>(of_rank[0]), static_cast<double>(of_rank[1])};
  sum_over_ranks(*grid.comm, sums);
  const Ledger ledger = sum_over_ranks(*grid.comm, state.ledger);
  EXPECT_NEAR(sums[0], ledger.initial_mass, 1e-13 * ledger.initial_mass);
  EXPECT_NEAR(sums[1], ledger.initial_momentum, 1e-13 * 120.0 * ledger.initial_mass);
}

TEST_P(Levels, CollisionKeepsMassAndAxialMomentumAndItsEnergyLedgerCloses) {
  const Scene scene = collision(GetParam());
  State state = start(scene);
  advance_to(scene, 4e-6, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_GT(state.clock.step, 30);
  EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  EXPECT_GT(ledger.elastic, 0.01 * ledger.initial_kinetic);
}

/// A body that moves and turns nowhere keeps its velocity to round-off: weights add up to one
/// across levels, and no force arises at their border.
TEST_P(Levels, UniformMotionStaysUniform) {
  const Mode mode = GetParam();
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.048, 0.012}, testing::elastic(70e9, 0.3, 2700.0)
  );
  const double sideways = mode == Mode::axisymmetric ? 0.0 : 30.0;
  add_box(scene, "body", {0.0, 0.013, 0.001}, {width_in(mode), 0.0253, 0.0052}, 2).velocity = {
      sideways, 100.0, 0.0};
  refine(scene, {{0.0, 0.017, 0.0}, {0.003, 0.022, 0.003}}, level_in(mode));
  State state = start(scene);
  advance_to(scene, 4e-6, state);
  const auto rows = all_rows(state);
  EXPECT_GT(state.clock.step, 30);
  for (const auto& row : rows) {
    EXPECT_NEAR(row[2], sideways, 1e-10);
    EXPECT_NEAR(row[3], 100.0, 1e-10);
    EXPECT_NEAR(row[8], 1.0, 1e-12);
  }
}

/// Stress, load and cells of three sizes: the discrete equilibrium stays exact.
TEST_P(Levels, PreloadedBodyStaysAtRest) {
  const Mode mode = GetParam();
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.040, 0.012}, testing::elastic(20e9, 0.25, 2300.0)
  );
  add_box(scene, "core", {0.0, 0.0122, 0.0}, {width_in(mode), 0.0227, 0.0053}, 2).initial_pressure =
      70e6;
  PressureLoadSpec load;
  load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
  load.faces[static_cast<std::size_t>(Face::y_lower)] = true;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
  load.faces[static_cast<std::size_t>(Face::z_upper)] = mode == Mode::three_dimensional;
  load.pressure = {{0.0}, {70e6}};
  scene.loads.push_back(load);
  add_symmetry(scene, Face::x_lower);
  if (mode == Mode::three_dimensional) add_symmetry(scene, Face::z_lower);
  refine(scene, {{0.0, 0.017, 0.0}, {0.003, 0.022, 0.003}}, level_in(mode));
  State state = start(scene);
  advance_to(scene, 3e-6, state);
  const double free_speed = 70e6 / (2300.0 * std::sqrt(24e9 / 2300.0));
  for (const auto& row : all_rows(state)) EXPECT_LT(std::hypot(row[2], row[3]), 1e-9 * free_speed);
}

/// Largest speed of a body under pressure that does not lie on cells, over that of a free face.
double speed_under_pressure(Mode mode, const char* shape) {
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.032, 0.048, 0.012}, testing::elastic(20e9, 0.25, 2300.0)
  );
  scene.step.shape = shape;
  const bool in_space = mode == Mode::three_dimensional;
  // Ends a fifth and seven tenths of a cell beyond lines of cells, at borders of tiles too.
  add_box(scene, "core", {0.0, 0.0082, 0.0}, {in_space ? 0.0083 : 0.0203, 0.0357, 0.0053}, 2)
      .initial_pressure = 70e6;
  PressureLoadSpec load;
  for (const Face face : {Face::x_upper, Face::y_lower, Face::y_upper})
    load.faces[static_cast<std::size_t>(face)] = true;
  load.faces[static_cast<std::size_t>(Face::z_upper)] = in_space;
  load.pressure = {{0.0}, {70e6}};
  scene.loads.push_back(load);
  add_symmetry(scene, Face::x_lower);
  if (in_space) add_symmetry(scene, Face::z_lower);
  refine(scene, {{0.0, 0.017, 0.0}, {0.003, 0.022, 0.003}}, level_in(mode));
  State state = start(scene);
  advance_to(scene, 1e-6, state);
  double largest = 0.0;
  for (const auto& row : all_rows(state)) largest = std::max(largest, std::hypot(row[2], row[3]));
  return largest / (70e6 / (2300.0 * std::sqrt(24e9 / 2300.0)));
}

/// Whatever the shape function that has exact faces, and wherever the box ends.
TEST_P(Levels, PreloadedBodyOffTheCellsStaysAtRest) {
  for (const char* shape : {"GIMP", "contiguous GIMP", "CPDI"})
    EXPECT_LT(speed_under_pressure(GetParam(), shape), 1e-9) << shape;
}

/// Of velocities of a body that flies freely, over its speed.
double change_of_uniform_motion(const char* shape) {
  Scene scene = collision(Mode::plane_strain);
  scene.step.shape = shape;
  scene.conditions.clear();
  for (BodySpec& body : scene.bodies) body.velocity = {0.0, 100.0, 0.0};
  State state = start(scene);
  advance_to(scene, 2e-6, state);
  double largest = 0.0;
  for (const auto& row : all_rows(state))
    largest = std::max({largest, std::abs(row[2]), std::abs(row[3] - 100.0)});
  return largest / 100.0;
}

/// Whatever the shape function: momentum is kept, and weights add up to one across levels.
TEST(LevelsOfShapes, KeepMomentumAndUniformMotion) {
  for_each_shape([](auto shape) {
    const char* const word = decltype(shape)::word;
    if (std::string(word) == "linear") return;  // refused by decks: forces jump at cells
    SCOPED_TRACE(word);
    Scene scene = collision(Mode::plane_strain);
    scene.step.shape = word;
    State state = start(scene);
    advance_to(scene, 2e-6, state);
    const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
    EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
    EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
    EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);

    // Round-off is divided by the mass of nodes that particles hardly reach: linear functions,
    // whose forces jump where particles change cells, have 1e-10 of the speed.
    EXPECT_LT(change_of_uniform_motion(word), std::string(word) == "linear" ? 1e-9 : 1e-11);
  });
}

INSTANTIATE_TEST_SUITE_P(Modes, Levels, ::testing::ValuesIn(all_modes));

/// Half a period of a standing wave in a bar, half of which is refined: the error of its velocity
/// where cells are h wide.
double error_of_wave(double h, bool refined) {
  constexpr double young = 100e9, poisson = 0.3, density = 4000.0, length = 0.064;
  const double modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double half_period = length / std::sqrt(modulus / density);
  Scene scene = box_scene(
      Mode::plane_strain,
      h,
      {0.0, 0.0, 0.0},
      {8 * h, length, 0.0},
      testing::elastic(young, poisson, density)
  );
  BodySpec& bar = add_box(scene, "bar", {0.0, 0.0, 0.0}, {8 * h, length, 0.0}, 2);
  bar.velocity = {0.0, 1e-3, 0.0};
  bar.velocity_wave_number = {0.0, pi / length, 0.0};
  for (int face = 0; face < 4; ++face) add_symmetry(scene, static_cast<Face>(face));
  scene.step.linear_viscosity = scene.step.quadratic_viscosity = 0.0;
  // The same step on all grids: errors in time and space cancel each other in part.
  scene.step.largest_step = scene.step.initial_step = 0.2 * h / std::sqrt(modulus / density);
  if (refined) refine(scene, {{0.0, 0.0, 0.0}, {8 * h, 0.5 * length, 0.0}}, 1);
  State state = start(scene);
  const auto before = all_rows(state);
  advance_to(scene, half_period, state);
  const auto after = all_rows(state);
  double sum = 0.0;
  for (std::size_t i = 0; i < after.size(); ++i)
    sum += std::pow((after[i][3] + before[i][3]) / 1e-3, 2);
  return std::sqrt(sum / static_cast<double>(after.size()));
}

/// The border costs no order. It costs accuracy that only shows where errors are this small: the
/// uniform grid of the coarse half ends at 1.6e-4 with the same steps, as lumped masses on either
/// side of the border differ.
TEST(LevelsOfAWave, KeepTheOrderOfTheUniformGrid) {
  const double coarse = error_of_wave(4e-3, true), fine = error_of_wave(2e-3, true);
  EXPECT_GT(std::log2(coarse / fine), 1.8) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-3);
}

}  // namespace
}  // namespace barreno
