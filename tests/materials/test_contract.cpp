// SPDX-License-Identifier: BSD-3-Clause
/// Contract tests: what every model in barreno/models.hpp must do, whatever it is.

#include "every_model.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <type_traits>
#include <vector>

namespace barreno::test {
namespace {

template <class Model>
class Contract : public ::testing::Test {};
TYPED_TEST_SUITE(Contract, AllModels, ModelName);

constexpr double step_time = 1e-8;  // s; of the order of a penetration run's

template <class Model>
std::vector<double> values(const typename Model::History& history) {
  std::vector<double> v(Model::history_count);
  if (!v.empty()) std::memcpy(v.data(), &history, v.size() * sizeof(double));
  return v;
}

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double symmetric() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  Sym3 tensor(double size) {
    return size *
           Sym3{symmetric(), symmetric(), symmetric(), symmetric(), symmetric(), symmetric()};
  }

private:
  std::mt19937_64 engine_;
};

/// Rotation about an axis that is no symmetry of the components: R s R^T.
Sym3 rotated(const Sym3& s) {
  const double angle = 0.7, n[3] = {2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0};
  const double a[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  const double cross[3][3] = {{0.0, -n[2], n[1]}, {n[2], 0.0, -n[0]}, {-n[1], n[0], 0.0}};
  double r[3][3], t[3][3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      r[i][j] = (i == j ? std::cos(angle) : 0.0) + (1.0 - std::cos(angle)) * n[i] * n[j] +
                std::sin(angle) * cross[i][j];
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) t[i][j] += r[i][k] * a[k][l] * r[j][l];
      }
    }
  }
  return {t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[0][2]};
}

/// Points in various states: unstressed, sheared under pressure, yielded, after reversal.
template <class Model>
std::vector<Point<Model>> various_states(const Model& model) {
  using S = Sample<Model>;
  std::vector<Point<Model>> points(4, Point<Model>(model));
  const Sym3 squeeze{-1.0, -0.3, -0.4, 0.2, -0.1, 0.15};
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(points[1].apply((0.1 * S::elastic) * squeeze, step_time).failed());
    EXPECT_FALSE(points[2].apply((0.1 * S::plastic) * squeeze, step_time).failed());
    EXPECT_FALSE(points[3].apply((0.1 * S::plastic) * squeeze, step_time).failed());
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(points[3].apply((-0.03 * S::plastic) * squeeze, step_time).failed());
  }
  return points;
}

template <class Model, class = void>
constexpr bool damaged_by_overstress = false;
template <class Model>
constexpr bool
    damaged_by_overstress<Model, std::enable_if_t<Model::Law::rated && Model::Law::damaged>> = true;

/// Let a point come to rest. A metal relaxes when straining stops, at once where rate terms are off
/// (dt = 0); the heat of it lowers the strength for the next relaxation, some 1e-4 of the one
/// before. The overstress of rock goes with time. Where that damages the rock, its surface comes
/// down a last time.
template <class Model>
void rest(Point<Model>& point) {
  const auto stand = [&point] {
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(point.apply({}, 0.0).failed());
  };
  stand();
  EXPECT_FALSE(point.apply({}, 1.0).failed());
  if constexpr (damaged_by_overstress<Model>) stand();
}

TYPED_TEST(Contract, ZeroIncrementChangesNothing) {
  const auto model = sample_model<TypeParam>();
  for (auto& point : various_states(model)) {
    rest(point);
    const Sym3 stress = point.stress;
    const auto history = values<TypeParam>(point.history);
    const Outcome outcome = point.apply({}, step_time);
    ASSERT_FALSE(outcome.failed());
    // A few round-offs of the stress: a model may split it into mean and deviator.
    EXPECT_LE(largest_component(point.stress - stress), 1e-15 * 4.0 * largest_component(stress));
    const auto after = values<TypeParam>(point.history);
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_LE(std::fabs(after[i] - history[i]), 1e-15 * std::fabs(history[i]));
    }
    const double scale = largest_component(stress) * Sample<TypeParam>::plastic;
    EXPECT_LE(std::fabs(outcome.plastic_work), 1e-14 * scale);
    EXPECT_LE(std::fabs(outcome.elastic_work), 1e-14 * scale);
    EXPECT_GT(outcome.longitudinal_modulus, 0.0);
  }
}

