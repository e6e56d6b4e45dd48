// SPDX-License-Identifier: BSD-3-Clause
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace barreno::test {
namespace {

using arenisca::FluidState;
using arenisca::Lode;
using arenisca::PointRock;
using Parameters = Arenisca::Parameters;

/// Strain paths like those of a penetration: crushing with shear, some of it back.
std::vector<std::vector<Sym3>> random_paths(int count, int steps, double size) {
  std::mt19937_64 engine(4711);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<std::vector<Sym3>> paths(static_cast<std::size_t>(count));
  for (auto& path : paths) {
    for (int i = 0; i < steps; ++i) {
      Sym3 e;
      for (double* c : {&e.xx, &e.yy, &e.zz, &e.xy, &e.yz, &e.zx}) *c = size * normal(engine);
      path.push_back(e - isotropic(0.5 * size));
    }
  }
  return paths;
}

template <class Model>
std::vector<Sym3> stresses(const Model& model, const std::vector<Sym3>& path) {
  Point<Model> point(model);
  std::vector<Sym3> all;
  for (const Sym3& strain : path) {
    EXPECT_FALSE(point.apply(strain, 1e-6).failed());
    all.push_back(point.stress);
  }
  return all;
}

/// Without fluid, rate and angle the two forms are the same equations, integrated differently.
TEST(GeneralArenisca, DryRockIsThatOfTheDrainedForm) {
  Parameters p = dry_rock();
  p.tolerance = 1e-6;
  const Arenisca drained(p, 2300.0);
  const GeneralArenisca general(p, 2300.0);
  double worst = 0.0;
  for (const auto& path : random_paths(20, 10, 3e-3)) {
    worst = std::max(worst, largest_difference(stresses(general, path), stresses(drained, path)));
  }
  RecordProperty("difference", std::to_string(worst));
  EXPECT_LE(worst, 1e-3);
}

TEST(GeneralArenisca, VanishingFluidApproachesDryRockAtFirstOrder) {
  Parameters p = dry_rock();
  p.tolerance = 1e-8;
  const std::vector<Sym3> path(40, isotropic(-2e-3 / 3.0));
  const auto without = stresses(GeneralArenisca(p, 2300.0), path);
  std::vector<double> differences;
  for (const double fluid : {1e6, 1e5, 1e4}) {
    p.fluid_B0 = fluid;
    differences.push_back(largest_difference(stresses(GeneralArenisca(p, 2300.0), path), without));
  }
  EXPECT_NEAR(differences[0] / differences[1], 10.0, 1.0);
  EXPECT_NEAR(differences[1] / differences[2], 10.0, 1.0);
}

/// Fluid as stiff as the grains: the pores are not felt.
TEST(GeneralArenisca, FluidOfTheGrainsMakesGrain) {
  Parameters p = wet_rock();
  p.fluid_B0 = p.B0 + p.B1;
  const GeneralArenisca model(p, 2300.0);
  const PointRock point(model.rock(), 1.0, 1.0);
  for (const double x : {-1e6, -1e8, -1e9}) {
    for (const double e : {0.0, -0.01, -0.05}) {
      EXPECT_NEAR(point.moduli(x, e).bulk / (p.B0 + p.B1), 1.0, 1e-12);
    }
  }
}

/// exp(e) = (1 - phi) exp(-p_c/Km) + mu phi exp(-p_c/Kf), and porosity from the fluid's volume.
TEST(GeneralArenisca, CentrePressureFulfilsTheBalanceOfVolumes) {
  Parameters p = wet_rock();
  p.fluid_pressure_initial = 30e6;
  const auto fluid = GeneralArenisca(p, 2300.0).rock().fluid;
  for (const double mu : {1.0, 0.9, 1.1}) {
    for (double e = -0.2; e < fluid.filling_strain(mu); e += 0.013) {
      const double q = fluid.centre_pressure(e, mu) - 30e6;
      const double solid = (1.0 - fluid.porosity) * std::exp(-q / fluid.matrix);
      const double pore = mu * fluid.porosity * std::exp(-q / fluid.bulk);
      EXPECT_NEAR(std::log(solid + pore), e, 1e-14);
      EXPECT_NEAR(fluid.porosity_at(e, mu, q + 30e6), pore / std::exp(e), 1e-14);
    }
  }
}

/// A wet rock's strength is continuous and falls with dilation, also where the moduli jump.
TEST(GeneralArenisca, StrengthFallsWithDilation) {
  const GeneralArenisca model(wet_rock(), 2300.0);
  const PointRock point(model.rock(), 1.0, 1.0);
  double before = point.strength(-0.2);
  for (double e = -0.2; e < 0.1; e += 1e-4) {
    const double X = point.strength(e);
    EXPECT_GE(X, before);
    EXPECT_NEAR(X / before, 1.0, 0.02);
    before = X;
  }
  EXPECT_NEAR(point.strength(1e-10) / point.strength(0.0), 1.0, 1e-7);
}

/// The cap, the centre's pressure and the threshold of the fluid are continuous where a gap opens.
TEST(GeneralArenisca, CavitationIsContinuous) {
  const GeneralArenisca model(wet_rock(), 2300.0);
  const PointRock point(model.rock(), 1.0, 0.97);
  const double filling = model.rock().fluid.filling_strain(0.97);
  const double step = 1e-9;
  const FluidState full = point.at_centre(filling - step), gap = point.at_centre(filling + step);
  EXPECT_FALSE(full.gap);
  EXPECT_TRUE(gap.gap);
  EXPECT_NEAR(full.pressure, 0.0, 1e2);
  EXPECT_NEAR(full.threshold, 0.0, 1e3);
  EXPECT_NEAR(gap.threshold, 0.0, 1e3);
  EXPECT_NEAR(point.strength(filling - step) / point.strength(filling + step), 1.0, 1e-6);
}

TEST(GeneralArenisca, SkemptonAndGassmannAgree) {
  // Undrained: dp = -B dI1/3, and K_u = Kd/(1 - alpha B).
  const auto fluid = GeneralArenisca(wet_rock(), 2300.0).rock().fluid;
  for (const double drained : {8e9, 12e9, 20e9}) {
    const double alpha = 1.0 - drained / fluid.matrix, b = fluid.skempton(drained, 0.19);
    EXPECT_NEAR(fluid.saturated(drained, 0.19) * (1.0 - alpha * b) / drained, 1.0, 1e-14);
  }
}

TEST(Lode, IsOneInCompressionAndPsiInExtension) {
  for (const int kind : {Lode::gudehus, Lode::willam_warnke, Lode::mohr_coulomb}) {
    for (const double psi : {0.8, 1.2}) {
      const Lode lode{kind, psi};
      EXPECT_NEAR(lode.at(Lode::third_turn).gamma, 1.0, 1e-14);
      EXPECT_NEAR(lode.at(0.0).gamma, psi, 1e-14);
      for (double t = 0.01; t < Lode::third_turn; t += 0.1) {
        constexpr double h = 1e-6;
        const double slope = (lode.at(t + h).gamma - lode.at(t - h).gamma) / (2.0 * h);
        EXPECT_NEAR(lode.at(t).slope, slope, 1e-8);
      }
    }
  }
}

TEST(Lode, TurnedTensorHasTheAngle) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    Sym3 t;
    for (double* c : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.zx}) *c = normal(engine);
    const Sym3 s = deviator(t);
    const double theta = arenisca::lode_angle(s);
    const double to = 0.1 + 0.8 * Lode::third_turn * (i % 10) / 10.0;
    const Sym3 u = arenisca::turned(s, to - theta, 3.0);
    EXPECT_NEAR(arenisca::lode_angle(u), to, 1e-7);
    EXPECT_NEAR(std::sqrt(second_invariant(u)), 3.0, 1e-13);
    EXPECT_NEAR(trace(u), 0.0, 1e-13);
  }
}

