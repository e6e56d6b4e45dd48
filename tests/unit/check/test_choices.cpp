// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/format.hpp"
#include "check/choices.hpp"
#include "check/cost_tables.hpp"
#include "check/feature_table.hpp"
#include "check/jet_note.hpp"
#include "check/locking_note.hpp"
#include "check/plan.hpp"
#include "check/predict_cost.hpp"
#include "check/probe_cost.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace barreno {
namespace {

constexpr double young = 8e10, poisson = 0.25, density = 2500.0, cell = 0.1;

/// A block of 10 x 10 cells with 4 particles in each, in a grid twice as wide.
Scene block(double poissons_ratio = poisson) {
  const MaterialSpec material = testing::elastic(young, poissons_ratio, density);
  Scene scene = testing::box_scene(Mode::plane_strain, cell, {0, 0, 0}, {2, 1, 0}, material);
  testing::add_box(scene, "block", {0, 0, 0}, {1, 1, 0}, 2);
  scene.end_time = 1e-3;
  return scene;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(Format, WritesAsPrintfAndCutsLongLines) {
  EXPECT_EQ(format("%5.2f|%-4s|", 3.14159, "ab"), " 3.14|ab  |");
  EXPECT_EQ(format("%s", std::string(900, 'x').c_str()).size(), 255U);
}

TEST(Choices, SayWhatIsOffAndWhy) {
  Scene scene = block();
  EXPECT_FALSE(pore_flow_choice(scene).on);
  EXPECT_TRUE(says(pore_flow_choice(scene).why, "no Pore Flow list"));
  EXPECT_FALSE(quasi_static_choice(scene).on);
  EXPECT_TRUE(dormancy_choice(scene).on);
  scene.step.skip_dormant = false;
  EXPECT_TRUE(says(dormancy_choice(scene).why, "Skip Dormant Tiles is false"));
  scene.quasi_static = {100.0, 1e-3, 1e-1};
  EXPECT_TRUE(quasi_static_choice(scene).on);
  EXPECT_TRUE(says(quasi_static_choice(scene).why, "inertia x 100"));
}

TEST(Fidelities, SayWhichOneTheDeckCannotHave) {
  const std::string lines = fidelity_lines(
      [](const std::string& name) {
        if (name == "reference") throw DeckError("deck.xml: too large; choose larger cells.");
        return block();
      },
      1
  );
  EXPECT_TRUE(says(
      lines,
      "\n  reference              not with this deck: deck.xml: too large; choose larger cells.\n"
  )) << lines;
  EXPECT_FALSE(says(lines, "\n  balanced               not")) << lines;
}

TEST(LockingNote, WarnsOfWhatHardlyChangesItsVolume) {
  Scene scene = block(0.4999);
  EXPECT_TRUE(says(locking_note(scene, 0), "volumetric locking, with GIMP"));
  scene.step.shape = "quadratic B-spline";
  EXPECT_EQ(locking_note(scene, 0), "");
  scene.step.shape = "GIMP";
  scene.bodies[0].particles_per_cell = 1;
  EXPECT_EQ(locking_note(scene, 0), "");
  EXPECT_EQ(locking_note(block(), 0), "");
}

TEST(LockingNote, DoesNotAdviseWhatTheDeckHas) {
  Scene scene = block(0.4999);
  scene.bodies[0].particles_per_cell = 1;
  std::get<Box>(scene.bodies[0].shape).upper[0] = 0.93;  // ends inside a cell
  const std::string note = locking_note(scene, 0);
  EXPECT_TRUE(says(note, "particles smaller than a cell; take Shape Function quadratic")) << note;
  EXPECT_FALSE(says(note, "Particles Per Cell")) << note;
  scene.bodies[0].particles_per_cell = 2;
  EXPECT_TRUE(says(locking_note(scene, 0), "take Particles Per Cell 1 or Shape Function"));
}

TEST(JetNote, WarnsOfAJetThatMissesOrComesTooLate) {
  Scene scene = block();
  EXPECT_EQ(jet_note(scene), "");
  scene.materials.push_back(testing::copper());
  scene.jet.present = true;
  scene.jet.material = 1;
  scene.jet.launch_position = -0.5;
  scene.jet.slugs = {{0.0, 1000.0, 0.2, 0.1, 8930.0}};
  EXPECT_EQ(jet_note(scene), "");  // its leading face takes 0.45 ms
  scene.end_time = 0.4e-3;
  EXPECT_TRUE(says(jet_note(scene), "reaches the target at 0.00045 s")) << jet_note(scene);
  scene.jet.direction = -1.0;
  EXPECT_TRUE(says(jet_note(scene), "hits no body"));
}

/// 400 particles that take 4 us in a step.
Probe probe_of_block() {
  Probe probe;
  probe.seconds = 4e-6;
  probe.particles = 400.0;
  return probe;
}

TEST(PredictCost, CountsParticleStepsByTheStep) {
  Scene scene = block();
  scene.step.largest_step = 1e-6;  // below the stable one
  const Prediction one = predict_cost(scene, probe_of_block(), particle_counts(scene), 1);
  EXPECT_DOUBLE_EQ(one.steps, 1000.0);
  EXPECT_DOUBLE_EQ(one.particle_steps, 400.0 * 1000.0);
  EXPECT_DOUBLE_EQ(one.nanoseconds, 10.0);
  EXPECT_GT(one.seconds, 4e-3);
  EXPECT_DOUBLE_EQ(
      predict_cost(scene, probe_of_block(), particle_counts(scene), 4).seconds, 0.25 * one.seconds
  );
}

TEST(PredictCost, FindsAStepInWhichAWaveCrossesLessThanACell) {
  const Scene scene = block();
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson));
  const double shear = young / (2.0 * (1.0 + poisson));
  const double crossing = cell / std::sqrt((bulk + 4.0 / 3.0 * shear) / density);
  const double step = stable_step_of_scene(scene, false);
  EXPECT_GT(step, 0.2 * crossing);
  EXPECT_LT(step, crossing);
  EXPECT_LT(stable_step_of_scene(scene, true), step);
}

