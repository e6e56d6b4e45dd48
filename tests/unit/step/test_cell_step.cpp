// SPDX-License-Identifier: BSD-3-Clause
// The step of rows of a cell that decide together.
#include "step/cell_step.hpp"
#include "step/ranks/place_particles.hpp"
#include "step/stable_step.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

/// A block of 2 x 2 particles in one cell, as if they were those of a jet that may be divided.
struct Cell {
  static constexpr double size = 0.5, density = 1000.0;
  Scene scene = testing::box_scene(
      Mode::plane_strain, size, {0.0, 0.0}, {8.0, 8.0}, testing::elastic(1e6, 0.3, density)
  );
  State state;
  Particles& particles() { return state.particles[0]; }

  explicit Cell(double aspect = 1.0) {
    testing::add_box(scene, "slug", {1.0, 1.0}, {1.5, 1.5}, 2);
    scene.step.linear_viscosity = 0.0;
    state = testing::start_alone(scene);
    place_particles({false, true}, 1, continuum_of(state));
    Particles& p = particles();
    p.split_rule = {4, 0.5, -1, false, 0};
    for (int row = 0; row < p.count; ++row) p.half_size(row, 1) *= aspect;
  }
  double wave() { return std::sqrt(particles().longitudinal_modulus(0) / density); }
  double step() { return stable_step_of_cells(scene.step, state.grid, particles()); }
};

TEST(StableStepOfCells, IsThatOfARowWhereAllAreAlike) {
  Cell cell;
  Particles& p = cell.particles();
  ASSERT_EQ(p.count, 4);
  for (int row = 0; row < 4; ++row) p.velocity(row, 1) = 7.0;
  const StableStepRule rule(
      cell.scene.step, Mode::plane_strain, p.critical_courant, p.isolated_courant
  );
  const double alone =
      rule.stable_step(Cell::size, Cell::density, double(p.longitudinal_modulus(0)), 0.0, 7.0);
  EXPECT_NEAR(cell.step() / alone, 1.0, 1e-12);
  EXPECT_NEAR(stable_step_of_rows(cell.scene.step, cell.state.grid, p, 0) / alone, 1.0, 1e-12);
  for (int row = 0; row < 4; ++row) p.body(row) |= debris_bit;
  EXPECT_TRUE(std::isinf(cell.step())) << "debris bounds no step";
  p.count = 0;
  p.sorted = false;
  place_particles({false, true}, 1, continuum_of(cell.state));
  EXPECT_TRUE(std::isinf(cell.step())) << "nor does a jet that is not launched yet";
}

/// sum m w^2 / sum m: a hundredth of the mass that is a hundred times as stiff doubles w^2, where
/// the row alone would take a tenth of the step.
TEST(StableStepOfCells, WeighsStiffRowsByTheirMass) {
  Cell cell;
  const double before = cell.step();
  Particles& p = cell.particles();
  double others = 0.0;
  for (int row = 1; row < 4; ++row) others += p.mass(row);
  const double part = others / 99.0 / p.mass(0);
  p.mass(0) *= part;
  p.volume(0) *= part;
  p.longitudinal_modulus(0) *= 100.0;
  EXPECT_NEAR(cell.step() / before, 1.0 / std::sqrt(0.99 + 0.01 * 100.0), 1e-12);
}

/// The fastest row's speed counts, and debris does not.
TEST(StableStepOfCells, TakesTheFastestRowThatIsNoDebris) {
  Cell cell;
  const double before = cell.step(), wave = cell.wave();
  Particles& p = cell.particles();
  p.velocity(2, 0) = -wave;
  EXPECT_NEAR(cell.step() / before, 0.5, 1e-12);
  p.body(2) |= debris_bit;
  EXPECT_NEAR(cell.step() / before, 1.0, 1e-12);
}

/// Frequencies along the axes add up as squares: a disc pays for its thin side alone.
TEST(StableStepOfCells, AThinParticleIsThinAlongOneAxis) {
  Cell square, disc(0.4);
  const CourantTable& table = disc.particles().courant_table;
  const double wide = table.at(0.25), thin = table.at(0.1);
  EXPECT_NEAR(
      disc.step() / square.step(),
      std::sqrt(2.0 / (wide * wide) / (1.0 / (wide * wide) + 1.0 / (thin * thin))),
      1e-12
  );
  EXPECT_GT(disc.step() / square.step(), thin / wide);
}

TEST(StableStepOfCells, IsForDividedRowsOfAJetInTheirOwnBoxes) {
  Cell cell;
  Particles& p = cell.particles();
  EXPECT_TRUE(decides_by_cells(p));
  p.split_rule.halves = true;  // domains that follow the deformation
  EXPECT_FALSE(decides_by_cells(p));
  p.split_rule = {4, 1.0, 3, true, -1};  // gas
  EXPECT_FALSE(decides_by_cells(p));
  p.split_rule = {};
  EXPECT_FALSE(decides_by_cells(p));
}

/// An isolated particle bears no more than its own limit (Stable Alone), which no other eases.
TEST(StableStepOfCells, KeepsTheLimitOfARowThatIsAlone) {
  Cell cell;
  cell.particles().isolated_courant = 0.1;
  EXPECT_NEAR(cell.step(), 0.1 * Cell::size / cell.wave(), 1e-12);
}

}  // namespace
}  // namespace barreno
