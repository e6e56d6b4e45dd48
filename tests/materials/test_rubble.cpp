// SPDX-License-Identifier: BSD-3-Clause
// Wet rock that has dilated many times over (docs/method.md 10): little fluid beside much gas.
#include "wet_by_halving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

/// A particle of a run, of the card berea_sandstone_bounded with water: twenty times its first
/// volume.
struct Rubble {
  WetArenisca::History h;
  Sym3 stress, strain;
};
Rubble rubble_of_a_run() {
  Rubble r;
  r.h.plastic_volume_strain = 0x1.81f9359d7338dp+1;
  r.h.equivalent_plastic_strain = 0x1.16173d130b5e3p+4;
  r.h.fluid_mass_ratio = 0x1.f14059c38f18ep-1;
  r.h.porosity = 0x1.ebcaca2a7691ep-1;
  r.h.gas = 0x1.e6dc7454a9bb2p-1;
  r.stress = {
      0x1.514afdac361f5p+20,
      -0x1.2b175cf90e6f3p+18,
      0x1.5e1ce43d01c91p+17,
      0x1.29b206729e653p+21,
      0.0,
      0.0};
  r.strain = {
      0x1.9a3ab449cc8b1p-12,
      -0x1.a02d42d947e09p-13,
      -0x1.d12602136a5bcp-16,
      0x1.be7b203e71f4cp-11,
      0.0,
      0.0};
  return r;
}
Parameters bounded_berea() {
  Parameters p = wet_rock();
  p.fluid_B0 = 2.25e9;
  p.PEAKI1 = 5.78e6;
  p.FSLOPE = 0.627;
  p.STREN = 128.5e6;
  p.YSLOPE = 0.0724;
  p.dilatancy_limit = 0.05;
  p.dilatancy_pressure = 60e6;
  p.CR = 0.593;
  p.B0 = 6.74e9;
  p.B1 = 28.6e9;
  p.B2 = 264e6;
  p.G0 = 5.703e9;
  p.G1 = 0.17;
  p.G2 = 0.03;
  p.p0_crush_curve = -1.2244e9;
  p.p1_crush_curve = 5.95e-10;
  p.p3_crush_curve = 0.2231;
  return p;
}

/// Where gas is left the answer is known: stress, plastic strain and what is dissipated are those
/// of dry rock, no work is more than stress times strain, grains follow the stress and the fluid
/// keeps its volume.
/// @param stress, h  before the step
void expect_dry_step(
    const Parameters& p, const Sym3& strain, const Sym3& stress, const WetArenisca::History& h
) {
  const WetArenisca model(p, 2320.0);
  const Arenisca skeleton(p, 2320.0);
  Increment increment;
  increment.strain = strain;
  Sym3 wet = stress, dry = stress;
  WetArenisca::History after = h;
  Arenisca::History dry_after{h.plastic_volume_strain, h.equivalent_plastic_strain};
  const Outcome outcome = model.update(increment, wet, after);
  const Outcome expected = skeleton.update(increment, dry, dry_after);
  ASSERT_FALSE(expected.failed());
  ASSERT_FALSE(outcome.failed());
  const double size = norm(stress) + norm(dry) + 8e9 * norm(strain);
  EXPECT_LE(norm(wet - dry), 1e-12 * size);
  const double path = norm(strain);
  EXPECT_NEAR(after.plastic_volume_strain, dry_after.plastic_volume_strain, 1e-10 * path + 1e-15);
  EXPECT_NEAR(
      after.equivalent_plastic_strain, dry_after.equivalent_plastic_strain, 1e-10 * path + 1e-14
  );
  EXPECT_NEAR(outcome.plastic_work, expected.plastic_work, 1e-11 * size * path);
  EXPECT_LE(std::fabs(outcome.elastic_work + outcome.plastic_work), size * path);
  EXPECT_EQ(after.pore_pressure, 0.0);
  const double solid = 1.0 - h.porosity, smaller = std::exp(-trace(strain));
  const double matrix = model.rock().constituents.matrix;
  const double load = -trace(dry - stress) / (3.0 * matrix);
  // Of each substep the grains' part is that at its start.
  const double slack = 2.0 * size / matrix * path + 1e-14;
  EXPECT_NEAR(1.0 - after.porosity, solid * std::exp(-load / solid) * smaller, slack);
  EXPECT_NEAR(after.porosity - after.gas, (h.porosity - h.gas) * smaller, 1e-9);
}

