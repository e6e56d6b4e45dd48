// SPDX-License-Identifier: BSD-3-Clause
#include "jet/channel.hpp"
#include "jet/depth.hpp"
#include "jet/estimate.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace barreno {
namespace {

using synthetic::launch_plane;
using synthetic::tip_speed;

TEST(JetPath, BeginsAtTheFirstBodyMetWhateverTheOrderInTheDeck) {
  const JetPath path = jet_path(synthetic::make_scene());
  EXPECT_EQ(path.face, 0.0);
  EXPECT_EQ(path.end, 0.04);
  EXPECT_EQ(path.bins, 20);
}

TEST(JetPath, RunsBackwardsForAJetThatDoes) {
  Scene scene = synthetic::make_scene();
  scene.jet.direction = -1.0;
  scene.jet.launch_position = 0.05;
  const JetPath path = jet_path(scene);
  EXPECT_EQ(path.face, 0.04);
  EXPECT_EQ(path.end, 0.0);
  EXPECT_NEAR(path.depth(0.03), 0.01, 1e-15);
}

TEST(JetPath, PassesBodiesBesideTheAxisAndBehindTheLaunchPlane) {
  Scene scene = synthetic::make_scene();
  BodySpec beside, behind, ball;
  beside.shape = Box{{0.01, -0.005, 0.0}, {0.02, 0.0, 0.0}};
  behind.shape = Box{{0.0, -0.012, 0.0}, {0.02, -0.007, 0.0}};
  ball.shape = Ball{{0.0, -0.002, 0.0}, 0.001};
  scene.bodies.insert(scene.bodies.end(), {beside, behind});
  EXPECT_EQ(jet_path(scene).face, 0.0);
  scene.bodies.push_back(ball);
  EXPECT_NEAR(jet_path(scene).face, -0.003, 1e-15);
  scene.bodies.clear();
  EXPECT_FALSE(jet_path(scene).has_target);
  EXPECT_EQ(jet_path(scene).face, launch_plane);
  EXPECT_EQ(jet_path(scene).bins, 0);
}

TEST(Channel, EndsAtTheFirstClosedBin) {
  JetPath path;
  path.bin = 1.0;
  path.end = 4.0;
  path.bins = 4;
  Penetration result;
  measure_channel({3.0, 2.0, 0.0, 0.0}, path, result);
  EXPECT_EQ(result.channel_depth, 2.0);
  EXPECT_EQ(result.channel_radius_mid, 2.5);
  measure_channel({3.0, 0.0, 2.0, 0.0}, path, result);  // a crumb, and what is left at the end
  EXPECT_EQ(result.channel_depth, 3.0);
  EXPECT_EQ(result.channel_radius_mid, 2.5) << "between the open rows around the crumb";
  measure_channel({0.0, 0.0, 2.0, 2.0}, path, result);
  EXPECT_EQ(result.channel_depth, 0.0);
  EXPECT_EQ(result.channel_radius_mid, 0.0);
  measure_channel({9.0, 9.0, 9.0, 9.0}, path, result);
  EXPECT_EQ(result.channel_depth, 4.0);
  EXPECT_EQ(result.channel_radius_mid, 9.0);
}

/// A hole of one cell in radius, and solid rock behind it, but for rows that are changed.
std::vector<double> walls_with(
    std::size_t wide, std::size_t first, std::size_t past, double radius
) {
  std::vector<double> walls(60, 0.0);
  std::fill_n(walls.begin(), wide, 1.0);
  std::fill(
      walls.begin() + static_cast<long>(first), walls.begin() + static_cast<long>(past), radius
  );
  return walls;
}

/// A probe half a cell in radius looks at five rows on either side.
TEST(Channel, IsAsWideAsTheJetButForNecks) {
  JetPath path;
  path.bin = 1.0;
  path.end = 60.0;
  path.bins = 60;
  path.origin.radius = 0.5;
  const auto probed = [&](const std::vector<double>& walls) {
    Penetration result;
    measure_channel(walls, path, result);
    return result.probed_depth;
  };
  for (const std::size_t wide : {0U, 1U, 2U, 7U, 30U, 60U})
    EXPECT_EQ(probed(walls_with(wide, 0, 0, 0.0)), static_cast<double>(wide)) << "a plain hole";
  EXPECT_EQ(probed(walls_with(30, 10, 15, 0.4)), 30.0) << "a neck of five diameters";
  EXPECT_EQ(probed(walls_with(30, 10, 16, 0.4)), 10.0) << "a longer one";
  EXPECT_EQ(probed(walls_with(30, 10, 22, 0.4)), 10.0) << "a thread, with a hole behind it";
  EXPECT_EQ(probed(walls_with(30, 30, 55, 0.4)), 30.0) << "a thread";
  EXPECT_EQ(probed(walls_with(30, 40, 45, 0.6)), 30.0) << "a bubble in a thread";
  EXPECT_EQ(probed(walls_with(0, 10, 40, 2.0)), 0.0) << "a closed entrance";
  path.origin.radius = 0.0;  // no slug: a probe is a quarter of a cell in radius
  EXPECT_EQ(probed(walls_with(30, 10, 12, 0.4)), 30.0);
}

TEST(Channel, VolumeAsWideAsTheJetLeavesOutAThread) {
  GridSpec grid = synthetic::make_scene().grid;
  grid.lower[0] = 0.0;
  grid.upper[0] = 20.0;
  JetPath path;
  path.bin = 1.0;
  path.end = 60.0;
  path.bins = 60;
  path.origin.radius = 0.5;
  Penetration found;
  found.walls = walls_with(30, 30, 45, 0.4);
  found.walls[7] = 0.0;  // a crumb, in a row that is one of those as wide
  measure_channel(found.walls, path, found);
  ASSERT_EQ(found.probed_depth, 30.0);
  ASSERT_EQ(found.channel_depth, 45.0);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(probed_volume(grid, path, found), 29.0 * pi, 1e-12);
  EXPECT_NEAR(channel_volume(grid, path, found), (29.0 + 15.0 * 0.16) * pi, 1e-12);
  grid.mode = Mode::plane_strain;
  EXPECT_NEAR(probed_volume(grid, path, found), 29.0 * 2.0, 1e-12);
}

TEST(Penetration, FollowsAJetOfKnownMotion) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const JetPath path = jet_path(scene);
  State state = synthetic::make_state(scene, comm);
  Penetration result = measure_penetration(scene, state, path);
  EXPECT_EQ(result.depth, 0.0);
  EXPECT_EQ(result.tip_velocity, 0.0);
  EXPECT_EQ(result.channel_depth, 0.0);