/// Round-off per update, over the stress. Wet rock finds its pressure to 1e-13 of the volume
/// (arenisca::fill_pores()), which is more.
template <class Model>
constexpr double round_off = 1e-12;

/// Rock at rest far ahead of a wave: squares of such strains and stresses are no numbers, and what
/// they would decide does not matter.
TYPED_TEST(Contract, StrainsAheadOfAWaveAreNoFailure) {
  using S = Sample<TypeParam>;
  const TypeParam model(S::parameters(), S::density);
  Random random(3);
  const auto size = [&] { return std::pow(10.0, -172.0 + 152.0 * random.symmetric()); };
  for (int i = 0; i < 1000; ++i) {
    Point<TypeParam> point(model);
    for (int step = 0; step < 3; ++step)
      ASSERT_FALSE(point.apply(random.tensor(size()), step_time).failed()) << i;
  }
}

TYPED_TEST(Contract, RotatedIncrementGivesRotatedStress) {
  const auto model = sample_model<TypeParam>();
  Random random(1);
  for (int path = 0; path < 20; ++path) {
    Point<TypeParam> straight(model), turned(model);
    double peak = 0.0;
    for (int i = 0; i < 20; ++i) {
      Sym3 strain = random.tensor(0.2 * Sample<TypeParam>::plastic);
      strain = strain - isotropic(0.3 * Sample<TypeParam>::elastic);
      ASSERT_FALSE(straight.apply(strain, step_time).failed());
      // Round-off in the trace would give another volume: the same one for both.
      Increment i_turned = turned.increment(rotated(strain), step_time);
      i_turned.volume_ratio_end = straight.volume_ratio;
      ASSERT_FALSE(model.update(i_turned, turned.stress, turned.history).failed());
      turned.volume_ratio = straight.volume_ratio;
      peak = std::max(peak, largest_component(straight.stress));
    }
    const double difference = largest_component(turned.stress - rotated(straight.stress));
    EXPECT_LE(difference, round_off<TypeParam> * 20 * peak);
  }
}

TYPED_TEST(Contract, ElasticBelowYield) {
  const auto model = sample_model<TypeParam>();
  const double a = Sample<TypeParam>::elastic;
  // A closed way through strain space; its legs do not come back along themselves.
  const std::vector<Sym3> legs{
      {-a, 0, 0, 0, 0, 0},
      {0, -a, 0, 0, 0, 0},
      {0, 0, 0, 0.5 * a, 0, 0},
      {a, 0, 0, 0, 0, 0},
      {0, 0, 0, -0.5 * a, 0, 0},
      {0, a, 0, 0, 0, 0}};
  Point<TypeParam> point(model);
  const auto begin = values<TypeParam>(point.history);
  double peak = 0.0, elastic_work = 0.0, elastic_turnover = 0.0;
  for (const Sym3& leg : legs) {
    for (int i = 0; i < 20; ++i) {
      const Outcome outcome = point.apply(0.05 * leg, step_time);
      ASSERT_FALSE(outcome.failed());
      EXPECT_EQ(outcome.plastic_work, 0.0);
      elastic_work += outcome.elastic_work;
      elastic_turnover += std::fabs(outcome.elastic_work);
      peak = std::max(peak, largest_component(point.stress));
    }
  }
  // Finite strain makes the volume part of the work depend on the path at the order of the strain.
  EXPECT_LE(largest_component(point.stress), 2.0 * a * peak);
  EXPECT_LE(std::fabs(elastic_work), 2.0 * a * elastic_turnover);
}

/// What a step may give back, over stress times strain. Overstress fades with time, and points
/// against a stress that has been reversed in the meantime: 0.02 of these paths. In wet rock, whose
/// grains the overstress loads too, pores that close meanwhile add to it: 0.062.
template <class Model>
constexpr double given_back = 1e-12;
template <>
constexpr double given_back<RatedArenisca> = 0.05;
template <>
constexpr double given_back<RatedWetArenisca> = 0.1;
template <>
constexpr double given_back<RatedHeatedArenisca> = 0.05;
template <>
constexpr double given_back<RatedHeatedWetArenisca> = 0.1;