TEST(Rubble, OfARunIsDryRock) {
  const Rubble r = rubble_of_a_run();
  expect_dry_step(bounded_berea(), r.strain, r.stress, r.h);
}

/// The same beside it: more and less porosity, water and dilation, other stresses and strains, in
/// both directions.
TEST(Rubble, BesideThatOfARunIsDryRock) {
  Parameters p = bounded_berea();
  const Arenisca skeleton(p, 2320.0);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> symmetric(-1.0, 1.0);
  const auto power = [&](double from, double to) {
    return from * std::pow(to / from, 0.5 + 0.5 * symmetric(random));
  };
  const auto tensor = [&](double size) {
    const auto part = [&] { return size * symmetric(random); };
    return Sym3{part(), part(), part(), part(), part(), part()};
  };
  for (int i = 0; i < 3000; ++i) {
    // Under the pressures of a jet the fluid's modulus changes, which does not matter here.
    p.fluid_stiffening = i % 2 == 0 ? 0.0 : 8.0;
    WetArenisca::History h = rubble_of_a_run().h;
    const double solid = power(0.02, 0.4);
    h.porosity = 1.0 - solid;
    h.gas = h.porosity - solid * power(1e-4, 0.3);
    h.plastic_volume_strain = power(0.05, 4.0);
    // A stress that the rock can bear: that after a step of dry rock.
    Sym3 stress{};
    Arenisca::History dry{h.plastic_volume_strain, 1.0};
    Increment increment;
    increment.strain = tensor(power(1e-5, 1e-3));
    ASSERT_FALSE(skeleton.update(increment, stress, dry).failed());
    const double size = power(1e-7, 1e-2);
    const Sym3 strain = tensor(size) - isotropic(0.5 * size * symmetric(random));
    for (const double way : {1.0, -1.0}) {
      SCOPED_TRACE(i);
      expect_dry_step(p, way * strain, stress, h);
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }
}

/// Water that is pressed out of rubble's gas bears the load as it would in rock: from the state of
/// the run back to full pores, against the dry law with the pressure as an unknown.
TEST(Rubble, FillsWhenItIsPressedToItsOwnVolume) {
  Parameters p = bounded_berea();
  p.tolerance = 1e-4;
  const WetArenisca model(p, 2320.0);
  const Arenisca skeleton(p, 2320.0);
  const Rubble r = rubble_of_a_run();
  Sym3 stress = r.stress, wet = r.stress;
  WetArenisca::History h = r.h, after = r.h;
  // Of grains and water alone, without a stress.
  const double least = 1.0 - r.h.gas;
  constexpr int steps = 4000;
  Increment increment;
  increment.strain = isotropic(std::log(0.98 * least) / (3.0 * steps));
  for (int i = 0; i < steps; ++i) {
    step_by_halving(model, skeleton, increment.strain, stress, h);
    ASSERT_FALSE(model.update(increment, wet, after).failed()) << i;
  }
  EXPECT_GT(h.pore_pressure, 1e6);
  EXPECT_NEAR(after.pore_pressure, h.pore_pressure, 1e-3 * h.pore_pressure);
  EXPECT_LE(norm(wet - stress), 1e-3 * norm(stress));
}

/// The lowest rise of the pressure at which grains and fluid take no more than the volume there is,
/// by halving. What they take is convex in it.
struct LowestRise {
  const arenisca::Constituents& c;
  const arenisca::PoresOf<double>& n;
  const arenisca::GrainsOf<double>& grains;
  double volume_strain;
  bool found = true, clear = true;  ///< clear: round-off does not decide on `found`

  long double excess(long double rise) const {
    return n.solid * std::exp(grains.begin + grains.slope * rise) +
           n.fluid * std::exp(-rise / c.fluid) - std::exp(static_cast<long double>(volume_strain));
  }
  bool falls(long double rise) const {
    return n.solid * grains.slope * std::exp(grains.begin + grains.slope * rise) <
           n.fluid / c.fluid * std::exp(-rise / c.fluid);
  }
  double find() {
    constexpr int halvings = 200;
    constexpr long double unclear = 1e-9L;
    long double low = -n.pressure, high = 100.0 * c.matrix;
    if (excess(low) <= 0.0L) return -n.pressure;
    long double begin = low, lowest = high;
    for (int i = 0; i < halvings; ++i) {
      const long double middle = 0.5L * (begin + lowest);
      (falls(middle) ? begin : lowest) = middle;
    }
    found = excess(lowest) <= 0.0L;
    clear = std::fabs(excess(lowest)) > unclear;
    high = lowest;
    for (int i = 0; i < halvings; ++i) {
      const long double middle = 0.5L * (low + high);
      (excess(middle) > 0.0L ? low : high) = middle;
    }
    return static_cast<double>(high);
  }
};

/// Of any rock, grains stiffer than the volume that they take too.
TEST(Rubble, ThePressureIsTheLowestThatFillsThePores) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto power = [&](double from, double to) {
    return from * std::pow(to / from, unit(random));
  };
  int without = 0, raised = 0, gas = 0;
  for (int i = 0; i < 20000; ++i) {
    Parameters p = wet_rock();
    p.fluid_B0 = power(1e8, 30e9);
    p.matrix_bulk_modulus = 36e9;
    const arenisca::Constituents c = arenisca::Constituents::make(p);
    arenisca::PoresOf<double> n;
    n.solid = power(0.01, 0.99);
    const bool full = unit(random) < 0.5;
    n.fluid = (1.0 - n.solid) * (full ? 1.0 : power(1e-4, 1.0));
    n.pressure = full ? power(1e3, 0.3 * c.fluid) : 0.0;
    const double bulk = power(0.05, 1.0) * c.matrix;
    const double strain = (unit(random) < 0.5 ? -1.0 : 1.0) * power(1e-6, 1.0);
    const auto grains = arenisca::elastic_grains(c, n, bulk, strain);
    const double biot = 1.0 - bulk * c.per_matrix;
    const double guess =
        -biot * strain / arenisca::storage_of(arenisca::compliances_at(c, n, 0.0), n, bulk);
    const auto filled = arenisca::fill_pores(c, n, grains, strain, guess);
    LowestRise lowest{c, n, grains, strain};
    const double rise = lowest.find();
    if (!lowest.clear) continue;
    ASSERT_EQ(filled.unsolved, !lowest.found) << i;
    if (!lowest.found) {
      ++without;
      continue;
    }
    ASSERT_NEAR(filled.rise, rise, 1e-6 * c.fluid) << i;
    rise > 0.0 ? ++raised : ++gas;
  }
  std::printf("%d without a pressure, %d raised, %d others\n", without, raised, gas);
  EXPECT_GT(without, 100);
  EXPECT_GT(raised, 1000);
  EXPECT_GT(gas, 1000);
}

