// SPDX-License-Identifier: BSD-3-Clause
#include "base/view_of.hpp"
#include "grid/tiles.hpp"
#include "state/bad_particle.hpp"
#include "state/cavity.hpp"
#include "state/contact_nodes.hpp"
#include "state/dormancy.hpp"
#include "state/effort.hpp"
#include "state/isolated_courant.hpp"
#include "state/ledger.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"
#include "state/row_frames.hpp"
#include "state/tally_scales.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <cmath>
#include <set>
#include <string>

namespace barreno {
namespace {

constexpr double young = 8e10, poisson = 0.25, density = 2500.0, cell = 0.1;

/// A block of 16 x 8 cells, which take two tiles, with one particle in each.
Scene block(Mode mode = Mode::plane_strain) {
  Scene scene = testing::box_scene(
      mode, cell, {0, 0, 0}, {1.6, 0.8, 0.4}, testing::elastic(young, poisson, density)
  );
  testing::add_box(scene, "block", {0, 0, 0}, {1.6, 0.8, 0.4}, 1);
  return scene;
}

/// Makes the two tiles of a block active and gives every particle the key of its cell.
void place(State& state) {
  Grid& grid = state.grid;
  activate_tiles(grid, {0, 1});
  const Particles& set = state.particles[0];
  for (int p = 0; p < set.count; ++p) {
    const Cell cell_of_row = cell_of(grid, vector_of(set.position, p));
    const int tile = grid.directory(cell_of_row.tile);
    set.key(p) = CellKey{tile * grid.patch.cells + cell_of_row.inside};
  }
}

TEST(ViewOf, CopiesValuesAndMakesRoom) {
  ArrayView<int> view = view_of<int>("values", {3, 1, 2});
  ASSERT_EQ(view.extent(0), 3U);
  EXPECT_EQ(view(2), 2);
  make_room("values", 3, view);
  EXPECT_EQ(view(0), 3);  // there was room
  make_room("values", 4, view);
  EXPECT_EQ(view.extent(0), 8U);
}

/// Copper whose void strain a step of |D| dt = 1/2 cannot close may have that strain, of which what
/// Largest Strain allows counts; with a larger one it is like others. Solid metal has no such rule.
TEST(Particles, OpenVoidsMayBeStrainedByAHalf) {
  const Material solid = testing::copper().material();
  JohnsonCook::Parameters porous = std::get<JohnsonCook>(solid.model).parameters();
  porous.expansion_strain = 1;
  const auto rule_of = [](const Material& material, double largest_strain) {
    Scene scene = testing::box_scene(Mode::axisymmetric, cell, {0.0, 0.0}, {1.6, 0.8}, material);
    scene.step.largest_strain = largest_strain;
    return make_particles(scene, 0).void_rule;
  };
  const Material voided{"copper", solid.density, Expanded<JohnsonCook>(porous, solid.density)};
  EXPECT_EQ(rule_of(voided, 0.1).column, Expanded<JohnsonCook>::history_count - 1);
  EXPECT_DOUBLE_EQ(rule_of(voided, 0.1).open, std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(rule_of(voided, 0.1).share, 0.2);
  EXPECT_EQ(rule_of(voided, 0.8).share, 1.0);
  EXPECT_EQ(rule_of(solid, 0.1).column, -1);
}

TEST(Particles, ListEveryFieldOnce) {
  const State state = testing::start_alone(block(Mode::axisymmetric));
  std::set<std::string> names;
  int fields = 0;
  state.particles[0].for_each_field([&](const Field& field) {
    names.insert(field.name);
    ++fields;
  });
  state.particles[0].for_each_scratch_field([&](const Field& field) {
    names.insert(field.name);
    ++fields;
  });
  EXPECT_EQ(static_cast<int>(names.size()), fields);
}

TEST(Particles, OfAModeHaveItsComponents) {
  const auto components = [](Mode mode) {
    const State state = testing::start_alone(block(mode));
    const Particles& set = state.particles[0];
    return std::array<int, 3>{
        set.deformation_gradient.components, set.stress.components, set.rotation.components};
  };
  EXPECT_EQ(components(Mode::plane_strain), (std::array<int, 3>{4, 4, 0}));
  EXPECT_EQ(components(Mode::axisymmetric), (std::array<int, 3>{5, 4, 0}));
  EXPECT_EQ(components(Mode::three_dimensional), (std::array<int, 3>{9, 6, 4}));
}

TEST(Particles, AreInTheirTilesAndHaveNoneBeforeThat) {
  State state = testing::start_alone(block());
  const Particles& set = state.particles[0];
  ASSERT_EQ(set.count, 16 * 8);
  place(state);
  for (int p = 0; p < set.count; ++p) {
    EXPECT_TRUE(is_placed(set.key(p)));
    EXPECT_EQ(tile_of(state.grid.patch, set, p), set.position(p, 0) < 0.8 ? 0 : 1);
  }
  set.fault(0) = Fault::failed;
  mark_unplaced(set, 0);
  EXPECT_FALSE(is_placed(set.key(0)));
  EXPECT_EQ(set.fault(0), Fault::none);
}

TEST(BadParticle, IsHeldWithoutStressOrMarkedForRemoval) {
  const State state = testing::start_alone(block());
  const Particles& set = state.particles[0];
  for (const int p : {3, 4}) {
    set.stress(p, 1) = -1e6;
    set.viscous_pressure(p) = 5.0;
  }
  treat_bad_particle(set, 3, BadParticlePolicy::hold, Fault::inverted);
  EXPECT_EQ(set.stress(3, 1), 0.0);
  EXPECT_EQ(set.viscous_pressure(3), 0.0);
  EXPECT_EQ(set.body(3), debris_bit);
  EXPECT_EQ(set.fault(3), Fault::none);
  treat_bad_particle(set, 4, BadParticlePolicy::remove, Fault::inverted);
  EXPECT_EQ(set.stress(4, 1), -1e6);
  EXPECT_EQ(set.body(4), 0);
  EXPECT_EQ(set.fault(4), Fault::inverted);
}

TEST(RowFrames, GiveARowTheCellSizeAndStepOfItsTile) {
  State state = testing::start_alone(block());
  const Particles& set = state.particles[0];
  place(state);
  state.grid.tile_frame(0).dt = 1e-7;
  state.grid.tile_frame(1).dt = 3e-7;
  state.grid.tile_frame(1).cell_size = 0.5 * cell;
  const RowFrames frames(state.grid, set);
  for (int p = 0; p < set.count; ++p) {
    const bool first = set.position(p, 0) < 0.8;
    EXPECT_EQ(frames.dt(p), first ? 1e-7 : 3e-7);
    EXPECT_EQ(frames.cell_size(p), first ? cell : 0.5 * cell);
  }
#if BARRENO_HAS_LANES
  for (int first = 0; first + 3 <= set.count; ++first) {
    const GroupFrame<Lanes> group(frames, first, 3);
    for (int i = 0; i < lane_count; ++i) {
      const int p = first + std::min(i, 2);
      EXPECT_EQ(group.dt[i], frames.dt(p));
      EXPECT_EQ(group.cell_size[i], frames.cell_size(p));
    }
  }
#endif
}

TEST(Nodes, HaveTheirValuesTileByTile) {
  const Patch patch = make_patch(2, 1);
  EXPECT_EQ(first_force(2), 3);
  EXPECT_EQ(first_force(3), 4);
  EXPECT_EQ(impedance_component, 7);
  EXPECT_EQ(first_sum(patch, 3), 3U * 121U * 8U);
  EXPECT_EQ(first_motion(patch, 3), 3U * 121U * 4U);
  EXPECT_EQ(first_motion(make_patch(3, 1), 1), 1331U * 8U);
  Nodes nodes;
  EXPECT_FALSE(nodes.keeps_sums(0));
  nodes.sums_kept = view_of<unsigned char>("kept", {0, 1});
  EXPECT_TRUE(nodes.keeps_sums(1));
  EXPECT_FALSE(nodes.keeps_sums(0));
}

TEST(ContactNodes, CountTheirComponents) {
  EXPECT_EQ(moment_components(2), 6);   // 1, x y, xx xy yy
  EXPECT_EQ(moment_components(3), 10);  // 1, x y z, xx xy xz yy yz zz
  EXPECT_EQ(normal_components(3), 4);
  EXPECT_EQ(impulse_components(2), 6);
  EXPECT_EQ(first_value(make_patch(2, 1), 2, 5), 2U * 121U * 5U);
}

TEST(Dormancy, IsOfNoTileUnlessItIsOn) {
  Dormancy dormancy;
  EXPECT_FALSE(dormancy.is_dormant(0));  // without arrays
  dormancy.on = true;
  dormancy.dormant = view_of<unsigned char>("dormant", {0, 1});
  EXPECT_FALSE(dormancy.is_dormant(0));
  EXPECT_TRUE(dormancy.is_dormant(1));
}

TEST(Effort, AddsUpBySetAndBlock) {
  Effort effort;
  effort.add(1, 2, 0.5);
  effort.add(1, 2, 0.25);
  effort.add(0, 0, 2.0);
  EXPECT_EQ(effort.seconds(1, 2), 0.75);
  EXPECT_EQ(effort.seconds(1, 0), 0.0);
  EXPECT_EQ(effort.seconds(7, 7), 0.0);
  EXPECT_EQ(effort.particle_seconds(), 2.75);
}

TEST(Ledger, NamesEveryCauseOfRemoval) {
  const std::set<std::string> names(removal_names.begin(), removal_names.end());
  EXPECT_EQ(static_cast<int>(names.size()), removal_causes);
  EXPECT_STREQ(removal_names[static_cast<std::size_t>(RemovalCause::inverted)], "inverted");
}

TEST(IsolatedCourant, IsALimitWhereTheDeckAsksForIt) {
  Scene scene = block();
  EXPECT_TRUE(std::isinf(isolated_courant(scene, 0)));
  scene.step.stable_alone = true;
  const double flat = isolated_courant(scene, 0);
  EXPECT_GT(flat, 0.0);
  EXPECT_LT(flat, 2.0);
  // lambda / M = nu / (1 - nu) = 1/3; a third strain makes 1 + 2/3 of 1 + 1/3.
  scene.grid.mode = Mode::axisymmetric;
  EXPECT_NEAR(isolated_courant(scene, 0), flat * std::sqrt(4.0 / 5.0), 1e-14);
  scene.step.transfer = Transfer::apic;
  EXPECT_TRUE(std::isinf(isolated_courant(scene, 0)));
}

TEST(TallyScales, AreOfACellFullOfTheMaterial) {
  const TallyScales scales = tally_scales(block(), 0);
  const double volume = cell * cell;
  const double shear = young / (2.0 * (1.0 + poisson));
  const double modulus = young / (3.0 * (1.0 - 2.0 * poisson)) + 4.0 / 3.0 * shear;
  EXPECT_EQ(scales.mass.top, SplitScales(density * volume).top);
  EXPECT_EQ(scales.energy.top, SplitScales(modulus * volume).top);
  EXPECT_EQ(scales.momentum.top, SplitScales(std::sqrt(density * modulus) * volume).top);
}

TEST(Cavity, IsTheHollowOfABallWithFluid) {
  Scene scene = testing::box_scene(
      Mode::axisymmetric, 0.1, {0, -2, 0}, {2, 2, 0}, testing::elastic(young, poisson, density)
  );
  BodySpec& body = testing::add_box(scene, "ball", {}, {}, 2);
  body.shape = Ball{{0, 0, 0}, 1.0, 0.5};
  PressureLoadSpec load;
  load.surfaces = {true, false};
  scene.loads.push_back(load);
  EXPECT_FALSE(make_cavities(scene).at(0).holds_fluid());
  scene.loads[0].kind = LoadKind::pore_fluid;
  scene.loads[0].bulk_modulus = 2e9;
  const Cavity cavity = make_cavities(scene).at(0);
  EXPECT_TRUE(cavity.holds_fluid());
  EXPECT_NEAR(cavity.initial_volume, 4.0 / 3.0 * std::acos(-1.0) * 0.125, 1e-12);
  EXPECT_EQ(cavity.initial_radius, 0.5);
  EXPECT_EQ(cavity.wall_density, density);
}

}  // namespace
}  // namespace barreno
