// SPDX-License-Identifier: BSD-3-Clause
/// Grains that break by plastic work (parts/breakage.hpp), against closed forms.
#include "arenisca_points.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

constexpr double energy = 40e6, strength = 50e6, shear_modulus = 6e9;

/// Rock of constant moduli without damage, of the same shear strength at any pressure.
Parameters von_mises() {
  Parameters p = berea();
  p.PEAKI1 = p.FSLOPE = p.YSLOPE = 0.0;
  p.STREN = strength;
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  p.B0 = 8e9;
  p.G0 = shear_modulus;
  p.p3_crush_curve = 0.0;
  p.breakage_energy = energy;
  return p;
}
/// The same with pores that crush under hydrostatic pressure.
Parameters crushing() {
  Parameters p = berea();
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  p.B0 = 8e9;
  p.breakage_energy = energy;
  return p;
}

template <class Model>
struct Piece {
  Model model;
  Sym3 stress{};
  typename Model::History history;

  explicit Piece(const Parameters& p) : model(p, 2120.0), history(model.initial_history()) {}
  void strain(const Sym3& by, int steps = 1, double volume_ratio = 1.0) {
    Increment increment{};
    increment.strain = (1.0 / steps) * by;
    increment.dt = 1e-6 / steps;
    increment.volume_ratio_begin = increment.volume_ratio_end = volume_ratio;
    for (int i = 0; i < steps; ++i) ASSERT_FALSE(model.update(increment, stress, history).failed());
  }
};

/// Pure shear in the plane of x and y, on the surface from its begin: a work of 2 k eps.
constexpr double shear_strain = 0.2;
constexpr Sym3 sheared{0.0, 0.0, 0.0, shear_strain, 0.0, 0.0};
template <class Model>
void put_on_surface(Piece<Model>& piece, double pressure) {
  piece.stress = isotropic(-pressure);
  piece.stress.xy = strength;
}
double exact_of_shear(double weight) {
  return -std::expm1(-weight * 2.0 * strength * shear_strain / energy);
}

TEST(Breakage, OfShearIsExactInAnyNumberOfSteps) {
  for (const double pressure : {30e6, 100e6, 900e6}) {
    Parameters p = von_mises();
    p.breakage_pressure = 100e6;
    const double square = pressure * pressure;
    const double exact = exact_of_shear(square / (square + 1e16));
    for (const int steps : {1, 10, 100}) {
      Piece<DamagedArenisca> piece(p);
      put_on_surface(piece, pressure);
      piece.strain(sheared, steps);
      EXPECT_NEAR(piece.history.breakage, exact, 1e-12) << pressure << ", " << steps << " steps";
      EXPECT_NEAR(trace(piece.stress), -3.0 * pressure, 1e-6 * pressure);
    }
  }
}

/// Without Breakage pressure all work of shear under pressure breaks grains; none does in tension.
TEST(Breakage, NeedsPressure) {
  for (const double pressure : {-1e6, 0.0, 1.0, 1e6}) {
    Piece<DamagedArenisca> piece(von_mises());
    put_on_surface(piece, pressure);
    piece.strain(sheared, 10);
    EXPECT_NEAR(piece.history.breakage, pressure >= 1.0 ? exact_of_shear(1.0) : 0.0, 1e-12)
        << pressure;
  }
}

/// W = integral of p de over the crush curve, p = -X/3.
double work_of_crushing(const Parameters& p, double e) {
  const double p3 = p.p3_crush_curve, open = 1.0 - e / p3;
  return (-p.p0_crush_curve * e + (p3 * open * std::log(open) + e) / p.p1_crush_curve) / 3.0;
}

TEST(Breakage, OfCrushingFollowsTheCrushCurve) {
  const Parameters p = crushing();
  double before = 1.0;
  for (const int steps : {1, 10, 100, 1000}) {
    Piece<DamagedArenisca> piece(p);
    piece.strain(isotropic(-0.08), steps);
    const double e = -piece.history.plastic_volume_strain;
    ASSERT_GT(e, 0.1);
    const double exact = -std::expm1(-work_of_crushing(p, e) / energy);
    ASSERT_GT(exact, 0.8);
    const double error = std::abs(piece.history.breakage / exact - 1.0);
    EXPECT_LT(error, 0.02) << "the tolerance of the substeps is 0.01; in " << steps << " steps";
    if (steps >= 100) {
      EXPECT_LT(error, 0.1 * before) << "of second order, in " << steps << " steps";
      before = error;
    }
  }
  EXPECT_LT(before, 1e-6);
}

/// Opening pores breaks none, and closing them again does.
TEST(Breakage, NeitherHealsNorGrowsInTension) {
  Piece<DamagedArenisca> piece(crushing());
  piece.strain(isotropic(0.02), 50);
  ASSERT_GT(piece.history.plastic_volume_strain, 0.01);
  EXPECT_EQ(piece.history.breakage, 0.0);
  piece.strain(isotropic(-0.1), 50);
  EXPECT_GT(piece.history.breakage, 0.1);
}

