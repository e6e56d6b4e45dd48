// SPDX-License-Identifier: BSD-3-Clause
/// Rock that loses cohesion and tensile strength and keeps friction (parts/damage.hpp).
#include "arenisca_points.hpp"
#include "sample_models.hpp"
#include "test_piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;
using History = DamagedArenisca::History;

constexpr double root_3 = 1.7320508075688772, tensile_strength = 3e6;

/// The same with moduli that do not depend on the state, so that its elasticity stores what it
/// returns.
Parameters simple_rock() {
  Parameters p = breaking_rock();
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  return p;
}

/// Peak and fracture work of uniaxial tension for pieces of three sizes: the same.
TEST(Damage, FractureWorkDoesNotDependOnTheSize) {
  for (const double length : {0.25e-3, 1e-3, 4e-3}) {
    TestPiece piece(breaking_rock(), length);
    double peak = 0.0;
    const double increment = 0.002 * piece.history.fracture_strain;
    for (int i = 0; i < 700 && piece.history.damage < 1.0; ++i) {
      piece.stretch(increment, 0.0);
      peak = std::max(peak, piece.stress.xx);
      EXPECT_LE(piece.stress.xx, (1.0 - piece.history.damage) * 1.02 * tensile_strength + 0.02e6);
    }
    EXPECT_EQ(piece.history.damage, 1.0);
    EXPECT_NEAR(peak / tensile_strength, 1.0, 0.02) << "length " << length;
    EXPECT_NEAR(length * piece.work / fracture_energy, 1.0, 0.05) << "length " << length;
    piece.stretch(increment, 0.0);
    EXPECT_NEAR(piece.stress.xx, 0.0, 0.02e6);
  }
}

/// A host that knows no size has the card's strain, and so has a card without energy.
TEST(Damage, SizeIsKnownToHostsThatSayIt) {
  const DamagedArenisca model(breaking_rock(), 2120.0);
  EXPECT_EQ(model.initial_history().fracture_strain, 0.03);
  Parameters p = breaking_rock();
  p.fracture_energy = 0.0;
  const TestPiece piece(p, 1e-3);
  EXPECT_EQ(piece.history.fracture_strain, 0.03);
  const TestPiece small(breaking_rock(), 1e-3), large(breaking_rock(), 2e-3);
  EXPECT_NEAR(small.history.fracture_strain / large.history.fracture_strain, 2.0, 1e-12);
  History h = small.history;
  model.vary(h, {1, 1e-9, 1e-6, 2.0});  // a crack as wide as two pieces
  EXPECT_NEAR(h.fracture_strain / large.history.fracture_strain, 1.0, 1e-12);
}

/// Strength of rock without cohesion in triaxial compression, by halving.
double residual_strength(const Parameters& p, double confinement) {
  double low = 0.0, high = 1e10;
  for (int i = 0; i < 80; ++i) {
    const double q = 0.5 * (low + high), y = 3.0 * confinement + root_3 * q;
    const double strength =
        p.STREN * (1.0 - std::exp(-(p.residual_slope - p.YSLOPE) * y / p.STREN)) + p.YSLOPE * y;
    (q < strength ? low : high) = q;
  }
  return confinement + root_3 * low;
}

TEST(Damage, FrictionIsLeft) {
  for (const double confinement : {0.0, 10e6, 50e6}) {
    TestPiece rock(breaking_rock());
    rock.confine(confinement);
    double peak = 0.0;
    for (int i = 0; i < 1000; ++i) {
      rock.stretch(-1e-4, -confinement);
      peak = std::max(peak, -rock.stress.xx);
    }
    EXPECT_EQ(rock.history.damage, 1.0);
    const double left = residual_strength(rock.model.parameters(), confinement);
    EXPECT_NEAR(-rock.stress.xx, left, 0.05 * left + 0.1e6) << "confinement " << confinement;
    EXPECT_GT(peak, 1.2 * left);
    if (confinement == 0.0) {
      EXPECT_NEAR(peak, 78e6, 8e6);
    }
  }
}

/// Crushing under hydrostatic pressure does not damage, nor does shear far above p_D.
TEST(Damage, DoesNotGrowUnderHighPressure) {
  TestPiece rock(breaking_rock());
  for (int i = 0; i < 400; ++i) rock.strain(isotropic(-5e-4));
  EXPECT_LT(rock.history.plastic_volume_strain, -0.1);
  EXPECT_EQ(rock.history.damage, 0.0);
  for (int i = 0; i < 200; ++i) rock.strain({-2e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0});
  EXPECT_GT(rock.history.equivalent_plastic_strain, 0.01);
  EXPECT_LT(rock.history.damage, 1e-3);
}

