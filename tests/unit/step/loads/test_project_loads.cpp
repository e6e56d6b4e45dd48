// SPDX-License-Identifier: BSD-3-Clause
// The force of a load on the face of one particle, at the nodes of the face; its work and impulse.
#include "step/loads/load_pressures.hpp"
#include "step/loads/project_loads.hpp"
#include "step/loads/release_torn_faces.hpp"
#include "unit/step/loads/two_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

using testing::sums_at;

using testing::axial;
using testing::density;
using testing::h;
using testing::shear;
using testing::two_particles;

void apply(const Scene& scene, State& state) {
  set_load_pressures(scene.loads, state.cavities, 0.0, state.loads);
  release_torn_faces(state.grid, state.nodes, state.particles, state.loads);
  project_loads(tractions_of(state), scene.materials);
}

TEST(ProjectLoads, APressurePushesTheNodesOfItsFaceInwards) {
  const Scene scene = two_particles(LoadKind::pressure, Face::y_upper, 4e6);
  State state = testing::in_tiles(scene, 1.0);
  apply(scene, state);
  for (const int x : {3, 4}) {
    const double* const node = sums_at(state, 0, 0, {x, 4});
    EXPECT_DOUBLE_EQ(node[first_force(2) + 1], -4e6 * h / 2.0);
    EXPECT_EQ(node[first_force(2)], 0.0);
    EXPECT_EQ(node[impedance_component], 0.0);
    EXPECT_EQ(sums_at(state, 0, 0, {x, 3})[first_force(2) + 1], 0.0);  // the face behind
  }
}

/// Nanson: a particle that is twice as wide has twice the face.
TEST(ProjectLoads, AFaceIsAsLargeAsItsParticleIsWideNow) {
  const Scene scene = two_particles(LoadKind::pressure, Face::y_upper, 4e6);
  State state = testing::in_tiles(scene, 1.0);
  Particles& particles = state.particles[0];
  particles.deformation_gradient(0, 0) = 1.5;
  particles.volume(0) *= 1.5;
  apply(scene, state);
  const int tile = tile_of(state.grid.patch, particles, 0);
  double force = 0.0;
  for (int slot = 0; slot < state.grid.patch.size; ++slot)
    force += state.nodes[0].sums(
        first_sum(state.grid.patch, tile) +
        static_cast<std::size_t>(slot * sum_components + first_force(2) + 1)
    );
  EXPECT_DOUBLE_EQ(force, -4e6 * 1.5 * h);
}

TEST(ProjectLoads, ANonReflectingFaceHasTheDashpotsOfBothWavesAndTheirImpedance) {
  const Scene scene = two_particles(LoadKind::non_reflecting, Face::y_upper, 5e5);
  State state = testing::in_tiles(scene, 1.0);
  apply(scene, state);
  const double normal = std::sqrt(density * axial), tangential = std::sqrt(density * shear);
  for (const int x : {3, 4}) {
    const double* const node = sums_at(state, 0, 0, {x, 4});
    EXPECT_NEAR(node[first_force(2)], -3.0 * tangential * h / 2.0, 1e-9 * tangential);
    EXPECT_NEAR(node[first_force(2) + 1], -(2.0 * normal + 5e5) * h / 2.0, 1e-9 * normal);
    EXPECT_NEAR(node[impedance_component], normal * h / 2.0, 1e-9 * normal);
  }
}

TEST(ProjectLoads, TilesThatKeepTheirSumsHaveTheForceAlready) {
  const Scene scene = two_particles(LoadKind::pressure, Face::y_upper, 4e6);
  State state = testing::in_tiles(scene, 1.0);
  state.nodes[0].sums_kept = ArrayView<unsigned char>("kept", 2);
  state.nodes[0].sums_kept(0) = 1;
  apply(scene, state);
  EXPECT_EQ(sums_at(state, 0, 0, {3, 4})[first_force(2) + 1], 0.0);
  EXPECT_DOUBLE_EQ(sums_at(state, 0, 1, {3, 12})[first_force(2) + 1], -4e6 * h / 2.0);
}

struct Tallied {
  double work, impulse;
};
/// With nodes at (7, 5) after an increment of (2, 4): 3 along y on average.
Tallied tally(double dt, double dt_above, int particles) {
  Scene scene = two_particles(LoadKind::pressure, Face::y_upper, 4e6);
  if (particles == 1) scene.loads.pop_back();
  State state = testing::in_tiles(scene, dt);
  testing::set_tile_step(state.grid, 1, dt_above);
  apply(scene, state);
  testing::set_motion(state, {7.0, 5.0, 0.0}, {2.0, 4.0, 0.0});
  const double work = tally_loads(tractions_of(state), state.dormancy, state.ledger);
  EXPECT_EQ(state.ledger.boundary_work.value(), work);
  return {work, state.ledger.load_impulse.value()};
}

TEST(TallyLoads, IsForceTimesMeanVelocityAndForceOverTheStep) {
  const Tallied found = tally(0.125, 0.125, 1);
  EXPECT_DOUBLE_EQ(found.work, -4e6 * h * 3.0 * 0.125);
  EXPECT_DOUBLE_EQ(found.impulse, -4e6 * h * 0.125);
}

TEST(TallyLoads, EveryTileTakesItsOwnStep) {
  const Tallied slow = tally(0.125, 0.125, 1), fast = tally(0.03125, 0.03125, 1);
  const Tallied both = tally(0.125, 0.03125, 2);
  EXPECT_DOUBLE_EQ(both.work, slow.work + fast.work);
  EXPECT_DOUBLE_EQ(both.impulse, slow.impulse + fast.impulse);
}

}  // namespace
}  // namespace barreno
