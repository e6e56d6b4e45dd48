// SPDX-License-Identifier: BSD-3-Clause
/// The tangent of a step against differences of another solver's steps, over the whole yield
/// surface.

#include "every_model.hpp"
#include "sample_models.hpp"
#include "scalar_arenisca.hpp"
#include "tangent_differences.hpp"

#include <gtest/gtest.h>

#include <barreno/tangent.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace barreno::test {
namespace {

/// Where on the yield surface a step has ended that began at a plastic volume strain.
std::string region_of(
    const ScalarArenisca& model, const Point<ScalarArenisca>& p, double evp_begin
) {
  const double evp_end = p.history.plastic_volume_strain;
  if (evp_begin * evp_end < 0.0) return through_jump;
  if (p.last.plastic_work == 0.0) return "elastic";
  const arenisca::Rock& rock = model.rock();
  const double q = std::sqrt(second_invariant(deviator(p.stress)));
  return region(trace(p.stress), q, rock.surface.vertex, rock.cap_at(evp_end));
}

TEST(Tangent, AreniscaOverTheWholeYieldSurface) {
  auto parameters = Sample<Arenisca>::parameters();
  parameters.tolerance = 1e-3;
  const Arenisca model(parameters, Sample<Arenisca>::density);
  parameters.return_solver = 1;  // the published nested bisection
  const ScalarArenisca oracle(parameters, Sample<Arenisca>::density);
  demand_tangents(compare_tangents(
      model,
      oracle,
      0.0,
      72,
      [&](const auto& point, double evp_begin) { return region_of(oracle, point, evp_begin); }
  ));
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

/// Whether rock has its moduli from beyond their jump.
template <class Model>
bool is_dilated(const Point<Model>& point) {
  const auto fields = Model::history_table();
  const bool is_rock = !fields.empty() && fields[0].name == std::string("plastic_volume_strain");
  return is_rock && history_values<Model>(point.history)[0] > 0.0;
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
      const bool was_dilated = is_dilated<TypeParam>(point);
      Sym3 stress = point.stress;
      auto history = point.history;
      Tangent tangent;
      ASSERT_FALSE(
          update_with_tangent(model, point.increment(way, 0.0), stress, history, tangent).failed()
      );
      ASSERT_FALSE(point.apply(way, 0.0).failed());
      const double scale = point.last.longitudinal_modulus;
      // Half of a kink is an error of the central difference (rock that is broken within the step).
      const bool kink = difference(expected.left, expected.right) > 1e-4 * scale;
      const bool jumps = was_dilated != is_dilated<TypeParam>(point);  // tested above, apart
      if (kink || jumps || !expected.same_substeps) continue;
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
