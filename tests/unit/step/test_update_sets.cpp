// SPDX-License-Identifier: BSD-3-Clause
#include "step/step_result.hpp"
#include "step/update_sets.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

/// Two particles whose grid moves at v = (2, -1) after an increment of (1, 1), and strains them by
/// dt L = 0.01 along x.
struct Moved {
  Scene scene;
  State state;
  Particles& particles;
  StepTally tally;
  StepResult result;

  explicit Moved(BadParticlePolicy policy = BadParticlePolicy::stop)
      : scene(make(policy)), state(testing::start_in_tiles(scene)), particles(state.particles[0]) {
    for (int tile = 0; tile < 2; ++tile) testing::set_frame(state.grid, tile, 1.0, 0.5);
    for (int p = 0; p < particles.count; ++p) {
      const double motion[] = {2.0, -1.0, 1.0, 1.0};
      for (int c = 0; c < 4; ++c) particles.grid_motion(p, c) = motion[c];
      for (int c = 0; c < 5; ++c) particles.increment(p, c) = c == 0 ? 0.01 : 0.0;
    }
  }
  static Scene make(BadParticlePolicy policy) {
    Scene scene = testing::two_tiles(Material{"elastic", 1.0, LinearElastic({2.0, 1.0}, 1.0)});
    scene.materials[0].bad_particles = policy;
    return scene;
  }
  SetUpdate update() { return set_update(scene.materials, scene.step, 0.0, state); }
  bool accelerated() const { return particles.velocity(0, 0) == 1.0; }
  bool moved() const { return particles.position(0, 1) == 3.0; }
  bool strained() const {
    return particles.deformation_gradient(0, 0) > 1.0 && particles.stress(0, 0) > 0.0;
  }
};

TEST(UpdateSets, EveryOrderOfTheStepDoesItsPart) {
  Moved all;
  update_sets(all.update(), all.tally, all.result);
  EXPECT_TRUE(all.accelerated() && all.moved() && all.strained());
  EXPECT_EQ(all.tally.moved.mass, 2.0);
  EXPECT_EQ(all.tally.moved.kinetic, 2.0 * 0.5 * 2.0);
  EXPECT_LT(all.tally.stress.stable_step, 1.0);

  Moved first;
  accelerate_sets(first.update(), first.tally);
  EXPECT_TRUE(first.accelerated() && !first.moved() && !first.strained());
  move_and_strain_sets(first.update(), first.tally, first.result);
  EXPECT_TRUE(first.moved() && first.strained());
  EXPECT_EQ(first.particles.stress(0, 0), all.particles.stress(0, 0));

  Moved strain;
  strain_sets(strain.update(), strain.tally, strain.result);
  EXPECT_TRUE(!strain.accelerated() && !strain.moved() && strain.strained());
  accelerate_and_move_sets(strain.update(), strain.tally);
  EXPECT_TRUE(strain.accelerated() && strain.moved());
}

TEST(UpdateSets, AFailureStopsIsHeldOrIsRemoved) {
  for (const auto policy :
       {BadParticlePolicy::stop, BadParticlePolicy::hold, BadParticlePolicy::remove}) {
    Moved one(policy);
    one.scene.step.largest_expansion = 1.2;
    const int p = testing::row_in(one.particles, 1);
    one.particles.volume(p) = 1.5;
    update_sets(one.update(), one.tally, one.result);
    EXPECT_EQ(one.tally.stress.failures, 1.0);
    EXPECT_EQ(one.state.ledger.held.value(), policy == BadParticlePolicy::hold ? 1.0 : 0.0);
    EXPECT_EQ(one.result.stopped, policy == BadParticlePolicy::stop);
    EXPECT_EQ(one.result.failed, policy == BadParticlePolicy::stop ? one.particles.id(p) : -1);
    agree_on_failure(one.scene.materials, *one.state.grid.comm, one.result);
    EXPECT_EQ(one.result.stopped, policy == BadParticlePolicy::stop);
  }
}

}  // namespace
}  // namespace barreno
