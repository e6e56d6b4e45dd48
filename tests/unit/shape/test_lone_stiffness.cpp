// SPDX-License-Identifier: BSD-3-Clause
#include "shape/lone_stiffness.hpp"
#include "unit/shape/shape_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno {
namespace {

using NodeValues = std::vector<double>;

/// Rate of volume that a unit pressure of the particle gives to it in a unit of time, where all
/// masses of the nodes are its own; volume and mass 1. By the sums of the step itself.
template <class M, class Support>
double rate_of_unit_pressure(const Support& support, const Patch& patch) {
  constexpr unsigned D = M::dimensions;
  const auto size = static_cast<std::size_t>(patch.size);
  const double none[D] = {};
  NodeValues mass(size, 0.0);
  support.template add_to<M::hoop>(mass.data(), patch, 1.0, none, 0.0);
  double rate = 0.0;
  for (unsigned d = 0; d < D; ++d) {
    NodeValues velocity(size, 0.0);
    double along[D] = {};
    along[d] = 1.0;
    const double hoop = M::hoop && d == 0 ? 1.0 : 0.0;
    support.template add_to<M::hoop>(velocity.data(), patch, 0.0, along, hoop);
    for (std::size_t i = 0; i < size; ++i)
      velocity[i] = mass[i] > 0.0 ? velocity[i] / mass[i] : 0.0;
    const auto at = support.template interpolate<M::hoop>(velocity.data(), patch);
    rate += at.d[d] + hoop * at.hoop;
  }
  return rate;
}

template <class M>
void check_against_the_step(double first) {
  const Patch patch = make_patch(M::dimensions, testing::reach);
  double largest = 0.0;
  for (const testing::ShapeCase& c : testing::shape_cases<M, Cpdi>(first)) {
    const auto support = Cpdi::support<M>(c.particle);
    const double k = lone_stiffness<M>(support, patch, testing::cell);
    const double rate = testing::cell * testing::cell * rate_of_unit_pressure<M>(support, patch);
    EXPECT_NEAR(k, rate, 1e-9 * rate);
    largest = std::max(largest, k);
  }
  EXPECT_GT(largest, 15.0);  // there are thin ones
}

TEST(LoneStiffness, IsTheRateThatAPressureGivesToItsOwnParticle) {
  check_against_the_step<PlaneStrain>(0.0);
  check_against_the_step<Axisymmetric>(0.0);
  check_against_the_step<ThreeDimensional>(0.0);
}

/// Along an axis a domain a cells half wide with one end on a node has 1 / (a (1 - a)).
TEST(LoneStiffness, OfAnAlignedNeedleIsThatOfTwoBars) {
  testing::ShapeCase c = testing::particle_at<PlaneStrain>({3.1, 3.25, 0.0}, 2, 0.0);
  testing::deform(c, 0.0, 0.4, 1.0, 0.0);
  const double k = lone_stiffness<PlaneStrain>(
      Cpdi::support<PlaneStrain>(c.particle), make_patch(2, testing::reach), testing::cell
  );
  EXPECT_NEAR(k, 1.0 / (0.1 * 0.9) + 1.0 / (0.25 * 0.75), 1e-9);
}

}  // namespace
}  // namespace barreno