TYPED_TEST(Contract, PlasticWorkIsNotNegative) {
  const auto model = sample_model<TypeParam>();
  const double size = Sample<TypeParam>::plastic;
  Random random(2);
  for (int path = 0; path < 50; ++path) {
    Point<TypeParam> point(model);
    const Sym3 direction = random.tensor(1.0);
    for (int i = 0; i < 60; ++i) {
      const double reversal = i % 20 < 12 ? 1.0 : -1.0;
      Sym3 strain = (0.05 * size) * (reversal * direction + random.tensor(0.5));
      strain = strain - isotropic(0.02 * size * reversal);
      const Outcome outcome = point.apply(strain, step_time);
      ASSERT_FALSE(outcome.failed());
      const double scale = largest_component(point.stress) * largest_component(strain);
      EXPECT_GE(outcome.plastic_work, -given_back<TypeParam> * scale);
      EXPECT_TRUE(std::isfinite(outcome.plastic_work));
      EXPECT_TRUE(std::isfinite(outcome.elastic_work));
    }
  }
}

/// Stress at the end of a curved strain path, divided into n steps.
template <class Model>
Sym3 end_of_path(const Model& model, int n) {
  Point<Model> point(model);
  const double a = Sample<Model>::plastic;
  const auto strain_at = [a](double t) {
    return Sym3{-a * t, 0.2 * a * t * t, 0.0, 0.5 * a * t * t, 0.0, -0.3 * a * std::sin(t)};
  };
  for (int i = 0; i < n; ++i) {
    const Sym3 strain = strain_at((i + 1.0) / n) - strain_at(double(i) / n);
    EXPECT_FALSE(point.apply(strain, 1e-6 / n).failed());
  }
  return point.stress;
}

TYPED_TEST(Contract, OneBigStepApproachesManySmall) {
  const auto model = sample_model<TypeParam>();
  const Sym3 reference = end_of_path(model, 1 << 16);
  const double scale = largest_component(reference);
  const auto error = [&](int n) {
    return largest_component(end_of_path(model, n) - reference) / scale;
  };
  EXPECT_LT(error(1), 0.1) << "one step for the whole path";
  EXPECT_LT(error(16), 5e-3);
  const double coarse = error(256), fine = error(2048);
  // Where a model integrates exactly there is no order to measure.
  if (coarse > 1e-12) {
    const double order = std::log2(coarse / fine) / 3.0;
    EXPECT_GT(order, 0.9);
    this->RecordProperty("order", std::to_string(order));
  }
  EXPECT_LT(fine, 1e-4);
}

double factor(const Dimension& d, double length, double time, double mass) {
  return std::pow(length, d.length) * std::pow(time, d.time) * std::pow(mass, d.mass);
}

/// Parameters whose table gives their unit as text: T1 |D|^-T2 is a time.
template <class Parameters>
void set_time_unit(Parameters& /*p*/, double /*unit*/) {}
void set_time_unit(AreniscaParameters& p, double unit) {
  p.T1_rate_dependence *= std::pow(unit, 1.0 - p.T2_rate_dependence);
}

