// SPDX-License-Identifier: BSD-3-Clause
// A bar that flies apart uniformly: domains that follow F keep it whole, domains of fixed size or
// of a limited one do not.
#include "shape/visit_kernels.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr double rate = 100.0;      ///< dv/dx at the start; nothing changes it [1/time]
constexpr double end_time = 0.049;  ///< stretched 5.9 times

/// A soft bar, 20 cells long; v = rate x, x = X (1 + rate t), F_xx = 1 + rate t.
Scene bar(const char* shape, double largest_domain) {
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.160, 0.008, 0.0},
      testing::elastic(1e-6, 0.0, 1000.0)
  );
  testing::add_box(scene, "bar", {0.0, 0.002, 0.0}, {0.020, 0.006, 0.0}, 2);
  testing::add_symmetry(scene, Face::x_lower);
  scene.step.shape = shape;
  scene.step.largest_domain = largest_domain;
  // The first stable step knows nothing of the velocities that are set below.
  scene.step.initial_step = 1e-5;
  scene.step.courant_fraction = 0.1;

  return scene;
}

struct Stretch {
  double worst = 0.0;  ///< largest |F_xx / (1 + rate t) - 1|
  double clipped = 0.0;
};
Stretch extend(const char* shape, double largest_domain) {
  const Scene scene = bar(shape, largest_domain);
  State state = testing::start(scene);
  Particles& particles = state.particles.front();
  for (int p = 0; p < particles.count; ++p) particles.velocity(p, 0) = rate * particles.position(p);
  testing::advance_to(scene, end_time, state);
  Stretch out;
  const double expected = 1.0 + rate * end_time;
  for (int p = 0; p < particles.count; ++p) {
    // Nodes at the free end and at the wall have particles on one side only; these cells differ by
    // some per cent with every shape function.
    const double place = particles.position(p) / (0.020 * expected);
    if (place < 0.1 || place > 0.9) continue;
    out.worst =
        std::max(out.worst, std::abs(particles.deformation_gradient(p, 0) / expected - 1.0));
  }
  out.clipped = state.ledger.clipped;
  EXPECT_EQ(particles.count, 40 * 8);
  return out;
}

TEST(Extension, CpdiStaysWholeOverDomainsOfSeveralCells) {
  const Stretch found = extend("CPDI", farthest_domain(Mode::plane_strain));
  EXPECT_LT(found.worst, 0.01);
  EXPECT_EQ(found.clipped, 0.0);
}

TEST(Extension, ScaledDomainsAreCountedWhereTheyNoLongerTouch) {
  const Stretch found = extend("CPDI", 0.5);
  EXPECT_EQ(found.clipped, 320.0);
}

TEST(Extension, DomainsOfFixedSizeLoseTouch) {
  EXPECT_GT(extend("GIMP", 1.0).worst, 0.05);
}

}  // namespace
}  // namespace barreno
