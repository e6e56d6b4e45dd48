// SPDX-License-Identifier: BSD-3-Clause
// Runs that go wrong without any bad particle end with a sentence.
#include "state/balance.hpp"
#include "support/scenes.hpp"
#include "watch_run.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace barreno {
namespace {

Scene flying_block(double speed) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {8.0, 8.0}, testing::elastic(1e7, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {2.1, 2.2}, {3.1, 3.2}, 2).velocity = {speed, 0.0, 0.0};
  scene.end_time = 1.0;
  return scene;
}

/// Steps until the watch says something, at most `steps`.
std::string watched(const Scene& scene, State& state, int steps) {
  RunWatch watch;
  for (int i = 0; i < steps; ++i) {
    const double last_dt = state.clock.dt;
    advance(scene, scene.end_time, state);
    std::string wrong = watch_run(scene, state, last_dt, watch);
    if (!wrong.empty()) return wrong;
  }
  return {};
}

TEST(WatchRun, SaysNothingOfASoundRun) {
  const Scene scene = flying_block(10.0);
  State state = testing::start(scene);
  EXPECT_EQ(watched(scene, state, 120), "");
}

TEST(WatchRun, SaysThatTimeStandsStill) {
  const Scene scene = flying_block(1e30);
  State state = testing::start(scene);
  const std::string wrong = watched(scene, state, 20);
  EXPECT_NE(wrong.find("Time has stalled at t = "), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("of material 'elastic', with 1e+30 m/s"), std::string::npos) << wrong;
  EXPECT_LE(state.clock.step, 15);
}

/// A short first step that grows is no reason to end.
TEST(WatchRun, LetsAStepGrow) {
  Scene scene = flying_block(10.0);
  scene.step.initial_step = 1e-30;
  State state = testing::start(scene);
  EXPECT_EQ(watched(scene, state, 200), "");
}

TEST(WatchRun, SaysThatEnergyCameFromNowhere) {
  const Scene scene = flying_block(1.0);
  State state = testing::start(scene);
  EXPECT_EQ(watched(scene, state, 10), "");
  for (Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) particles.velocity(p, 1) = 4.0;
  const std::string wrong = watched(scene, state, energy_interval);
  EXPECT_NE(wrong.find("times the energy supplied at t = "), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("Courant Fraction"), std::string::npos) << wrong;
  EXPECT_EQ(state.clock.step, energy_interval);
}

/// What the run does already, or what its deck would be refused with, is no advice.
TEST(WatchRun, AdvisesWhatTheRunDoesNotFollow) {
  Scene scene = flying_block(1.0);
  const auto sentence = [&] {
    State state = testing::start(scene);
    watched(scene, state, 10);
    for (Particles& particles : state.particles)
      for (int p = 0; p < particles.count; ++p) particles.velocity(p, 1) = 4.0;
    return watched(scene, state, energy_interval);
  };
  EXPECT_NE(sentence().find("unstable: set \"Stable Alone\""), std::string::npos);
  scene.step.stable_alone = true;
  std::string wrong = sentence();
  EXPECT_EQ(wrong.find("Stable Alone"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("unstable: halve the \"Courant Fraction\""), std::string::npos) << wrong;
  scene.step.return_losses = true;
  wrong = sentence();
  EXPECT_NE(wrong.find("unstable: set \"Return Losses\" to false"), std::string::npos) << wrong;
  EXPECT_EQ(wrong.find("modified stress last"), std::string::npos) << wrong;
}

TEST(WatchRun, LooksAtTheEndToo) {
  Scene scene = flying_block(10.0);
  scene.end_time = 1e-6;
  State state = testing::start(scene);
  for (Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) particles.velocity(p, 1) = 100.0;
  EXPECT_NE(watched(scene, state, 5), "");
  EXPECT_LT(state.clock.step, energy_interval);
}

/// A plate that moves strains the block in a first step; its force does work from the next one on.
TEST(WatchRun, LetsAPlateStrainABlockAtRestInAFirstStep) {
  Scene scene = flying_block(0.0);
  scene.materials.push_back(scene.materials[0]);
  BodySpec& plate = testing::add_box(scene, "plate", {2.1, 3.2}, {3.1, 4.2}, 2);
  plate.material = 1;
  plate.motion.prescribed = true;
  plate.motion.velocity = {0.0, -1.0, 0.0};
  scene.end_time = 1e-6;
  State state = testing::start(scene);
  EXPECT_EQ(watched(scene, state, 1), "");
  EXPECT_EQ(state.clock.step, 1);
  EXPECT_GT(sum_over_ranks(*state.grid.comm, state.ledger).elastic, 0.0);
}

}  // namespace
}  // namespace barreno
