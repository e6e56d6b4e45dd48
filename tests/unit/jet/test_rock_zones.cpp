// SPDX-License-Identifier: BSD-3-Clause
#include "jet/depth.hpp"
#include "jet/rock_permeability.hpp"
#include "jet/rock_zones.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace barreno {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(RockZones, AreWhereThePorosityHasChanged) {
  const double virgin = 0.2, wall = 0.01, width = 0.001;
  const RockZones zones =
      zones_of_rings({{0.15, 0.0}, {none, none}, {0.25, 0.0}, {0.2, 0.0}}, virgin, wall, width);
  EXPECT_EQ(zones.crushed_from, wall);
  EXPECT_NEAR(zones.crushed_to, 0.011, 1e-15);
  EXPECT_NEAR(zones.dilated_to, 0.013, 1e-15);
  EXPECT_EQ(zones.least_porosity, 0.15);
  // (0.15/0.2)^3 (0.8/0.85)^2 and (0.25/0.2)^3 (0.8/0.75)^2
  const double crushed = 0.421875 * 0.64 / 0.7225, dilated = 1.953125 * 0.64 / 0.5625;
  EXPECT_NEAR(zones.least_permeability, crushed, 1e-14);
  const double skin = (1.0 / crushed - 1.0) * std::log(0.011 / 0.010) +
                      (1.0 / dilated - 1.0) * std::log(0.013 / 0.012);
  EXPECT_NEAR(zones.skin, skin, 1e-13);
}

/// Fully broken grains let 0.3 through: S/S_0 = sqrt(1/0.3); half-way there it is half of that
/// more.
TEST(RockZones, AreImpairedByBrokenGrains) {
  const RockZones zones =
      zones_of_rings({{0.2, 1.0}, {0.2, 0.5}, {0.2, 0.1}, {0.2, 0.0}}, 0.2, 0.01, 0.001);
  const auto permeability = [](double breakage) {
    const double surface = 1.0 - breakage + breakage * std::sqrt(1.0 / 0.3);
    return 1.0 / (surface * surface);
  };
  ASSERT_LT(permeability(0.5), 0.7);
  ASSERT_GT(permeability(0.1), 0.7);
  EXPECT_EQ(zones.crushed_to, 0.01) << "the porosity is that of virgin rock";
  EXPECT_NEAR(zones.impaired_to, 0.012, 1e-15);
  EXPECT_EQ(zones.greatest_breakage, 1.0);
  EXPECT_NEAR(zones.least_permeability, 0.3, 1e-15);
  const double skin = (1.0 / 0.3 - 1.0) * std::log(1.1) +
                      (1.0 / permeability(0.5) - 1.0) * std::log(12.0 / 11.0) +
                      (1.0 / permeability(0.1) - 1.0) * std::log(13.0 / 12.0);
  EXPECT_NEAR(zones.skin, skin, 1e-13);
}

/// Rock that opens breaks in cracks: its pores give no more than three times the permeability.
TEST(RockZones, BoundWhatDilationGives) {
  EXPECT_EQ(rock_permeability(0.36, 0.2, 0.0), 3.0);
  EXPECT_NEAR(rock_permeability(0.36, 0.2, 1.0), 0.9, 1e-15);
  EXPECT_EQ(rock_permeability(0.2, 0.2, 0.0), 1.0);
}

TEST(RockZones, AreTheWallInVirginRock) {
  const RockZones zones = zones_of_rings({{0.2, 0.0}, {0.2, 0.0}}, 0.2, 0.01, 0.001);
  EXPECT_EQ(zones.crushed_to, 0.01);
  EXPECT_EQ(zones.dilated_to, 0.01);
  EXPECT_NEAR(zones.skin, 0.0, 1e-15);
}

TEST(RockZones, HaveASkinWhereAllPoresAreClosed) {
  const RockZones zones = zones_of_rings({{0.0, 0.0}}, 0.2, 0.01, 0.001);
  EXPECT_EQ(zones.least_permeability, 0.0);
  EXPECT_NEAR(zones.skin, 9999.0 * std::log(1.1), 1e-9);
}

/// Compacts the rock within a radius of the axis by a plastic volume strain.
void compact(const Scene& scene, State& state, double radius, double strain) {
  for (std::size_t set = 0; set < state.particles.size(); ++set) {
    Particles& p = state.particles[set];
    const auto table = scene.materials[set].history_table();
    for (std::size_t column = 0; column < table.size(); ++column)
      for (int row = 0; row < p.count; ++row)
        if (std::string(table[column].name) == "plastic_volume_strain")
          p.history(row, static_cast<int>(column)) = p.position(row, 0) < radius ? strain : 0.0;
  }
}

TEST(RockZones, AreTheSameOnEveryRank) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const JetPath path = jet_path(scene);
  State state = synthetic::make_state(scene, comm);
  synthetic::move_to(scene, state, 5e-6);
  const double edge = 0.009, strain = -0.1;
  compact(scene, state, edge, strain);
  const Penetration found = measure_penetration(scene, state, path);
  const std::vector<RockZones> zones = measure_zones(scene, state, path, found);
  ASSERT_EQ(zones.size(), 1U) << "of the rock alone: steel has no pores";
  EXPECT_EQ(scene.bodies[zones[0].body].name, "rock");
  EXPECT_NEAR(zones[0].depth, 0.5 * (0.004 + found.channel_depth), 1e-12);
  EXPECT_NEAR(zones[0].wall, 0.004 * std::exp(-20.0 * zones[0].depth), 0.1 * path.bin);
  EXPECT_EQ(zones[0].crushed_from, zones[0].wall);
  EXPECT_NEAR(zones[0].crushed_to, edge, path.bin);
  EXPECT_EQ(zones[0].dilated_to, zones[0].wall);
  const double virgin = 1.0 - std::exp(-0.2);  // p3_crush_curve of the synthetic rock
  EXPECT_NEAR(zones[0].least_porosity, 1.0 - (1.0 - virgin) * std::exp(-strain), 1e-9);
  EXPECT_GT(zones[0].skin, 0.0);
}

TEST(RockZones, NeedAHoleInRock) {
  const Scene scene = synthetic::make_scene();
  const JetPath path = jet_path(scene);
  const State state = synthetic::make_state(scene, Teuchos::DefaultComm<int>::getComm());
  EXPECT_TRUE(measure_zones(scene, state, path, measure_penetration(scene, state, path)).empty());
}

}  // namespace
}  // namespace barreno
