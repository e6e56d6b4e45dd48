// SPDX-License-Identifier: BSD-3-Clause
/// The bound on principal tension (parts/tension.hpp, docs/method.md 22).
#include "arenisca_points.hpp"
#include "sample_models.hpp"
#include "test_piece.hpp"
#include "torn_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;
using History = DamagedArenisca::History;

constexpr double cutoff = 3e6;

/// Rock that breaks (test_piece.hpp), with the bound.
Parameters torn_rock(double bound = cutoff) {
  Parameters p = breaking_rock();
  p.tension_cutoff = bound;
  return p;
}
/// Elastic rock of constant moduli below the bound: its surface is far away.
Parameters brittle_rock() {
  Parameters p = torn_rock();
  p.B1 = p.B2 = p.G1 = p.G2 = 0.0;
  p.PEAKI1 = 6e9;
  p.STREN = p.YSLOPE = 0.0;
  p.p0_crush_curve = p.p1_crush_curve = p.p3_crush_curve = 0.0;
  p.dilatancy_limit = p.dilatancy_pressure = p.fracture_energy = 0.0;
  p.fracture_strain = 0.004;
  return p;
}

struct Drive {
  const char* name;
  Sym3 first, then;  ///< strain of the first half, and of the second
};

/// A point of the model and the law written anew follow the same strains.
void expect_the_same(const std::vector<Sym3>& strains, const char* name, double least_damage) {
  const Parameters p = brittle_rock();
  const DamagedArenisca model(p, 2120.0);
  BrittlePoint anew(p);
  Sym3 stress{};
  History h = model.initial_history();
  double work = 0.0, stress_work = 0.0, peak = p.tension_cutoff;
  for (const Sym3& by : strains) {
    Increment increment{};
    increment.strain = by;
    increment.dt = 1e-6;
    const Sym3 before = stress;
    const Outcome outcome = model.update(increment, stress, h);
    ASSERT_FALSE(outcome.failed()) << name;
    anew.strain(by);
    // The surface of rock that is nearly broken is no longer far away.
    if (anew.damage > 0.9L) break;
    work += outcome.plastic_work + outcome.elastic_work;
    stress_work += 0.5 * contract(before + stress, by);
    peak = std::max(peak, norm(stress));
    ASSERT_LE(norm(stress - anew.tensor()), 1e-9 * p.tension_cutoff + 1e-12 * peak) << name;
    ASSERT_NEAR(h.damage, static_cast<double>(anew.damage), 1e-11) << name;
    ASSERT_NEAR(h.plastic_volume_strain, static_cast<double>(anew.opened), 1e-12) << name;
    ASSERT_NEAR(h.equivalent_plastic_strain, static_cast<double>(anew.sheared), 1e-12) << name;
    ASSERT_NEAR(work, stress_work, 1e-10 * std::abs(stress_work) + 1e-6) << name;
    ASSERT_GE(outcome.plastic_work, 0.0) << name;
  }
  EXPECT_GE(h.damage, least_damage) << name;
}

