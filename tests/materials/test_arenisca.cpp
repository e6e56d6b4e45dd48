// SPDX-License-Identifier: BSD-3-Clause
/// Arenisca, drained: published single-element benchmarks with exact answers, limits, robustness,
/// solvers.
///
/// The benchmark numbers are those of the design's verification reference, section 2: closed forms,
/// or rate integrations that converged to 3e-7.

#include "barreno/models/arenisca.hpp"
#include "materials/scalar_arenisca.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace barreno {
namespace {

using Parameters = Arenisca::Parameters;
using test::ScalarArenisca;

Parameters defaults() {
  Parameters p{};
  const auto table = Arenisca::parameter_table();
  for (const auto& entry : table.numbers) p.*entry.member = entry.default_value;
  for (const auto& entry : table.choices) p.*entry.member = entry.default_index;
  return p;
}

/// Set "A" of the published benchmarks (their unit of stress).
Parameters set_a() {
  Parameters p = defaults();
  p.PEAKI1 = 612.3724356953976;
  p.FSLOPE = 0.057735026919;
  p.p0_crush_curve = -1837.0724;
  p.p1_crush_curve = 1.0 / 1500.0;
  p.p3_crush_curve = 0.5;
  p.B0 = 1e4;
  p.G0 = 1.5e4;
  return p;
}

/// As materials/cards/arenisca_demonstration.xml.
Parameters demonstration() {
  Parameters p = defaults();
  p.PEAKI1 = 21e6;
  p.FSLOPE = 0.435;
  p.STREN = 4e8;
  p.YSLOPE = 0.02;
  p.B0 = 8e9;
  p.B1 = 28e9;
  p.B2 = 4e8;
  p.G0 = 8e9;
  p.p0_crush_curve = -6e8;
  p.p1_crush_curve = 1.5e-9;
  p.p3_crush_curve = 0.22;
  return p;
}

/// Parameters of the published sandstone example: elastic-plastic coupling, stiff in crush.
Parameters published_sandstone() {
  Parameters p = defaults();
  p.PEAKI1 = 20e6;
  p.FSLOPE = 0.435;
  p.B0 = 1.003e9;
  p.B1 = 14.7e9;
  p.B2 = 41e6;
  p.B3 = 1e9;
  p.B4 = 4e-3;
  p.G0 = 1e9;
  p.p0_crush_curve = -30e6;
  p.p1_crush_curve = 5.4e-11;
  p.p3_crush_curve = 0.189;
  return p;
}

Parameters von_mises(double bulk, double shear, double strength) {
  Parameters p = defaults();
  p.STREN = strength;
  p.B0 = bulk;
  p.G0 = shear;
  return p;
}

double shear_size(const Sym3& stress) {
  return std::sqrt(second_invariant(deviator(stress)));
}

/// One point driven along axis-aligned logarithmic strains.
struct Point {
  explicit Point(const Parameters& p) : model(p, 1.0) { EXPECT_EQ(Arenisca::check(p, 1.0), ""); }

  void step(const Sym3& increment) {
    Increment i{};
    i.strain = increment;
    const Outcome outcome = model.update(i, stress, history);
    ASSERT_FALSE(outcome.failed());
    plastic_work += outcome.plastic_work;
    elastic_work += outcome.elastic_work;
    min_plastic_work = std::min(min_plastic_work, outcome.plastic_work);
    strain = strain + increment;
  }
  /// Straight line in logarithmic strain.
  void go_to(const Sym3& target, int steps) {
    const Sym3 increment = (1.0 / steps) * (target - strain);
    for (int i = 0; i < steps; ++i) step(increment);
  }
  /// Uniaxial strain, the stretch F linear in time from 1.
  void stretch_to(double F, double F_end, double steps_per_unit) {
    const int steps = static_cast<int>(std::lround(steps_per_unit));
    for (int i = 1; i <= steps; ++i) {
      const double now = std::log(F + (F_end - F) * i / steps);
      step({now - strain.xx, 0, 0, 0, 0, 0});
    }
  }
  void go_hydrostatic(double volume_strain, int steps) {
    go_to(isotropic(volume_strain / 3.0), steps);
  }

