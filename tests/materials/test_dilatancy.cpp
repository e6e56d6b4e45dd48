// SPDX-License-Identifier: BSD-3-Clause
/// How much sheared rock dilates: the published rule, and its bounds (parts/flow_rule.hpp).
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;
using arenisca::Cap;
using arenisca::FlowRule;

/// Rock without pores and with a straight limit, so that its plastic volume strain over its plastic
/// shear strain is 3 sqrt(3) beta^2 FSLOPE.
Parameters straight_rock() {
  Parameters p = Sample<Arenisca>::parameters();
  p.p3_crush_curve = p.STREN = p.YSLOPE = p.B1 = p.B2 = 0.0;
  p.FSLOPE = 0.2;
  return p;
}

/// A point that is compressed to 240 MPa and then sheared at constant volume.
struct ShearedPoint {
  Arenisca model;
  Sym3 stress{};
  Arenisca::History history;

  explicit ShearedPoint(const Parameters& p) : model(p, 2300.0), history(model.initial_history()) {
    for (int i = 0; i < 100; ++i) strain(isotropic(-1e-4));
  }
  void strain(const Sym3& by) {
    Increment increment{};
    increment.strain = by;
    increment.dt = 1e-6;
    ASSERT_FALSE(model.update(increment, stress, history).failed());
  }
  /// Plastic volume strain over plastic shear strain of a step, over that of beta = 1.
  double ratio_of_step() {
    const Arenisca::History before = history;
    strain({-2e-4, 1e-4, 1e-4, 0.0, 0.0, 0.0});
    const double shear = history.equivalent_plastic_strain - before.equivalent_plastic_strain;
    const double volume = history.plastic_volume_strain - before.plastic_volume_strain;
    return shear > 0.0 ? volume / (3.0 * std::sqrt(3.0) * model.parameters().FSLOPE * shear) : 0.0;
  }
};

TEST(Dilatancy, IsThatOfBetaWithoutBounds) {
  Parameters p = straight_rock();
  p.BETA_nonassociativity = 0.5;
  ShearedPoint point(p);
  for (int i = 0; i < 100; ++i) point.ratio_of_step();
  EXPECT_NEAR(point.ratio_of_step(), 0.25, 1e-3);
}

TEST(Dilatancy, FallsTowardsItsLimit) {
  Parameters p = straight_rock();
  p.dilatancy_limit = 0.02;
  ShearedPoint point(p);
  double least = 1.0, most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double before = point.history.plastic_volume_strain;
    const double ratio = point.ratio_of_step();
    if (ratio == 0.0) continue;
    const double evp = 0.5 * (before + point.history.plastic_volume_strain);
    EXPECT_NEAR(ratio, 1.0 - evp / p.dilatancy_limit, 0.02) << "at " << evp;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  EXPECT_GT(most, 0.95);
  EXPECT_LT(least, 0.05);
  EXPECT_LT(point.history.plastic_volume_strain, p.dilatancy_limit * 1.001);
}

TEST(Dilatancy, FallsWithPressure) {
  Parameters p = straight_rock();
  p.dilatancy_pressure = 100e6;
  ShearedPoint point(p);
  int flowing = 0;
  for (int i = 0; i < 400; ++i) {
    const double before = trace(point.stress);
    const double ratio = point.ratio_of_step();
    if (ratio == 0.0) continue;
    ++flowing;
    const double pressure = -(before + trace(point.stress)) / 6.0;
    EXPECT_NEAR(ratio / std::exp(-pressure / p.dilatancy_pressure), 1.0, 0.02);
  }
  EXPECT_GT(flowing, 200);
}

/// Where next to nothing is left of beta rock shears at constant plastic volume.
TEST(Dilatancy, VanishesUnderPressureFarBeyondItsScale) {
  Parameters p = straight_rock();
  p.dilatancy_pressure = 1e5;
  ShearedPoint point(p);
  for (int i = 0; i < 400; ++i) EXPECT_NEAR(point.ratio_of_step(), 0.0, 1e-9);
  EXPECT_GT(point.history.equivalent_plastic_strain, 0.01);
  EXPECT_TRUE(std::isfinite(trace(point.stress)));
}

/// Bounds that are far away change nothing but round-off.
TEST(Dilatancy, IsAsPublishedFarFromItsBounds) {
  Parameters p = Sample<Arenisca>::parameters();
  ShearedPoint published(p);
  p.dilatancy_limit = 1e12;
  p.dilatancy_pressure = 1e24;
  ShearedPoint bounded(p);
  for (int i = 0; i < 300; ++i) {
    published.ratio_of_step();
    bounded.ratio_of_step();
  }
  EXPECT_NEAR(
      bounded.history.plastic_volume_strain / published.history.plastic_volume_strain, 1.0, 1e-9
  );
}

