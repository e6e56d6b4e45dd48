// SPDX-License-Identifier: BSD-3-Clause
// The particles of a slug: how many, where, how heavy and how fast.
#include "scene/jet_kinds.hpp"
#include "state/balance.hpp"
#include "step/jet/launch_jet.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

constexpr int jet_body = 1;  // behind the one body of the scene

/// Half a plane jet of cells of size 1, one particle each, that flies down from y = 10. The second
/// slug comes a second later.
Scene jet_scene() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0}, {16.0, 16.0}, testing::elastic(1e6, 0.3, 1000.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0}, {2.0, 2.0}, 1);
  scene.jet.present = true;
  scene.jet.launch_position = 10.0;
  scene.jet.direction = -1.0;
  scene.jet.particles_per_cell = 1;
  scene.jet.slugs = {{0.5, 4.0, 2.0, 3.0, 1000.0}, {1.5, 4.0, 1.0, 1.0, 1000.0}};
  return scene;
}

int launch(const Scene& scene, double time, State& state) {
  return launch_jet(
      scene.jet, scene.materials[0], state.grid, time, state.jet, state.particles[0], state.ledger
  );
}

TEST(LaunchJet, WaitsForTheTimeOfASlug) {
  const Scene scene = jet_scene();
  State state = testing::start_alone(scene);
  EXPECT_EQ(launch(scene, 0.49, state), 4);
  EXPECT_EQ(state.particles[0].count, 4);
  EXPECT_EQ(state.jet.next_slug, 0U);
}

/// Radius 2 and length 3: two by three particles, a quarter of a second behind the launch plane.
TEST(LaunchJet, CutsASlugIntoParticlesThatFillIt) {
  const Scene scene = jet_scene();
  State state = testing::start_alone(scene);
  const Particles& particles = state.particles[0];
  EXPECT_EQ(launch(scene, 0.75, state), 4);
  EXPECT_EQ(state.jet.next_slug, 1U);
  ASSERT_EQ(particles.count, 10);
  EXPECT_FALSE(particles.sorted);
  for (int k = 0; k < 6; ++k) {
    const int p = 4 + k, column = k % 2, row = k / 2;
    EXPECT_EQ(particles.id(p), 5 + k);
    EXPECT_EQ(particles.body(p), jet_body);
    EXPECT_FALSE(is_placed(particles.key(p)));
    EXPECT_EQ(particles.position(p, 0), 0.5 + column);
    EXPECT_EQ(particles.position(p, 1), 9.0 - 1.0 + row);  // the centre has flown 4 * 0.25
    EXPECT_EQ(particles.velocity(p, 0), 0.0);
    EXPECT_EQ(particles.velocity(p, 1), -4.0);
    EXPECT_EQ(particles.half_size(p, 0), 0.5);
    EXPECT_EQ(particles.mass(p), 1000.0);
    EXPECT_EQ(particles.volume(p), 1.0);
    EXPECT_EQ(particles.deformation_gradient(p, 0), 1.0);
    EXPECT_EQ(particles.deformation_gradient(p, 1), 0.0);
    EXPECT_EQ(particles.deformation_gradient(p, 3), 1.0);
    EXPECT_EQ(particles.stress(p, 1), 0.0);
  }
  EXPECT_EQ(state.ledger.launched_mass, 6000.0);
  EXPECT_EQ(state.ledger.launched_momentum, -24000.0);
  EXPECT_EQ(state.ledger.launched_kinetic, 48000.0);
}

TEST(LaunchJet, LaunchesEverySlugThatIsDueOnce) {
  const Scene scene = jet_scene();
  State state = testing::start_alone(scene);
  launch(scene, 2.0, state);
  EXPECT_EQ(state.jet.next_slug, 2U);
  EXPECT_EQ(state.particles[0].count, 4 + 6 + 1);
  EXPECT_EQ(launch(scene, 3.0, state), 11);
  EXPECT_EQ(state.ledger.launched_mass, 7000.0);
}

TEST(LaunchJet, WhatIsBeyondTheGridIsNotLaunched) {
  Scene scene = jet_scene();
  scene.jet.launch_position = 16.0;
  State state = testing::start_alone(scene);
  launch(scene, 0.5, state);
  EXPECT_EQ(state.particles[0].count, 4 + 2);  // of rows at y = 15, 16 and 17 the first
  EXPECT_EQ(state.ledger.launched_mass, 2000.0);
}

/// Copper with voids, two slugs of half the density that follow each other.
Scene kind_scene(JetKind kind, Mode mode) {
  JetSpec jet;
  jet.present = true;
  jet.kind = kind;
  jet.launch_position = 5e-3;
  jet.particles_per_cell = 2;
  const Material copper = testing::copper().material();
  JohnsonCook::Parameters porous = std::get<JohnsonCook>(copper.model).parameters();
  porous.expansion_strain = 1;
  Scene scene = testing::box_scene(
      mode,
      1e-3,
      {0.0, 0.0},
      {16e-3, 16e-3},
      Material{"copper", copper.density, Expanded<JohnsonCook>(porous, copper.density)}
  );
  jet.table = {
      {1e-6, 2000.0, 3e-3, 2e-3, 0.5 * copper.density},
      {2e-6, 1900.0, 2.5e-3, 1.9e-3, 0.5 * copper.density}};
  jet.slugs = slugs_of_kind(jet.table, kind, mode, copper.density);
  scene.jet = jet;
  return scene;
}

/// What is launched is what the table says, whatever becomes of its voids.
TEST(LaunchJet, EveryKindLaunchesTheTablesMassMomentumAndEnergy) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain})
    for (const JetKind kind : {JetKind::discrete, JetKind::thinned, JetKind::continuous}) {
      const Scene scene = kind_scene(kind, mode);
      State state = testing::start_alone(scene);
      launch(scene, 2.5e-6, state);
      const JetTotals table = jet_table_totals(scene, 2);
      const OwnLedger& ledger = state.ledger;
      EXPECT_NEAR(double(ledger.launched_mass) / table.mass, 1.0, 1e-12) << word_of(kind);
      EXPECT_NEAR(double(ledger.launched_momentum) / table.momentum, 1.0, 1e-12) << word_of(kind);
      EXPECT_NEAR(double(ledger.launched_kinetic) / table.kinetic, 1.0, 1e-12) << word_of(kind);
      const Particles& particles = state.particles[0];
      const int last = Expanded<JohnsonCook>::history_count - 1;
      for (int p = 0; p < particles.count; ++p) {
        const double expansion = kind == JetKind::continuous ? 2.0 : 1.0;
        const double own = scene.materials[0].density() * particles.volume(p) / particles.mass(p);
        EXPECT_NEAR(own, expansion, 1e-12);
        EXPECT_NEAR(particles.history(p, last), std::log(expansion), 1e-12);
        EXPECT_EQ(particles.stress(p, 1), 0.0);
        // The sound speed of a step is the solid's.
        const JohnsonCook& solid =
            std::get<Expanded<JohnsonCook>>(scene.materials[0].material().model);
        JohnsonCook::History at_rest = solid.initial_history();
        at_rest.temperature = 294.0;
        EXPECT_NEAR(
            particles.longitudinal_modulus(p) * expansion,
            solid.longitudinal_modulus(Sym3{}, at_rest, 1.0),
            1.0
        );
      }
    }
}

}  // namespace
}  // namespace barreno