  Arenisca model;
  Sym3 stress, strain;
  Arenisca::History history = model.initial_history();
  double plastic_work = 0.0, elastic_work = 0.0, min_plastic_work = 0.0;
};

// Benchmark 02: vertex and half-associated flow, exact at every way point. beta acts squared:
// beta^2 = 1 would give (-417.10, -102.16) at t = 2 and beta^2 = 1/4 (-222.47, -38.76).
TEST(AreniscaBenchmark, vertex_with_beta_squared) {
  Parameters p = defaults();
  p.PEAKI1 = 150.0;
  p.FSLOPE = std::sqrt(2.0) / 6.0;
  p.BETA_nonassociativity = std::sqrt(0.5);
  p.B0 = 1e4;
  p.G0 = 3750.0;
  const double r6 = std::sqrt(6.0);
  struct WayPoint {
    double axial_strain, lateral_strain, axial, lateral;
  };
  const std::vector<WayPoint> path = {
      {-0.009444444444444429, -0.009444444444444429, -850.0 / 3.0, -850.0 / 3.0},
      {-0.026773242158072745,
       0.005886621079036361,
       -50.0 / 3.0 * (9 + 4 * r6),
       50.0 / 3.0 * (2 * r6 - 9)},
      {-0.04410203987170097,
       0.021217686602517126,
       -50.0 / 3.0 * (9 + 4 * r6),
       50.0 / 3.0 * (2 * r6 - 9)},
      {-0.008108843301258597,
       0.00822108831729599,
       50.0 / 3.0 * (2 * r6 - 3),
       -50.0 / 3.0 * (3 + r6)},
      {0.02788435326918387, -0.004775509967925198, 20.639452948436173, -175.31972647421807},
      {0.02517505640595475, 0.005579138463689218, 30 + 20 * r6 / 3, 30 - 10 * r6 / 3},
      {0.022465759542725734, 0.01593378689530386, 50.0, 50.0},
      {0.0017475059877453765,
       0.023792913672793986,
       -50.0 / 3.0 * (3 + 2 * r6),
       50.0 / 3.0 * (r6 - 3)},
      {-0.0189707475672349,
       0.03165204045028404,
       -50.0 / 3.0 * (9 + 4 * r6),
       50.0 / 3.0 * (2 * r6 - 9)}};
  for (const int steps : {1, 50}) {
    Point point(p);
    for (const WayPoint& w : path) {
      point.go_to({w.axial_strain, w.lateral_strain, w.lateral_strain, 0, 0, 0}, steps);
      // The reference's own integrations differ from the closed form by 9e-5 where the strain ends
      // early.
      EXPECT_NEAR(point.stress.xx, w.axial, 1e-6 * 300.0 + 2e-4) << steps;
      EXPECT_NEAR(point.stress.yy, w.lateral, 1e-6 * 300.0 + 2e-4) << steps;
    }
  }
}

// Benchmark 03: von Mises through linear Drucker-Prager with a far vertex, load and unload.
TEST(AreniscaBenchmark, von_mises_by_a_far_vertex) {
  Parameters p = defaults();
  p.FSLOPE = 1e-10;
  p.PEAKI1 = 25.0 * std::sqrt(2.0) / 1e-10;
  p.B0 = 1e4;
  p.G0 = 3750.0;
  Point point(p);
  point.stretch_to(1.0, 0.97, 1);
  EXPECT_NEAR(point.stress.xx, -345.416903893472, 1e-6 * 345.0);
  EXPECT_NEAR(point.stress.yy, -284.17966032389256, 1e-6 * 345.0);
  point.stretch_to(0.97, 1.0, 1);
  EXPECT_NEAR(point.stress.xx, 40.8248290463863, 1e-6 * 345.0);
  EXPECT_NEAR(point.stress.yy, -20.41241452319315, 1e-6 * 345.0);
}

// The same answer from the von Mises surface itself, which has no vertex.
TEST(AreniscaBenchmark, von_mises_without_a_vertex) {
  Point point(von_mises(1e4, 3750.0, 25.0 * std::sqrt(2.0)));
  point.stretch_to(1.0, 0.97, 7);
  EXPECT_NEAR(point.stress.xx, -345.416903893472, 1e-9 * 345.0);
  point.stretch_to(0.97, 1.0, 7);
  EXPECT_NEAR(point.stress.xx, 40.8248290463863, 1e-9 * 345.0);
  EXPECT_NEAR(point.history.plastic_volume_strain, 0.0, 1e-15);
  point.go_hydrostatic(0.3, 1);
  EXPECT_NEAR(trace(point.stress), 3.0 * 1e4 * 0.3, 1e-6);
}

// Benchmark 11: cyclic uniaxial strain of a von Mises solid, closed form, one step per leg.
TEST(AreniscaBenchmark, von_mises_cyclic) {
  Point point(von_mises(79e9, 70e9, 165e6));
  const std::vector<std::vector<double>> legs = {
      {0.0020413430408304707, 351791450.7031178, 66003424.986851886},
      {0.006123855860287559, 674310201.7952937, 388521818.5464289},
      {0.0020411713915688178, -29272421.64723614, 256515020.72452295},
      {-0.0020413431238572345, -351791695.617298, -66003312.36843328},
      {0.0, -230.6059012413025, 115.30295062065125}};
  for (const auto& leg : legs) {
    point.go_to({leg[0], 0, 0, 0, 0, 0}, 1);
    EXPECT_NEAR(point.stress.xx, leg[1], 1e-9 * 674e6);
    EXPECT_NEAR(point.stress.yy, leg[2], 1e-9 * 674e6);
  }
}

struct CapRow {
  double axial, lateral, evp;
};

void expect_uniaxial_compaction(
    const Parameters& p, double F_end, const std::vector<CapRow>& rows, double tolerance
) {
  Point point(p);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double share = 1.0 / static_cast<double>(rows.size());
    const double from = 1.0 + (F_end - 1.0) * share * static_cast<double>(i);
    const double to = 1.0 + (F_end - 1.0) * share * static_cast<double>(i + 1);
    point.stretch_to(from, to, 100);
    EXPECT_NEAR(point.stress.xx, rows[i].axial, tolerance * 644.0) << i;
    EXPECT_NEAR(point.stress.yy, rows[i].lateral, tolerance * 644.0) << i;
    EXPECT_NEAR(point.history.plastic_volume_strain, rows[i].evp, tolerance * 0.033) << i;
  }
  EXPECT_GE(point.min_plastic_work, 0.0);
}

