// SPDX-License-Identifier: BSD-3-Clause
/// The yield surface of pictures is that which the update obeys, for every model that has one.

#include "drive/yield_table.hpp"
#include "drive/yield_view.hpp"
#include "materials/every_model.hpp"
#include "materials/sample_models.hpp"

#include <gtest/gtest.h>

#include <barreno/arenisca/parts/lode.hpp>
#include <barreno/input/scan_xml.hpp>
#include <cmath>
#include <map>
#include <sstream>

namespace barreno::test {
namespace {

template <class Model>
constexpr bool is_rock = std::is_same_v<typename Model::Parameters, AreniscaParameters>;

template <class Model>
class YieldViewOf : public ::testing::Test {
protected:
  static Material material() {
    auto p = Sample<Model>::parameters();
    if constexpr (is_rock<Model>) p.tolerance = 1e-6;
    return {"sample", Sample<Model>::density, Model(p, Sample<Model>::density)};
  }
  /// Compression with shear, well beyond yield.
  static std::vector<DrivenState> states(const Material& material) {
    const double a = Sample<Model>::plastic;
    std::string path = "time,strain_xx,strain_yy,strain_xy\n0,0,0,0\n1e-3";
    for (const double end : {-a, 0.3 * a, 0.4 * a}) path += "," + input::exact_text(end);
    return states_of(drive_mixed(material, read_mixed_path(path + "\n", "p"), {100, true}, "p"));
  }
};
TYPED_TEST_SUITE(YieldViewOf, AllModels, ModelName);

/// sqrt(J2) of the bounded stress over that of the surface.
double load_of(const YieldView& view) {
  const double limit = view.limit(trace(view.bounded));
  const double theta = arenisca::lode_angle(deviator(view.bounded));
  return shear_of(view.bounded) / (view.gamma(theta) * limit);
}

TYPED_TEST(YieldViewOf, ThePathStaysInsideAndEndsOnTheSurface) {
  const Material material = this->material();
  const auto states = this->states(material);
  ASSERT_EQ(states.size(), 101u);
  if (!yield_view(material, states[0], states[0])) {
    EXPECT_TRUE(yield_table(material, states).empty());
    EXPECT_FALSE(is_rock<TypeParam>);
    return;
  }
  double load = 0.0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const auto view = yield_view(material, states[i], states[i - 1]);
    const double I1 = trace(view->bounded);
    ASSERT_GE(I1, view->tip * (1.0 + 1e-5));
    ASSERT_LE(I1, view->vertex + 1.0);
    load = load_of(*view);
    // The published backstress moves with the flow of a step: its point is where it was then.
    ASSERT_LE(load, 1.0 + 1e-3) << "step " << i;
  }
  EXPECT_GE(load, 1.0 - 1e-3);
}

struct Curve {
  std::vector<double> angle, I1, shear;
};
std::map<std::string, Curve> curves_of(const std::string& table) {
  std::map<std::string, Curve> curves;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  EXPECT_EQ(line, "state,section,time,lode_angle,I1,sqrt_J2");
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string state, section, number;
    std::getline(cells, state, ',');
    std::getline(cells, section, ',');
    std::vector<double> values;
    while (std::getline(cells, number, ',')) values.push_back(std::stod(number));
    std::string key = state;
    key.append(" ").append(section);
    Curve& curve = curves[key];
    curve.angle.push_back(values[1]);
    curve.I1.push_back(values[2]);
    curve.shear.push_back(values[3]);
  }
  return curves;
}

TEST(YieldTable, AMeridianEndsAtVertexAndTipAndAnOctahedralSectionAtItsAngles) {
  auto p = Sample<AngledArenisca>::parameters();
  const Material material{"rock", 2300.0, AngledArenisca(p, 2300.0)};
  const auto path = read_mixed_path(
      "time,strain_xx,stress_xx,stress_yy,stress_zz\n0,,0,0,0\n1,,-30e6,-30e6,-30e6\n"
      "2,-0.02,,-30e6,-30e6\n",
      "path"
  );
  const auto states = states_of(drive_mixed(material, path, {40, true}, "path"));
  auto curves = curves_of(yield_table(material, states));
  const Curve& initial = curves["initial compression"];
  EXPECT_NEAR(initial.I1.front() / p.p0_crush_curve, 1.0, 1e-12);
  EXPECT_NEAR(initial.I1.back() / p.PEAKI1, 1.0, 1e-12);
  EXPECT_LE(
      initial.shear.front(), 1e-6 * *std::max_element(initial.shear.begin(), initial.shear.end())
  );
  const Curve& extension = curves["initial extension"];
  ASSERT_EQ(extension.shear.size(), initial.shear.size());
  EXPECT_NEAR(extension.shear[100] / initial.shear[100], p.J3_psi, 1e-12);
  const Curve& plane = curves["current octahedral"];
  ASSERT_EQ(plane.angle.size(), 61u);
  EXPECT_EQ(plane.angle.front(), 0.0);
  EXPECT_NEAR(plane.angle.back(), 60.0, 1e-12);
  EXPECT_NEAR(plane.shear.front() / plane.shear.back(), p.J3_psi, 1e-12);
  double largest = 0.0;
  for (const DrivenState& state : states) largest = std::max(largest, shear_of(state.stress));
  EXPECT_NEAR(plane.shear.back() / largest, 1.0, 0.02);  // the tolerance of the sample
}

/// F = R U: the strain is ln U from the first row, whatever the rotation.
TEST(DrivenStates, StrainsAreThoseOfTheStretch) {
  const Mat3 first{{{1.5, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Mat3 f{{{c * 1.2 * 1.5, -s * 0.9, 0}, {s * 1.2 * 1.5, c * 0.9, 0}, {0, 0, 1}}};
  const auto states = states_of(std::vector<DrivenRow>{
      {0.0, first, Sym3{}, Sym3{}, {}}, {1.0, f, Sym3{}, Sym3{1, 2, 3, 4, 5, 6}, {7.0}}});
  EXPECT_NEAR(states[1].strain.xx, std::log(1.2), 1e-14);
  EXPECT_NEAR(states[1].strain.yy, std::log(0.9), 1e-14);
  EXPECT_NEAR(states[1].strain.xy, 0.0, 1e-14);
  EXPECT_EQ(states[1].stress.zx, 6.0);
  EXPECT_EQ(states[0].strain.xx, 0.0);
}

}  // namespace
}  // namespace barreno::test