TEST(Tension, IsTheLawWrittenAnew) {
  const Drive drives[] = {
      {"uniaxial strain", {2e-3, 1e-7, 2e-7, 0.0, 0.0, 0.0}, {-1e-3, 0.0, 0.0, 0.0, 0.0, 0.0}},
      {"plane tension", {1e-3, 1.01e-3, -3e-4, 1e-6, 0.0, 0.0}, {1e-3, 0.0, 0.0, 1e-4, 0.0, 0.0}},
      {"on all sides", {1e-3, 1.1e-3, 0.9e-3, 1e-4, 0.0, 0.0}, {2e-4, 3e-4, 5e-4, 0.0, 1e-4, 0.0}},
      {"beside compression",
       {-4e-3, 1e-3, 0.5e-3, 2e-4, 0.0, 1e-4},
       {-1e-3, 1e-3, 0.6e-3, 3e-4, 5e-4, 0.0}},
      {"shear", {0.0, 0.0, 1e-5, 2e-3, 0.0, 0.0}, {0.0, 0.0, 0.0, -3e-3, 1e-3, 0.0}}};
  for (const Drive& drive : drives) {
    for (const int steps : {1, 13, 200}) {
      std::vector<Sym3> strains;
      for (const Sym3& way : {drive.first, drive.then})
        for (int i = 0; i < steps; ++i) strains.push_back((1.0 / steps) * way);
      expect_the_same(strains, drive.name, 0.1);
    }
  }
}
TEST(Tension, IsTheLawWrittenAnewOnRandomWays) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto draw = [&] {
    return Sym3{
        normal(random),
        normal(random),
        normal(random),
        normal(random),
        normal(random),
        normal(random)};
  };
  for (int way = 0; way < 60; ++way) {
    const double size = std::pow(10.0, -5.0 + 0.025 * way);
    std::vector<Sym3> strains;
    const Sym3 direction = draw();
    strains.reserve(60);
    for (int i = 0; i < 60; ++i)
      strains.push_back(size * (0.3 * (i % 30 < 20 ? 1.0 : -1.0) * direction + draw()));
    expect_the_same(strains, std::to_string(way).c_str(), 0.0);
  }
}

/// Equal principal values have no axes of their own: the answer is that of the invariants.
TEST(Tension, EqualPrincipalStresses) {
  const Parameters p = brittle_rock();
  const DamagedArenisca model(p, 2120.0);
  const double lambda = p.B0 - 2.0 / 3.0 * p.G0;
  for (const Sym3& by :
       {Sym3{1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0},
        Sym3{1e-3, 1e-3, -4e-3, 0.0, 0.0, 0.0},
        Sym3{2e-3, -1e-3, -1e-3, 0.0, 0.0, 0.0},
        Sym3{0.0, 0.0, 0.0, 1e-3, 1e-3, 1e-3},
        Sym3{0.0, 0.0, 0.0, -1e-3, 1e-3, 1e-3}}) {
    Increment increment{};
    increment.strain = by;
    Sym3 stress{};
    History h = model.initial_history();
    ASSERT_FALSE(model.update(increment, stress, h).failed());
    const double bound = (1.0 - h.damage) * cutoff;
    EXPECT_FALSE(exceeds(stress, bound + 1e-9 * cutoff));
    EXPECT_TRUE(exceeds(stress, bound - 1e-9 * cutoff));
    // Opening is the rest of the strain.
    const double x = 3.0 * p.B0 * trace(by) - trace(stress);
    EXPECT_NEAR(h.plastic_volume_strain, x / (3.0 * p.B0), 1e-15);
    EXPECT_GT(h.plastic_volume_strain, 0.0);
    const auto trial = principal_values((2.0 * p.G0) * by + isotropic(lambda * trace(by)));
    EXPECT_LT(principal_values(stress)[2], trial[2] + 1.0);
  }
}

/// A crack in uniaxial tension takes the fracture energy, whatever its size and whatever presses
/// the sides; the bound is the peak.
TEST(Tension, WorkOfACrackIsTheFractureEnergy) {
  constexpr double bound = 2e6;
  for (const double length : {0.25e-3, 1e-3, 4e-3}) {
    for (const double side : {0.0, -20e6}) {
      TestPiece piece(torn_rock(bound), length);
      piece.confine(-side);
      const double increment = 1e-3 * piece.history.fracture_strain;
      while (piece.stress.xx < 0.0) piece.stretch(1e-5, side);
      double peak = 0.0, work = 0.0;
      for (int i = 0; i < 3000 && piece.history.damage < 1.0; ++i) {
        const double before = piece.stress.xx;
        piece.stretch(increment, side);
        work += 0.5 * (before + piece.stress.xx) * increment;
        peak = std::max(peak, piece.stress.xx);
        ASSERT_LE(piece.stress.xx, (1.0 - piece.history.damage) * bound * (1.0 + 1e-9) + 1e-6);
      }
      EXPECT_EQ(piece.history.damage, 1.0);
      EXPECT_NEAR(peak / bound, 1.0, 0.01) << length << " " << side;
      EXPECT_NEAR(length * work / fracture_energy, 1.0, 0.01) << length << " " << side;
      piece.stretch(increment, side);
      EXPECT_LE(piece.stress.xx, 1e-6);
    }
  }
}
/// Mean strength over the damage: of the surface alone, and of the lower of both.
TEST(Tension, FractureStrainKnowsTheBound) {
  const auto strain = [](const Parameters& p) {
    return TestPiece(p, 1e-3).history.fracture_strain;
  };
  const double alone = strain(breaking_rock());
  EXPECT_EQ(strain(torn_rock(1e12)), alone);
  EXPECT_NEAR(
      strain(torn_rock(1e6)), fracture_energy / (1e-3 * 0.5e6), 0.02 * strain(torn_rock(1e6))
  );
  EXPECT_GT(strain(torn_rock(2e6)), alone);
}