// Benchmark 04: curved cap, 1000 steps, at a tolerance that keeps every step second order; the
// published bound is 1e-3.
TEST(AreniscaBenchmark, curved_cap) {
  Parameters p = set_a();
  p.tolerance = 1e-5;
  expect_uniaxial_compaction(
      p,
      0.94,
      {{-120.98292904889311, -39.70616047867449, 0.0006617693413115897},
       {-206.4583489365249, -103.81272539439024, 0.0017302120899074375},
       {-292.4330811609338, -168.30893120095908, 0.002804394151096465},
       {-375.7054641305132, -233.0210860756795, 0.0037655620003503656},
       {-452.08429870788683, -297.4208986155923, 0.004438329046593016},
       {-518.5522719157759, -360.44848628427087, 0.0046509904445515948},
       {-571.8892116416432, -420.0415488702879, 0.004158242634796474},
       {-609.5647198177999, -472.69788803329914, 0.0026417723387072403},
       {-631.8563453890439, -513.9271259359384, -0.00018902335489577062},
       {-643.5558511147822, -541.238982675429, -0.004340943169233872}},
      2e-5
  );
}

// Benchmark 06: the cap as it hardens.
TEST(AreniscaBenchmark, cap_evolution) {
  Parameters p = set_a();
  p.G0 = 3750.0;
  p.tolerance = 1e-5;
  expect_uniaxial_compaction(
      p,
      0.91,
      {{-135.6111697822372, -67.80558489111834, 0.0},
       {-264.8667356169626, -147.61901540471024, 0.0005061882532078829},
       {-385.0235684934509, -240.4646156724641, 0.0014938964989462769},
       {-493.6934808549195, -335.43320975631536, 0.0021546789739931987},
       {-576.994360200073, -425.3426356576959, 0.0015453825491083492},
       {-623.7941384383495, -494.01005395812905, -0.0017855683851055065},
       {-644.7675617737568, -534.9812260233816, -0.007914329616364488},
       {-656.758734105129, -558.2665121048203, -0.015613820918777794},
       {-666.8160495814026, -573.3645364237284, -0.024017652545488318},
       {-676.698680682802, -585.0031977377243, -0.032753843599299906}},
      2e-5
  );
}

// Benchmark 05: a cap that does not move (the published p1 = -1e99 is refused; a stiff positive one
// serves).
TEST(AreniscaBenchmark, fixed_cap) {
  Parameters p = set_a();
  p.G0 = 3750.0;
  p.p1_crush_curve = 1e99;
  Point point(p);
  point.go_hydrostatic(3.0 * std::log(0.93), 10);
  EXPECT_NEAR(trace(point.stress), -1837.0724, 1e-9 * 1837.0);
  EXPECT_NEAR(point.history.plastic_volume_strain, -0.15647633183883944, 1e-10);
}

// Benchmark 07: hydrostatic crush until no pores are left; closed form by the Lambert function.
TEST(AreniscaBenchmark, hydrostatic_crush_to_no_porosity) {
  const double end = 3.0 * std::log(0.5);
  for (const int steps : {4, 100}) {
    Point point(set_a());
    const std::vector<double> exact = {
        -2491.889512821714,
        -4042.8671019749268,
        -16192.669579254765,
        -31787.43471975383,
        -47383.24625039605};
    const std::vector<double> shares = {0.125, 0.25, 0.5, 0.75, 1.0};
    for (std::size_t i = 0; i < shares.size(); ++i) {
      point.go_hydrostatic(end * shares[i], steps);
      EXPECT_NEAR(trace(point.stress), exact[i], 1e-7 * 47383.0) << i;
    }
    EXPECT_DOUBLE_EQ(point.history.plastic_volume_strain, -0.5);
  }
}