/// No point of the surface is closer to the trial than the returned one: against samples of it.
void expect_closest(const GeneralArenisca& model, const Sym3& t) {
  const arenisca::GeneralRock& rock = model.rock();
  const arenisca::GeneralPiecesOf<double> piece(rock, 1.0, 1.0);
  const PointRock& point = piece.points[0];
  const arenisca::Moduli m{8e9, 8e9};
  const double x = 3.0 * m.bulk * trace(t), metric = 9.0 * m.bulk / m.shear;
  const Sym3 s = (2.0 * m.shear) * deviator(t);
  const double q = std::sqrt(second_invariant(s));
  const double gamma = rock.lode.at(arenisca::lode_angle(s)).gamma;
  arenisca::NoCounter none;
  if (arenisca::scaled_surface(point.surface, gamma).contains(x, q * q, {}, none)) return;
  const arenisca::TrialOf<double> trial{x, q, metric, 3.0 * m.bulk, 0.0, {}};
  const auto end = arenisca::return_alone<double>(piece, {s}, trial, true);
  const auto distance = [&](double x1, const Sym3& s1) {
    return (x1 - x) * (x1 - x) + metric * second_invariant(s1 - s);
  };
  const double found = distance(end.point.x, end.shear.tensor);
  const double theta = arenisca::lode_angle(s);
  for (int a = 0; a <= 60; ++a) {
    const double angle = Lode::third_turn * a / 60.0;
    const double strength = rock.lode.at(angle).gamma;
    for (double y = point.surface.vertex; y > x - 3e9; y -= 2e7) {
      const Sym3 on = arenisca::turned(s, angle - theta, strength * point.surface.limit(y));
      EXPECT_GE(distance(y, on), found * (1.0 - 1e-9));
    }
  }
}