/// Squeezed rock bears no more tension than its bound; without, it bears ten times as much.
TEST(Tension, SqueezedRockBearsNoMore) {
  double borne[2];
  for (const bool bounded : {false, true}) {
    TestPiece rock(bounded ? torn_rock() : breaking_rock());
    double& peak = borne[bounded ? 1 : 0];
    peak = 0.0;
    for (int i = 0; i < 400; ++i) {
      rock.strain({-2e-5, 1.2e-5, 0.0, 0.0, 0.0, 0.0});
      peak = std::max(peak, rock.stress.yy);
    }
  }
  EXPECT_GT(borne[0], 4.0 * cutoff);
  EXPECT_LE(borne[1], cutoff * (1.0 + 1e-9));
  EXPECT_GT(borne[1], 0.9 * cutoff);
}

/// Effective stress of the quasi-static answer.
template <class Model>
Sym3 effective(const Sym3& stress, const typename Model::History& h) {
  Sym3 own = stress;
  if constexpr (Model::Law::rated) own = own - arenisca::overstress_of<double>(h);
  if constexpr (Model::Law::wet) own = own + isotropic(h.pore_pressure);
  return own;
}

/// Random ways: the bound holds after every step, and plastic work is not negative.
template <class Model>
void expect_bounded(Parameters p) {
  p.tension_cutoff = cutoff;
  const Model model(p, 2120.0);
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  const auto draw = [&] {
    return Sym3{
        normal(random),
        normal(random),
        normal(random),
        normal(random),
        normal(random),
        normal(random)};
  };
  int at_bound = 0;
  for (int way = 0; way < 80; ++way) {
    Point<Model> point(model);
    point.history.coherence = way % 2 == 0 ? 1.0 : 0.6;
    const Sym3 direction = draw();
    const double size = std::pow(10.0, -5.5 + 0.04 * way), squeeze = way % 3 == 0 ? 0.5 : 0.0;
    for (int i = 0; i < 80; ++i) {
      const double sign = i % 40 < 25 ? 1.0 : -1.0;
      const Sym3 by = size * (sign * direction + 0.3 * draw()) - isotropic(size * squeeze * sign);
      ASSERT_FALSE(point.apply(by, 1e-6).failed());
      const Sym3 own = effective<Model>(point.stress, point.history);
      const double most = static_cast<double>(principal_values(own)[0]);
      // Round-off of the difference that is the quasi-static stress, and of stresses before.
      const double parts = norm(own) + norm(point.stress) + norm(point.stress - own);
      const double bound = (1.0 - point.history.damage) * cutoff * point.history.coherence;
      ASSERT_FALSE(exceeds(own, bound * (1.0 + 1e-9) + 1e-14 * parts + 1e-6));
      if (most > 0.999 * bound && bound > 0.0) ++at_bound;
      if constexpr (!Model::Law::rated) {
        ASSERT_GE(point.last.plastic_work, -1e-12 * norm(point.stress) * norm(by));
      }
    }
  }
  EXPECT_GT(at_bound, 100);
}
TEST(Tension, NoPrincipalStressExceedsTheBound) {
  expect_bounded<DamagedArenisca>(breaking_rock());
  expect_bounded<HeatedArenisca>(Sample<HeatedArenisca>::parameters());
  expect_bounded<RatedHeatedArenisca>(Sample<RatedHeatedArenisca>::parameters());
}
TEST(Tension, NoEffectiveStressOfWetRockExceedsTheBound) {
  expect_bounded<DamagedWetArenisca>(Sample<DamagedWetArenisca>::parameters());
  expect_bounded<HeatedWetArenisca>(Sample<HeatedWetArenisca>::parameters());
  expect_bounded<RatedHeatedWetArenisca>(Sample<RatedHeatedWetArenisca>::parameters());
}