// Benchmark 08: hydrostatic load, tension to the vertex (dilation), load, tension. 100 steps a leg.
TEST(AreniscaBenchmark, hydrostatic_load_and_unload) {
  Parameters p = set_a();
  p.B0 = 6000.0;
  p.B1 = 2e4;
  p.B2 = 1500.0;
  p.tolerance = 1e-4;
  const std::vector<std::vector<double>> rows = {
      {-0.07902038674336971, -1867.7402689043493, -0.010118829513200239},
      {-0.15804077348673942, -2112.3958645121443, -0.08384444440766577},
      {-0.23706116023010912, -2402.0969390823957, -0.15693323705999712},
      {-0.31608154697347884, -2756.238499080331, -0.22907806977303746},
      {0.23550562321449714, 612.3724356953974, 0.20148493231865425},
      {0.7870927934024732, 612.3724356953974, 0.7530721025066303},
      {0.058831069729922025, -1480.860299010356, 0.14110108631773202},
      {-0.6694306539426291, -6815.245594983028, -0.4819015559793189},
      {0.058831069729922025, 612.3724356953969, 0.05865452497098326},
      {0.7870927934024732, 612.3724356953974, 0.7869162446475344}};
  Point point(p);
  for (const auto& row : rows) {
    point.go_hydrostatic(row[0], 100);
    EXPECT_NEAR(trace(point.stress), row[1], 5e-4 * 1837.0) << row[0];
    EXPECT_NEAR(point.history.plastic_volume_strain, row[2], 1e-3) << row[0];
  }
}

// Benchmark 12: hydrostatic loops with nonlinear elasticity and elastic-plastic coupling.
TEST(AreniscaBenchmark, nonlinear_elasticity_with_coupling) {
  const std::vector<std::vector<double>> turning_points = {
      {-0.016085945044463403, -280341666.92065483, -0.0025377948789135534},
      {-0.010033482226194995, -65101057.572343096, -0.002537794878913553},
      {-0.018108871851403856, -338966843.5452451, -0.003127156002201263},
      {-0.017097067428554033, -297547467.1730895, -0.003127156002201263},
      {-0.021655571696654604, -443306255.4965221, -0.004171479822858003},
      {-0.0191213592337538, -338038281.93389606, -0.004171479822858003},
      {-0.025210677474571425, -549172498.8855197, -0.0052250887890922144},
      {-0.022162928373231416, -420807834.83726496, -0.0052250887890922144},
      {-0.029283999733295513, -671509529.2662036, -0.006435141216777605},
      {-0.005008351898271965, -4868171.959366454, -0.006435141216777605}};
  Point point(published_sandstone());
  for (const auto& row : turning_points) {
    point.go_hydrostatic(row[0], 100);
    EXPECT_NEAR(trace(point.stress), row[1], 1e-3 * 671e6) << row[0];
    EXPECT_NEAR(point.history.plastic_volume_strain, row[2], 1e-3 * 0.0064) << row[0];
  }
}

TEST(AreniscaCrushCurve, is_its_own_inverse_and_smooth_at_zero) {
  const arenisca::CrushCurve curve{-6e8, 1.5e-9, 0.22};
  for (const double evp : {-0.2199, -0.1, -1e-3, -1e-9, 0.0, 1e-9, 1e-3, 0.1, 0.8}) {
    EXPECT_NEAR(curve.plastic_strain(curve.strength(evp)), evp, 1e-14 + 1e-12 * std::fabs(evp));
  }
  const double h = 1e-7;
  const double before = (curve.strength(0.0) - curve.strength(-h)) / h;
  const double after = (curve.strength(h) - curve.strength(0.0)) / h;
  EXPECT_NEAR(before, 1.0 / (curve.p1 * curve.p3), 1e-5 * before);
  EXPECT_NEAR(after, before, 1e-5 * before);
  EXPECT_TRUE(curve.has_cap(0.0));
  EXPECT_FALSE(curve.has_cap(-0.22));
  EXPECT_FALSE((arenisca::CrushCurve{0.0, 0.0, 0.0}).has_cap(0.0));
}

arenisca::YieldSurface surface_of(const arenisca::ShearLimit::Parameters& p) {
  return arenisca::make_surface<arenisca::ShearLimit>(p, p.PEAKI1, 0.5);
}

TEST(AreniscaSurface, special_cases_have_their_vertex_and_slope) {
  const auto nonlinear = surface_of({21e6, 0.435, 4e8, 0.02, 0.0});
  EXPECT_NEAR(nonlinear.limit(21e6), 0.0, 1.0);
  EXPECT_NEAR((nonlinear.limit(20.999e6) - nonlinear.limit(21e6)) / 1e3, 0.435, 1e-4);
  EXPECT_NEAR((nonlinear.limit(-2e10) - nonlinear.limit(-1e10)) / 1e10, 0.02, 1e-5);
  const auto zero_vertex = surface_of({0.0, 0.5, 1e8, 0.0, 0.0});
  EXPECT_NEAR(zero_vertex.limit(0.0), 0.0, 1e-6);
  EXPECT_NEAR(zero_vertex.limit(-1e10), 1e8, 1e-6);
  EXPECT_TRUE(std::isinf(surface_of({0.0, 0.0, 1e8, 0.0, 0.0}).vertex));
}