TEST(GeneralArenisca, ReturnIsClosestInThreeDimensions) {
  for (const int kind : {Lode::gudehus, Lode::willam_warnke, Lode::mohr_coulomb}) {
    Parameters p = dry_rock();
    p.p3_crush_curve = 0.0;  // no hardening: the surface stands still
    p.J3_type = kind;
    p.J3_psi = 0.8;
    const GeneralArenisca model(p, 2300.0);
    std::mt19937_64 engine(6);
    std::normal_distribution<double> normal(0.0, 1.0);
    for (int i = 0; i < 50; ++i) {
      Sym3 t;
      for (double* c : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.zx}) *c = 0.01 * normal(engine);
      expect_closest(model, t);
    }
  }
}

/// Constant strain rate, elastic range, constant relaxation time: nothing relaxes. Beyond yield of
/// von Mises rock in shear the overstress tends to 2 G D tau.
TEST(GeneralArenisca, OverstressTendsToRateTimesRelaxationTime) {
  Parameters p = dry_rock();
  p.PEAKI1 = p.FSLOPE = p.YSLOPE = 0.0;
  p.STREN = 20e6;
  p.p3_crush_curve = 0.0;
  p.B1 = p.B2 = 0.0;
  p.T1_rate_dependence = 2e-6;
  const GeneralArenisca model(p, 2300.0);
  Point<GeneralArenisca> point(model);
  const double rate = 1e3, dt = 1e-7;
  double time = 0.0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_FALSE(point.apply({0, 0, 0, rate * dt, 0, 0}, dt).failed());
    time += dt;
    const double yield = p.STREN, elastic = 2.0 * p.G0 * rate * time;
    const double over =
        elastic <= yield
            ? 0.0
            : 2.0 * p.G0 * rate * p.T1_rate_dependence *
                  -std::expm1(-(time - yield / (2.0 * p.G0 * rate)) / p.T1_rate_dependence);
    const double expected = std::min(elastic, yield) + over;
    EXPECT_NEAR(point.stress.xy, expected, 1e-3 * yield);
  }
  EXPECT_NEAR(point.stress.xy - p.STREN, 2.0 * p.G0 * rate * p.T1_rate_dependence, 1e-6 * p.STREN);
}

/// The fast and the published solver give one answer on the same substeps.
TEST(GeneralArenisca, SolversAgree) {
  for (const int kind : {Lode::none, Lode::willam_warnke}) {
    Parameters p = wet_rock();
    p.J3_type = kind;
    p.J3_psi = kind == Lode::none ? 1.0 : 0.7;
    const GeneralArenisca fast(p, 2300.0);
    p.return_solver = 1;
    const GeneralArenisca bisection(p, 2300.0);
    // The published one, for each Lode angle anew, is slow.
    for (const auto& path : random_paths(kind == Lode::none ? 10 : 2, 10, 2e-3)) {
      EXPECT_LE(largest_difference(stresses(fast, path), stresses(bisection, path)), 1e-7);
    }
  }
}

}  // namespace
}  // namespace barreno::test
