// SPDX-License-Identifier: BSD-3-Clause
#include "output/radii.hpp"
#include "support/scenes.hpp"
#include "synthetic_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace barreno {
namespace {

Scene hollow_scene(Mode mode) {
  Scene scene = testing::box_scene(mode, 0.1, {}, {4.0, 4.0, 0.0}, testing::elastic(1e9, 0.3, 1e3));
  testing::add_box(scene, "Beside", {0.0, 3.6, 0.0}, {1.0, 4.0, 0.0}, 2);
  BodySpec body;
  body.name = "A shell";
  body.shape = Ball{{}, 3.5, 2.0};
  scene.bodies.push_back(body);
  return scene;
}

/// Last row of a CSV file: time, inner and outer radius.
std::vector<double> last_row(const std::filesystem::path& path) {
  std::stringstream lines(synthetic::read_text(path));
  std::string line, last;
  while (std::getline(lines, line)) last = line;
  std::vector<double> values;
  std::stringstream cells(last);
  for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
  return values;
}

/// Moves every particle of the shell as an incompressible one whose a^n falls by `change`, and
/// shrinks all by one ratio.
void implode(State& state, int n, double change, double ratio) {
  Particles& particles = state.particles[0];
  for (int p = 0; p < particles.count; ++p) {
    if (particles.body(p) != 1) continue;
    const double r = std::hypot(particles.position(p, 0), particles.position(p, 1));
    const double scale = ratio * std::pow(std::pow(r, n) - change, 1.0 / n) / r;
    particles.position(p, 0) *= scale;
    particles.position(p, 1) *= scale;
    particles.volume(p) *= std::pow(ratio, n);
  }
}

TEST(Radii, AreThoseOfAShellThatKeepsItsVolume) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain}) {
    const int n = mode == Mode::axisymmetric ? 3 : 2;
    const Scene scene = hollow_scene(mode);
    State state = testing::start(scene);
    const synthetic::TemporaryFolder folder(*state.grid.comm);
    RadiiWriter writer(
        scene, *state.grid.comm, start_of_radii(scene, state), folder.path() / "radii.csv"
    );
    writer.write(scene, state);
    std::vector<double> row = last_row(folder.path() / "radii.csv");
    ASSERT_EQ(row.size(), 3U);
    EXPECT_NEAR(row[1], 2.0, 1e-14);
    EXPECT_NEAR(row[2], 3.5, 1e-14);
    implode(state, n, 1.0, 1.0);
    state.clock.time = 5.0;
    writer.write(scene, state);
    row = last_row(folder.path() / "radii.csv");
    EXPECT_EQ(row[0], 5.0);
    EXPECT_NEAR(row[1], std::pow(std::pow(2.0, n) - 1.0, 1.0 / n), 1e-12);
    EXPECT_NEAR(row[2], std::pow(std::pow(3.5, n) - 1.0, 1.0 / n), 1e-12);
  }
}

TEST(Radii, FollowAUniformCompression) {
  const Scene scene = hollow_scene(Mode::axisymmetric);
  State state = testing::start(scene);
  const synthetic::TemporaryFolder folder(*state.grid.comm);
  RadiiWriter writer(
      scene, *state.grid.comm, start_of_radii(scene, state), folder.path() / "radii.csv"
  );
  implode(state, 3, 0.0, 0.9);
  writer.write(scene, state);
  const std::vector<double> row = last_row(folder.path() / "radii.csv");
  // The mean of r^3 of the particles' centres is not quite that of the sphere: O(size^2).
  EXPECT_NEAR(row[1], 0.9 * 2.0, 2e-3);
  EXPECT_NEAR(row[2], 0.9 * 3.5, 2e-3);
}

TEST(Radii, AreTheSameBitsOnAnyRanks) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain}) {
    const Scene scene = hollow_scene(mode);
    State shared = testing::start(scene), alone = testing::start_alone(scene);
    for (const double ratio : {1.0, 0.97}) {
      for (State* state : {&shared, &alone}) implode(*state, 3, 0.3, ratio);
      const RadialMoment here = radial_moments(scene, shared, {1}).front();
      const RadialMoment expected = radial_moments(scene, alone, {1}).front();
      EXPECT_EQ(here.mass, expected.mass);
      EXPECT_EQ(here.mean_power, expected.mean_power);
      EXPECT_EQ(here.volume, expected.volume);
    }
  }
}

TEST(Radii, AreForHollowBallsOnly) {
  EXPECT_EQ(hollow_balls(hollow_scene(Mode::axisymmetric)), std::vector<int>{1});
  EXPECT_TRUE(hollow_balls(synthetic::make_scene()).empty());
}

}  // namespace
}  // namespace barreno
