// SPDX-License-Identifier: BSD-3-Clause
// Particles of a jet that become long are divided; test_explosives.cpp has the sums that a division
// keeps.
#include "state/balance.hpp"
#include "step/advance.hpp"
#include "step/jet/launch_jet.hpp"
#include "step/order/split_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace barreno {
namespace {

using testing::advance_to;
using testing::all_rows;

constexpr int splits = 3, parts = 1 << splits, block_particles = 32, jet_particles = 24;

/// A jet of four by six particles, two to a cell of size 1, that flies down onto a block.
Scene jet_scene(const char* shape) {
  Scene scene = testing::box_scene(
      Mode::axisymmetric, 1.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {8.0, 4.0}, 1);
  scene.jet.present = true;
  scene.jet.launch_position = 10.0;
  scene.jet.direction = -1.0;
  scene.jet.particles_per_cell = 2;
  scene.jet.splits = splits;
  scene.jet.slugs = {{0.5, 40.0, 2.0, 3.0, 1000.0}};
  scene.step.shape = shape;
  return scene;
}

State launched(const Scene& scene) {
  State state = testing::start_alone(scene);
  launch_jet(
      scene.jet, scene.materials[0], state.grid, 0.5, state.jet, state.particles[0], state.ledger
  );
  return state;
}

/// Drawn out to 16 times its length, eight cells, along y.
int draw_out(Particles& jet) {
  const int row = jet.count - 1;
  jet.deformation_gradient(row, 3) = 16.0;
  jet.deformation_gradient(row, 0) = 1.0 / 4.0;
  return row;
}

TEST(SplitParticles, PlacesAreKeptForAllPartsOfAJet) {
  const Scene scene = jet_scene("GIMP");
  const State state = launched(scene);
  const Particles& set = state.particles[0];
  std::set<ParticleId> ids;
  int of_jet = 0;
  for (int p = 0; p < set.count; ++p) {
    if (set.body(p) != 1) continue;
    EXPECT_EQ((set.id(p) - block_particles - 1) % parts, 0);
    ids.insert(set.id(p));
    ++of_jet;
  }
  EXPECT_EQ(of_jet, jet_particles);
  EXPECT_EQ(static_cast<int>(ids.size()), of_jet);
}

/// At rest it is half a cell wide, which is borne; the block's particles, wider, are not its own.
TEST(SplitParticles, AJetThatIsNotDrawnOutStaysWhole) {
  const Scene scene = jet_scene("GIMP");
  State state = launched(scene);
  EXPECT_EQ(split_particles(state.grid, state.particles[0]), 0);
}

/// One becomes eight that lie side by side, and no more. Boxes of weights that do not follow the
/// deformation stay, others halve.
void expect_eight(const char* shape, double left_of_box) {
  const Scene scene = jet_scene(shape);
  State state = launched(scene);
  Particles& set = state.particles[0];
  const int before = set.count, row = draw_out(set);
  const double mass = set.mass(row), box = set.half_size(row, 1);
  const ParticleId id = set.id(row);
  set.position(row, 1) = 10.0;
  for (int n = 0; n < splits; ++n) EXPECT_EQ(split_particles(state.grid, set), 1 << n);
  EXPECT_EQ(split_particles(state.grid, set), 0);
  ASSERT_EQ(set.count, before + parts - 1);
  std::vector<double> places;
  std::set<ParticleId> ids;
  for (int p = 0; p < set.count; ++p) {
    if (set.id(p) < id || set.id(p) >= id + parts) continue;
    ids.insert(set.id(p));
    places.push_back(set.position(p, 1));
    EXPECT_EQ(set.mass(p), mass / parts);
    EXPECT_EQ(set.half_size(p, 1), left_of_box * box);
    EXPECT_EQ(set.splits(p, 0), 0.0);
    EXPECT_EQ(set.splits(p, 1), double(splits));
  }
  EXPECT_EQ(static_cast<int>(ids.size()), parts);
  std::sort(places.begin(), places.end());
  for (std::size_t n = 0; n < places.size(); ++n)
    EXPECT_NEAR(places[n], 10.0 + (double(n) - 3.5) * 2.0 * box * 16.0 / parts, 1e-12);
}
TEST(SplitParticles, ADrawnOutParticleBecomesEightWhoseBoxStays) {
  expect_eight("GIMP", 1.0);
}
TEST(SplitParticles, ADrawnOutParticleBecomesEightWhoseDomainIsAnEighth) {
  expect_eight("CPDI", 1.0 / parts);
}

/// Each rank repeats the run alone: a jet that spreads on the block.
TEST(SplitParticles, AnyRankCountGivesTheSameBitsOfADividedJet) {
  Scene scene = jet_scene("GIMP");
  scene.jet.slugs[0].time = 0.0;
  State together = testing::start(scene), alone = testing::start_alone(scene);
  advance_to(scene, 0.3, together);
  advance_to(scene, 0.3, alone);
  EXPECT_GT(alone.particles[0].count, block_particles + jet_particles + 5);
  EXPECT_EQ(all_rows(together), all_rows(alone));
  const Ledger ledger = sum_over_ranks(*together.grid.comm, together.ledger);
  EXPECT_LT(std::fabs(mass_balance(ledger).error()), 1e-13);
  EXPECT_LT(std::fabs(energy_balance(ledger).error()), 1e-4);
}

}  // namespace
}  // namespace barreno