  const double before_arrival = 1e-6, inside = 5e-6;
  synthetic::move_to(scene, state, before_arrival);
  result = measure_penetration(scene, state, path);
  if (comm->getRank() == 0) {
    EXPECT_FALSE(result.met);
    EXPECT_EQ(result.depth, 0.0);
    EXPECT_EQ(result.tip_velocity, tip_speed);
    EXPECT_EQ(result.jet_mass_inside, 0.0);
  }
  synthetic::move_to(scene, state, inside);
  result = measure_penetration(scene, state, path);
  if (comm->getRank() == 0) {
    EXPECT_TRUE(result.met);
    EXPECT_NEAR(result.depth, launch_plane + tip_speed * inside, 1e-12);
    EXPECT_NEAR(result.channel_depth, 0.014, 1e-12);
    EXPECT_NEAR(
        result.channel_radius_mid, 0.004 * std::exp(-20.0 * 0.007), 0.1 * scene.grid.cell_size
    );
    EXPECT_GT(result.jet_mass_inside, 0.0);
    EXPECT_FALSE(result.through);
  }
}

TEST(Penetration, IsNoDepthBeyondTheRearOfTheTarget) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  JetPath path = jet_path(scene);
  State state = synthetic::make_state(scene, comm);
  synthetic::move_to(scene, state, 5e-6);
  const double length = 0.5 * (launch_plane + tip_speed * 5e-6 - path.face);
  path.end = path.face + path.direction * length;
  path.bins = static_cast<int>(std::ceil(length / path.bin));
  const Penetration result = measure_penetration(scene, state, path);
  if (comm->getRank() == 0) {
    EXPECT_TRUE(result.through);
    EXPECT_NEAR(result.depth, length, 1e-15);
    EXPECT_NE(depth_doubt(scene, 5e-6, result).unknown, "");
  }
  const PathLayer layer{0, 0.02, 0.05};
  JetPath straight;
  straight.face = 0.01;
  EXPECT_EQ(depth_in(layer, straight, 0.005), 0.0);
  EXPECT_NEAR(depth_in(layer, straight, 0.03), 0.02, 1e-15);
  EXPECT_NEAR(depth_in(layer, straight, 0.09), 0.03, 1e-15);
}

TEST(DepthWriter, StaysThroughWhenTheTipIsGone) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  JetPath path = jet_path(scene);
  path.end = path.face + 0.5 * (launch_plane + tip_speed * 5e-6 - path.face);
  path.bins = static_cast<int>(std::ceil((path.end - path.face) / path.bin));
  const auto file = std::filesystem::temp_directory_path() /
                    ("depth_through" + std::to_string(comm->getSize()) + ".csv");
  DepthWriter writer(path, *comm, file);
  State state = synthetic::make_state(scene, comm);
  for (const double time : {1e-6, 5e-6, 1e-6}) {
    state.clock.time = time;
    synthetic::move_to(scene, state, time);
    writer.measure(scene, state);
    if (comm->getRank() != 0) continue;
    EXPECT_EQ(writer.last().through, writer.through_since() > 0.0);
  }
  if (comm->getRank() == 0) {
    EXPECT_EQ(writer.last().through_since, 5e-6);
    EXPECT_EQ(writer.last().depth, path.end - path.face);
    std::filesystem::remove(file);
  }
  DepthWriter resumed(path, *comm, file, 0, 5e-6);
  resumed.measure(scene, state);
  if (comm->getRank() == 0) {
    EXPECT_TRUE(resumed.last().through);
    std::filesystem::remove(file);
  }
}