/// Damage never heals, whatever the path.
TEST(Damage, OnlyGrows) {
  TestPiece rock(breaking_rock());
  double before = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double phase = 0.013 * i, size = 3e-4;
    rock.strain(
        {size * std::cos(phase),
         size * std::sin(1.7 * phase),
         -size * std::cos(0.6 * phase),
         size * std::sin(2.3 * phase),
         0.0,
         0.0}
    );
    ASSERT_GE(rock.history.damage, before);
    ASSERT_LE(rock.history.damage, 1.0);
    before = rock.history.damage;
  }
  EXPECT_EQ(before, 1.0);
}

/// Energy that elastic rock of constant moduli holds [stress].
double stored_in(const TestPiece& rock) {
  const Sym3 s = deviator(rock.stress);
  const double x = trace(rock.stress);
  const Parameters& p = rock.model.parameters();
  return x * x / (18.0 * p.B0) + contract(s, s) / (4.0 * p.G0);
}

/// A closed path of strain takes work: it never gives more than what was stored before.
TEST(Damage, ClosedCyclesCreateNoEnergy) {
  const Sym3 ways[] = {
      {1.0, 0.0, 0.0, 0.0, 0.0, 0.0},
      {1.0, -0.3, -0.3, 0.0, 0.0, 0.0},
      {0.2, 0.1, 0.1, 1.0, 0.0, 0.0},
      {-1.0, 0.4, 0.3, 0.2, 0.0, 0.0}};
  const Sym3 aside{-0.3, 0.2, 0.1, 0.4, -0.2, 0.1};
  for (const double size : {2e-4, 1e-3, 5e-3}) {
    for (const Sym3& way : ways) {
      TestPiece rock(simple_rock());
      for (int cycle = 0; cycle < 6; ++cycle) {
        const double before = rock.work - stored_in(rock);
        for (const double sign : {1.0, -1.0})
          for (const Sym3& along : {way, aside})
            for (int i = 0; i < 50; ++i) rock.strain((sign * size / 50) * along);
        EXPECT_GE(rock.work - stored_in(rock) - before, -1e-6 * (rock.work + 1.0)) << size;
      }
    }
  }
}

/// End of a strain that is taken in so many steps, and the largest stress on the way.
template <class Model>
struct Walk {
  Sym3 stress;
  typename Model::History history;
  double largest = 0.0;
};
template <class Model>
Walk<Model> walk(const Model& model, double confinement, const Sym3& way, int steps) {
  Walk<Model> w{isotropic(-confinement), model.initial_history()};
  for (int i = 0; i < steps; ++i) {
    Increment increment{};
    increment.strain = (1.0 / steps) * way;
    increment.dt = 1e-6;
    EXPECT_FALSE(model.update(increment, w.stress, w.history).failed());
    w.largest = std::max(w.largest, norm(w.stress));
  }
  return w;
}

/// One strain in 1, 10 and 100 steps against 2000. The tolerance bounds the error of a substep.
/// With a hundredth of the default one the ends agree to a hundredth of the largest stress on the
/// way; with the default one to two of it, or as well as those of the law without damage.
TEST(Damage, StepsDoNotChangeTheAnswer) {
  constexpr int many = 2000;
  const Sym3 ways[] = {
      {0.02, 0.0, 0.0, 0.0, 0.0, 0.0},
      {-0.03, 0.012, 0.012, 0.0, 0.0, 0.0},
      {-0.01, 0.002, 0.0, 0.01, 0.0, 0.0}};
  Parameters exact = breaking_rock();
  exact.tolerance = 1e-4;
  const DamagedArenisca rough(breaking_rock(), 2120.0), fine(exact, 2120.0);
  Parameters p = breaking_rock();
  p.fracture_strain = p.fracture_energy = p.residual_slope = p.damage_pressure = 0.0;
  const Arenisca whole(p, 2120.0);
  for (const Sym3& way : ways) {
    for (const double confinement : {0.0, 20e6}) {
      const auto of_whole = walk(whole, confinement, way, many);
      const auto of_fine = walk(fine, confinement, way, many);
      for (const int steps : {1, 10, 100}) {
        const Sym3 near = walk(fine, confinement, way, steps).stress - of_fine.stress;
        EXPECT_LT(norm(near), 0.01 * of_fine.largest) << steps;
        const auto rougher = walk(rough, confinement, way, steps);
        const Sym3 error = walk(whole, confinement, way, steps).stress - of_whole.stress;
        const double allowed = std::max(0.02 * of_fine.largest, norm(error));
        EXPECT_LT(norm(rougher.stress - of_fine.stress), allowed) << steps;
        EXPECT_NEAR(rougher.history.damage, of_fine.history.damage, 0.006);
      }
    }
  }
}

