// SPDX-License-Identifier: BSD-3-Clause
// Functions of several numbers at once against those of the standard library, and Johnson-Cook
// points in lanes against single points.
#include "materials/sample_models.hpp"

#include <gtest/gtest.h>

#include <array>
#include <barreno/history_values.hpp>
#include <barreno/real.hpp>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace barreno {
namespace {

#if BARRENO_HAS_LANES

/// Largest |f(x) - exact(x)| in units of the last place of the exact value.
template <class F, class Exact>
double largest_error(const std::vector<double>& values, const F& f, const Exact& exact) {
  double worst = 0.0;
  for (std::size_t first = 0; first + lane_count <= values.size(); first += lane_count) {
    Lanes x{};
    for (int i = 0; i < lane_count; ++i) x[i] = values[first + static_cast<std::size_t>(i)];
    const Lanes y = f(x);
    for (int i = 0; i < lane_count; ++i) {
      const double right = exact(x[i]);
      const double unit = std::nextafter(std::fabs(right), HUGE_VAL) - std::fabs(right);
      worst = std::max(worst, std::fabs(y[i] - right) / unit);
    }
  }
  return worst;
}

std::vector<double> draw(double low, double high, bool logarithmic) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> u(
      logarithmic ? std::log(low) : low, logarithmic ? std::log(high) : high
  );
  std::vector<double> out(200000);
  for (double& x : out) x = logarithmic ? std::exp(u(engine)) : u(engine);
  return out;
}

TEST(Real, LogarithmIsExactToAUnit) {
  const auto f = [](const Lanes& x) { return real::log(x); };
  const auto exact = [](double x) { return std::log(x); };
  EXPECT_LT(largest_error(draw(1e-300, 1e300, true), f, exact), 1.5);
  EXPECT_LT(largest_error(draw(0.5, 2.0, false), f, exact), 1.5);
  EXPECT_LT(largest_error(draw(1.0 - 1e-9, 1.0 + 1e-9, false), f, exact), 1.5);
}

TEST(Real, ExponentialIsExactToAUnit) {
  const auto f = [](const Lanes& x) { return real::exp(x); };
  const auto exact = [](double x) { return std::exp(x); };
  EXPECT_LT(largest_error(draw(-690.0, 690.0, false), f, exact), 1.5);
  EXPECT_LT(largest_error(draw(-1.0, 1.0, false), f, exact), 1.5);
  EXPECT_EQ(real::exp(Lanes{} - 800.0)[3], 0.0);
}

TEST(Real, PowerIsExactToRoundOffOfItsLogarithm) {
  for (const double y : {0.0, 0.01, 0.31, 1.0, 1.09, 3.0}) {
    const auto f = [y](const Lanes& x) { return real::pow(x, y); };
    const auto exact = [y](double x) { return std::pow(x, y); };
    EXPECT_LT(largest_error(draw(1e-9, 10.0, true), f, exact), 2.0 + 30.0 * y) << y;
    EXPECT_EQ(f(Lanes{})[0], exact(0.0)) << y;
  }
}

TEST(Real, SelectionsAndChecksGoByLane) {
  const std::array<double, 8> numbers{-1.0, 2.0, HUGE_VAL, NAN, 0.0, 5.0, -HUGE_VAL, 7.0};
  const std::array<double, 8> expected{1.0, 2.0, -3.0, -3.0, 0.0, 5.0, -3.0, 7.0};
  static_assert(
      numbers.size() % lane_count == 0 && lane_count >= 4, "a number that is not finite in each"
  );
  LaneMask finite{};
  for (std::size_t first = 0; first < numbers.size(); first += lane_count) {
    Lanes x{};
    for (int i = 0; i < lane_count; ++i) x[i] = numbers[first + static_cast<std::size_t>(i)];
    finite = real::is_finite(x);
    const Lanes y = real::select(finite, real::abs(x), -3.0);
    for (int i = 0; i < lane_count; ++i)
      EXPECT_EQ(y[i], expected[first + static_cast<std::size_t>(i)]);
  }
  EXPECT_TRUE(real::any(finite));
  EXPECT_FALSE(real::all(finite));
  EXPECT_FALSE(real::any(Lanes{} > 0.0));
}

struct CopperPoint {
  Increment increment;
  Sym3 stress;
  JohnsonCook::History history;
};

