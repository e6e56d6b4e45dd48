// SPDX-License-Identifier: BSD-3-Clause
/// One material point along a path against closed forms, and what must hold for every model.

#include "base/error.hpp"
#include "drive/drive_point.hpp"
#include "drive/matrix.hpp"
#include "materials/every_model.hpp"
#include "materials/sample_models.hpp"
#include "shape/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno::test {
namespace {

constexpr double bulk = 16e9, shear = 12e9;

Material elastic() {
  return {"Glass", 2500.0, LinearElastic({bulk, shear}, 2500.0)};
}

Mat3 turn(double x, double y, double z, double angle) {
  return exponential(angle * Mat3{{{0, -z, y}, {z, 0, -x}, {-y, x, 0}}});
}
Mat3 stretch(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}
Mat3 sheared(double gamma) {
  return {{{1, gamma, 0}, {0, 1, 0}, {0, 0, 1}}};
}

std::vector<PathRow> path_of(const std::vector<Mat3>& gradients, double interval = 1e-6) {
  std::vector<PathRow> path;
  for (std::size_t i = 0; i < gradients.size(); ++i)
    path.push_back({interval * static_cast<double>(i), gradients[i], static_cast<int>(i) + 2});
  return path;
}

std::vector<DrivenRow> drive_elastic(const std::vector<Mat3>& gradients, int steps = 1) {
  return drive_point(elastic(), path_of(gradients), {steps}, "path");
}

Sym3 uniaxial_stress(double log_strain) {
  const double lateral = (bulk - 2.0 / 3.0 * shear) * log_strain;
  return {lateral + 2.0 * shear * log_strain, lateral, lateral, 0, 0, 0};
}

TEST(DriveElastic, UniaxialStrainIsTheLogarithm) {
  for (const int steps : {1, 7, 100}) {
    const auto rows = drive_elastic(
        {identity(), stretch(0.999, 1, 1), stretch(0.6, 1, 1), stretch(2.5, 1, 1)}, steps
    );
    const double axial[] = {0.0, 0.999, 0.6, 2.5};
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const Sym3 exact = uniaxial_stress(std::log(axial[i]));
      EXPECT_LE(norm(rows[i].stress - exact), 1e-12 * norm(exact)) << steps << " steps, row " << i;
    }
    EXPECT_EQ(norm(rows[0].stress), 0.0);
  }
}

TEST(DriveElastic, StressTurnsWithTheBody) {
  const Mat3 u = stretch(0.98, 1.01, 1.0);
  const Sym3 before = drive_elastic({identity(), u})[1].stress;
  for (const int steps : {1, 10}) {
    const Mat3 first = turn(0, 0, 1, 2.0), second = turn(0.6, 0, 0.8, 3.0) * first;
    const auto rows = drive_elastic({identity(), u, first * u, second * u}, steps);
    EXPECT_LE(norm(rows[2].stress - rotate(first, before)), 1e-12 * norm(before));
    EXPECT_LE(norm(rows[3].stress - rotate(second, before)), 1e-12 * norm(before));
  }
}

/// Simple shear with the polar rate: tan b = gamma / 2,
///   s_xx = -s_yy = 4 G (cos 2b ln cos b + b sin 2b - sin^2 b)
///   s_xy = 2 G cos 2b (2 b - 2 tan 2b ln cos b - tan b)
/// (Dienes, Acta Mech. 32 (1979) 217-232).
TEST(DriveElastic, SimpleShearConvergesToTheClosedFormAtSecondOrder) {
  const double gamma = 2.0, b = std::atan(gamma / 2.0), c = std::log(std::cos(b));
  const double axial =
      4.0 * shear * (std::cos(2 * b) * c + b * std::sin(2 * b) - std::pow(std::sin(b), 2));
  // cos 2b tan 2b written as sin 2b: gamma = 2 is where cos 2b = 0.
  const double across =
      2.0 * shear * (std::cos(2 * b) * (2 * b - std::tan(b)) - 2.0 * std::sin(2 * b) * c);
  const Sym3 exact{axial, -axial, 0, across, 0, 0};
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    const auto rows = drive_elastic({identity(), sheared(gamma)}, i == 0 ? 20 : 80);
    errors[i] = norm(rows[1].stress - exact) / norm(exact);
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]) / 2.0, 2.0, 0.05);
}

TEST(DriveElastic, StepsDoNotMatterWithoutRotation) {
  const Mat3 r = turn(0.6, 0.0, 0.8, 0.9);
  // Principal axes across the coordinates, stretches in proportion: L is symmetric and constant.
  const Mat3 end = r * stretch(0.8, 1.1, 0.9) * transpose(r);
  const Sym3 once = drive_elastic({identity(), end}, 1)[1].stress;
  const Sym3 often = drive_elastic({identity(), end}, 1000)[1].stress;
  EXPECT_LE(norm(often - once), 1e-12 * norm(once));
}

TEST(DriveElastic, TheFirstRowIsTheReference) {
  const Mat3 first = turn(0, 0, 1, 0.5) * stretch(0.7, 1.2, 1.0);
  const auto rows = drive_elastic({first, stretch(0.9, 1, 1) * first});
  EXPECT_EQ(norm(rows[0].stress), 0.0);
  const Sym3 exact = uniaxial_stress(std::log(0.9));
  EXPECT_LE(norm(rows[1].stress - exact), 1e-12 * norm(exact));
}

