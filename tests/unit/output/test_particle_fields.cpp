// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tiles.hpp"
#include "output/particle_fields.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>

namespace barreno {
namespace {

TEST(SpaceStress, TurnsWithTheRotationOfF) {
  // A quarter turn of a stretched particle: xx and yy change places, shear changes its sign.
  const double F[4] = {0.0, -3.0, 2.0, 0.0};
  const PlaneStress s = space_stress({1.0, 2.0, 3.0, 4.0}, F);
  EXPECT_NEAR(s[0], 2.0, 1e-14);
  EXPECT_NEAR(s[1], 1.0, 1e-14);
  EXPECT_NEAR(s[2], 3.0, 1e-14);
  EXPECT_NEAR(s[3], -4.0, 1e-14);
}

TEST(SpaceStress, OfAUniaxialStressPointsAlongTheTurnedAxis) {
  const double angle = 0.3, c = std::cos(angle), s = std::sin(angle);
  // F = R U with the symmetric U = ((1.5, 0.2), (0.2, 0.8)).
  const double F[4] = {1.5 * c - 0.2 * s, 0.2 * c - 0.8 * s, 1.5 * s + 0.2 * c, 0.2 * s + 0.8 * c};
  const PlaneStress turned = space_stress({7.0, 0.0, 0.0, 0.0}, F);
  EXPECT_NEAR(turned[0], 7.0 * c * c, 1e-13);
  EXPECT_NEAR(turned[1], 7.0 * s * s, 1e-13);
  EXPECT_NEAR(turned[3], 7.0 * c * s, 1e-13);
}

TEST(ParticleFields, HaveANameEachAndTheDocumentedMeaning) {
  const Scene scene = synthetic::make_scene();
  State state = synthetic::make_state(scene, Teuchos::DefaultComm<int>::getComm());
  const MaterialSpec& rock = scene.materials[1];
  const std::vector<std::string> names = particle_field_names(rock, 2);
  EXPECT_EQ(names.back(), "equivalent_plastic_strain");
  Particles& set = state.particles[1];
  ASSERT_GT(set.count, 0);
  set.stress(0, 0) = -6.0;
  set.stress(0, 3) = 2.0;
  set.volume(0) *= 0.5;
  std::vector<double> values;
  append_particle_fields(HostParticles(set), 0, rock.density(), {}, values);
  ASSERT_EQ(values.size(), names.size());
  const auto value = [&](const char* name) {
    return values[static_cast<std::size_t>(
        std::find(names.begin(), names.end(), name) - names.begin()
    )];
  };
  EXPECT_EQ(value("status"), 1.0);
  EXPECT_NEAR(value("pressure"), 2.0, 1e-14);
  EXPECT_NEAR(value("shear_stress"), std::sqrt((16.0 + 4.0 + 4.0) / 2.0 + 4.0), 1e-14);
  EXPECT_NEAR(
      value("density"), 2.0 * 2000.0, 1e-9
  );  // 2000: the mass that make_state gives to set 1
  EXPECT_NEAR(value("volume_ratio"), rock.density() / 4000.0, 1e-12);
}

TEST(ParticleFields, SayCellAndStepWhereTheyDiffer) {
  Scene scene = synthetic::make_scene();
  State state = synthetic::make_state(scene, Teuchos::DefaultComm<int>::getComm());
  Grid grid = make_grid(scene, 1, state.grid.comm);
  const OptionalFields alike = optional_fields(scene, scene.materials[1]);
  EXPECT_FALSE(alike.cell_size || alike.step_length);
  scene.grid.level_of_tile.assign(4, 1);
  scene.step.subcycles = 4;
  const OptionalFields both = optional_fields(scene, scene.materials[1]);
  EXPECT_TRUE(both.cell_size && both.step_length);
  const std::vector<std::string> names = particle_field_names(scene.materials[1], 2, both);
  EXPECT_EQ(std::count(names.begin(), names.end(), "cell_size"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "step_length"), 1);

  Particles& set = state.particles[1];
  ASSERT_GT(set.count, 1);
  const int box[3] = {grid.tiles[0], grid.tiles[1], 1};
  grid.box = BoxTiles(2, 2, box);
  const std::size_t tiles = static_cast<std::size_t>(box[0]) * static_cast<std::size_t>(box[1]);
  grid.host_level_of_tile.assign(tiles, 1);
  const auto tile_of = [&](int p) {
    return CellLattice(grid).cell_of_level([&](int d) { return set.position(p, d); }, 1).tile;
  };
  ASSERT_NE(tile_of(0), tile_of(set.count - 1));
  std::vector<double> tile_steps(static_cast<std::size_t>(grid.box.first_id[2]), 0.0);
  tile_steps[static_cast<std::size_t>(tile_of(0))] = 3e-7;
  tile_steps.back() = 4e-7;
  const CellsAndSteps own(both, grid, tile_steps, set);
  std::vector<double> values;
  for (const int p : {0, set.count - 1}) {
    own.append_cell_size(p, values);
    own.append_step_length(p, values);
  }
  const double half = 0.5 * grid.cell_size;
  // The tile of the last particle was not active: the longest step.
  EXPECT_EQ(values, (std::vector<double>{half, 3e-7, half, 4e-7}));
  // Nor does it matter whether particles have been placed.
  set.key(0) = CellKey::unplaced;
  values.clear();
  const CellsAndSteps unplaced(both, grid, tile_steps, set);
  unplaced.append_cell_size(0, values);
  unplaced.append_step_length(0, values);
  EXPECT_EQ(values, (std::vector<double>{half, 3e-7}));
  values.clear();
  const CellsAndSteps none(alike, grid, {}, set);
  EXPECT_TRUE(none.cell_size.empty());
  EXPECT_TRUE(none.step_length.empty());
}

}  // namespace
}  // namespace barreno
