// SPDX-License-Identifier: BSD-3-Clause
/// The neo-Hookean law against its closed form in F, which it never sees.

#include "barreno/symmetric_functions.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno::test {
namespace {

const Sym3 sheared{2.0, 0.7, 1.3, 0.4, -0.2, 0.3};

TEST(SymmetricFunctions, RootAndExponentialAgreeWithTheirMeaning) {
  const Sym3 root = square_root(sheared);
  EXPECT_LE(largest_component(commuting_product(root, root) - sheared), 1e-14);
  EXPECT_LE(largest_component(commuting_product(inverse(root), root) - isotropic(1.0)), 1e-14);
  // exp(A) exp(-A) = I, and the doublings agree with the series of a small tensor.
  const Sym3 forth = isotropic(1.0) + exponential_less_one(sheared);
  const Sym3 back = isotropic(1.0) + exponential_less_one(-1.0 * sheared);
  EXPECT_LE(largest_component(commuting_product(forth, back) - isotropic(1.0)), 1e-13);
  EXPECT_NEAR(determinant(forth), std::exp(trace(sheared)), 1e-12);
  EXPECT_EQ(largest_component(exponential_less_one({})), 0.0);
}

TEST(NeoHookean, PrincipalStretchesAreExactInOneStep) {
  const auto model = sample_model<NeoHookean>();
  const double mu = model.parameters().shear_modulus;
  const double stretch[3] = {1.9, 0.6, 1.2};
  Point<NeoHookean> point(model);
  const Sym3 strain{std::log(stretch[0]), std::log(stretch[1]), std::log(stretch[2]), 0, 0, 0};
  ASSERT_FALSE(point.apply(strain, 1.0).failed());
  const double j = stretch[0] * stretch[1] * stretch[2];
  const double stress[3] = {point.stress.xx, point.stress.yy, point.stress.zz};
  for (int i = 0; i < 3; ++i) {
    const double exact = (model.lambda() * std::log(j) + mu * (stretch[i] * stretch[i] - 1.0)) / j;
    EXPECT_NEAR(stress[i], exact, 1e-12 * mu);
  }
  double square = -3.0;
  for (const double s : stretch) square += s * s;
  const double energy =
      0.5 * model.lambda() * std::log(j) * std::log(j) - mu * std::log(j) + 0.5 * mu * square;
  EXPECT_NEAR(point.last.elastic_work, energy, 1e-12 * mu);
}

/// Simple shear F = I + k e_x e_y to k = 4 in n steps of constant dF/dt, unrotated strain
/// increments as the code finds them. Error of the stress over its largest component.
double error_of_shear(int n) {
  const double end = 4.0;
  const auto model = sample_model<NeoHookean>();
  Point<NeoHookean> point(model);
  // Polar rotation of a plane F: direction of (Fxx + Fyy, Fyx - Fxy).
  const auto angle = [](double k) { return std::atan2(-k, 2.0); };
  for (int i = 0; i < n; ++i) {
    const double step = end / n;
    const double turn = 0.5 * (angle(i * step) + angle((i + 1) * step));
    // sym(L dt) = step / 2 (e_x e_y + e_y e_x) seen from axes turned by `turn`.
    const double diagonal = 0.5 * step * std::sin(2.0 * turn);
    const Sym3 strain{diagonal, -diagonal, 0.0, 0.5 * step * std::cos(2.0 * turn), 0.0, 0.0};
    EXPECT_FALSE(point.apply(strain, 1.0).failed());
  }
  // B - I = [[k^2, k], [k, 0]] turned back by the final angle.
  const double c = std::cos(angle(end)), s = std::sin(angle(end)), k = end;
  const double mu = model.parameters().shear_modulus;
  const Sym3 exact = mu * Sym3{
                              c * c * k * k + 2.0 * c * s * k,
                              s * s * k * k - 2.0 * c * s * k,
                              0.0,
                              -c * s * k * k + (c * c - s * s) * k,
                              0.0,
                              0.0};
  return largest_component(point.stress - exact) / largest_component(exact);
}

TEST(NeoHookean, LargeShearIsSecondOrderInTheStep) {
  const double coarse = error_of_shear(100), fine = error_of_shear(200);
  EXPECT_LE(coarse, 3.5e-4);  // 3.06e-4: steps of 0.04 in shear, each turned by its own middle
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
  RecordProperty("error", std::to_string(coarse));
}

}  // namespace
}  // namespace barreno::test
