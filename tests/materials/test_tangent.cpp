// SPDX-License-Identifier: BSD-3-Clause
/// The tangent of a step against differences of another solver's steps, over the whole yield
/// surface.

#include "every_model.hpp"
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <barreno/tangent.hpp>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <type_traits>

namespace barreno::test {
namespace {

double largest(const Tangent& t) {
  double size = 0.0;
  for (const auto& row : t.c) {
    for (const double c : row) size = std::fmax(size, std::fabs(c));
  }
  return size;
}
double difference(const Tangent& a, const Tangent& b) {
  Tangent d;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) d.c[i][j] = a.c[i][j] - b.c[i][j];
  }
  return largest(d);
}

/// d sigma / d gamma of a model's step by differences over 4 points, fourth order; plain update().
template <class Model>
struct Differences {
  Tangent central, left, right;
  bool same_substeps = true;  ///< else they are differences of a function that jumps
};

template <class Model>
Differences<Model> differences(const Point<Model>& begin, const Sym3& strain) {
  constexpr double h = 4e-7;
  Differences<Model> result;
  const auto stress_at = [&](int component, double shift, int& substeps) {
    Point<Model> point = begin;
    Sym3 shifted = strain;
    tangent::components(shifted)[component] += component < 3 ? shift : 0.5 * shift;
    EXPECT_FALSE(point.apply(shifted, 0.0).failed());
    substeps = point.last.substeps;
    return point.stress;
  };
  int n[5];
  Sym3 s[5];
  s[2] = stress_at(0, 0.0, n[2]);
  for (int j = 0; j < 6; ++j) {
    for (const int k : {0, 1, 3, 4}) s[k] = stress_at(j, (k - 2) * h, n[k]);
    result.same_substeps = result.same_substeps && std::equal(n + 1, n + 5, n);
    for (int i = 0; i < 6; ++i) {
      const auto v = [&](int k) { return tangent::components(s[k])[i]; };
      result.central.c[i][j] = (8.0 * (v(3) - v(1)) - (v(4) - v(0))) / (12.0 * h);
      result.right.c[i][j] = (-3.0 * v(2) + 4.0 * v(3) - v(4)) / (2.0 * h);
      result.left.c[i][j] = (3.0 * v(2) - 4.0 * v(1) + v(0)) / (2.0 * h);
    }
  }
  return result;
}

const char* const through_jump = "through the moduli's jump";

/// Where on the yield surface a step has ended that began at a plastic volume strain.
std::string region(const Arenisca& model, const Point<Arenisca>& p, double evp_begin) {
  const arenisca::Rock& rock = model.rock();
  const double evp_end = p.history.plastic_volume_strain;
  if (evp_begin * evp_end < 0.0) return through_jump;
  if (p.last.plastic_work == 0.0) return "elastic";
  const double x = trace(p.stress), q = std::sqrt(second_invariant(deviator(p.stress)));
  if (x >= rock.surface.vertex * (1.0 - 1e-9)) return "vertex";
  const arenisca::Cap cap = rock.cap_at(evp_end);
  if (!cap.present || x >= cap.kappa) return "shear";
  const double towards_tip = (cap.kappa - x) / (cap.kappa - cap.X);
  if (towards_tip < 0.1) return "corner of shear and cap";
  return q < 0.02 * std::fabs(x) ? "tip of the cap" : "cap";
}

/// Strain increments that lead everywhere: the six kinds of a path.
Sym3 direction(int kind, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  Sym3 d{};
  for (int i = 0; i < 6; ++i) tangent::components(d)[i] = normal(engine);
  d = deviator(d);
  switch (kind) {
    case 0:
      return 0.02 * d + isotropic(-1.0);  // towards the tip of the cap
    case 1:
      return d + isotropic(-0.8);  // cap
    case 2:
      return d + isotropic(-0.25);  // about the corner
    case 3:
      return d;  // shear, dilating
    case 4:
      return 0.3 * d + isotropic(0.5);  // tension
    default:
      return d + isotropic(normal(engine));
  }
}

