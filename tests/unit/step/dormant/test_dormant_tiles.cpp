// SPDX-License-Identifier: BSD-3-Clause
// Tiles at rest are left out of a step, and nobody can tell from the answer.
#include "barreno/models.hpp"
#include "barreno/registry.hpp"
#include "base/gather.hpp"
#include "state/balance.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::on_root;
using testing::start;
using testing::start_alone;

const std::string cards = BARRENO_SOURCE_DIR "/materials/cards/";
constexpr double pressure = 70e6;
constexpr double end_time = 3e-6;

MaterialSpec sandstone() {
  return read_card(cards + "berea_sandstone.xml");
}

/// A copper rod that crosses tiles, leaves some empty and hits the end of a long block.
Scene impact(Mode mode, const MaterialSpec& target) {
  Scene scene = box_scene(mode, 1e-3, {0.0, 0.0, 0.0}, {0.024, 0.100, 0.012}, testing::copper());
  scene.materials.push_back(target);
  scene.materials.back().bad_particles = BadParticlePolicy::hold;
  const bool space = mode == Mode::three_dimensional;
  add_box(scene, "rod", {0.0, 0.001, 0.0}, {0.0041, 0.0125, 0.0042}, 2).velocity = {0, 1500.0, 0};
  const Vector upper{space ? 0.0092 : 0.0172, space ? 0.0607 : 0.0907, 0.0052};
  add_box(scene, "block", {0.0, 0.0129, 0.0}, upper, 2).material = 1;
  add_symmetry(scene, Face::x_lower);
  if (space) add_symmetry(scene, Face::z_lower);
  return scene;
}

/// The same in equilibrium under a pressure; its far end rests on a plane of symmetry if `held`.
Scene confined(Mode mode, bool held = false) {
  Scene scene = impact(mode, sandstone());
  scene.bodies[1].initial_pressure = pressure;
  PressureLoadSpec load;
  load.body = 1;
  load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
  load.faces[static_cast<std::size_t>(Face::y_lower)] = true;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = !held;
  load.faces[static_cast<std::size_t>(Face::z_upper)] = mode == Mode::three_dimensional;
  load.pressure = {{0.0}, {pressure}};
  scene.loads.push_back(load);
  if (held) {
    scene.grid.upper[1] = std::get<Box>(scene.bodies[1].shape).upper[1] = 0.088;
    add_symmetry(scene, Face::y_upper);
  }
  return scene;
}

struct Ended {
  State state;
  std::vector<std::vector<double>> rows;
  double advanced = 0.0, skipped = 0.0;
  double share() const { return skipped / (skipped + advanced); }
};

Ended finish(const Scene& scene, State state, double time = end_time) {
  advance_to(scene, time, state);
  std::array<double, 2> counts{state.particle_steps, state.skipped_steps};
  sum_over_ranks(*state.grid.comm, counts);
  auto rows = all_rows(state);
  return {std::move(state), std::move(rows), counts[0], counts[1]};
}
Ended run(const Scene& scene, double time = end_time) {
  return finish(scene, start(scene), time);
}
Ended run_without(Scene scene, double time = end_time) {
  scene.step.skip_dormant = false;
  Ended without = run(scene, time);
  EXPECT_EQ(without.skipped, 0.0);
  return without;
}

void expect_same_ledger(const Ledger& a, const Ledger& b) {
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.momentum, b.momentum);
  EXPECT_EQ(a.kinetic, b.kinetic);
  EXPECT_EQ(a.elastic, b.elastic);
  EXPECT_EQ(a.plastic, b.plastic);
  EXPECT_EQ(a.viscous, b.viscous);
  EXPECT_EQ(a.friction, b.friction);
  EXPECT_EQ(a.boundary_work, b.boundary_work);
  EXPECT_EQ(a.load_impulse, b.load_impulse);
  EXPECT_EQ(a.condition_impulse, b.condition_impulse);
  EXPECT_EQ(a.transfer, b.transfer);
  EXPECT_EQ(a.stress_integration, b.stress_integration);
}

/// Skipping changes no bit of particles, steps and ledger, and skips at least a share.
void expect_same_without(const Scene& scene, double min_share) {
  const Ended with = run(scene);
  const Ended without = run_without(scene);
  EXPECT_GT(with.share(), min_share);
  EXPECT_EQ(with.skipped + with.advanced, without.advanced);
  EXPECT_GT(with.state.clock.step, 20);
  EXPECT_EQ(with.state.clock.step, without.state.clock.step);
  EXPECT_EQ(with.state.clock.dt, without.state.clock.dt);
  EXPECT_EQ(with.rows, without.rows);
  const Ledger ledger = sum_over_ranks(*with.state.grid.comm, with.state.ledger);
  expect_same_ledger(ledger, sum_over_ranks(*with.state.grid.comm, without.state.ledger));
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-12);
}

