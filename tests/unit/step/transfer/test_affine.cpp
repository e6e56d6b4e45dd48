// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/gather_affine.hpp"
#include "step/transfer/project_affine.hpp"
#include "step/transfer/project_particles.hpp"
#include "step/transfer/start_affine.hpp"
#include "support/two_tiles.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// A particle that fills a cell weighs its four corners alike: D is 1/4 of a square cell along each
/// axis. The second tile has cells half as large, from 4 to 8 along x.
struct TwoCells {
  Scene scene;
  State state;
  Particles& particles;

  TwoCells() : scene(make()), state(testing::start_in_tiles(scene)), particles(state.particles[0]) {
    testing::set_frame(state.grid, 0, 1.0, 0.5);
    testing::set_frame(state.grid, 1, 0.5, 0.5);
    const int fine = testing::row_in(particles, 1);
    particles.position(fine, 0) = 4.0 + 3.5 * 0.5;
    particles.position(fine, 1) = 3.5 * 0.5;
    for (int d = 0; d < 2; ++d) particles.half_size(fine, d) = 0.25;
    clear_nodes(state.grid, state.nodes[0]);
  }
  static Scene make() {
    Scene scene = testing::two_tiles(testing::elastic(1.0, 0.25, 4.0));
    scene.step.transfer = Transfer::apic;
    scene.step.pic_fraction = 1.0;
    return scene;
  }
  static double cell_size(int tile) { return tile == 0 ? 1.0 : 0.5; }
  static double second_moment(int tile) { return 0.25 * cell_size(tile) * cell_size(tile); }
};

constexpr double slope[2][2] = {{0.5, 2.0}, {-1.0, 4.0}};

TEST(StartAffine, MomentsAreThoseOfTheInitialGradient) {
  TwoCells two;
  for (int p = 0; p < 2; ++p)
    for (int c = 0; c < 4; ++c) two.particles.affine(p, c) = slope[c / 2][c % 2];
  start_affine(two.state.grid, two.state.particles);
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c)
      EXPECT_EQ(
          two.particles.affine(testing::row_in(two.particles, tile), c),
          slope[c / 2][c % 2] * TwoCells::second_moment(tile)
      );
}

/// p_I = S m G (x_I - x_p), with G = B D^-1.
TEST(ProjectAffine, MomentaTurnAboutTheParticle) {
  TwoCells two;
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c)
      two.particles.affine(testing::row_in(two.particles, tile), c) =
          slope[c / 2][c % 2] * TwoCells::second_moment(tile);
  Nodes& nodes = two.state.nodes[0];
  project_affine(two.state.grid, two.particles, nodes);
  for (int tile = 0; tile < 2; ++tile)
    for (const int x : {0, 1})
      for (const int y : {0, 1}) {
        const double h = TwoCells::cell_size(tile);
        const double at[] = {(x - 0.5) * h, (y - 0.5) * h};
        const double* const node =
            &nodes.sums(first_sum(two.state.grid.patch, tile)) +
            testing::slot_of(two.state.grid.patch, 3 + x, 3 + y) * sum_components;
        EXPECT_EQ(node[0], 0.0);  // no mass
        for (int i = 0; i < 2; ++i)
          EXPECT_EQ(node[1 + i], 0.25 * 4.0 * (slope[i][0] * at[0] + slope[i][1] * at[1]));
      }
}

TEST(GatherAffine, MomentsAreThoseOfTheGridsVelocity) {
  TwoCells two;
  Nodes& nodes = two.state.nodes[0];
  const Patch& patch = two.state.grid.patch;
  double energy = 0.0;
  for (int tile = 0; tile < 2; ++tile)
    for (int slot = 0; slot < patch.size; ++slot) {
      int at[2];
      position_of_slot(patch, slot, at);
      double* const node = &nodes.motion(first_motion(patch, tile)) + slot * motion_components(2);
      for (int i = 0; i < 2; ++i)
        node[i] = 3.0 + TwoCells::cell_size(tile) * (slope[i][0] * at[0] + slope[i][1] * at[1]);
    }
  const ReproducibleSum remembered =
      gather_affine(two.state.grid, two.state.nodes, two.state.particles);
  for (int tile = 0; tile < 2; ++tile)
    for (int c = 0; c < 4; ++c) {
      const double g = slope[c / 2][c % 2], d = TwoCells::second_moment(tile);
      EXPECT_EQ(two.particles.affine(testing::row_in(two.particles, tile), c), g * d);
      energy += 0.5 * 4.0 * g * g * d;
    }
  EXPECT_EQ(remembered, energy);
}

TEST(GatherAffine, OtherTransfersKeepNothing) {
  State state = testing::start_in_tiles(testing::two_tiles(testing::elastic(1.0, 0.25, 4.0)));
  clear_nodes(state.grid, state.nodes[0]);
  start_affine(state.grid, state.particles);
  project_affine(state.grid, state.particles[0], state.nodes[0]);
  EXPECT_EQ(gather_affine(state.grid, state.nodes, state.particles), 0.0);
}

}  // namespace
}  // namespace barreno