/// The synthetic scene with its jet said to come from a liner behind the launch plane.
Scene with_liner(Scene scene) {
  scene.jet.present = false;
  BodySpec liner;
  liner.name = "liner";
  liner.material = 2;
  liner.shape = Box{{0.0, -0.012, 0.0}, {0.004, -0.007, 0.0}};
  scene.bodies.push_back(liner);  // with the number that the launched jet had
  return scene;
}

JetMonitorSpec monitor_at(double position) {
  JetMonitorSpec monitor;
  monitor.bodies = {2};
  monitor.position = position;
  monitor.density = 17600.0;
  return monitor;
}

TEST(JetPath, OfAFormedJetBeginsAtTheMonitorAndIsRecordedWithATarget) {
  const Scene launched = synthetic::make_scene(), formed = with_liner(launched);
  const auto path = recorded_path(formed, monitor_at(launch_plane));
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->face, 0.0);
  EXPECT_EQ(path->end, 0.04);
  EXPECT_TRUE(path->origin.formed);
  // Beyond the target there is none; nor without a jet.
  EXPECT_FALSE(recorded_path(formed, monitor_at(0.04)).has_value());
  EXPECT_FALSE(recorded_path(formed, {}).has_value());
  // A launched jet is the one whose depth is recorded.
  EXPECT_FALSE(recorded_path(launched, monitor_at(launch_plane))->origin.formed);
  EXPECT_EQ(recorded_path(formed, monitor_at(0.002))->face, 0.0);
}

TEST(Penetration, OfAFormedJetIsThatOfALaunchedOne) {
  const Scene launched = synthetic::make_scene(), formed = with_liner(launched);
  State state = synthetic::make_state(launched, Teuchos::DefaultComm<int>::getComm());
  synthetic::move_to(launched, state, 5e-6);
  const Penetration one = measure_penetration(launched, state, jet_path(launched));
  const auto monitor = monitor_at(launch_plane);
  const JetPath path = jet_path(formed, formed_jet(formed, monitor));
  const Penetration other = measure_penetration(formed, state, path);
  EXPECT_EQ(one.met, other.met);
  EXPECT_EQ(one.depth, other.depth);
  EXPECT_EQ(one.channel_depth, other.channel_depth);
  EXPECT_EQ(one.channel_radius_mid, other.channel_radius_mid);
  EXPECT_EQ(one.tip_velocity, other.tip_velocity);
  EXPECT_NEAR(one.jet_mass_inside, other.jet_mass_inside, 1e-12 * one.jet_mass_inside);
  // What has not passed the plane is no jet yet.
  const JetPath late = jet_path(formed, formed_jet(formed, monitor_at(0.039)));
  EXPECT_EQ(measure_penetration(formed, state, late).tip_velocity, 0.0);
}

/// The same jet above a target that it flies away from: it moves, but there is nothing to be deep
/// in.
TEST(Penetration, NeedsATarget) {
  const Scene scene = synthetic::make_scene();
  JetPath path = jet_path(scene);
  path.has_target = false;
  path.face = path.end = launch_plane;
  path.bins = 0;
  State state = synthetic::make_state(scene, Teuchos::DefaultComm<int>::getComm());
  synthetic::move_to(scene, state, 5e-6);
  const Penetration result = measure_penetration(scene, state, path);
  EXPECT_FALSE(result.met);
  EXPECT_EQ(result.depth, 0.0);
  EXPECT_EQ(result.channel_depth, 0.0);
  if (state.grid.comm->getRank() == 0) {
    EXPECT_EQ(result.jet_mass_inside, 0.0);
    EXPECT_EQ(result.tip_velocity, tip_speed);
  }
}

TEST(Penetration, IsTheSameInAnyOrderOfParticles) {
  const Scene scene = synthetic::make_scene();
  State state = synthetic::make_state(scene, Teuchos::DefaultComm<int>::getComm());
  const JetPath path = jet_path(scene);
  synthetic::move_to(scene, state, 7e-6);
  const Penetration before = measure_penetration(scene, state, path);
  for (Particles& set : state.particles) {
    for (int p = 0, q = set.count - 1; p < q; ++p, --q) {
      std::swap(set.id(p), set.id(q));
      std::swap(set.body(p), set.body(q));
      set.for_each_field([&](Field& field) {
        for (int c = 0; c < field.components; ++c) std::swap(field(p, c), field(q, c));
      });
    }
  }
  const Penetration after = measure_penetration(scene, state, path);
  EXPECT_EQ(before.depth, after.depth);
  EXPECT_EQ(before.channel_depth, after.channel_depth);
  EXPECT_EQ(before.channel_radius_mid, after.channel_radius_mid);
  EXPECT_EQ(before.jet_mass_inside, after.jet_mass_inside);
  EXPECT_EQ(before.tip_velocity, after.tip_velocity);
}

}  // namespace
}  // namespace barreno