/// Elastic energy of brittle rock.
double stored_in(const TestPiece& rock) {
  const Sym3 s = deviator(rock.stress);
  const double x = trace(rock.stress);
  const Parameters& p = rock.model.parameters();
  return x * x / (18.0 * p.B0) + contract(s, s) / (4.0 * p.G0);
}
/// Work over a path is what is stored and what is dissipated, and closed ways create nothing.
TEST(Tension, ClosedCyclesCreateNoEnergy) {
  const Sym3 ways[] = {
      {1.0, 0.0, 0.0, 0.0, 0.0, 0.0},
      {1.0, -0.5, -0.5, 0.0, 0.0, 0.0},
      {0.2, 0.1, 0.1, 1.0, 0.0, 0.0},
      {-1.0, 0.4, 0.3, 0.2, 0.0, 0.0}};
  const Sym3 aside{-0.3, 0.2, 0.1, 0.4, -0.2, 0.1};
  for (const double size : {2e-4, 1e-3, 5e-3}) {
    for (const Sym3& way : ways) {
      TestPiece rock(brittle_rock());
      for (int cycle = 0; cycle < 6; ++cycle) {
        const double before = rock.work - stored_in(rock);
        for (const double sign : {1.0, -1.0})
          for (const Sym3& along : {way, aside})
            for (int i = 0; i < 50; ++i) rock.strain((sign * size / 50) * along);
        EXPECT_GE(rock.work - stored_in(rock) - before, -1e-9 * (rock.work + 1.0)) << size;
      }
    }
  }
}

/// One strain in several numbers of steps against 20000. Where surface and bound hold together the
/// split of a step between them is of first order: it errs by a part of the elastic stress of one.
TEST(Tension, ConvergesWithTheStep) {
  const Sym3 ways[] = {
      {0.004, 0.0, 0.0, 0.0, 0.0, 0.0},
      {-0.004, 0.002, 0.001, 0.0, 0.0, 0.0},
      {-0.002, 0.0, 0.0, 0.003, 0.001, 0.0}};
  const DamagedArenisca model(torn_rock(), 2120.0);
  const auto walk = [&](const Sym3& way, int steps) {
    Point<DamagedArenisca> point(model);
    for (int i = 0; i < steps; ++i) EXPECT_FALSE(point.apply((1.0 / steps) * way, 1e-6).failed());
    return point;
  };
  const Parameters& p = model.parameters();
  for (const Sym3& way : ways) {
    const auto fine = walk(way, 20000);
    const double elastic = norm((2.0 * p.G0) * deviator(way) + isotropic(p.B0 * trace(way)));
    EXPECT_GT(fine.history.damage, 0.04);
    for (const int steps : {40, 160, 640, 2560}) {
      const auto rough = walk(way, steps);
      EXPECT_LE(norm(rough.stress - fine.stress), 0.4 * elastic / steps) << steps;
      EXPECT_NEAR(rough.history.damage / fine.history.damage, 1.0, 1.0 / steps) << steps;
    }
  }
}

/// Rock whose cracks give back more than they take breaks at once.
TEST(Tension, ShortFractureStrainBreaksAtOnce) {
  Parameters p = brittle_rock();
  p.fracture_strain = 0.5 * cutoff / (p.B0 + 4.0 / 3.0 * p.G0);
  TestPiece rock(p);
  for (int i = 0; i < 300; ++i) {
    rock.strain({1e-6, 0.0, 0.0, 0.0, 0.0, 0.0});
    ASSERT_TRUE(rock.history.damage == 0.0 || rock.history.damage == 1.0) << rock.history.damage;
  }
  EXPECT_EQ(rock.history.damage, 1.0);
  EXPECT_LE(rock.stress.xx, 1e-6);
}