TEST(DriveElastic, HalfATurnBetweenRowsIsRefused) {
  try {
    drive_elastic({identity(), stretch(-1, -1, 1)});
    FAIL() << "accepted";
  } catch (const DeckError& error) {
    EXPECT_STREQ(
        error.what(),
        "path: line 3 is half a turn or more from line 2 (there is no unique constant velocity "
        "gradient between them); add rows between them."
    );
  }
}

template <class Model>
class Drive : public ::testing::Test {
public:
  Material material{"sample", Sample<Model>::density, sample_model<Model>()};
  /// Squeeze with shear and turning, well beyond yield.
  std::vector<Mat3> path() const {
    const double a = Sample<Model>::plastic;
    std::vector<Mat3> rows;
    for (int i = 0; i <= 20; ++i) {
      const double t = i / 20.0;
      const Mat3 strain{
          {{-a * t, 0.5 * a * t * t, 0}, {0.1 * a * t, 0.2 * a * t, 0}, {0, 0, -0.3 * a * t}}};
      rows.push_back(turn(0, 0, 1, 0.3 * t) * exponential(strain));
    }
    return rows;
  }
  std::vector<DrivenRow> run(const std::vector<Mat3>& rows, int steps) const {
    return drive_point(material, path_of(rows, 1e-7), {steps}, "path");
  }
};
TYPED_TEST_SUITE(Drive, AllModels, ModelName);

TYPED_TEST(Drive, EveryRowHasStressAndHistory) {
  const auto rows = this->run(this->path(), 3);
  ASSERT_EQ(rows.size(), 21u);
  for (const DrivenRow& row : rows) {
    EXPECT_TRUE(is_finite(row.stress));
    ASSERT_EQ(row.history.size(), TypeParam::history_table().size());
  }
  EXPECT_EQ(norm(rows[0].stress), 0.0);
  EXPECT_GT(norm(rows[20].stress), 0.1 * Sample<TypeParam>::pressure);
}

TYPED_TEST(Drive, ATurnedPathGivesTurnedStress) {
  const Mat3 q = turn(0.6, 0.0, 0.8, 1.1);
  auto turned = this->path();
  for (Mat3& f : turned) f = q * f * transpose(q);
  const auto straight = this->run(this->path(), 2), other = this->run(turned, 2);
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const Sym3 expected = rotate(q, straight[i].stress);
    EXPECT_LE(norm(other[i].stress - expected), 1e-10 * norm(straight.back().stress)) << i;
  }
}

TYPED_TEST(Drive, MoreStepsConverge) {
  const auto end = [&](int steps) { return this->run(this->path(), steps).back().stress; };
  const Sym3 reference = end(512);
  const double coarse = norm(end(4) - reference), fine = norm(end(32) - reference);
  EXPECT_LT(coarse, 1e-2 * norm(reference));
  // Error control of a model's own may stop convergence below its tolerance.
  EXPECT_LT(fine, 2e-3 * norm(reference));
}

/// The step of a particle in plane strain, from the functions of shape/kinematics.hpp.
template <class Model>
struct PlaneParticle {
  const Model& model;
  PlaneTensor f{};
  double volume = 1.0;
  Sym3 stress{};
  typename Model::History history;

  void step(const PlaneTensor& dt_l, double dt) {
    const PlaneTensor growth = exponential(dt_l), next = multiply(growth, f);
    Increment increment;
    increment.strain = unrotate(
        mean_polar_rotation(f, next),
        Sym3{dt_l.xx, dt_l.yy, dt_l.zz, 0.5 * (dt_l.xy + dt_l.yx), 0.0, 0.0}
    );
    increment.dt = dt;
    increment.volume_ratio_begin = volume;
    volume *= determinant(growth);
    increment.volume_ratio_end = volume;
    f = next;
    EXPECT_FALSE(model.update(increment, stress, history).failed());
  }
};

TYPED_TEST(Drive, TakesTheStepsOfAParticle) {
  const auto path = this->path();
  constexpr int steps = 5;
  const auto driven = this->run(path, steps);
  const auto& model = std::get<TypeParam>(this->material.model);
  PlaneParticle<TypeParam> particle{model, {}, 1.0, {}, model.initial_history()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Mat3 l = (1.0 / steps) * *logarithm_1p((path[i] - path[i - 1]) * inverse(path[i - 1]));
    for (int k = 0; k < steps; ++k)
      particle.step({l(0, 0), l(0, 1), l(1, 0), l(1, 1), l(2, 2)}, 1e-7 / steps);
    const Sym3 space = rotate(polar_rotation(particle.f), particle.stress);
    EXPECT_LE(norm(driven[i].stress - space), 1e-10 * norm(driven.back().stress)) << i;
  }
}

TYPED_TEST(Drive, AStepBeyondAllBoundsIsANumericalError) {
  try {
    this->run({identity(), stretch(1e5, 1, 1)}, 1);
  } catch (const NumericalError& error) {
    const std::string sentence = error.what();
    EXPECT_NE(
        sentence.find("path: line 3 cannot be reached: at time 1e-07 s the "), std::string::npos
    ) << sentence;
    return;
  }
  // A model for which nothing is too large answers with finite numbers.
  EXPECT_TRUE(is_finite(this->run({identity(), stretch(1e5, 1, 1)}, 1)[1].stress));
}

}  // namespace
}  // namespace barreno::test
