// SPDX-License-Identifier: BSD-3-Clause
// Rock that lets nothing through is undrained rock, and any rank count gives the same answer.
#include "barreno/models.hpp"
#include "barreno/registry.hpp"
#include "support/scenes.hpp"

#include <Teuchos_ParameterList.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

using namespace testing;

Material wet_sandstone() {
  const Material dry = read_card(BARRENO_SOURCE_DIR "/materials/cards/arenisca_demonstration.xml");
  Arenisca::Parameters p = std::get<Arenisca>(dry.model).parameters();
  p.fluid_B0 = 2.2e9;
  return {"Rock", dry.density, GeneralArenisca(p, dry.density)};
}

Material berea() {
  Poroelastic::Parameters p{8e9, 6e9, 0.19, 2.25e9};
  p.grain_bulk_modulus = 36e9;
  return {"Rock", 2300.0, Poroelastic(p, 2300.0)};
}

/// A block of rock that flies into another, sides and ends open to the fluid.
Scene impact(Mode mode, const Material& rock, double permeability) {
  Scene scene = box_scene(mode, 1e-3, {0, 0, 0}, {0.012, 0.020, 0.008}, rock);
  add_box(scene, "ball", {0, 0.002, 0}, {0.0041, 0.0079, 0.0041}, 2).velocity = {0, 30.0, 0};
  add_box(scene, "block", {0, 0.0083, 0}, {0.0082, 0.0132, 0.0041}, 2);
  add_symmetry(scene, Face::x_lower);
  PoreConditionSpec open;
  open.open_faces = {true, true, true, true, true, true};
  scene.pore_flow.conditions = {open};
  scene.pore_flow.drainage = Drainage::on;
  scene.pore_flow.viscosity = 1e-3;
  scene.pore_flow.rocks = {{{permeability, permeability, permeability}, true}};
  scene.end_time = 0.0;  // rock that nothing moves in drains at every step
  return scene;
}

/// Everything that a later step depends on, row by row.
std::vector<double> numbers_of(const State& state) {
  std::vector<double> numbers;
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      numbers.push_back(static_cast<double>(particles.id(p)));
      for (const Field* field :
           {&particles.position, &particles.velocity, &particles.stress, &particles.history})
        for (int c = 0; c < field->components; ++c) numbers.push_back((*field)(p, c));
    }
  return numbers;
}

TEST(PoreFlowLimits, WithoutPermeabilityARunIsTheUndrainedOneBitForBit) {
  for (const Material& rock : {wet_sandstone(), berea()})
    for (const Mode mode : all_modes) {
      Scene scene = impact(mode, rock, 0.0);
      State drained = start(scene);
      advance_to(scene, 2e-6, drained);
      EXPECT_EQ(drained.pore_flow.solves, drained.clock.step);
      scene.pore_flow.drainage = Drainage::off;
      State undrained = start(scene);
      advance_to(scene, 2e-6, undrained);
      EXPECT_GT(undrained.clock.step, 10);
      EXPECT_TRUE(numbers_of(drained) == numbers_of(undrained)) << word_of(mode);
    }
}

/// Largest difference of two results, column by column relative to the column's own size.
double difference(
    const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b
) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t c = 0; !a.empty() && c < a.front().size(); ++c) {
    double size = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      size = std::max(size, std::abs(a[i][c]));
      worst = std::max(worst, std::abs(a[i][c] - b[i][c]));
    }
    if (size > 0.0) largest = std::max(largest, worst / size);
  }
  return largest;
}

/// The linear solver's inner products depend on ranks, so not to the bit but within what is made of
/// its tolerance: rock that yields makes more of it.
TEST(PoreFlowLimits, AnyRankCountGivesTheSameAnswer) {
  for (const Material& rock : {wet_sandstone(), berea()})
    for (const Mode mode : all_modes) {
      Scene scene = impact(mode, rock, 1e-13);
      auto lists = std::make_shared<Teuchos::ParameterList>();
      lists->sublist("Belos").set("Convergence Tolerance", 1e-13);
      scene.pore_flow.solver = lists;
      State together = start(scene);
      advance_to(scene, 2e-6, together);
      State alone = start_alone(scene);
      advance_to(scene, 2e-6, alone);
      EXPECT_GT(alone.pore_flow.solves, 1);
      EXPECT_LT(alone.pore_flow.inflow, 0.0);
      EXPECT_LT(difference(all_rows(alone), all_rows(together)), 1e-9)
          << word_of(mode) << rock.density;
      EXPECT_NEAR(alone.pore_flow.inflow / together.pore_flow.inflow, 1.0, 1e-10);
      Scene undrained = scene;
      undrained.pore_flow.drainage = Drainage::off;
      State other = start_alone(undrained);
      advance_to(undrained, 2e-6, other);
      EXPECT_GT(difference(all_rows(alone), all_rows(other)), 1e-4) << word_of(mode);
    }
}

}  // namespace
}  // namespace barreno