/// States and steps of all kinds: elastic, yielding, flowing on, hot, molten, broken, in tension
/// beyond spall, refused.
std::vector<CopperPoint> draw_points(std::size_t count) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::vector<CopperPoint> points(count);
  for (CopperPoint& p : points) {
    const double size = std::pow(10.0, -4.0 + 3.0 * std::fabs(u(engine)));
    auto tensor = [&](double s) {
      return Sym3{s * u(engine), s * u(engine), s * u(engine), s * u(engine), 0.0, 0.0};
    };
    p.increment.strain = tensor(size);
    p.increment.dt = 1e-8;
    p.increment.volume_ratio_begin = 1.0 + 0.1 * u(engine);
    p.increment.volume_ratio_end = p.increment.volume_ratio_begin + trace(p.increment.strain);
    p.increment.viscous_pressure = 1e8 * std::fabs(u(engine));
    p.stress = tensor(5e8);
    p.history.plastic_strain = u(engine) > 0.5 ? 0.0 : std::fabs(u(engine));
    p.history.temperature = u(engine) > 0.8 ? 1500.0 : 294.0 + 900.0 * std::fabs(u(engine));
    p.history.internal_energy = 1e5 * u(engine);
    p.history.damage = u(engine) > 0.8 ? 1.0 : 0.3;
    if (u(engine) > 0.97) p.increment.volume_ratio_end = 0.01;
    if (u(engine) > 0.97) p.stress.xx = NAN;
  }
  return points;
}

JohnsonCook breaking_copper() {
  JohnsonCook::Parameters p = test::Sample<JohnsonCook>::parameters();
  p.spall_stress = 2e9;
  p.d1 = 0.5;
  p.d2 = 4.9;
  p.d3 = -3.0;
  p.d4 = 0.014;
  p.d5 = 1.1;
  return {p, test::Sample<JohnsonCook>::density};
}

struct LanePoints {
  IncrementOf<Sym3Of<Lanes>> increment;
  Sym3Of<Lanes> stress;
  JohnsonCook::HistoryOf<Lanes> history;
};

template <class T>
void put(T& lanes, int lane, const double* values, std::size_t count) {
  Lanes* const out = reals_of<Lanes>(lanes);
  for (std::size_t c = 0; c < count; ++c) out[c][lane] = values[c];
}

LanePoints gather(
    const std::vector<CopperPoint>& points, const std::array<std::size_t, lane_count>& of
) {
  LanePoints out{};
  out.increment.dt = Lanes{} + points[of[0]].increment.dt;
  for (int i = 0; i < lane_count; ++i) {
    const CopperPoint& p = points[of[static_cast<std::size_t>(i)]];
    put(out.increment.strain, i, &p.increment.strain.xx, 6);
    out.increment.volume_ratio_begin[i] = p.increment.volume_ratio_begin;
    out.increment.volume_ratio_end[i] = p.increment.volume_ratio_end;
    out.increment.viscous_pressure[i] = p.increment.viscous_pressure;
    put(out.stress, i, &p.stress.xx, 6);
    put(out.history, i, &p.history.plastic_strain, 4);
  }
  return out;
}

double away(double a, double b, double scale) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  return std::fabs(a - b) / (std::fabs(b) + scale);
}

TEST(JohnsonCookLanes, GiveWhatSinglePointsGive) {
  const JohnsonCook model = breaking_copper();
  const std::vector<CopperPoint> points = draw_points(80000);
  std::size_t refused = 0;
  for (std::size_t first = 0; first < points.size(); first += lane_count) {
    std::array<std::size_t, lane_count> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = first + i;
    LanePoints lanes = gather(points, of);
    const auto outcome = model.update_points(lanes.increment, lanes.stress, lanes.history);
    for (int i = 0; i < lane_count; ++i) {
      CopperPoint p = points[first + static_cast<std::size_t>(i)];
      const Outcome one = model.update(p.increment, p.stress, p.history);
      ASSERT_EQ(outcome.sound[i] != 0, !one.failed());
      refused += static_cast<std::size_t>(one.failed());
      if (one.failed()) continue;
      EXPECT_LT(away(lanes.stress.xx[i], p.stress.xx, 1e8), 1e-11);
      EXPECT_LT(away(lanes.stress.xy[i], p.stress.xy, 1e8), 1e-11);
      EXPECT_LT(away(lanes.history.plastic_strain[i], p.history.plastic_strain, 1e-3), 1e-11);
      EXPECT_LT(away(lanes.history.temperature[i], p.history.temperature, 0.0), 1e-11);
      EXPECT_LT(away(lanes.history.internal_energy[i], p.history.internal_energy, 1e3), 1e-10);
      EXPECT_LT(away(lanes.history.damage[i], p.history.damage, 1e-3), 1e-10);
      EXPECT_LT(away(outcome.plastic_work[i], one.plastic_work, 1e3), 1e-10);
      EXPECT_LT(away(outcome.elastic_work[i], one.elastic_work, 1e3), 1e-9);
      EXPECT_LT(away(outcome.longitudinal_modulus[i], one.longitudinal_modulus, 0.0), 1e-12);
    }
  }
  EXPECT_GT(refused, points.size() / 200);
  EXPECT_LT(refused, points.size() / 10);
}