TEST(PredictCost, HasNoStepOfAMaterialWithoutParticles) {
  Scene scene = block();
  const double step = stable_step_of_scene(scene, true);
  scene.materials.push_back(testing::elastic(young, poisson, 1e-300));
  EXPECT_EQ(stable_step_of_scene(scene, true), step);
  EXPECT_FALSE(says(plan_text(scene, probe_of_block(), 1, {}), "could take"));
}

TEST(PredictCost, KnowsWhatGrowsOverARun) {
  Scene scene = block();
  EXPECT_EQ(growth_of(scene, "move_particles"), 1.0);
  EXPECT_EQ(growth_of(scene, "project_particles"), 1.0);
  EXPECT_EQ(growth_of(scene, "update_stress Linear Elastic"), 1.0);
  scene.materials.push_back(testing::copper());
  EXPECT_GT(growth_of(scene, "update_stress Johnson-Cook"), 1.0);
  scene.step.shape = "CPDI";
  EXPECT_EQ(growth_of(scene, "project_particles"), cost_tables().domains);
  scene.grid.mode = Mode::three_dimensional;
  EXPECT_EQ(growth_of(scene, "update_deformation"), cost_tables().rotations);
}

TEST(ProbeCost, TakesFirstStepsAndSharesThemAmongVerbs) {
  const Probe probe = probe_cost(block());
  EXPECT_EQ(probe.particles, 400.0);
  EXPECT_GT(probe.seconds, 0.0);
  EXPECT_GT(probe.dt, 0.0);
  EXPECT_NEAR(share_of(probe, ""), 1.0, 1e-12);
  EXPECT_GT(share_of(probe, "update_stress"), 0.0);
  EXPECT_LT(share_of(probe, "update_stress"), 1.0);
  EXPECT_EQ(share_of(probe, "no such verb"), 0.0);
}

TEST(FeatureTable, HasWhatIsOnAndOff) {
  const std::string table = feature_table(block(), {});
  EXPECT_TRUE(says(table, dormancy_choice(block()).why)) << table;
  EXPECT_TRUE(says(table, "no Pore Flow list")) << table;
}

TEST(Plan, SaysHowManyParticlesAndWhatIsNoted) {
  Scene scene = block();
  scene.title = "a block of glass";
  const std::string plan = plan_text(scene, probe_of_block(), 1, {"mind the step."});
  for (const char* words : {"a block of glass", "400", "mind the step."})
    EXPECT_TRUE(says(plan, words)) << plan;
}

TEST(Plan, SaysWhichFilesParticlesGoTo) {
  Scene scene = block();
  const auto plan = [&](int ranks) { return plan_text(scene, probe_of_block(), ranks, {}); };
  EXPECT_TRUE(says(plan(12), "Files     particles.e, one for all ranks\n")) << plan(12);
  scene.output.files = ParticleFiles::one_per_rank;
  EXPECT_TRUE(says(plan(1), "Files     particles.e, one for all ranks\n")) << plan(1);
  EXPECT_TRUE(says(plan(12), "particles.e.12.00 to particles.e.12.11, one per rank; barreno join"))
      << plan(12);
  // 400 particles, and 100 times as many along each side.
  scene.output.files = ParticleFiles::by_number;
  scene.grid.cell_size *= 0.01;
  EXPECT_TRUE(says(plan(2), "one per rank above 2000000 particles; barreno join")) << plan(2);
  scene.output.files = ParticleFiles::one;
  EXPECT_TRUE(says(plan(2), "Files     particles.e, one for all ranks\n")) << plan(2);
}

Scene block_of_sandstone(const std::string& solver) {
  Scene scene = block();
  std::ifstream file(BARRENO_SOURCE_DIR "/materials/cards/berea_sandstone.xml");
  std::ostringstream text;
  text << file.rdbuf();
  Teuchos::ParameterList card = scan_card(text.str(), "berea_sandstone.xml");
  card.set("Return solver", solver);
  scene.materials[0] = MaterialSpec(make_material("sandstone", card), BadParticlePolicy::hold);
  return scene;
}

TEST(Plan, SaysWhetherTheCostMayBeMoreOrLess) {
  Scene scene = block_of_sandstone("fast");
  const auto plan = [&] { return plan_text(scene, probe_of_block(), 1, {}); };
  EXPECT_TRUE(says(plan(), "Cost      about ")) << plan();
  EXPECT_TRUE(says(plan(), "less while tiles are dormant")) << plan();
  scene.step.skip_dormant = false;
  EXPECT_TRUE(says(plan(), "Cost      about ")) << plan();
  EXPECT_FALSE(says(plan(), "less while tiles are dormant")) << plan();
  scene = block_of_sandstone("bisection");
  EXPECT_TRUE(says(plan(), "Cost      at least ")) << plan();
}

}  // namespace
}  // namespace barreno
