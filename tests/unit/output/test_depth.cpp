// SPDX-License-Identifier: BSD-3-Clause
#include "output/depth.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <cmath>

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
  measure_channel({3.0, 2.0, 0.0, 5.0}, path, result);
  EXPECT_EQ(result.channel_depth, 2.0);
  EXPECT_EQ(result.channel_radius_mid, 2.0);
  measure_channel({0.0, 2.0, 2.0, 2.0}, path, result);
  EXPECT_EQ(result.channel_depth, 0.0);
  EXPECT_EQ(result.channel_radius_mid, 0.0);
  measure_channel({9.0, 9.0, 9.0, 9.0}, path, result);
  EXPECT_EQ(result.channel_depth, 4.0);
  EXPECT_EQ(result.channel_radius_mid, 9.0);
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
    // Whole cells: the radius is found to half of one.
    EXPECT_NEAR(
        result.channel_radius_mid, 0.004 * std::exp(-20.0 * 0.0075), 0.5 * scene.grid.cell_size
    );
    EXPECT_GT(result.jet_mass_inside, 0.0);
  }
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