/// Random states on, inside and at the special places of the surface, and increments of random
/// size.
struct Sampler {
  const Arenisca& model;
  std::mt19937_64 random;
  double smallest_power, largest_power;

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  Sym3 direction() {
    std::normal_distribution<double> n;
    Sym3 s{n(random), n(random), n(random), n(random), n(random), n(random)};
    if (random() % 4 == 0) s = {s.xx, s.yy, s.yy, 0.0, 0.0, 0.0};
    s = deviator(s);
    return (1.0 / std::sqrt(second_invariant(s))) * s;
  }
  double plastic_strain() {
    const double p3 = model.rock().crush.p3;
    if (p3 == 0.0) return 0.0;
    switch (random() % 8) {
      case 0:
        return 0.0;
      case 1:
        return -p3;
      case 2:
        return -p3 * (1.0 - std::pow(10.0, -9.0 * unit()));
      case 3:
        return 0.3 * std::pow(unit(), 3.0);
      default:
        return -p3 * unit();
    }
  }
  void draw(Sym3& stress, Arenisca::History& h, Sym3& increment) {
    const arenisca::Rock& rock = model.rock();
    h = {plastic_strain(), 0.0};
    const arenisca::Cap cap = rock.cap_at(h.plastic_volume_strain);
    const double top =
        std::isfinite(rock.surface.vertex) ? rock.surface.vertex : 0.1 * rock.elasticity.B0;
    const double X = cap.present ? cap.X : -rock.elasticity.B0;
    const double places[] = {top, X, X + (top - X) * std::pow(10.0, -12.0 * unit())};
    const auto place = random() % 6;
    const double x = place < 3 ? places[place] : X + (top - X) * unit();
    arenisca::NoCounter none;
    const auto m = rock.surface.at(x, cap, none);
    const double limit = std::max(m.limit, 0.0) * std::sqrt(std::max(m.cap_squared, 0.0));
    const double shares[] = {0.0, unit(), 1.0, 1.0};
    stress = isotropic(x / 3.0) + (limit * shares[random() % 4]) * direction();
    const double volume[] = {2.0 * unit() - 1.0, 0.0};
    const double shear[] = {1.0, 0.0, 1e-9};
    const Sym3 d = shear[random() % 3] * direction() + isotropic(volume[random() % 2] + 1e-12);
    const double power = smallest_power + (largest_power - smallest_power) * unit();
    increment = (std::pow(10.0, power) / norm(d)) * d;
  }
};

/// By how much a state lies outside the surface, relative to the surface's size; I1 is allowed its
/// round-off, which the vertical tip of the cap would turn into its square root.
double excess(const arenisca::Rock& rock, const Sym3& stress, double evp) {
  const arenisca::Cap cap = rock.cap_at(evp);
  const double x = trace(stress);
  const double size = std::max({std::fabs(x), rock.stress_floor, cap.present ? -cap.X : 0.0});
  double outside = std::max(0.0, x - rock.surface.vertex);
  if (cap.present) outside = std::max(outside, cap.X - x);
  const double inner = cap.present && x < cap.kappa ? std::min(x + 1e-9 * size, cap.kappa) : x;
  arenisca::NoCounter none;
  const auto m = rock.surface.at(inner, cap, none);
  const double limit = std::max(m.limit, 0.0) * std::sqrt(std::max(m.cap_squared, 0.0));
  return std::max(outside, shear_size(stress) - limit) / size;
}

std::vector<Parameters> sets_of_all_kinds() {
  std::vector<Parameters> sets(12, demonstration());
  sets[1] = set_a();
  sets[2].PEAKI1 = sets[2].STREN = sets[2].YSLOPE = 0.0;   // no strength at zero pressure
  sets[3].PEAKI1 = sets[3].YSLOPE = 0.0;                   // zero vertex to von Mises
  sets[4].p3_crush_curve = 0.0;                            // no porosity
  sets[5].PEAKI1 = sets[5].FSLOPE = sets[5].YSLOPE = 0.0;  // von Mises with cap
  sets[6].BETA_nonassociativity = 0.5;
  sets[6].CR = 0.0;
  sets[7].G1 = 0.1;
  sets[7].G2 = 0.2;
  sets[7].G0 = arenisca::Elasticity::shear_from_ratio(sets[7].B0, 0.1);
  sets[7].B3 = 4e9;
  sets[7].B4 = 0.01;
  sets[8].dilatancy_limit = 0.05;
  sets[8].dilatancy_pressure = 60e6;
  sets[9].strength_limit = 0.6e9;
  sets[10].STREN = sets[10].YSLOPE = 0.0;  // Lundborg's law
  sets[10].strength_limit = 0.2e9;
  sets[11].grain_stiffening = 5.0;
  sets[11].transition_strain = 0.15;  // within the pressures of these states
  sets[11].transition_start = 0.2e9;
  sets[11].transition_end = 2e9;
  return sets;
}

