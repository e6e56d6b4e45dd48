// SPDX-License-Identifier: BSD-3-Clause
/// Grains that stiffen under pressure and turn into a denser phase (parts/elasticity.hpp), against
/// exact solutions.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// Rock without pores and without the published rise of K: Murnaghan's solid.
Parameters solid_grains() {
  Parameters p = Sample<Arenisca>::parameters();
  p.p3_crush_curve = p.B1 = p.B2 = p.B3 = p.B4 = 0.0;
  p.B0 = 37e9;
  p.grain_stiffening = 5.0;
  p.tolerance = 1e-6;
  return p;
}
Parameters grains_with_transition() {
  Parameters p = solid_grains();
  p.transition_strain = 0.15;
  p.transition_start = 12e9;
  p.transition_end = 35e9;
  return p;
}

/// Logarithmic volume strain at a pressure: Murnaghan's, and the part of the transition that the
/// pressure has completed, 3 s^2 - 2 s^3.
double exact_strain(const Parameters& p, double pressure) {
  const double own = std::log1p(p.grain_stiffening * pressure / p.B0) / p.grain_stiffening;
  if (p.transition_strain == 0.0) return -own;
  const double way = (pressure - p.transition_start) / (p.transition_end - p.transition_start);
  const double s = std::fmin(std::fmax(way, 0.0), 1.0);
  return -own - p.transition_strain * s * s * (3.0 - 2.0 * s);
}

/// A point under hydrostatic strain.
struct Squeezed {
  Arenisca model;
  Sym3 stress{};
  Arenisca::History history;
  double strain = 0.0;

  explicit Squeezed(const Parameters& p) : model(p, 2650.0), history(model.initial_history()) {}
  void to(double volume_strain, int steps) {
    const double part = (volume_strain - strain) / (3.0 * steps);
    for (int i = 0; i < steps; ++i) {
      Increment increment{};
      increment.strain = isotropic(part);
      increment.dt = 1e-6;
      ASSERT_FALSE(model.update(increment, stress, history).failed());
    }
    strain = volume_strain;
  }
  double pressure() const { return -trace(stress) / 3.0; }
};

TEST(GrainStiffening, IsMurnaghansSolid) {
  const Parameters p = solid_grains();
  Squeezed point(p);
  for (const double pressure : {1e8, 1e9, 5e9, 10e9, 20e9, 40e9}) {
    point.to(exact_strain(p, pressure), 200);
    EXPECT_NEAR(point.pressure() / pressure, 1.0, 1e-5) << pressure;
  }
}

TEST(GrainStiffening, TransitionTakesItsVolume) {
  const Parameters p = grains_with_transition();
  Squeezed point(p);
  for (const double pressure : {10e9, 13e9, 20e9, 30e9, 34e9, 40e9}) {
    point.to(exact_strain(p, pressure), 400);
    EXPECT_NEAR(point.pressure() / pressure, 1.0, 1e-4) << pressure;
  }
}

/// What compression takes, release gives back: no energy comes of a cycle.
TEST(GrainStiffening, CycleIsClosed) {
  const Parameters p = grains_with_transition();
  Squeezed point(p);
  point.to(exact_strain(p, 40e9), 2000);
  point.to(exact_strain(p, 1e6), 2000);
  EXPECT_NEAR(point.pressure(), 1e6, 1e-4 * p.B0);
}

/// The moduli of a state against the equation written anew: pores make the grains count by
/// exp(B2/I1), G is that of K without the grains' change.
TEST(GrainStiffening, ModuliAreThoseOfTheEquation) {
  Parameters p = Sample<Arenisca>::parameters();
  p.G1 = 0.17;
  p.G2 = 0.03;
  p.G0 = arenisca::Elasticity::shear_from_ratio(p.B0, p.G1);
  const auto published = arenisca::Elasticity::make(p);
  p.grain_stiffening = 4.0;
  p.transition_strain = 0.2;
  p.transition_start = 1e9;
  p.transition_end = 5e9;
  ASSERT_EQ(Arenisca::check(p, 2300.0), "");
  const auto stiffening = arenisca::Elasticity::make(p);
  for (const double pressure : {-1e8, 0.0, 1e7, 1e8, 0.9e9, 1.5e9, 4.9e9, 6e9, 40e9}) {
    const double x = -3.0 * pressure;
    for (const double evp : {-0.01, 0.01}) {
      const bool pressed = pressure > 0.0 && evp < 0.0;
      const auto own = published.moduli_at(x, evp), with = stiffening.moduli_at(x, evp);
      const double s = std::fmin(std::fmax((pressure - 1e9) / 4e9, 0.0), 1.0);
      const double compliance = pressed ? 6.0 * 0.2 * s * (1.0 - s) / 4e9 : 0.0;
      const double grains = own.bulk + (pressed ? 4.0 * pressure * std::exp(p.B2 / x) : 0.0);
      EXPECT_NEAR(with.bulk, 1.0 / (1.0 / grains + compliance), 1e-9 * grains) << pressure;
      EXPECT_EQ(with.shear, own.shear) << pressure;
    }
  }
}

TEST(GrainStiffening, IsRefusedWhereItContradicts) {
  const auto fault = [](auto change) {
    Parameters p = grains_with_transition();
    change(p);
    return Arenisca::check(p, 2650.0);
  };
  const auto names = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  EXPECT_EQ(fault([](Parameters&) {}), "");
  EXPECT_TRUE(names(
      fault([](Parameters& p) { p.transition_end = 10e9; }),
      "Transition end = 1e+10 does not exceed Transition start = 1.2e+10"
  ));
  EXPECT_TRUE(names(
      fault([](Parameters& p) { p.transition_start = 0.0; }), "Transition strain = 0.15 needs"
  ));
  EXPECT_TRUE(names(
      fault([](Parameters& p) { p.transition_strain = 0.0; }), "Transition start = 1.2e+10 needs"
  ));
}

}  // namespace
}  // namespace barreno::test