/// Damage that would come at a strain far away changes nothing but round-off.
TEST(Damage, IsAsPublishedFarFromIt) {
  Parameters p = breaking_rock();
  p.fracture_energy = 0.0;
  p.fracture_strain = 1e15;
  TestPiece rock(p);
  const Arenisca published(p, 2120.0);
  Sym3 stress{};
  Arenisca::History history = published.initial_history();
  for (int i = 0; i < 400; ++i) {
    const Sym3 by{-2e-4, 1e-4, 0.5e-4, 0.3e-4, 0.0, 0.0};
    rock.strain(by);
    Increment increment{};
    increment.strain = by;
    increment.dt = 1e-6;
    ASSERT_FALSE(published.update(increment, stress, history).failed());
    ASSERT_LT(norm(rock.stress - stress), 1e-9 * norm(stress) + 1e-3) << "step " << i;
  }
  EXPECT_LT(rock.history.damage, 1e-12);
}

/// Broken rock shears at constant volume where dilatancy is bounded.
TEST(Damage, EndsDilatancy) {
  Parameters p = breaking_rock();
  p.damage_pressure = 0.0;
  TestPiece rock(p);
  rock.confine(10e6);
  for (int i = 0; i < 600; ++i) rock.stretch(-1e-4, -10e6);
  ASSERT_EQ(rock.history.damage, 1.0);
  const History before = rock.history;
  for (int i = 0; i < 200; ++i) rock.stretch(-1e-4, -10e6);
  const double volume = rock.history.plastic_volume_strain - before.plastic_volume_strain;
  const double shear = rock.history.equivalent_plastic_strain - before.equivalent_plastic_strain;
  EXPECT_GT(before.plastic_volume_strain, 0.003);
  EXPECT_LT(std::abs(volume / shear), 2e-3);
}

/// The bits of a point do not depend on the others in its lanes: broken, whole and weak ones.
TEST(Damage, PointsAreTheirOwn) {
  const DamagedArenisca model(breaking_rock(), 2120.0);
  using Points = DamagedArenisca::Points<Lanes>;
  PointOf<DamagedArenisca> points[lane_count];
  for (int i = 0; i < lane_count; ++i) {
    points[i].history = model.initial_history();
    points[i].history.damage = i % 3 == 0 ? 0.0 : (i % 3 == 1 ? 0.4 : 1.0);
    points[i].history.coherence = i % 2 == 0 ? 1.0 : 0.7;
    points[i].increment.strain = {1e-3 * (i + 1), -2e-4, 1e-4 * i, 2e-4, 0.0, 0.0};
    points[i].increment.dt = 1e-6;
  }
  Points groups[1] = {};
  for (int i = 0; i < lane_count; ++i) {
    set_lane(points[i].increment, i, groups[0].increment);
    set_lane(points[i].stress, i, groups[0].stress);
    set_lane(points[i].history, i, groups[0].history);
  }
  const LaneMask flows[1] = {model.start_points(groups[0])};
  model.finish_points(groups, flows, 1);
  for (int i = 0; i < lane_count; ++i) {
    Sym3 stress = points[i].stress;
    History history = points[i].history;
    ASSERT_FALSE(model.update(points[i].increment, stress, history).failed());
    EXPECT_EQ(stress.xx, groups[0].stress.xx[i]);
    EXPECT_EQ(stress.xy, groups[0].stress.xy[i]);
    EXPECT_EQ(history.damage, groups[0].history.damage[i]);
  }
}

/// Damage or a strain that cannot be is refused.
TEST(Damage, ImpossibleStatesAreRefused) {
  const TestPiece rock(breaking_rock());
  const double nan = std::nan("");
  const double damages[] = {-0.1, 1.1, nan, 0.5, 0.5}, strains[] = {0.03, 0.03, 0.03, 0.0, nan};
  for (int kind = 0; kind < 5; ++kind) {
    Sym3 stress{};
    History h = rock.history;
    h.damage = damages[kind];
    h.fracture_strain = strains[kind];
    EXPECT_EQ(rock.step({1e-3, 0.0, 0.0, 0.0, 0.0, 0.0}, stress, h).status, Status::bad_input);
  }
}

/// Wet rock breaks as dry rock does under its effective stress.
TEST(Damage, WetRockBreaksToo) {
  Parameters p = breaking_rock();
  p.fluid_B0 = 2.2e9;
  p.backstress_strain = Parameters::poroplastic;
  const DamagedWetArenisca model(p, 2120.0);
  Sym3 stress{};
  auto history = model.initial_history();
  EXPECT_EQ(history.fracture_strain, p.fracture_strain);
  double peak = 0.0;
  for (int i = 0; i < 2000; ++i) {
    Increment increment{};
    increment.strain = {1e-4, 0.0, 0.0, 0.0, 0.0, 0.0};
    increment.dt = 1e-6;
    ASSERT_FALSE(model.update(increment, stress, history).failed());
    peak = std::max(peak, stress.xx);
  }
  EXPECT_EQ(history.damage, 1.0);
  EXPECT_GT(peak, 2e6);
  EXPECT_LT(norm(stress), 0.05e6);
}

}  // namespace
}  // namespace barreno::test