// 1e5 updates with increments from 1e-6 to 1 in one step: finite, on the surface, dissipating.
TEST(AreniscaFuzz, stays_on_the_surface_and_dissipates) {
  const auto sets = sets_of_all_kinds();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    ASSERT_EQ(Arenisca::check(sets[k], 1.0), "");
    const Arenisca model(sets[k], 1.0);
    Sampler sampler{model, std::mt19937_64(k), -6.0, 0.0};
    double worst = 0.0, least_work = 0.0;
    int failures = 0, plastic = 0;
    for (int i = 0; i < 12500; ++i) {
      Sym3 stress;
      Increment increment{};
      Arenisca::History h;
      sampler.draw(stress, h, increment.strain);
      const Outcome o = model.update(increment, stress, h);
      failures += o.failed();
      plastic += o.plastic_work > 0.0;
      ASSERT_TRUE(is_finite(stress) && std::isfinite(o.plastic_work + o.elastic_work));
      ASSERT_TRUE(std::isfinite(h.plastic_volume_strain + h.equivalent_plastic_strain));
      if (o.failed()) continue;
      worst = std::max(worst, excess(model.rock(), stress, h.plastic_volume_strain));
      const double scale = (norm(stress) + model.rock().stress_floor) * norm(increment.strain);
      least_work = std::min(least_work, o.plastic_work / scale);
    }
    EXPECT_LE(worst, 1e-8) << "set " << k;
    // Strengthless rock (set 2) dissipates 0 to the round-off of its return: -2.0e-9.
    EXPECT_GE(least_work, k == 2 ? -5e-9 : -1e-9) << "set " << k;
    EXPECT_EQ(failures, 0) << "set " << k;
    EXPECT_GT(plastic, 1000) << "set " << k;
  }
}

// The two return solvers on the same substeps.
TEST(AreniscaFuzz, solvers_agree) {
  const auto sets = sets_of_all_kinds();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    Parameters p = sets[k];
    const ScalarArenisca fast(p, 1.0);
    p.return_solver = 1;
    const ScalarArenisca slow(p, 1.0);
    Sampler sampler{fast, std::mt19937_64(100 + k), -6.0, -3.0};
    arenisca::EvaluationCounter fast_count, slow_count;
    double worst = 0.0;
    int other_substeps = 0;
    for (int i = 0; i < 500; ++i) {
      Sym3 a, b;
      Increment increment{};
      Arenisca::History ha, hb;
      sampler.draw(a, ha, increment.strain);
      b = a;
      hb = ha;
      const double trial =
          norm(a) + 3.0 * fast.rock().elasticity.published_bound().bulk * norm(increment.strain);
      const Outcome oa = fast.update_counted(increment, a, ha, fast_count);
      const Outcome ob = slow.update_counted(increment, b, hb, slow_count);
      ASSERT_FALSE(oa.failed() || ob.failed());
      other_substeps += oa.substeps != ob.substeps;
      worst = std::max(worst, norm(a - b) / std::max(trial, fast.rock().stress_floor));
    }
    EXPECT_LE(worst, 1e-9) << "set " << k;
    EXPECT_EQ(other_substeps, 0) << "set " << k;
    if (fast.rock().crush.p3 > 0.0) {
      EXPECT_GT(slow_count.evaluations, 30 * fast_count.evaluations) << "set " << k;
    }
  }
}

// Non-hardening return: no point of the surface, taken densely, is closer to the trial point. This
// uses the surface's value only, no slope.
TEST(AreniscaReturn, is_the_closest_point) {
  const Arenisca model(demonstration(), 1.0);
  const arenisca::Rock& rock = model.rock();
  const arenisca::Cap cap = rock.cap_at(-0.02);
  arenisca::NoCounter none;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const arenisca::Trial trial{
        -1.5e9 + 2e9 * unit(random), 5e8 * unit(random), 20.0, 5e10, -0.02, cap};
    if (rock.surface.contains(trial.x, trial.q * trial.q, cap, none)) continue;
    const auto r = arenisca::return_without_hardening(rock.surface, trial, cap, none);
    const auto distance = [&](double x, double q) {
      return (x - trial.x) * (x - trial.x) + trial.metric * (q - trial.q) * (q - trial.q);
    };
    double nearest = 1e300;
    for (int j = 0; j <= 20000; ++j) {
      const double x = cap.X + (rock.surface.vertex - cap.X) * j / 20000.0;
      const auto m = rock.surface.at(x, cap, none);
      const double limit = std::max(m.limit, 0.0) * std::sqrt(std::max(m.cap_squared, 0.0));
      nearest = std::min(nearest, distance(x, std::min(limit, trial.q)));
    }
    EXPECT_LE(distance(r.x, r.q), nearest * (1.0 + 1e-9)) << trial.x << " " << trial.q;
  }
}

