// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arenisca_points.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// Rock that breaks, and a round piece of it between the plates of a press.
namespace barreno::test {

constexpr double fracture_energy = 60.0;

/// As materials/cards/berea_sandstone_damage.xml.
inline Arenisca::Parameters breaking_rock() {
  Arenisca::Parameters p = berea();
  p.PEAKI1 = 5.78e6;
  p.FSLOPE = 0.627;
  p.dilatancy_limit = 0.05;
  p.dilatancy_pressure = 60e6;
  p.fracture_energy = fracture_energy;
  p.fracture_strain = 0.03;
  p.residual_slope = 0.396;
  p.damage_pressure = 150e6;
  return p;
}
/// A round piece of rock: axial strain is given, and the stress at its side, along y and z.
struct TestPiece {
  DamagedArenisca model;
  Sym3 stress{};
  DamagedArenisca::History history;
  double work = 0.0;  ///< of the stress per volume at the beginning
  double side = 0.0;  ///< strain of the side in the last step

  explicit TestPiece(const Arenisca::Parameters& p)
      : model(p, 2120.0), history(model.initial_history()) {}
  explicit TestPiece(const Arenisca::Parameters& p, double length) : TestPiece(p) {
    model.vary(history, {1, length * length * length, length * length});
  }
  Outcome step(const Sym3& strain, Sym3& s, DamagedArenisca::History& h) const {
    Increment increment{};
    increment.strain = strain;
    increment.dt = 1e-6;
    return model.update(increment, s, h);
  }
  void strain(const Sym3& by) {
    const Sym3 before = stress;
    ASSERT_FALSE(step(by, stress, history).failed());
    work += 0.5 * contract(before + stress, by);
  }
  double side_stress_after(double axial, double lateral) const {
    Sym3 s = stress;
    DamagedArenisca::History h = history;
    EXPECT_FALSE(step({axial, lateral, lateral, 0.0, 0.0, 0.0}, s, h).failed());
    return s.yy;
  }
  /// The strain of the side is found by halving.
  void stretch(double axial, double side_stress) {
    double reach = 1.5 * std::abs(axial) + 1e-9, low = side - reach, high = side + reach;
    while (side_stress_after(axial, low) > side_stress) low -= reach *= 2.0;
    while (side_stress_after(axial, high) < side_stress) high += reach *= 2.0;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (side_stress_after(axial, middle) < side_stress ? low : high) = middle;
    }
    side = 0.5 * (low + high);
    strain({axial, side, side, 0.0, 0.0, 0.0});
  }
  void confine(double pressure) {
    for (int i = 0; i < 100 && -trace(stress) < 3.0 * pressure; ++i) strain(isotropic(-5e-5));
    stress = isotropic(-pressure);
  }
};

}  // namespace barreno::test
