// SPDX-License-Identifier: BSD-3-Clause
/// Moduli of dilated rock (parts/elasticity.hpp): those without pressure, as published, or those of
/// its pressure. What the onset of dilation then gives back: verification/cases/closed_cycles.py.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// Rock whose moduli rise with pressure, crushed rock's fall, and which dilates when sheared.
Parameters pressed_rock(int dilated_moduli) {
  Parameters p = Sample<Arenisca>::parameters();
  p.B1 = p.B0;
  p.B2 = 1e6;
  p.G1 = 0.17;
  p.G2 = 0.03;
  p.G0 = arenisca::Elasticity::shear_from_ratio(p.B0, p.G1);
  p.BETA_nonassociativity = 1.0;
  p.dilated_moduli = dilated_moduli;
  return p;
}
constexpr int constant = arenisca::Elasticity::constant;
constexpr int of_pressure = arenisca::Elasticity::of_pressure;

TEST(DilatedModuli, AreThoseOfTheirPressure) {
  const auto published = arenisca::Elasticity::make(pressed_rock(constant));
  const auto pressed = arenisca::Elasticity::make(pressed_rock(of_pressure));
  for (const double x : {-1e7, -1e8, -1e9, -1e10}) {
    const auto virgin = published.moduli_at(x, 0.0);
    for (const double evp : {1e-9, 1e-3, 0.2}) {
      EXPECT_EQ(published.moduli_at(x, evp).bulk, published.B0);
      EXPECT_EQ(published.moduli_at(x, evp).shear, published.moduli_at(0.0, 0.0).shear);
      EXPECT_EQ(pressed.moduli_at(x, evp).bulk, virgin.bulk) << x;
      EXPECT_EQ(pressed.moduli_at(x, evp).shear, virgin.shear) << x;
    }
    for (const double evp : {0.0, -1e-3, -0.1})
      EXPECT_EQ(pressed.moduli_at(x, evp).bulk, published.moduli_at(x, evp).bulk) << x;
  }
  EXPECT_EQ(pressed.moduli_at(1e6, 0.1).bulk, published.B0);
}

/// Rock under a mean pressure, sheared until it dilates.
struct Sheared {
  Arenisca model;
  Sym3 stress{};
  Arenisca::History history;
  double modulus = 0.0, largest_change = 0.0;

  explicit Sheared(int dilated_moduli)
      : model(pressed_rock(dilated_moduli), 2000.0), history(model.initial_history()) {}
  void strain_by(double volume, double shear) {
    Increment increment{};
    increment.strain = isotropic(volume / 3.0);
    increment.strain.xy = shear;
    increment.dt = 1e-6;
    const Outcome outcome = model.update(increment, stress, history);
    ASSERT_FALSE(outcome.failed());
    if (modulus > 0.0)
      largest_change =
          std::fmax(largest_change, std::fabs(outcome.longitudinal_modulus / modulus - 1.0));
    modulus = outcome.longitudinal_modulus;
  }
  /// @return largest relative change of the longitudinal modulus in one step of the shear
  double shear_until_dilated() {
    const double pressure = -model.parameters().p0_crush_curve / 30.0;
    while (trace(stress) > -3.0 * pressure) strain_by(-1e-5, 0.0);
    largest_change = 0.0;
    for (int i = 0; i < 4000 && history.plastic_volume_strain < 1e-4; ++i) strain_by(0.0, 1e-5);
    return largest_change;
  }
};

TEST(DilatedModuli, DoNotJumpWhereRockBeginsToDilate) {
  Sheared published(constant), pressed(of_pressure);
  const double jump = published.shear_until_dilated(), none = pressed.shear_until_dilated();
  ASSERT_GT(published.history.plastic_volume_strain, 0.0);
  ASSERT_GT(pressed.history.plastic_volume_strain, 0.0);
  EXPECT_GT(jump, 0.1);
  EXPECT_LT(none, 0.01);
}

}  // namespace
}  // namespace barreno::test