/// Shear that turns while the cap hardens, from a confined state on the cap; the state is prepared
/// with small errors, so that only the path itself is measured.
Sym3 turning_path(int steps, double tolerance, double* error_of_work) {
  Parameters p = demonstration();
  p.tolerance = 1e-8;
  Point prepared(p);
  prepared.go_hydrostatic(-0.02, 20);
  prepared.go_to({-0.03, 0.01, 0.0, 0.0, 0.0, 0.0}, 200);
  p.tolerance = tolerance;
  Point point(p);
  point.stress = prepared.stress;
  point.history = prepared.history;
  const Sym3 target{0.002, -0.008, 0.004, 0.006, 0.0, 0.0};
  double host_work = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Sym3 before = point.stress, increment = (1.0 / steps) * target;
    point.step(increment);
    host_work += 0.5 * contract(before + point.stress, increment);
  }
  *error_of_work = point.plastic_work + point.elastic_work - host_work;
  return point.stress;
}

// One big step against many small ones: second order in the number of steps. The tolerance falls
// with the local error, so that every step is one substep with its second pass.
TEST(AreniscaAccuracy, second_order_in_the_step) {
  double work = 0.0;
  const Sym3 exact = turning_path(20000, 1e-9, &work);
  double previous = 0.0;
  for (const int steps : {20, 40, 80, 160, 320}) {
    const double tolerance = 0.02 * std::pow(20.0 / steps, 2.0);
    const double error = norm(turning_path(steps, tolerance, &work) - exact) / norm(exact);
    if (previous > 0.0) {
      EXPECT_GT(previous / error, 3.0) << steps << " " << error;
    }
    previous = error;
  }
  EXPECT_LT(previous, 1e-5);
}

// The tolerance controls the error of one big step against many small ones.
TEST(AreniscaAccuracy, tolerance_controls_the_error) {
  double work = 0.0;
  const Sym3 exact = turning_path(5120, 1e-6, &work);
  double previous = 1.0;
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const double error = norm(turning_path(1, tolerance, &work) - exact) / norm(exact);
    EXPECT_LT(error, 2.0 * tolerance) << tolerance;
    EXPECT_LE(error, previous) << tolerance;
    previous = error;
  }
}

// Elastic and plastic work are measured each by itself; together they are the work done on the
// point.
TEST(AreniscaAccuracy, works_add_up) {
  double work = 0.0;
  turning_path(2000, 1e-2, &work);
  Point point(demonstration());
  point.go_hydrostatic(-0.02, 20);
  EXPECT_LT(std::fabs(work), 1e-3 * point.elastic_work);
}

TEST(AreniscaFailure, keeps_the_old_state) {
  const Arenisca model(demonstration(), 1.0);
  const double nan = std::nan(""), huge = 1e200;
  for (const Sym3& strain :
       {Sym3{nan, 0, 0, 0, 0, 0}, Sym3{huge, 0, 0, 0, 0, 0}, Sym3{0, 0, 0, 20, 0, 0}}) {
    Sym3 stress{-1e6, -2e6, -3e6, 4e5, 5e5, 6e5};
    Arenisca::History h{-0.01, 0.02};
    Increment increment{};
    increment.strain = strain;
    EXPECT_EQ(model.update(increment, stress, h).status, Status::bad_input);
    EXPECT_EQ(stress.xx, -1e6);
    EXPECT_EQ(stress.zx, 6e5);
    EXPECT_EQ(h.plastic_volume_strain, -0.01);
  }
  Sym3 stress{nan, 0, 0, 0, 0, 0};
  Arenisca::History h;
  EXPECT_EQ(model.update(Increment{}, stress, h).status, Status::bad_input);
}

// Steps of up to 100 %: done with a bounded number of substeps.
TEST(AreniscaFailure, survives_steps_of_a_hundred_percent) {
  for (const Sym3& strain :
       {isotropic(-0.33),
        isotropic(0.33),
        Sym3{1, -0.5, -0.5, 0, 0, 0},
        Sym3{-1, 0, 0, 0.5, 0.5, 0.5}}) {
    const Arenisca model(demonstration(), 1.0);
    Sym3 stress;
    Arenisca::History h;
    Increment increment{};
    increment.strain = strain;
    const Outcome outcome = model.update(increment, stress, h);
    EXPECT_FALSE(outcome.failed());
    EXPECT_LE(outcome.substeps, 1000);
    EXPECT_TRUE(is_finite(stress));
  }
}