/// A point's bits depend neither on its lane nor on its neighbours: on that the reproducibility of
/// runs rests.
TEST(JohnsonCookLanes, NoLaneDependsOnAnother) {
  const JohnsonCook model = breaking_copper();
  const std::vector<CopperPoint> points = draw_points(16000);
  std::mt19937_64 engine(3);
  std::uniform_int_distribution<std::size_t> any(0, points.size() - 1);
  for (std::size_t trial = 0; trial < 4000; ++trial) {
    std::array<std::size_t, lane_count> one{};
    std::array<std::size_t, lane_count> other{};
    for (std::size_t i = 0; i < one.size(); ++i) {
      one[i] = any(engine);
      other[i] = any(engine);
    }
    const auto lane = static_cast<int>(trial % lane_count);
    const int place = lane_count - 1 - lane;
    other[static_cast<std::size_t>(place)] = one[static_cast<std::size_t>(lane)];
    LanePoints a = gather(points, one);
    LanePoints b = gather(points, other);
    const auto out_a = model.update_points(a.increment, a.stress, a.history);
    const auto out_b = model.update_points(b.increment, b.stress, b.history);
    const auto same = [&](const Lanes& u, const Lanes& v) {
      const double x = u[lane];
      const double y = v[place];
      return std::memcmp(&x, &y, sizeof x) == 0;
    };
    ASSERT_EQ(out_a.sound[lane], out_b.sound[place]);
    ASSERT_TRUE(same(a.stress.xx, b.stress.xx) && same(a.stress.xy, b.stress.xy));
    ASSERT_TRUE(same(a.history.plastic_strain, b.history.plastic_strain));
    ASSERT_TRUE(same(a.history.temperature, b.history.temperature));
    if (out_a.sound[lane] == 0) continue;
    ASSERT_TRUE(same(out_a.plastic_work, out_b.plastic_work));
    ASSERT_TRUE(same(out_a.longitudinal_modulus, out_b.longitudinal_modulus));
  }
}

/// Elastic points in lanes, some of them with strain or stress that is no number.
TEST(LinearElasticLanes, GiveWhatSinglePointsGive) {
  const LinearElastic model({50e9, 30e9}, 2700.0);
  const std::vector<CopperPoint> points = draw_points(8000);
  std::size_t refused = 0;
  for (std::size_t first = 0; first < points.size(); first += lane_count) {
    std::array<std::size_t, lane_count> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = first + i;
    LanePoints lanes = gather(points, of);
    LinearElastic::HistoryOf<Lanes> none;
    const auto outcome = model.update_points(lanes.increment, lanes.stress, none);
    for (int i = 0; i < lane_count; ++i) {
      const CopperPoint& p = points[first + static_cast<std::size_t>(i)];
      Sym3 stress = p.stress;
      LinearElastic::History no_history;
      const Outcome one = model.update(p.increment, stress, no_history);
      ASSERT_EQ(outcome.sound[i] != 0, !one.failed());
      EXPECT_LT(away(lanes.stress.xx[i], stress.xx, 1e8), 1e-14);
      EXPECT_LT(away(lanes.stress.zx[i], stress.zx, 1e8), 1e-14);
      refused += static_cast<std::size_t>(one.failed());
      if (one.failed()) continue;
      EXPECT_LT(away(outcome.elastic_work[i], one.elastic_work, 1e3), 1e-12);
      EXPECT_EQ(outcome.longitudinal_modulus[i], one.longitudinal_modulus);
    }
  }
  EXPECT_GT(refused, points.size() / 200);
}

#endif

}  // namespace
}  // namespace barreno
