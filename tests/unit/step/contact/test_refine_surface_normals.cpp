// SPDX-License-Identifier: BSD-3-Clause
// The gap between two blocks, along the normal that makes it widest.
#include "step/contact/contact_bodies.hpp"
#include "unit/step/contact/two_blocks.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Normal and gap of two blocks at the node (4, 4) between them.
std::vector<double> refined(const Scene& scene) {
  State state = testing::in_tiles(scene, 1.0);
  testing::meet(scene, state);
  const SymmetryPlanes planes(scene.conditions, state.grid);
  refine_surface_normals({state.grid, state.fields, state.particles, planes}, state.contact);
  const double* const n = testing::normal_at(state, 0, {4, 4});
  return {n[0], n[1], n[2]};
}

TEST(RefineSurfaceNormals, GapIsThatOfTheParticlesInCells) {
  for (const double h : {1.0, 0.25})
    for (const double gap : {0.0, 0.125, 0.375}) {
      const std::vector<double> found =
          refined(testing::two_blocks(Mode::plane_strain, h, gap, ContactKind::frictionless));
      EXPECT_NEAR(found[0], 1.0, 1e-12);
      EXPECT_NEAR(found[1], 0.0, 1e-12);
      EXPECT_NEAR(found[2], gap, 1e-12);
    }
}

/// At the corner of the second block, half of whose cloud is missing, the fit leans; along the face
/// of the first the gap is widest.
TEST(RefineSurfaceNormals, AtACornerTheyTurnToTheWidestGap) {
  Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.25, ContactKind::frictionless);
  scene.bodies[1].shape = Box{{4.25, 4.0, 0.0}, {6.25, 6.0, 0.0}};
  State fitted = testing::in_tiles(scene, 1.0);
  testing::meet(scene, fitted);
  const double leaning = testing::normal_at(fitted, 0, {4, 4})[1];
  EXPECT_GT(leaning, 0.1);
  const std::vector<double> found = refined(scene);
  EXPECT_NEAR(found[0], 1.0, 1e-12);
  EXPECT_NEAR(found[1], 0.0, 1e-12);
  EXPECT_NEAR(found[2], 0.25, 1e-12);
}

}  // namespace
}  // namespace barreno