/// A bound far away changes no bit until the rock is broken.
TEST(Tension, FarAwayItChangesNothing) {
  TestPiece with(torn_rock(1e15)), without(breaking_rock());
  int steps = 0;
  for (; without.history.damage < 0.99; ++steps) {
    const double phase = 0.013 * steps, size = 1e-5;
    const Sym3 by{
        size * std::cos(phase),
        size * std::sin(1.7 * phase),
        -size * std::cos(0.6 * phase),
        size * std::sin(2.3 * phase),
        0.2 * size,
        0.0};
    with.strain(by);
    without.strain(by);
    ASSERT_EQ(with.stress.xx, without.stress.xx) << steps;
    ASSERT_EQ(with.stress.xy, without.stress.xy) << steps;
    ASSERT_EQ(with.history.damage, without.history.damage) << steps;
  }
  EXPECT_GT(steps, 500);
}

/// The bits of a point do not depend on the others in its lanes: torn and whole ones, elastic ones
/// and those that flow.
TEST(Tension, PointsAreTheirOwn) {
  const DamagedArenisca model(torn_rock(), 2120.0);
  using Points = DamagedArenisca::Points<Lanes>;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int torn = 0;
  for (int round = 0; round < 300; ++round) {
    PointOf<DamagedArenisca> points[lane_count];
    Points groups[1] = {};
    for (int i = 0; i < lane_count; ++i) {
      PointOf<DamagedArenisca>& p = points[i];
      p.history = model.initial_history();
      p.history.damage = i % 3 == 0 ? 0.0 : (i % 3 == 1 ? 0.4 : 1.0);
      p.history.coherence = i % 2 == 0 ? 1.0 : 0.7;
      const double size = std::pow(10.0, -5.0 + 0.5 * ((i + round) % 6));
      p.increment.strain = {size * normal(random), size * normal(random), size * normal(random)};
      if (i % 2 == 0) p.increment.strain.xy = size * normal(random);
      if ((i + round) % 3 == 0) p.increment.strain.yz = size * normal(random);
      p.increment.dt = 1e-6;
      set_lane(p.increment, i, groups[0].increment);
      set_lane(p.stress, i, groups[0].stress);
      set_lane(p.history, i, groups[0].history);
    }
    const LaneMask flows[1] = {model.start_points(groups[0])};
    model.finish_points(groups, flows, 1);
    for (int i = 0; i < lane_count; ++i) {
      Sym3 stress = points[i].stress;
      History h = points[i].history;
      const Outcome outcome = model.update(points[i].increment, stress, h);
      ASSERT_FALSE(outcome.failed());
      const Sym3& lanes = lane_of<Sym3>(groups[0].stress, i);
      ASSERT_EQ(stress.xx, lanes.xx);
      ASSERT_EQ(stress.yy, lanes.yy);
      ASSERT_EQ(stress.zz, lanes.zz);
      ASSERT_EQ(stress.xy, lanes.xy);
      ASSERT_EQ(stress.yz, lanes.yz);
      ASSERT_EQ(stress.zx, lanes.zx);
      ASSERT_EQ(h.damage, groups[0].history.damage[i]);
      ASSERT_EQ(h.plastic_volume_strain, groups[0].history.plastic_volume_strain[i]);
      ASSERT_EQ(outcome.plastic_work, groups[0].outcome.plastic_work[i]);
      const double bound = (1.0 - h.damage) * cutoff * h.coherence;
      if (principal_values(stress)[0] > 0.999999 * bound) ++torn;
    }
  }
  EXPECT_GT(torn, 100);
}

