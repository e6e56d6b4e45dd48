// SPDX-License-Identifier: BSD-3-Clause
/// Parts of the law that no folder of the library knows (outside/): a card asks for them, and the
/// rock does what their equations say. The library is compiled here with them; the contract of
/// every model runs over their forms too.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <barreno/registry.hpp>
#include <cmath>
#include <string>
#include <variant>

namespace barreno::test {
namespace {

using Parameters = Arenisca::Parameters;

std::string name_of(const Material& material) {
  return std::visit(
      [](const auto& model) { return FullName<std::decay_t<decltype(model)>>::of(); },
      material.model
  );
}

/// The material of a card that says this besides the shipped one.
Material card_with(const std::string& more) {
  const std::string text =
      R"(<ParameterList name="Rock"><Parameter name="Schema Version" type="int" value="1"/>
<Parameter name="Model" type="string" value="Arenisca"/><Parameter name="Density" type="double" value="2300"/>
<Parameter name="PEAKI1" type="double" value="21e6"/><Parameter name="FSLOPE" type="double" value="0.435"/>
<Parameter name="B0" type="double" value="8e9"/><Parameter name="B1" type="double" value="28e9"/>
<Parameter name="B2" type="double" value="4e8"/><Parameter name="G0" type="double" value="8e9"/>
<Parameter name="p0_crush_curve" type="double" value="-6e8"/><Parameter name="p1_crush_curve" type="double" value="1.5e-9"/>
<Parameter name="p3_crush_curve" type="double" value="0.22"/>)" +
      more + "</ParameterList>";
  return make_material("Rock", scan_card(text, "rock.xml"), "rock.xml");
}
std::string entry(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + value + "\"/>";
}

TEST(OutsideParts, CardsAskForThemByTheirParameters) {
  EXPECT_EQ(name_of(card_with("")), "Arenisca");
  EXPECT_EQ(name_of(card_with(entry("Lundborg strength", "5e8"))), "Arenisca Lundborg strength");
  EXPECT_EQ(
      name_of(card_with(entry("Solid pressure", "1.5e9") + entry("fluid_B0", "2.2e9"))),
      "Arenisca Solid pressure wet"
  );
  EXPECT_EQ(name_of(card_with(entry("Dilation scale", "0.02"))), "Arenisca Dilation scale");
}

TEST(OutsideParts, TwoInPlaceOfPublishedOnesAreRefused) {
  const auto sentence = [](const std::string& more) -> std::string {
    try {
      card_with(more);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  const std::string two =
      sentence(entry("Lundborg strength", "5e8") + entry("Dilation scale", "0.02"));
  EXPECT_NE(two.find("Lundborg strength and Dilation scale"), std::string::npos) << two;
  const std::string rated =
      sentence(entry("Lundborg strength", "5e8") + entry("T1_rate_dependence", "1e-5"));
  EXPECT_NE(rated.find("rate dependence"), std::string::npos) << rated;
}

template <class Part>
using DryForm = std::conditional_t<
    std::is_same_v<Part, arenisca::outside::LundborgLimit>,
    ExchangedArenisca<
        Part,
        AreniscaOf<arenisca::PartsOf<
            arenisca::outside::LundborgLimit,
            arenisca::CrushCurve,
            arenisca::FlowRule>>>,
    std::conditional_t<
        std::is_same_v<Part, arenisca::outside::CompactionCurve>,
        ExchangedArenisca<
            Part,
            AreniscaOf<arenisca::PartsOf<
                arenisca::ShearLimit,
                arenisca::outside::CompactionCurve,
                arenisca::FlowRule>>>,
        ExchangedArenisca<
            Part,
            AreniscaOf<arenisca::PartsOf<
                arenisca::ShearLimit,
                arenisca::CrushCurve,
                arenisca::outside::FadingDilatancy>>>>>;

/// Nonporous rock in shear under pressure ends on the limit that the part says.
TEST(OutsideParts, RockFlowsOnTheNewShearLimit) {
  using Model = DryForm<arenisca::outside::LundborgLimit>;
  Parameters p = Sample<Model>::parameters();
  p.p3_crush_curve = 0.0;
  const Model model(p, 2300.0);
  Point<Model> point(model);
  for (int i = 0; i < 200; ++i) {
    ASSERT_FALSE(point.apply({-4e-4, 1e-4, 1e-4, 0.0, 0.0, 0.0}, 1e-6).failed());
    if (i < 50) continue;
    const double x = trace(point.stress), d = p.PEAKI1 - x;
    const double limit = p.FSLOPE * d / (1.0 + p.FSLOPE * d / p.lundborg_strength);
    const double q = std::sqrt(second_invariant(deviator(point.stress)));
    EXPECT_NEAR(q / limit, 1.0, 1e-9) << "at step " << i;
  }
}

/// Hydrostatic crushing follows the curve to its end: X is the stress.
TEST(OutsideParts, RockCrushesAlongTheNewCurve) {
  using Model = DryForm<arenisca::outside::CompactionCurve>;
  const Parameters p = Sample<Model>::parameters();
  const Model model(p, 2300.0);
  Point<Model> point(model);
  const double Xs = -3.0 * p.solid_pressure;
  int crushed = 0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_FALSE(point.apply({-4e-4, -4e-4, -4e-4, 0.0, 0.0, 0.0}, 1e-6).failed());
    const double f = 1.0 + point.history.plastic_volume_strain / p.p3_crush_curve;
    if (point.history.plastic_volume_strain == 0.0 || f < 1e-3) continue;
    ++crushed;
    const double X = Xs - (Xs - p.p0_crush_curve) * std::sqrt(f);
    EXPECT_NEAR(trace(point.stress) / X, 1.0, 1e-9) << "at step " << i;
  }
  EXPECT_GT(crushed, 50);
  EXPECT_LT(trace(point.stress), Xs) << "closed pores carry more than the curve's end";
}

/// Plastic volume strain over plastic shear strain is 3 sqrt(3) beta^2 FSLOPE on a straight limit,
/// with the beta that the rule says.
TEST(OutsideParts, DilatancyFadesAsTheRuleSays) {
  using Model = DryForm<arenisca::outside::FadingDilatancy>;
  Parameters p = Sample<Model>::parameters();
  p.p3_crush_curve = p.STREN = p.YSLOPE = p.B1 = p.B2 = 0.0;
  p.FSLOPE = 0.2;
  const Model model(p, 2300.0);
  Point<Model> point(model);
  for (int i = 0; i < 50; ++i)
    ASSERT_FALSE(point.apply({-1e-3, -1e-3, -1e-3, 0.0, 0.0, 0.0}, 1e-6).failed());
  double least = 1.0;
  for (int i = 0; i < 400; ++i) {
    const auto before = point.history;
    ASSERT_FALSE(point.apply({-2e-4, 1e-4, 1e-4, 0.0, 0.0, 0.0}, 1e-6).failed());
    const double shear = point.history.equivalent_plastic_strain - before.equivalent_plastic_strain;
    if (i < 300 || shear == 0.0) continue;
    const double evp = 0.5 * (point.history.plastic_volume_strain + before.plastic_volume_strain);
    const double beta = p.BETA_nonassociativity * std::exp(-evp / p.dilation_scale);
    const double ratio =
        (point.history.plastic_volume_strain - before.plastic_volume_strain) / shear;
    EXPECT_NEAR(ratio / (3.0 * std::sqrt(3.0) * beta * beta * p.FSLOPE), 1.0, 0.02);
    least = std::min(least, beta / p.BETA_nonassociativity);
  }
  EXPECT_LT(least, 0.7) << "the rock has dilated enough to tell";
}

}  // namespace
}  // namespace barreno::test