TYPED_TEST(Contract, TwoUnitSystemsGiveTheSameDigits) {
  using Model = TypeParam;
  const double length = 1024.0, time = 1.0 / 4096.0, mass = 8.0;  // powers of two: no rounding
  auto parameters = Sample<Model>::parameters();
  for (const auto& entry : Model::parameter_table().numbers) {
    parameters.*entry.member *= factor(entry.dimension, length, time, mass);
  }
  set_time_unit(parameters, time);
  const auto model = sample_model<Model>();
  const Model other(
      parameters, Sample<Model>::density * factor(dimension::density, length, time, mass)
  );
  const double stress_unit = factor(dimension::stress, length, time, mass);
  Point<Model> a(model), b(other);
  // Bit for bit, but for a compiler that contracts products and sums differently in the two calls.
  constexpr double round_off = 1e-12;
  const auto same = [&](double x, double unit, double y) {
    return std::fabs(x * unit - y) <= round_off * std::fabs(y);
  };
  double peak = 0.0;
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Sym3 strain =
        random.tensor(0.1 * Sample<Model>::plastic) - isotropic(0.02 * Sample<Model>::elastic);
    const double viscosity = trace(strain) < 0.0 ? 1e7 : 0.0;
    ASSERT_FALSE(a.apply(strain, step_time, viscosity).failed());
    ASSERT_FALSE(b.apply(strain, step_time * time, viscosity * stress_unit).failed());
    peak = std::max(peak, largest_component(b.stress));
    EXPECT_LE(largest_component(stress_unit * a.stress - b.stress), round_off * peak);
    const double work = peak * largest_component(strain);
    EXPECT_NEAR(a.last.plastic_work * stress_unit, b.last.plastic_work, round_off * work);
    EXPECT_NEAR(a.last.elastic_work * stress_unit, b.last.elastic_work, round_off * work);
    EXPECT_TRUE(same(a.last.longitudinal_modulus, stress_unit, b.last.longitudinal_modulus));
    EXPECT_EQ(a.last.substeps, b.last.substeps);
  }
  const auto fields = Model::history_table();
  const auto h_a = values<Model>(a.history), h_b = values<Model>(b.history);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double unit = factor(fields[i].dimension, length, time, mass);
    EXPECT_TRUE(same(h_a[i], unit, h_b[i])) << fields[i].name << ' ' << h_a[i] * unit - h_b[i];
  }
}

TYPED_TEST(Contract, ModulusBoundsTheStiffness) {
  const auto model = sample_model<TypeParam>();
  constexpr double d = 1e-6;
  const std::vector<Sym3> steps{
      {d, 0, 0, 0, 0, 0},
      {0, d, 0, 0, 0, 0},
      {0, 0, d, 0, 0, 0},
      {-d, 0, 0, 0, 0, 0},
      {0, 0, -d, 0, 0, 0}};
  for (auto& begin : various_states(model)) {
    rest(begin);
    const double bound =
        model.longitudinal_modulus(begin.stress, begin.history, begin.volume_ratio);
    for (const Sym3& strain : steps) {
      Point<TypeParam> point = begin;
      ASSERT_FALSE(point.apply(strain, step_time).failed());
      const double stiffness = largest_component(point.stress - begin.stress) / d;
      // Between begin and end of the step the modulus may change, in rock a thousand times d.
      const double largest = std::max(bound, point.last.longitudinal_modulus);
      EXPECT_LE(stiffness, largest * (1.0 + d));
      EXPECT_GE(stiffness, 0.0);
    }
  }
}

/// The sentence that the tables of a model and its check() give about a set; empty: it is sound.
template <class Model>
std::string refusal(const typename Model::Parameters& p, double density) {
  for (const auto& entry : Model::parameter_table().numbers) {
    if (!entry.bounds.contain(p.*entry.member)) return std::string(entry.name) + " out of bounds";
  }
  return Model::check(p, density);
}

TYPED_TEST(Contract, BadParametersAreRefusedByName) {
  using S = Sample<TypeParam>;
  const auto good = S::parameters();
  EXPECT_EQ(refusal<TypeParam>(good, S::density), "");
  std::set<std::string> names;
  for (const auto& entry : TypeParam::parameter_table().numbers) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " appears twice";
    EXPECT_STRNE(entry.meaning, "");
    if (!entry.required) {
      EXPECT_TRUE(entry.bounds.contain(entry.default_value)) << entry.name;
    }
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> bad{std::nan(""), infinity, -infinity};
    const double lower = entry.bounds.lower, upper = entry.bounds.upper;
    if (std::isfinite(lower)) {
      bad.push_back(entry.bounds.lower_open ? lower : std::nextafter(lower, -infinity));
    }
    if (std::isfinite(upper)) {
      bad.push_back(entry.bounds.upper_open ? upper : std::nextafter(upper, infinity));
    }
    for (const double value : bad) {
      auto p = good;
      p.*entry.member = value;
      const std::string text = refusal<TypeParam>(p, S::density);
      EXPECT_NE(text.find(entry.name), std::string::npos) << entry.name << " = " << value;
    }
  }
}

