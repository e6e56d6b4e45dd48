// SPDX-License-Identifier: BSD-3-Clause
/// Biot's linear material against closed forms: Skempton's table, limits, drained paths.

#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

/// K = 8, Ks = 36, G = 6 GPa, phi = 0.19.
PoroelasticParameters berea(double fluid) {
  return {8e9, 6e9, 0.19, fluid, 36e9, 1.0, 0.0};
}

struct Row {
  double fluid, undrained, skempton;
};

/// B = alpha M/Ku and Ku by an undrained hydrostatic path, against nine digits of each and against
/// B = a/(a + phi (1/Kf - 1/Ks)), a = 1/K - 1/Ks.
TEST(Poroelastic, SkemptonsCoefficient) {
  const std::vector<Row> table{
      {0.0, 8.00000000e9, 0.0},
      {1e5, 8.00031839e9, 0.000051167},
      {1e7, 8.03181152e9, 0.005092316},
      {1e9, 1.09319372e10, 0.344827586},
      {1e10, 2.51238861e10, 0.876314472},
      {3.6e10, 3.6e10, 1.0},
      {1e12, 4.46248346e10, 1.055221235},
      {1e15, 4.50506085e10, 1.057399628}};
  for (const Row& row : table) {
    const Poroelastic model(berea(row.fluid), 2300.0);
    Point<Poroelastic> point(model);
    for (int i = 0; i < 10; ++i) ASSERT_FALSE(point.apply(isotropic(-1e-4), 1e-6).failed());
    const double pressure = -trace(point.stress) / 3.0;
    EXPECT_NEAR(point.history.pore_pressure / pressure, row.skempton, 1e-9) << row.fluid;
    EXPECT_NEAR(pressure / 3e-3, row.undrained, 50.0) << row.fluid;
    EXPECT_NEAR(pressure / 3e-3 / model.undrained_bulk_modulus(), 1.0, 1e-13) << row.fluid;
    if (row.fluid == 0.0) continue;
    const double a = 1.0 / 8e9 - 1.0 / 36e9;
    const double b = a / (a + 0.19 * (1.0 / row.fluid - 1.0 / 36e9));
    EXPECT_NEAR(point.history.pore_pressure / pressure / b, 1.0, 1e-13) << row.fluid;
  }
}

/// Kf = Ks: Ku = Ks and B = 1 exactly. No fluid: the drained rock, and nothing to drain.
TEST(Poroelastic, Limits) {
  EXPECT_NEAR(Poroelastic(berea(36e9), 2300.0).undrained_bulk_modulus() / 36e9, 1.0, 1e-15);
  const Poroelastic dry(berea(0.0), 2300.0);
  EXPECT_EQ(dry.undrained_bulk_modulus(), 8e9);
  Point<Poroelastic> point(dry);
  EXPECT_EQ(dry.pore_point(point.stress, point.history).storage, 0.0);
  EXPECT_EQ(dry.drain(1e-6, point.stress, point.history).status, Status::bad_input);
  EXPECT_EQ(norm(point.stress), 0.0);
}

/// Incompressible grains: alpha = 1, 1/M = phi/Kf. The Biot coefficient says the same as the
/// grains.
TEST(Poroelastic, GrainsOrBiotCoefficient) {
  PoroelasticParameters p = berea(2.25e9);
  const PorePoint by_grains = Poroelastic(p, 2300.0).pore_point({}, {});
  EXPECT_NEAR(by_grains.biot, 0.7777777778, 1e-10);
  EXPECT_NEAR(1.0 / by_grains.storage / 9.92343032159e9, 1.0, 1e-11);
  p.biot_coefficient = 1.0 - 8.0 / 36.0;
  p.grain_bulk_modulus = 0.0;
  const PorePoint by_biot = Poroelastic(p, 2300.0).pore_point({}, {});
  EXPECT_NEAR(by_biot.storage / by_grains.storage, 1.0, 1e-14);
  p.biot_coefficient = 1.0;
  const PorePoint rigid = Poroelastic(p, 2300.0).pore_point({}, {});
  EXPECT_EQ(rigid.biot, 1.0);
  EXPECT_NEAR(rigid.storage * 2.25e9 / 0.19, 1.0, 1e-15);
}

/// Undrained strain and then its fluid pressure let out: the stress of dry rock, to round-off; and
/// so is strain with the fluid kept at its pressure all the way.
TEST(Poroelastic, UndrainedThenDrainedIsDrained) {
  const Poroelastic wet(berea(2.25e9), 2300.0);
  const LinearElastic dry({8e9, 6e9}, 2300.0);
  Point<Poroelastic> late(wet), always(wet);
  Point<LinearElastic> drained(dry);
  const Sym3 strain{-3e-4, -1e-4, 2e-4, 1e-4, -2e-4, 3e-4};
  const auto let_out = [&](Point<Poroelastic>& point) {
    const PorePoint at = wet.pore_point(point.stress, point.history);
    ASSERT_FALSE(wet.drain(-at.pressure * at.storage, point.stress, point.history).failed());
  };
  for (int i = 0; i < 10; ++i) {
    ASSERT_FALSE(late.apply(strain, 1e-6).failed());
    ASSERT_FALSE(always.apply(strain, 1e-6).failed());
    ASSERT_FALSE(drained.apply(strain, 1e-6).failed());
    let_out(always);
  }
  let_out(late);
  EXPECT_LE(norm(late.stress - drained.stress), 1e-14 * norm(drained.stress));
  EXPECT_LE(norm(always.stress - drained.stress), 1e-14 * norm(drained.stress));
  EXPECT_LE(std::fabs(late.history.pore_pressure), 1e-8);
  // Fluid out by the pores' change of volume, alpha tr(eps).
  EXPECT_NEAR((late.history.fluid_mass_ratio - 1.0) * 0.19 / (7.0 / 9.0 * -2e-3), 1.0, 1e-12);
}

/// At rest under confinement and a pore pressure of its own; the stored energy is that of bringing
/// both up.
TEST(Poroelastic, InitialState) {
  PoroelasticParameters p = berea(2.25e9);
  p.initial_pressure = 20e6;
  const Poroelastic model(p, 2300.0);
  const auto start = model.initial_state(50e6);
  EXPECT_TRUE(start.possible);
  EXPECT_LE(norm(start.stress + isotropic(50e6)), 1e-6);
  EXPECT_EQ(start.history.pore_pressure, 20e6);
  EXPECT_EQ(start.history.fluid_mass_ratio, 1.0);
  p.initial_pressure = 0.0;
  const Poroelastic empty(p, 2300.0);
  auto from = empty.initial_state(0.0);
  const PorePoint at = empty.pore_point(from.stress, from.history);
  const double strain = -(50e6 - at.biot * 20e6) / 8e9;
  Increment increment{};
  increment.strain = isotropic(strain / 3.0);
  const Outcome squeezed = empty.update(increment, from.stress, from.history);
  const double volume = (20e6 - from.history.pore_pressure) * at.storage;
  const Outcome filled = empty.drain(volume, from.stress, from.history);
  EXPECT_LE(norm(from.stress - start.stress), 1e-12 * norm(start.stress));
  const double work = squeezed.elastic_work + filled.elastic_work;
  EXPECT_NEAR(work / start.stored_energy, 1.0, 1e-12);
}

}  // namespace
}  // namespace barreno::test
