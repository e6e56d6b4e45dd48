// SPDX-License-Identifier: BSD-3-Clause
// Charges that burn: their energy in the ledger, tiles that wake when the front comes, what expands
// too far, divided particles, and the same bits on any number of ranks.
#include "barreno/models.hpp"
#include "base/error.hpp"
#include "scene/lighting.hpp"
#include "scene/lighting_map.hpp"
#include "state/balance.hpp"
#include "step/order/split_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace barreno {
namespace {

using testing::advance_to;
using testing::all_rows;

JwlExplosive::Parameters comp_b(int splits) {
  JwlExplosive::Parameters p;
  p.detonation_speed = 7980.0;
  p.a = 524.23e9;
  p.b = 7.678e9;
  p.r1 = 4.2;
  p.r2 = 1.1;
  p.omega = 0.34;
  p.energy = 8.5e9;
  p.splits = splits;
  return p;
}
constexpr double density = 1717.0;

/// A charge lit in a corner of it beside a copper plate.
Scene charge(Mode mode, int splits = 0) {
  Scene scene = testing::box_scene(
      mode,
      1e-3,
      {0.0, -0.024, 0.0},
      {0.032, 0.048, 0.0},
      Material{"comp b", density, JwlExplosive(comp_b(splits), density)}
  );
  scene.materials[0].bad_particles = BadParticlePolicy::remove;
  scene.materials.push_back(testing::copper());
  testing::add_box(scene, "charge", {0.0, 0.004, 0.0}, {0.012, 0.030, 0.0}, 2);
  testing::add_box(scene, "plate", {0.0, 0.030, 0.0}, {0.014, 0.033, 0.0}, 2).material = 1;
  testing::add_symmetry(scene, Face::x_lower);
  DetonatorSpec point;
  point.position = {0.0, 0.004, 0.0};
  scene.detonation.bodies = {0};
  scene.detonation.speed = 7980.0;
  scene.detonation.detonators = {point};
  return scene;
}

/// Sum of V_ref (E0 - E) over the particles.
double energy_given(const Particles& gas) {
  double sum = 0.0;
  for (int p = 0; p < gas.count; ++p) sum += gas.mass(p) * (8.5e9 / density - gas.history(p, 2));
  return sum;
}

/// Also where the particles that the detonation does not reach are all on one of the ranks.
TEST(Explosives, APartThatIsNeverLitIsRefusedByEveryRank) {
  Scene scene = charge(Mode::axisymmetric);
  EXPECT_NO_THROW(testing::start(scene));
  const Box lower_end{{0.0, 0.004, 0.0}, {0.012, 0.008, 0.0}};
  const Box upper_end{{0.0, 0.026, 0.0}, {0.012, 0.030, 0.0}};
  const std::vector<Shape> apart{lower_end, upper_end};
  scene.detonation.map = std::make_shared<LightingMap>(scene.grid, apart, scene.detonation);
  EXPECT_THROW(testing::start(scene), DeckError);
}

TEST(Explosives, TheLedgerHasWhatTheExplosiveGaveAndCloses) {
  const Scene scene = charge(Mode::axisymmetric);
  State state = testing::start(scene);
  advance_to(scene, 4e-6, state);
  const Comm& comm = *state.grid.comm;
  const Ledger ledger = sum_over_ranks(comm, state.ledger);
  std::vector<double> given{energy_given(state.particles[0])};
  sum_over_ranks(comm, given);
  const double charge_energy = 8.5e9 * 3.14159265358979 * 0.012 * 0.012 * 0.026;
  EXPECT_GT(ledger.explosive, 0.1 * charge_energy);
  EXPECT_LT(ledger.explosive, 0.9 * charge_energy);
  EXPECT_EQ(total_removed(ledger).count, 0.0);
  EXPECT_NEAR(given[0] / ledger.explosive, 1.0, 1e-11);
  EXPECT_LT(std::fabs(energy_balance(ledger).error()), 1e-3);
  EXPECT_LT(std::fabs(momentum_balance(ledger).error()), 1e-12);
}

TEST(Explosives, TilesWakeWhenTheFrontComes) {
  Scene scene = charge(Mode::plane_strain);
  scene.detonation.detonators[0].time = 1e-6;
  State state = testing::start_alone(scene);
  ASSERT_TRUE(state.dormancy.on && state.dormancy.skip);
  advance_to(scene, 0.9e-6, state);
  EXPECT_EQ(state.ledger.kinetic.value(), 0.0);
  EXPECT_GT(state.skipped_steps, 0.8 * state.particle_steps);
  advance_to(scene, 3e-6, state);
  EXPECT_GT(state.ledger.kinetic.value(), 0.0);
  scene.step.skip_dormant = false;
  State awake = testing::start_alone(scene);
  advance_to(scene, 0.9e-6, awake);
  advance_to(scene, 3e-6, awake);
  EXPECT_EQ(awake.skipped_steps, 0.0);
  EXPECT_EQ(all_rows(state), all_rows(awake));
}

TEST(Explosives, GasBeyondTheLargestExpansionIsRemovedAndMetalIsNot) {
  Scene scene = charge(Mode::plane_strain);
  EXPECT_EQ(scene.materials[0].largest_expansion, 100.0);
  EXPECT_FALSE(scene.materials[1].largest_expansion.has_value());
  scene.materials[0].largest_expansion = 3.0;
  State state = testing::start_alone(scene);
  advance_to(scene, 6e-6, state);
  const auto& gone = state.ledger.removed[static_cast<std::size_t>(RemovalCause::expanded)];
  EXPECT_GT(gone.count.value(), 0.0);
  const Particles& gas = state.particles[0];
  for (int p = 0; p < gas.count; ++p)
    EXPECT_LE(gas.fault(p) == Fault::none ? gas.volume(p) * density / gas.mass(p) : 0.0, 3.0);
  EXPECT_EQ(state.particles[1].count, 14 * 2 * 3 * 2);
}

/// Sums that a division keeps.
struct Sums {
  double mass = 0.0, volume = 0.0, first = 0.0, momentum = 0.0, kinetic = 0.0, internal = 0.0;
};
Sums sums_of(const Particles& gas) {
  Sums sums;
  for (int p = 0; p < gas.count; ++p) {
    const double m = gas.mass(p);
    sums.mass += m;
    sums.volume += gas.volume(p);
    sums.first += m * gas.position(p, 1);
    sums.momentum += m * gas.velocity(p, 1);
    sums.kinetic += 0.5 * m * gas.velocity(p, 1) * gas.velocity(p, 1);
    sums.internal += m * gas.history(p, 2);
  }
  return sums;
}

void expect_division(Mode mode) {
  const Scene scene = charge(mode, 3);
  State state = testing::start_alone(scene);
  Particles& gas = state.particles[0];
  const int before = gas.count;
  EXPECT_EQ(split_particles(state.grid, gas), 0);
  const int row = 1000, columns = gas.deformation_gradient.components;
  const double stretch = 3.0;  // of half a cell: wider than one
  gas.deformation_gradient(row, 0) = stretch;
  gas.deformation_gradient(row, 2) = 0.25;  // F e_x leans
  gas.volume(row) *= stretch;
  for (int p = 0; p < before; ++p) gas.velocity(p, 1) = 100.0 + p;
  const double x = gas.position(row, 0), y = gas.position(row, 1), half = gas.half_size(row, 0);
  const ParticleId id = gas.id(row);
  EXPECT_EQ((id - 1) % 8, 0);
  const Sums old = sums_of(gas);
  ASSERT_EQ(split_particles(state.grid, gas), 1);
  ASSERT_EQ(gas.count, before + 1);
  const Sums now = sums_of(gas);
  EXPECT_NEAR(now.mass / old.mass, 1.0, 1e-13);
  EXPECT_NEAR(now.volume / old.volume, 1.0, 1e-13);
  EXPECT_NEAR(now.momentum / old.momentum, 1.0, 1e-13);
  EXPECT_NEAR(now.kinetic / old.kinetic, 1.0, 1e-13);
  EXPECT_NEAR(now.internal / old.internal, 1.0, 1e-13);
  if (mode == Mode::plane_strain) {
    EXPECT_NEAR(now.first / old.first, 1.0, 1e-13);
  }
  // The two domains lie side by side in that of the parent.
  const int child = before;
  EXPECT_NEAR(gas.position(row, 0), x - 0.5 * stretch * half, 1e-18);
  EXPECT_NEAR(gas.position(child, 0), x + 0.5 * stretch * half, 1e-18);
  EXPECT_NEAR(gas.position(child, 1), y + 0.5 * 0.25 * half, 1e-18);
  EXPECT_EQ(gas.half_size(row, 0), 0.5 * half);
  EXPECT_EQ(gas.half_size(child, 0), 0.5 * half);
  EXPECT_EQ(gas.half_size(child, 1), half);
  EXPECT_EQ(
      gas.deformation_gradient(child, columns - 1), gas.deformation_gradient(row, columns - 1)
  );
  // Densities are those of the parent, and so are rings' masses over their radii.
  EXPECT_NEAR(gas.mass(child) / gas.volume(child) * gas.volume(row) / gas.mass(row), 1.0, 1e-13);
  const double ratio =
      mode == Mode::axisymmetric ? gas.position(child, 0) / gas.position(row, 0) : 1.0;
  EXPECT_NEAR(gas.mass(child) / gas.mass(row), ratio, 1e-13 * ratio);
  // Ids are those that the parent has to give.
  EXPECT_EQ(gas.id(row), id);
  EXPECT_EQ(gas.id(child), id + 4);
  // Again, and no more often than three times.
  for (int n = 0; n < 5; ++n) {
    for (const int p : {row, child}) gas.deformation_gradient(p, 0) = 30.0;
    split_particles(state.grid, gas);
  }
  std::vector<ParticleId> ids;
  for (int p = 0; p < gas.count; ++p)
    if (gas.id(p) >= id && gas.id(p) < id + 8) ids.push_back(gas.id(p));
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_GT(ids.size(), 4u);
  EXPECT_NEAR(sums_of(gas).mass / old.mass, 1.0, 1e-13);
}
TEST(SplitParticles, ADivisionKeepsAllSumsInPlaneStrain) {
  expect_division(Mode::plane_strain);
}
TEST(SplitParticles, ADivisionKeepsAllSumsInAxisymmetry) {
  expect_division(Mode::axisymmetric);
}

/// Each rank repeats the run alone.
TEST(Explosives, AnyRankCountGivesTheSameBitsWithDividedParticles) {
  const Scene scene = charge(Mode::axisymmetric, 2);
  State together = testing::start(scene), alone = testing::start_alone(scene);
  const int before = alone.particles[0].count;
  advance_to(scene, 6e-6, together);
  advance_to(scene, 6e-6, alone);
  EXPECT_GT(alone.particles[0].count, before + 100);
  EXPECT_EQ(all_rows(together), all_rows(alone));
  const Ledger ledger = sum_over_ranks(*together.grid.comm, together.ledger);
  EXPECT_LT(std::fabs(mass_balance(ledger).error()), 1e-13);
  EXPECT_LT(std::fabs(energy_balance(ledger).error()), 1e-3);
}

}  // namespace
}  // namespace barreno