TEST(DormantTiles, NobodyCanTellInUnstressedMetal) {
  for (const Mode mode : {Mode::plane_strain, Mode::three_dimensional})
    expect_same_without(impact(mode, testing::copper()), 0.05);
  // An equation of state makes a stress of the round-off in volumes of rings: no node is still.
  expect_same_without(impact(Mode::axisymmetric, testing::copper()), -1.0);
}
TEST(DormantTiles, NobodyCanTellInUnstressedRock) {
  for (const Mode mode : all_modes) expect_same_without(impact(mode, sandstone()), 0.05);
}
TEST(DormantTiles, NobodyCanTellInConfinedRock) {
  for (const Mode mode : all_modes) {
    expect_same_without(confined(mode), 0.2);
    expect_same_without(confined(mode, true), 0.2);
  }
}
/// Two velocity fields, and nodes where both have mass.
TEST(DormantTiles, NobodyCanTellBesideContact) {
  Scene scene = confined(Mode::axisymmetric);
  scene.contacts.push_back({"faces", {0, 1}, ContactKind::friction, 0.2});
  expect_same_without(scene, 0.2);
  scene = impact(Mode::three_dimensional, sandstone());
  scene.contacts.push_back({"faces", {0, 1}, ContactKind::frictionless, 0.0});
  expect_same_without(scene, 0.05);
}

/// A rigid body has a field of its own, which is the first here.
TEST(DormantTiles, NobodyCanTellBesideARigidBody) {
  Scene scene = impact(Mode::plane_strain, sandstone());
  scene.bodies[0].motion.prescribed = true;
  scene.bodies[0].motion.velocity = {0.0, 300.0, 0.0};
  scene.bodies[0].motion.factor = {{0.0, 1e-6, 2e-6}, {0.0, 0.0, 1.0}};
  expect_same_without(scene, 0.05);
}

TEST(DormantTiles, MoreRestWhereRoundOffWakesNobody) {
  for (const MaterialSpec& target : {testing::copper(), sandstone()}) {
    Scene scene = impact(Mode::axisymmetric, target);
    const double exact = run(scene).share();
    scene.step.rest_motion = 1e-16;
    expect_same_without(scene, exact + 0.1);
  }
}

/// Against the step without any rule, before chaos has made digits of round-off.
TEST(DormantTiles, ConfinedRockMovesAsItDoesWhenAllIsAwake) {
  for (const Mode mode : all_modes) {
    Scene awake = confined(mode);
    const Ended with = run(awake, 0.5 * end_time);
    EXPECT_GT(with.share(), 0.25);
    awake.step.rest_motion = 0.0;
    const Ended without = run_without(awake, 0.5 * end_time);
    ASSERT_EQ(with.rows.size(), without.rows.size());
    for (std::size_t c = 0; c < with.rows.front().size(); ++c) {
      double size = 0.0, worst = 0.0;
      for (std::size_t i = 0; i < with.rows.size(); ++i) {
        size = std::max(size, std::abs(without.rows[i][c]));
        worst = std::max(worst, std::abs(with.rows[i][c] - without.rows[i][c]));
      }
      EXPECT_LE(worst, 1e-10 * size) << "column " << c;
    }
  }
}

/// The root repeats the run alone; and the rows are stored in another order.
TEST(DormantTiles, AnyRankCountAndOrderGivesTheSameBits) {
  for (const Mode mode : all_modes) {
    const Scene scene = confined(mode);
    const Ended together = run(scene);
    on_root([&] { EXPECT_EQ(together.rows, finish(scene, start_alone(scene)).rows); });
    State shuffled = start(scene);
    for (Particles& particles : shuffled.particles) {
      for (int k = 0; k < particles.count; ++k)
        particles.order(static_cast<std::size_t>(k)) = (k * 7919) % particles.count;
      if (particles.count % 7919 != 0) permute_rows(particles);
      particles.sorted = false;
    }
    EXPECT_EQ(together.rows, finish(scene, std::move(shuffled)).rows);
  }
}

/// Where features see all particles nothing is skipped.
TEST(DormantTiles, AllAreAwakeWhereAFeatureAsksForAll) {
  const Scene scene = impact(Mode::axisymmetric, testing::copper());
  EXPECT_TRUE(start(scene).dormancy.on);
  const auto expect_awake = [&](const auto& change) {
    Scene changed = scene;
    change(changed);
    EXPECT_FALSE(start(changed).dormancy.on);
  };
  expect_awake([](Scene& s) { s.step.skip_dormant = false; });
  expect_awake([](Scene& s) { s.step.order = Order::stress_first; });
  expect_awake([](Scene& s) { s.step.transfer = Transfer::xpic; });
  expect_awake([](Scene& s) { s.step.transfer = Transfer::apic; });
  expect_awake([](Scene& s) { s.body_force.kind = BodyForceKind::gravity; });
  expect_awake([](Scene& s) {
    PressureLoadSpec load;
    load.pressure = {{0.0, 1e-6}, {0.0, 1e6}};
    s.loads.push_back(load);
  });
}

}  // namespace
}  // namespace barreno