struct Tally {
  int checked = 0, at_kinks = 0, jumped = 0;
  double worst = 0.0;
};

TEST(Tangent, AreniscaOverTheWholeYieldSurface) {
  auto parameters = Sample<Arenisca>::parameters();
  parameters.tolerance = 1e-3;
  const Arenisca model(parameters, Sample<Arenisca>::density);
  parameters.return_solver = 1;  // the published nested bisection
  const Arenisca oracle(parameters, Sample<Arenisca>::density);
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> exponent(-4.0, -2.7);
  std::map<std::string, Tally> regions;
  for (int path = 0; path < 72; ++path) {
    Point<Arenisca> point(oracle);
    const Sym3 way = direction(path % 6, engine);
    for (int i = 0; i < 12; ++i) {
      const double size = std::pow(10.0, exponent(engine)) * (i % 8 == 7 ? -1.0 : 1.0);
      const Sym3 strain = size * way;
      const auto expected = differences(point, strain);
      Sym3 stress = point.stress;
      Arenisca::History history = point.history;
      Tangent tangent;
      ASSERT_FALSE(
          update_with_tangent(model, point.increment(strain, 0.0), stress, history, tangent)
              .failed()
      );
      const double evp_begin = point.history.plastic_volume_strain;
      ASSERT_FALSE(point.apply(strain, 0.0).failed());
      Tally& tally = regions[region(oracle, point, evp_begin)];
      const double scale = point.last.longitudinal_modulus;
      if (!expected.same_substeps) {
        ++tally.jumped;
      } else if (difference(expected.left, expected.right) > 1e-5 * scale) {
        ++tally.at_kinks;
      } else {
        ++tally.checked;
        tally.worst = std::fmax(tally.worst, difference(tangent, expected.central) / scale);
      }
    }
  }
  for (const auto& [name, tally] : regions) {
    std::printf(
        "%-26s %5d checked, worst %.1e; %d at kinks, %d where substeps change\n",
        name.c_str(),
        tally.checked,
        tally.worst,
        tally.at_kinks,
        tally.jumped
    );
    // Substeps end at the jump. Where it lies moves with the strain, which frozen ones do not
    // follow.
    EXPECT_LT(tally.worst, name == through_jump ? 2e-2 : 2e-5) << name;
    if (name == through_jump) continue;
    EXPECT_GE(tally.checked, 10) << name;
    EXPECT_LE(tally.at_kinks + tally.jumped, tally.checked) << name;
  }
  EXPECT_EQ(regions.size(), 7U);
}

TEST(Tangent, FrozenSubstepsGiveTheSameStep) {
  const auto model = sample_model<Arenisca>();
  std::mt19937 engine(2);
  int divided = 0;
  for (int path = 0; path < 200; ++path) {
    Point<Arenisca> point(model);
    const Sym3 way = direction(path % 6, engine);
    for (int i = 0; i < 5; ++i) {
      SmoothUpdate<Arenisca> update{model};
      Sym3 first = point.stress, again = point.stress;
      Arenisca::History h_first = point.history, h_again = point.history;
      const Increment increment = point.increment(3e-3 * way, 0.0);
      ASSERT_FALSE(update.first(increment, first, h_first).failed());
      ASSERT_FALSE(update.again(increment, again, h_again).failed());
      const double size = norm(first) + 1.0;
      EXPECT_LE(norm(first - again), 1e-13 * size);
      EXPECT_EQ(h_first.plastic_volume_strain, h_again.plastic_volume_strain);
      divided += update.record.count > 1;
      ASSERT_FALSE(point.apply(3e-3 * way, 0.0).failed());
    }
  }
  EXPECT_GT(divided, 50) << "steps must be divided, or this tests nothing";
}

/// Substeps of a step along a way, its stress and its tangent.
struct Sized {
  int substeps;
  Sym3 stress;
  Tangent tangent;
};
Sized step_of_size(const Point<Arenisca>& begin, double size, const Sym3& way) {
  Sized s{0, begin.stress, {}};
  Arenisca::History history = begin.history;
  const Outcome outcome = update_with_tangent(
      begin.model, begin.increment(size * way, 0.0), s.stress, history, s.tangent
  );
  EXPECT_FALSE(outcome.failed());
  s.substeps = outcome.substeps;
  return s;
}