TEST(AreniscaStart, confinement_is_elastic_below_the_crush_pressure) {
  const Arenisca model(demonstration(), 1.0);
  const auto start = model.initial_state(68.95e6);
  EXPECT_TRUE(start.possible);
  EXPECT_DOUBLE_EQ(start.stress.xx, -68.95e6);
  // Stored energy against the closed form of constant modulus: between those of the two end moduli.
  const double p = 68.95e6;
  EXPECT_LT(start.stored_energy, 0.5 * p * p / 8e9);
  EXPECT_GT(start.stored_energy, 0.5 * p * p / model.rock().elasticity.moduli_at(-3 * p, 0.0).bulk);
  EXPECT_FALSE(model.initial_state(201e6).possible);
  EXPECT_FALSE(model.initial_state(-1.0).possible);
}

TEST(AreniscaModuli, bound_every_state) {
  for (const Parameters& p : sets_of_all_kinds()) {
    const Arenisca model(p, 1.0);
    const double p3 = p.p3_crush_curve;
    for (const double x : {1e6, -1.0, -1e6, -1e8, -1e10, -1e14}) {
      for (const double evp : {-p3, -0.5 * p3, 0.0, 0.1}) {
        const double modulus = model.longitudinal_modulus(isotropic(x / 3.0), {evp, 0.0}, 1.0);
        EXPECT_LE(modulus, model.longitudinal_modulus() * (1.0 + 1e-12));
        EXPECT_GT(modulus, 0.0);
      }
    }
  }
}

struct Refusal {
  double Parameters::*member;
  double value;
  const char* name;
};

TEST(AreniscaCheck, refuses_by_name) {
  const double nan = std::nan("");
  const std::vector<Refusal> refusals = {
      {&Parameters::YSLOPE, 0.5, "YSLOPE = 0.5"},
      {&Parameters::STREN, 4e5, "STREN = 400000"},
      {&Parameters::STREN, 0.0, "YSLOPE = 0.02"},
      {&Parameters::strength_limit, 3e8, "Strength limit = 3e+08"},
      {&Parameters::grain_stiffening, -1.0, "Grain stiffening = -1"},
      {&Parameters::transition_strain, 0.1, "Transition strain = 0.1"},
      {&Parameters::transition_start, 1e10, "Transition start = 1e+10"},
      {&Parameters::transition_end, 1e10, "Transition end = 1e+10"},
      {&Parameters::FSLOPE, 0.0, "PEAKI1 = 2.1e+07"},
      {&Parameters::PEAKI1, -1.0, "PEAKI1 = -1"},
      {&Parameters::PEAKI1, nan, "PEAKI1 = nan"},
      {&Parameters::BETA_nonassociativity, 1.1, "BETA_nonassociativity = 1.1"},
      {&Parameters::BETA_nonassociativity, 0.0, "BETA_nonassociativity = 0"},
      {&Parameters::p0_crush_curve, 6e8, "p0_crush_curve = 6e+08"},
      {&Parameters::p1_crush_curve, -1e99, "p1_crush_curve = -1e+99"},
      {&Parameters::p3_crush_curve, -0.1, "p3_crush_curve = -0.1"},
      {&Parameters::CR, 1.0, "CR = 1"},
      {&Parameters::CR, -0.1, "CR = -0.1"},
      {&Parameters::B0, 0.0, "B0 = 0"},
      {&Parameters::B2, 0.0, "B1 = 2.8e+10"},
      {&Parameters::B3, 1e9, "B3 = 1e+09"},
      {&Parameters::G0, -1.0, "G0 = -1"},
      {&Parameters::G1, 0.2, "G1 = 0.2"},
      {&Parameters::G3, 1.0, "G3 = 1"},
      {&Parameters::tolerance, 0.0, "Tolerance = 0"}};
  EXPECT_EQ(Arenisca::check(demonstration(), 2300.0), "");
  for (const Refusal& r : refusals) {
    Parameters p = demonstration();
    p.*r.member = r.value;
    const std::string text = Arenisca::check(p, 2300.0);
    EXPECT_NE(text.find(r.name), std::string::npos) << r.name << ": " << text;
    EXPECT_NE(std::string(".?").find(text.back()), std::string::npos) << text;
  }
}

TEST(AreniscaCheck, refuses_contradictions) {
  Parameters p = demonstration();
  p.FSLOPE = p.STREN = p.PEAKI1 = p.YSLOPE = 0.0;
  EXPECT_NE(Arenisca::check(p, 1.0).find("without any shear strength"), std::string::npos);
  p = demonstration();
  p.B3 = 9e9;
  p.B4 = 1e-3;
  EXPECT_NE(Arenisca::check(p, 1.0).find("negative when the pores are crushed"), std::string::npos);
  p = demonstration();
  p.G1 = 0.25;
  p.G2 = 0.1;
  EXPECT_NE(Arenisca::check(p, 1.0).find("G0 = 8e+09 must equal"), std::string::npos);
  p.G2 = 0.3;
  EXPECT_NE(Arenisca::check(p, 1.0).find("Poisson's ratio of 0.55"), std::string::npos);
}

}  // namespace
}  // namespace barreno
