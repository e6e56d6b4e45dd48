// SPDX-License-Identifier: BSD-3-Clause
// A pressure acts on a surface as long as its particles are part of one.
#include "base/gather.hpp"
#include "shape/kinematics.hpp"
#include "step/loads/release_torn_faces.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno {
namespace {

using testing::add_box;
using testing::box_scene;
using testing::start;

/// R(a) diag(x, y) R(b), hoop stretch z.
PlaneTensor stretched(double x, double y, double z, double a, double b) {
  const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
  return {
      ca * x * cb - sa * y * sb,
      -ca * x * sb - sa * y * cb,
      sa * x * cb + ca * y * sb,
      -sa * x * sb + ca * y * cb,
      z};
}

void put(const PlaneTensor& f, Particles& particles, int p) {
  particles.deformation_gradient(p, 0) = f.xx;
  particles.deformation_gradient(p, 1) = f.xy;
  particles.deformation_gradient(p, 2) = f.yx;
  particles.deformation_gradient(p, 3) = f.yy;
  particles.deformation_gradient(p, 4) = f.zz;
}

TEST(ReleaseTornFaces, LargestStretchIsTheLargestSingularValue) {
  EXPECT_EQ(largest_stretch(PlaneTensor{}), 1.0);
  for (const double a : {0.0, 0.4, 2.9})
    for (const double b : {0.0, -1.1, 0.7}) {
      EXPECT_NEAR(largest_stretch(stretched(1.7, 0.2, 1.0, a, b)), 1.7, 1e-14);
      EXPECT_NEAR(largest_stretch(stretched(0.3, 2.5, 2.4, a, b)), 2.5, 1e-14);
      EXPECT_NEAR(largest_stretch(stretched(0.9, 0.8, 1.2, a, b)), 1.2, 1e-14);
    }
}

TEST(ReleaseTornFaces, StretchedParticlesAndDebrisLoseTheirLoadsForGood) {
  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.016, 0.016, 0.0},
      testing::elastic(20e9, 0.25, 2300.0)
  );
  add_box(scene, "core", {0.0, 0.004, 0.0}, {0.008, 0.012, 0.0}, 1);
  PressureLoadSpec load;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
  load.pressure = {{0.0}, {70e6}};
  scene.loads.push_back(load);
  State state = start(scene);
  give_parcels(state.grid.owner, 0, continuum_of(state));  // keys and tiles
  Particles& particles = state.particles.front();
  // By the particle's id, which does not depend on the ranks: whole, stretched, torn, debris.
  double loaded = 0.0, torn = 0.0;
  for (int p = 0; p < particles.count; ++p) {
    const auto kind = static_cast<int>(particles.id(p) % 4);
    if (kind == 1) put(stretched(1.95, 0.6, 1.0, 0.3, 0.8), particles, p);
    if (kind == 2) put(stretched(2.05, 0.6, 1.0, 0.3, 0.8), particles, p);
    if (kind == 3) particles.body(p) |= debris_bit;
    if (particles.loaded_faces(p) == 0.0) continue;
    loaded += 1.0;
    if (kind >= 2) torn += 1.0;
  }
  for (int pass = 0; pass < 2; ++pass) {
    const double released =
        release_torn_faces(state.grid, state.nodes, state.particles, state.loads);
    EXPECT_EQ(released, pass == 0 ? torn : 0.0);
    double still_loaded = 0.0;
    std::vector<unsigned char> tiles(static_cast<std::size_t>(state.grid.active), 0);
    for (int p = 0; p < particles.count; ++p) {
      if (particles.loaded_faces(p) == 0.0) continue;
      still_loaded += 1.0;
      tiles[static_cast<std::size_t>(tile_of(state.grid.patch, particles, p))] = 1;
      EXPECT_LT(particles.id(p) % 4, 2);
    }
    EXPECT_EQ(still_loaded, loaded - torn);
    for (int tile = 0; tile < state.grid.active; ++tile)
      EXPECT_EQ(state.loads.loaded_tiles(tile), tiles[static_cast<std::size_t>(tile)]);
  }
  std::vector<double> sums{loaded, torn};
  sum_over_ranks(*state.grid.comm, sums);
  EXPECT_EQ(sums[0], 8.0);
  EXPECT_EQ(sums[1], 4.0);
}

}  // namespace
}  // namespace barreno