/// A stress of absurd tension comes back to the vertex by the plastic strain that takes it away.
/// Steps that no strain can have made are refused, and leave the point as it was.
template <class Model>
void expect_bounded_end() {
  const Parameters p = Sample<Model>::parameters();
  const Model model(p, 2300.0);
  const double vertex = p.PEAKI1 / 3.0;
  for (const double gain : {1.0, 19.0, 21.0, 2.3e7}) {
    SCOPED_TRACE(gain);
    const Sym3 begin = isotropic(vertex + gain * p.B0);
    Sym3 stress = begin;
    auto h = model.initial_history();
    // Dilated, so that the moduli do not change.
    h.plastic_volume_strain = 1.0;
    const Outcome outcome = model.update(Increment{}, stress, h);
    if (gain > 20.0) {
      EXPECT_EQ(outcome.status, Status::substep_limit);
      EXPECT_EQ(stress.xx, begin.xx);
      EXPECT_EQ(h.plastic_volume_strain, 1.0);
    } else {
      EXPECT_EQ(outcome.status, Status::ok);
      EXPECT_NEAR(stress.xx, vertex, 1e-12 * begin.xx);
      EXPECT_NEAR(h.plastic_volume_strain, 1.0 + gain, 1e-12 * gain);
    }
  }
}
TEST(Rubble, AStepBeyondAnyStrainIsRefused) {
  expect_bounded_end<Arenisca>();
  expect_bounded_end<ScatteredArenisca>();
}

}  // namespace
}  // namespace barreno::test
