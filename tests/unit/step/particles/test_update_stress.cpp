// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/update_stress.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>
#include <functional>
#include <vector>

namespace barreno {
namespace {

/// K = 2, G = 1: K + 4G/3 = 10/3.
MaterialSpec two_one() {
  return Material{"elastic", 1.0, LinearElastic({2.0, 1.0}, 1.0)};
}

/// Strain increment and old volume of all rows, as update_deformation leaves them.
void set_increment(Particles& particles, double xx, double yy, double xy) {
  for (int p = 0; p < particles.count; ++p) {
    particles.increment(p, 0) = xx;
    particles.increment(p, 1) = yy;
    particles.increment(p, 2) = 0.0;
    particles.increment(p, 3) = xy;
    particles.increment(p, 4) = particles.volume(p);
    particles.volume(p) *= 1.0 + xx + yy;
  }
}

StressTally update(const Scene& scene, State& state) {
  Particles& particles = state.particles[0];
  return update_stress(
      scene.materials[0], scene.step, state.grid, 0.0, testing::all_rows_of(particles), particles
  );
}

TEST(UpdateStress, StressIsThatOfTheStrain) {
  Scene scene = testing::two_tiles(two_one());
  scene.step.linear_viscosity = scene.step.quadratic_viscosity = 0.0;
  State state = testing::start_in_tiles(scene);
  for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.1);
  Particles& particles = state.particles[0];
  set_increment(particles, 0.01, 0.0, 0.02);
  const StressTally tally = update(scene, state);
  const double tolerance = 1e-16;
  for (int p = 0; p < particles.count; ++p) {
    EXPECT_NEAR(particles.stress(p, 0), 2.0 * 0.01 + 2.0 * 0.01 * 2.0 / 3.0, tolerance);
    EXPECT_NEAR(particles.stress(p, 1), 2.0 * 0.01 - 2.0 * 0.01 / 3.0, tolerance);
    EXPECT_NEAR(particles.stress(p, 2), 2.0 * 0.01 - 2.0 * 0.01 / 3.0, tolerance);
    EXPECT_NEAR(particles.stress(p, 3), 2.0 * 0.02, tolerance);
    EXPECT_EQ(particles.viscous_pressure(p), 0.0);
  }
  // Mean volume times half of the new stress times the strain, for each of two particles.
  const double work = 0.5 * ((10.0 / 3.0) * 1e-4 + 2.0 * 2.0 * 4e-4);
  EXPECT_NEAR(tally.stress_work, 2.0 * 1.005 * work, 1e-17);
  EXPECT_EQ(tally.plastic.value(), 0.0);
  EXPECT_EQ(tally.failures, 0.0);
  EXPECT_EQ(tally.first_failed, -1);
}

/// q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2), and the stable step C h / (Q + sqrt(Q^2 + c^2)),
/// each with the cell size and the step of the particle's tile.
TEST(UpdateStress, ViscosityAndStableStepAreThoseOfTheTile) {
  Scene scene = testing::two_tiles(two_one());
  scene.step.linear_viscosity = 0.5;
  scene.step.quadratic_viscosity = 2.0;
  State state = testing::start_in_tiles(scene);
  const double cell_size[] = {1.0, 0.25}, dt[] = {0.1, 0.02};
  for (int tile = 0; tile < 2; ++tile)
    testing::set_frame(state.grid, tile, cell_size[tile], dt[tile]);
  Particles& particles = state.particles[0];
  set_increment(particles, -0.01, 0.0, 0.0);
  const StressTally tally = update(scene, state);
  double stable = std::numeric_limits<double>::infinity();
  for (int tile = 0; tile < 2; ++tile) {
    const double density = 1.0 / 0.99, c = std::sqrt(10.0 / 3.0 / density);
    const double h_rate = cell_size[tile] * 0.01 / dt[tile];
    const int p = testing::row_in(particles, tile);
    EXPECT_NEAR(
        particles.viscous_pressure(p), density * (0.5 * c * h_rate + 2.0 * h_rate * h_rate), 1e-15
    );
    const double q = 0.5 * c + 2.0 * h_rate;
    const double courant =
        scene.step.courant_fraction * particles.critical_courant / std::sqrt(2.0);
    stable = std::min(stable, courant * cell_size[tile] / (q + std::sqrt(q * q + c * c)));
  }
  EXPECT_NEAR(tally.stable_step, stable, 1e-15);
}

TEST(UpdateStress, APointThatExpandsBeyondTheBoundFails) {
  Scene scene = testing::two_tiles(two_one());
  scene.step.largest_expansion = 1.5;
  scene.materials[0].bad_particles = BadParticlePolicy::remove;
  State state = testing::start_in_tiles(scene);
  for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.1);
  Particles& particles = state.particles[0];
  set_increment(particles, 0.01, 0.0, 0.0);
  const int p = testing::row_in(particles, 1);
  particles.volume(p) = 1.6;
  const StressTally tally = update(scene, state);
  EXPECT_EQ(tally.failures, 1.0);
  EXPECT_EQ(tally.first_failed, particles.id(p));
  EXPECT_EQ(particles.fault(p), Fault::expanded);
  EXPECT_EQ(particles.stress(p, 0), 0.0);  // as it was
  EXPECT_EQ(particles.fault(testing::row_in(particles, 0)), Fault::none);
}

/// Every field of a state after an update with these steps of the two tiles; rows of both share a
/// group of lanes.
std::vector<std::vector<double>> updated(const MaterialSpec& material, double left, double right) {
  Scene scene = testing::two_tiles(material, 2);
  State state = testing::start_in_tiles(scene);
  testing::set_frame(state.grid, 0, 1.0, left);
  testing::set_frame(state.grid, 1, 1.0, right);
  Particles& particles = state.particles[0];
  set_increment(particles, -0.004, 0.001, 0.003);
  update(scene, state);
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(particles.count));
  for (int p = 0; p < particles.count; ++p) {
    auto& row = rows[static_cast<std::size_t>(p)];
    row.push_back(tile_of(state.grid.patch, particles, p));
    particles.for_each_field([&](const Field& field) {
      for (int c = 0; c < field.components; ++c) row.push_back(field(p, c));
    });
  }
  return rows;
}

TEST(UpdateStress, TwoTilesWithStepsOfTheirOwnAreTwoRuns) {
  const std::vector<std::function<MaterialSpec()>> materials{
      two_one, [] { return testing::copper(); }, [] { return testing::copper(0.0); }};
  for (const auto& material : materials) {
    const double steps[] = {1e-9, 4e-7};
    const auto both = updated(material(), steps[0], steps[1]);
    for (int tile = 0; tile < 2; ++tile) {
      const auto one = updated(material(), steps[tile], steps[tile]);
      int rows = 0;
      for (std::size_t p = 0; p < both.size(); ++p) {
        if (both[p][0] != tile) continue;
        EXPECT_EQ(both[p], one[p]);
        ++rows;
      }
      EXPECT_EQ(rows, 4);
    }
    EXPECT_NE(updated(material(), steps[0], steps[0]), updated(material(), steps[1], steps[1]));
  }
}

}  // namespace
}  // namespace barreno