/// Two strains next to each other that are divided differently: the stress jumps, which a plain
/// difference would take for stiffness; the tangent stays what it was.
TEST(Tangent, DoesNotSeeTheChoiceOfSubsteps) {
  const auto model = sample_model<Arenisca>();
  std::mt19937 engine(4);
  int changes = 0, steep = 0;
  for (int path = 0; path < 60; ++path) {
    Point<Arenisca> begin(model);
    const Sym3 way = direction(path % 6, engine);
    ASSERT_FALSE(begin.apply(2e-3 * way, 0.0).failed());
    for (int i = 1; i < 40; ++i) {
      double low = 1e-4 * i, high = 1e-4 * (i + 1);
      const int n = step_of_size(begin, low, way).substeps;
      if (step_of_size(begin, high, way).substeps == n) continue;
      while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        (step_of_size(begin, middle, way).substeps == n ? low : high) = middle;
      }
      const Sized before = step_of_size(begin, low, way), after = step_of_size(begin, high, way);
      const double modulus = model.longitudinal_modulus(begin.stress, begin.history, 1.0);
      ++changes;
      constexpr double h = 1e-7;  // what a plain difference would use
      steep += norm(after.stress - before.stress) > 0.1 * h * modulus;
      EXPECT_LT(difference(before.tangent, after.tangent), 0.5 * modulus)
          << "path " << path << " size " << low;
    }
  }
  EXPECT_GT(changes, 20);
  EXPECT_GT(steep, 5) << "no stress jumps: substeps need not be frozen any more";
}

template <class Model>
class EveryModel : public ::testing::Test {};
TYPED_TEST_SUITE(EveryModel, AllModels, ModelName);

TYPED_TEST(EveryModel, HasATangentOfWhatItDoes) {
  const auto model = sample_model<TypeParam>();
  std::mt19937 engine(3);
  double worst = 0.0;
  int checked = 0;
  for (int path = 0; path < 60; ++path) {
    Point<TypeParam> point(model);
    const Sym3 way = (Sample<TypeParam>::plastic / 50.0) * direction(path % 6, engine);
    for (int i = 0; i < 10; ++i) {
      const auto expected = differences(point, way);
      Sym3 stress = point.stress;
      auto history = point.history;
      Tangent tangent;
      ASSERT_FALSE(
          update_with_tangent(model, point.increment(way, 0.0), stress, history, tangent).failed()
      );
      ASSERT_FALSE(point.apply(way, 0.0).failed());
      const double scale = point.last.longitudinal_modulus;
      const bool kink = difference(expected.left, expected.right) > 1e-3 * scale;
      if (kink || !expected.same_substeps) continue;
      ++checked;
      worst = std::fmax(worst, difference(tangent, expected.central) / scale);
    }
  }
  std::printf("%s: %d checked, worst %.1e\n", TypeParam::name, checked, worst);
  EXPECT_GT(checked, 300);
  EXPECT_LT(worst, 1e-4);
}

TYPED_TEST(EveryModel, AZeroStepHasTheElasticTangent) {
  const auto model = sample_model<TypeParam>();
  Point<TypeParam> point(model);
  ASSERT_FALSE(point.apply(isotropic(-Sample<TypeParam>::elastic), 0.0).failed());
  Sym3 stress = point.stress;
  auto history = point.history;
  Tangent zero, small;
  ASSERT_FALSE(update_with_tangent(model, point.increment({}, 0.0), stress, history, zero).failed()
  );
  const Sym3 little = isotropic(-1e-3 * Sample<TypeParam>::elastic);
  ASSERT_FALSE(
      update_with_tangent(model, point.increment(little, 0.0), stress, history, small).failed()
  );
  EXPECT_GT(zero.c[0][0], 0.0);
  EXPECT_LT(difference(zero, small), 2e-3 * largest(zero));
}

}  // namespace
}  // namespace barreno::test