/// Heat of cracks: all plastic work warms.
TEST(Tension, OpeningHeats) {
  Parameters p = brittle_rock();
  p.specific_heat = 1000.0;
  const HeatedArenisca model(p, 2120.0);
  Point<HeatedArenisca> point(model);
  double work = 0.0;
  for (int i = 0; i < 50; ++i) {
    ASSERT_FALSE(point.apply({1e-5, -2e-5, 0.5e-5, 1e-5, 0.0, 0.0}, 1e-6).failed());
    work += point.last.plastic_work;
  }
  EXPECT_GT(work, 10.0);
  const double warming = point.history.temperature - p.initial_temperature;
  EXPECT_NEAR(warming / (work / (2120.0 * 1000.0)), 1.0, 1e-9);
}

/// Wet rock opens cracks as dry rock does under its effective stress and the strain of its
/// skeleton, and its fluid stays.
TEST(Tension, WetRockFollowsItsEffectiveStress) {
  Parameters p = brittle_rock();
  p.p3_crush_curve = 0.2231;
  p.p0_crush_curve = -1e13;
  p.p1_crush_curve = 1e-13;
  const DamagedArenisca dry(p, 2120.0);
  p.fluid_B0 = 2.2e9;
  p.matrix_bulk_modulus = 37e9;
  p.fluid_pressure_initial = 30e6;
  p.backstress_strain = Parameters::poroplastic;
  const DamagedWetArenisca wet(p, 2120.0);
  const auto at_rest = wet.initial_state(30e6);
  Sym3 stress = at_rest.stress, effective_stress{};
  auto h = at_rest.history;
  History own = dry.initial_history();
  const auto mass = [&](double volume) {
    return volume * (h.porosity - h.gas) * std::exp(h.pore_pressure / p.fluid_B0);
  };
  const double first = mass(1.0);
  double volume = 1.0;
  for (int i = 0; i < 2000; ++i) {
    Increment increment{};
    increment.strain = {-1e-6, 1.5e-6, i > 1000 ? 1e-6 : 0.0, 0.5e-6, 0.0, 0.0};
    increment.dt = 1e-6;
    const double before = h.pore_pressure;
    ASSERT_FALSE(wet.update(increment, stress, h).failed());
    volume *= std::exp(trace(increment.strain));
    ASSERT_NEAR(mass(volume) / first, 1.0, 1e-10);
    const double rise = h.pore_pressure - before;
    increment.strain = increment.strain + isotropic(rise / (3.0 * p.matrix_bulk_modulus));
    ASSERT_FALSE(dry.update(increment, effective_stress, own).failed());
    const Sym3 seen = stress + isotropic(h.pore_pressure);
    ASSERT_LE(norm(seen - effective_stress), 1e-4 * cutoff) << i;
    ASSERT_NEAR(h.damage, own.damage, 1e-4);
  }
  EXPECT_GT(h.damage, 0.1);
  EXPECT_GT(h.pore_pressure, 1e6);
}

/// Fluid that is pressed into rock opens it: the effective stress keeps to the bound.
TEST(Tension, FluidPressedInOpensRock) {
  Parameters p = Sample<DamagedWetArenisca>::parameters();
  p.tension_cutoff = cutoff;
  const DamagedWetArenisca model(p, 2120.0);
  const auto at_rest = model.initial_state(0.0);
  Sym3 stress = at_rest.stress;
  auto h = at_rest.history;
  double most = 0.0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_FALSE(model.drain(2e-5, stress, h).failed());
    const Sym3 own = stress + isotropic(h.pore_pressure);
    most = std::max(most, own.xx);
    ASSERT_LE(own.xx, (1.0 - h.damage) * cutoff * (1.0 + 1e-9) + 1e-14 * norm(stress));
  }
  EXPECT_GT(most, 0.9 * cutoff);
  EXPECT_GT(h.damage, 0.02);
}

/// The bound needs damage.
TEST(Tension, RockWithoutDamageIsRefused) {
  Parameters p = breaking_rock();
  p.fracture_strain = p.fracture_energy = p.residual_slope = p.damage_pressure = 0.0;
  p.tension_cutoff = cutoff;
  EXPECT_NE(
      Arenisca::check(p, 2120.0).find("Tension cutoff = 3e+06 needs a Fracture strain"),
      std::string::npos
  );
  EXPECT_EQ(Arenisca::check(torn_rock(), 2120.0), "");
}

}  // namespace
}  // namespace barreno::test
