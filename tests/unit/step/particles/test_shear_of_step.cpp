// SPDX-License-Identifier: BSD-3-Clause
#include "shape/kinematics.hpp"
#include "step/particles/shear_of_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace barreno {
namespace {

/// The norm for one row whose dt L is given.
template <class M>
double shear_of_row(const std::vector<double>& entries) {
  const FieldView increment("increment", 1, entries.size());
  for (std::size_t c = 0; c < entries.size(); ++c) increment(0, static_cast<int>(c)) = entries[c];
  return shear_of_step<M>(increment, 0);
}

TEST(ShearOfStep, IsTheNormOfTheDeviatorOfTheSymmetricPart) {
  EXPECT_NEAR(
      (shear_of_row<Axisymmetric>({0.0, 2e-3, 0.0, 0.0, 0.0})), 2e-3 / std::sqrt(2.0), 1e-18
  );
  EXPECT_EQ((shear_of_row<Axisymmetric>({0.0, 2e-3, -2e-3, 0.0, 0.0})), 0.0) << "a spin";
  EXPECT_NEAR((shear_of_row<Axisymmetric>({1e-3, 0.0, 0.0, 1e-3, 1e-3})), 0.0, 1e-11)
      << "dilatation";
  EXPECT_NEAR(
      (shear_of_row<Axisymmetric>({0.0, 0.0, 0.0, 3e-3, 0.0})), 3e-3 * std::sqrt(2.0 / 3.0), 1e-18
  );
  EXPECT_NEAR(
      (shear_of_row<ThreeDimensional>({0.0, 0.0, 0.0, 0.0, 0.0, 4e-3, 0.0, 0.0, 0.0})),
      4e-3 / std::sqrt(2.0),
      1e-18
  );
}

}  // namespace
}  // namespace barreno