/// Any path: 0 <= B <= 1, B never falls, and the stress does not depend on it.
template <class Model>
void follow_any_path() {
  Parameters with = Sample<Model>::parameters(), without = with;
  with.breakage_energy = 1e5;
  without.breakage_energy = without.breakage_pressure = 0.0;
  Piece<Model> breaking(with), whole(without);
  double before = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double phase = 0.013 * i, size = 3e-4;
    const Sym3 by{
        size * std::cos(phase) - 2e-5,
        size * std::sin(1.7 * phase),
        -size * std::cos(0.6 * phase),
        size * std::sin(2.3 * phase),
        0.0,
        0.0};
    breaking.strain(by);
    whole.strain(by);
    ASSERT_GE(breaking.history.breakage, before);
    ASSERT_LE(breaking.history.breakage, 1.0);
    before = breaking.history.breakage;
    const Sym3 difference = breaking.stress - whole.stress;
    ASSERT_EQ(contract(difference, difference), 0.0) << Model::form << ", step " << i;
    ASSERT_EQ(whole.history.breakage, 0.0);
    ASSERT_EQ(breaking.history.damage, whole.history.damage);
  }
  EXPECT_GT(before, 0.99) << Model::form;
}
TEST(Breakage, ChangesNoStress) {
  follow_any_path<DamagedArenisca>();
  follow_any_path<DamagedWetArenisca>();
  follow_any_path<HeatedArenisca>();
  follow_any_path<HeatedWetArenisca>();
  follow_any_path<RatedHeatedArenisca>();
  follow_any_path<RatedHeatedWetArenisca>();
}

/// The pressure that counts in wet rock is the effective one.
TEST(Breakage, OfWetRockFollowsItsEffectivePressure) {
  Parameters p = von_mises();
  p.p3_crush_curve = 0.2;
  p.p0_crush_curve = -1e12;  // no crushing here
  p.p1_crush_curve = 1e-10;
  p.fluid_B0 = 2e9;
  p.fluid_pressure_initial = 0.0;
  p.matrix_bulk_modulus = 40e9;
  p.breakage_pressure = 100e6;
  ASSERT_EQ(DamagedWetArenisca::check(p, 2120.0), "");
  Piece<DamagedWetArenisca> piece(p);
  const double fluid = 60e6, effective = 80e6;
  piece.history.pore_pressure = fluid;
  put_on_surface(piece, fluid + effective);
  piece.strain(sheared, 10);
  EXPECT_NEAR(piece.history.pore_pressure, fluid, 1.0);
  EXPECT_NEAR(piece.history.breakage, exact_of_shear(0.64 / 1.64), 1e-9);
}

/// It is the work of the quasi-static stress: as in rock without overstress, at any rate.
TEST(Breakage, DoesNotDependOnTheRate) {
  Parameters p = von_mises();
  p.T1_rate_dependence = 2e-5;
  Piece<RatedHeatedArenisca> piece(p);
  put_on_surface(piece, 200e6);
  piece.strain(sheared, 10);
  EXPECT_GT(piece.stress.xy, 1.5 * strength) << "overstress";
  EXPECT_NEAR(piece.history.breakage, exact_of_shear(1.0), 1e-9);
}

/// Works are per volume of the rock at the start.
TEST(Breakage, CountsTheVolumeAtTheStart) {
  Piece<DamagedArenisca> piece(von_mises());
  put_on_surface(piece, 200e6);
  piece.strain(sheared, 4, 0.5);
  EXPECT_NEAR(piece.history.breakage, exact_of_shear(0.5), 1e-12);
}

/// A card with nothing but broken grains has the stress of the card without, and no damage.
TEST(Breakage, AloneIsTheLawOfThePlainForm) {
  Parameters p = berea();
  const Arenisca plain(p, 2120.0);
  p.breakage_energy = energy;
  EXPECT_TRUE(DamagedArenisca::needed(p));
  Piece<DamagedArenisca> piece(p);
  Sym3 stress{};
  Arenisca::History history = plain.initial_history();
  Increment increment{};
  increment.dt = 1e-6;
  for (int i = 0; i < 300; ++i) {
    increment.strain = {-1e-3, 2e-4 * std::sin(0.1 * i), 1e-4, 3e-4, 0.0, 0.0};
    ASSERT_FALSE(plain.update(increment, stress, history).failed());
    piece.strain(increment.strain);
  }
  const Sym3 difference = piece.stress - stress;
  EXPECT_LT(contract(difference, difference), 1e-24 * contract(stress, stress));
  EXPECT_LT(piece.history.damage, 1e-25);
  EXPECT_GT(piece.history.breakage, 0.5);
}

}  // namespace
}  // namespace barreno::test