/// On the cap the flow becomes associated again, without a jump where the cap begins.
TEST(Dilatancy, IsWholeAtTheEndOfTheCap) {
  Parameters p{};
  p.BETA_nonassociativity = 1.0;
  p.dilatancy_pressure = 50e6;
  const FlowRule rule = FlowRule::make(p);
  Cap cap;
  cap.present = true;
  cap.X = -1.2e9;
  cap.kappa = -0.6e9;
  EXPECT_NEAR(rule.share(cap.X, 0.0, cap), 1.0, 1e-12);
  EXPECT_NEAR(rule.share(2.0 * cap.X, 0.0, cap), 1.0, 1e-12);
  const double at_branch = std::exp(cap.kappa / 3.0 / p.dilatancy_pressure);
  EXPECT_NEAR(rule.share(cap.kappa, 0.0, cap), at_branch, 1e-12);
  EXPECT_NEAR(rule.share(cap.kappa - 1.0, 0.0, cap), at_branch, 1e-8);
  EXPECT_NEAR(rule.share(0.5 * (cap.kappa + cap.X), 0.0, cap), 0.5, 0.01);
}

FlowRule rule_of_broken_rock(double broken) {
  Parameters p{};
  p.BETA_nonassociativity = 1.0;
  p.dilatancy_limit = 0.05;
  p.broken_dilatancy = broken;
  return FlowRule::make(p);
}

/// Broken rock that is denser than at the start dilates, the less the nearer it is to that volume.
TEST(Dilatancy, EndsAtTheFirstVolumeWhereRockIsBroken) {
  const FlowRule rule = rule_of_broken_rock(0.5);
  const Cap none{};
  const double tension = 1.0;
  const double whole = FlowRule::least;  // what whole rock keeps, wherever it is
  EXPECT_NEAR(rule.share(tension, -0.02, none, 0.0), whole + 0.5 * 0.4, 1e-14);
  EXPECT_NEAR(rule.share(tension, -0.2, none, 0.0), whole + 0.5, 1e-14);
  EXPECT_NEAR(rule.share(tension, 0.0, none, 0.0), whole, 1e-14);
  EXPECT_NEAR(rule.share(tension, 0.03, none, 0.0), whole, 1e-14);
  EXPECT_NEAR(rule.share(tension, -0.02, none, 0.25), 0.25 + 0.75 * 0.2, 1e-14) << "broken in part";
  EXPECT_NEAR(rule.share(tension, -0.02, none, 1.0), 1.0, 1e-14) << "whole";
  const double without = rule_of_broken_rock(0.0).share(tension, -0.02, none, 0.25);
  EXPECT_EQ(without, 0.25) << "it ends with damage";
}

/// ... and the less the nearer the pressure is to that at which the cap begins.
TEST(Dilatancy, EndsAtTheBranchPointWhereRockIsBroken) {
  const FlowRule rule = rule_of_broken_rock(1.0);
  Cap cap;
  cap.present = true;
  cap.X = -3e9;
  cap.kappa = -1.8e9;
  const double whole = FlowRule::least;
  EXPECT_NEAR(rule.share(1e6, -0.2, cap, 0.0), whole + 1.0, 1e-14);
  EXPECT_NEAR(rule.share(0.25 * cap.kappa, -0.2, cap, 0.0), whole + 0.75, 1e-14);
  EXPECT_NEAR(rule.share(0.25 * cap.kappa, -0.02, cap, 0.0), whole + 0.75 * 0.4, 1e-14);
  EXPECT_NEAR(rule.share(cap.kappa, -0.2, cap, 0.0), whole, 1e-14);
  EXPECT_NEAR(rule.share(cap.X, -0.2, cap, 0.0), 1.0, 1e-14) << "compacts as without damage";
  EXPECT_NEAR(rule.share(0.5 * cap.kappa, -0.2, Cap{}, 0.0), whole + 1.0, 1e-14) << "no cap";
}

TEST(Dilatancy, OfBrokenRockNeedsALimit) {
  Parameters p = Sample<Arenisca>::parameters();
  p.broken_dilatancy = 1.0;
  EXPECT_NE(FlowRule::check(p).find("needs a Dilatancy limit"), std::string::npos);
}

}  // namespace
}  // namespace barreno::test