TYPED_TEST(Contract, ContradictionsAreRefusedByName) {
  using S = Sample<TypeParam>;
  for (const auto& [parameters, name] : S::contradictions()) {
    const std::string text = TypeParam::check(parameters, S::density);
    EXPECT_NE(text.find(name), std::string::npos) << "sentence: '" << text << "'";
    EXPECT_NE(text.find('('), std::string::npos) << "no reason given: " << text;
    EXPECT_EQ(text.empty() ? '?' : text.back(), text.back() == '?' ? '?' : '.') << text;
  }
}

TYPED_TEST(Contract, ValuesThatAreNotFiniteFailAndChangeNothing) {
  const auto model = sample_model<TypeParam>();
  for (const auto& begin : various_states(model)) {
    const Increment good = begin.increment({-1e-4, 0, 0, 0, 0, 0}, step_time);
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300}) {
      std::vector<Increment> increments(9, good);
      increments[0].strain.xx = increments[1].strain.yy = increments[2].strain.zz = bad;
      increments[3].strain.xy = increments[4].strain.yz = increments[5].strain.zx = bad;
      increments[6].volume_ratio_begin = increments[7].volume_ratio_end = bad;
      increments[8].viscous_pressure = bad;
      // As volume ratio or viscosity 1e300 is a number like any other.
      const std::size_t number = std::isfinite(bad) ? 6 : 9;
      for (std::size_t i = 0; i < number; ++i) {
        Point<TypeParam> point = begin;
        const Outcome outcome = model.update(increments[i], point.stress, point.history);
        const bool unchanged = std::memcmp(&point.stress, &begin.stress, sizeof(Sym3)) == 0 &&
                               values<TypeParam>(point.history) == values<TypeParam>(begin.history);
        // A model without an equation of state may ignore the last three; then nothing else may
        // show them.
        const bool ignored = i >= 6 && is_finite(point.stress) &&
                             std::isfinite(outcome.elastic_work + outcome.plastic_work);
        EXPECT_TRUE(outcome.failed() || ignored) << "field " << i << " = " << bad;
        EXPECT_TRUE(unchanged || ignored) << "field " << i << " = " << bad;
      }
    }
  }
}

TYPED_TEST(Contract, HistoryIsDoublesAsInItsTable) {
  using History = typename TypeParam::History;
  constexpr auto count = static_cast<std::size_t>(TypeParam::history_count);
  EXPECT_TRUE(
      count == 0 ? std::is_empty<History>::value : sizeof(History) == count * sizeof(double)
  );
  EXPECT_TRUE(std::is_trivially_copyable<History>::value);
  EXPECT_EQ(alignof(History), count == 0 ? 1U : alignof(double));
  const auto table = TypeParam::history_table();
  EXPECT_EQ(table.size(), count);
  std::set<std::string> names;
  for (const HistoryField& field : table) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    for (const char letter : std::string(field.name)) {
      EXPECT_TRUE(std::islower(letter) || std::isdigit(letter) || letter == '_') << field.name;
    }
  }
}

TYPED_TEST(Contract, InitialStateIsInEquilibrium) {
  const auto model = sample_model<TypeParam>();
  for (const double fraction : {0.0, 0.1, 1.0}) {
    const double pressure = fraction * Sample<TypeParam>::pressure;
    const auto state = model.initial_state(pressure);
    ASSERT_TRUE(state.possible);
    EXPECT_LE(largest_component(state.stress + isotropic(pressure)), 1e-12 * pressure);
    Point<TypeParam> point(model);
    point.stress = state.stress;
    point.history = state.history;
    point.volume_ratio = state.volume_ratio;
    ASSERT_FALSE(point.apply({}, step_time).failed());
    EXPECT_LE(largest_component(point.stress - state.stress), 1e-12 * pressure);
    EXPECT_EQ(point.last.plastic_work, 0.0);
    EXPECT_GE(state.stored_energy, 0.0);
    const double bound =
        pressure * pressure / model.longitudinal_modulus({}, model.initial_history(), 1.0);
    EXPECT_GE(state.stored_energy, 0.25 * bound) << "an elastic body stores about p^2 / 2K";
  }
}

}  // namespace
}  // namespace barreno::test
