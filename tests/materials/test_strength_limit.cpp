// SPDX-License-Identifier: BSD-3-Clause
/// Shear strength that tends to a limit (parts/shear_limit.hpp), against its equation written anew.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// Nonlinear Drucker-Prager without pores, so that nothing but the limit bounds the strength.
Parameters solid_rock() {
  Parameters p = Sample<Arenisca>::parameters();
  p.p3_crush_curve = 0.0;
  p.PEAKI1 = 6e6;
  p.FSLOPE = 0.6;
  p.STREN = 130e6;
  p.YSLOPE = 0.07;
  p.strength_limit = 1e9;
  return p;
}
/// Lundborg's law from the vertex: S = M mu y/(M + mu y).
Parameters linear_rock() {
  Parameters p = solid_rock();
  p.STREN = p.YSLOPE = 0.0;
  return p;
}

/// The law written anew: the part that saturates by itself, and Lundborg's hyperbola for the rest.
double strength(const Parameters& p, double x) {
  const double y = p.PEAKI1 - x;
  if (p.STREN == 0.0) return p.strength_limit * p.FSLOPE * y / (p.strength_limit + p.FSLOPE * y);
  const double own = p.STREN - p.YSLOPE * p.PEAKI1, rest = p.strength_limit - own;
  const double saturating = -own * std::expm1(-(p.FSLOPE - p.YSLOPE) / own * y);
  return saturating + rest * p.YSLOPE * y / (rest + p.YSLOPE * y);
}

TEST(StrengthLimit, IsThatOfTheEquation) {
  for (const Parameters& p : {solid_rock(), linear_rock()}) {
    const auto surface = Arenisca(p, 2300.0).rock().surface;
    EXPECT_EQ(surface.vertex, p.PEAKI1);
    for (double y = 1e4; y < 1e13; y *= 1.7) {
      const double x = p.PEAKI1 - y;
      EXPECT_NEAR(surface.limit(x) / strength(p, x), 1.0, 1e-9) << "at " << x;
      EXPECT_LT(surface.limit(x), p.strength_limit);
    }
    EXPECT_NEAR(surface.limit(-1e15) / p.strength_limit, 1.0, 1e-4);
    EXPECT_NEAR(surface.limit_at(p.PEAKI1).slope, -p.FSLOPE, 1e-12);
    // Trial states far beyond the vertex see no pole: the limit goes on to fall.
    for (double y = 1e4; y < 1e11; y *= 3.0) EXPECT_LT(surface.limit(p.PEAKI1 + y), 0.0);
  }
}

/// Slope and curvature by differences, concave and falling everywhere, and the bound from below.
TEST(StrengthLimit, IsSmoothAndConcave) {
  for (const Parameters& p : {solid_rock(), linear_rock()}) {
    const auto surface = Arenisca(p, 2300.0).rock().surface;
    for (double y = 1e5; y < 1e11; y *= 1.3) {
      const double x = p.PEAKI1 - y, h = 1e-4 * y;
      const auto at = surface.limit_at(x);
      const double below = surface.limit(x - h), above = surface.limit(x + h);
      EXPECT_LT(at.slope, 0.0);
      EXPECT_NEAR((above - below) / (2.0 * h) / at.slope, 1.0, 1e-6) << "at " << x;
      const double curvature = surface.curvature(at.curved);
      EXPECT_LT(curvature, 0.0);
      const double by_slopes =
          (surface.limit_at(x + h).slope - surface.limit_at(x - h).slope) / (2.0 * h);
      EXPECT_NEAR(by_slopes / curvature, 1.0, 1e-5) << "at " << x;
      if (x <= 0.0) {
        EXPECT_LE(surface.lower_bound(x), at.value * (1.0 + 1e-14));
      }
    }
  }
}

/// A stronger piece has its own limit: the vertex moves, the limit stays.
TEST(StrengthLimit, IsTheSameForPiecesOfAnotherCohesion) {
  const Parameters p = solid_rock();
  Parameters strong = p;
  strong.PEAKI1 = 3.0 * p.PEAKI1;
  const auto piece = arenisca::make_surface<arenisca::ShearLimit>(p, 3.0 * p.PEAKI1, p.CR);
  for (double x = 0.0; x > -1e11; x = 2.0 * x - 1e6)
    EXPECT_NEAR(piece.limit(x) / strength(strong, x), 1.0, 1e-12);
}

/// Compressed far and sheared: the stress stays on the surface and below the limit.
TEST(StrengthLimit, BoundsTheStressOfAPath) {
  for (const Parameters& p : {solid_rock(), linear_rock()}) {
    const Arenisca model(p, 2300.0);
    Sym3 stress{};
    Arenisca::History history = model.initial_history();
    double highest = 0.0;
    for (int i = 0; i < 400; ++i) {
      Increment increment{};
      increment.strain = {-4e-3, 1e-3, -1e-3, 5e-4, 0.0, 0.0};
      increment.dt = 1e-6;
      ASSERT_FALSE(model.update(increment, stress, history).failed());
      if (i < 20) continue;
      const double shear = std::sqrt(second_invariant(deviator(stress)));
      EXPECT_NEAR(shear / strength(p, trace(stress)), 1.0, 1e-9);
      highest = std::fmax(highest, shear);
    }
    EXPECT_LT(highest, p.strength_limit);
    EXPECT_GT(highest, 0.7 * p.strength_limit);
  }
}

/// A limit that is far away changes nothing but round-off.
TEST(StrengthLimit, IsAsPublishedFarFromIt) {
  Parameters p = solid_rock();
  p.strength_limit = 1e24;
  Parameters published = p;
  published.strength_limit = 0.0;
  const auto bent = Arenisca(p, 2300.0).rock().surface;
  const auto straight = Arenisca(published, 2300.0).rock().surface;
  for (double x = 0.0; x > -1e11; x = 2.0 * x - 1e6)
    EXPECT_NEAR(bent.limit(x) / straight.limit(x), 1.0, 1e-12);
}

TEST(StrengthLimit, IsRefusedBelowWhatTheRockHasAnyway) {
  const auto fault = [](auto change) {
    Parameters p = solid_rock();
    change(p);
    return Arenisca::check(p, 2300.0);
  };
  EXPECT_EQ(fault([](Parameters&) {}), "");
  EXPECT_NE(
      fault([](Parameters& p) { p.strength_limit = 100e6; }
      ).find("does not exceed STREN = 1.3e+08"),
      std::string::npos
  );
  EXPECT_NE(
      fault([](Parameters& p) { p.YSLOPE = 0.0; }).find("no effect with YSLOPE = 0"),
      std::string::npos
  );
  EXPECT_NE(
      fault([](Parameters& p) {
        p.STREN = p.YSLOPE = 0.0;
        p.strength_limit = 3e6;
      }).find("does not exceed the cohesion FSLOPE*PEAKI1 = 3.6e+06"),
      std::string::npos
  );
}

}  // namespace
}  // namespace barreno::test
