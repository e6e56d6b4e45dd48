// SPDX-License-Identifier: BSD-3-Clause
/// A strength and an equation of state that no folder of the library knows (outside/): a card names
/// them, and the metal does what their equations say.
#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <barreno/plausible.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <string>
#include <variant>

namespace barreno::test {
namespace {

using metal::outside::Tillotson;
using metal::outside::ZerilliArmstrong;
constexpr double density = 8930.0;  // kg/m3

template <class Strength, class EquationOfState>
using Usual = Metal<Strength, EquationOfState, Fracture>;

double pressure(const Sym3& stress) {
  return -trace(stress) / 3.0;
}
double equivalent(const Sym3& stress) {
  return std::sqrt(3.0 * second_invariant(deviator(stress)));
}

/// The card of a sample, parameter by parameter.
template <class Model>
Material card_of(const typename Model::Parameters& p, const std::string& more = "") {
  std::string text =
      R"(<ParameterList name="Copper"><Parameter name="Schema Version" type="int" value="1"/>
<Parameter name="Density" type="double" value="8930"/><Parameter name="Model" type="string" value=")" +
      std::string(Model::name) + "\"/>" + more;
  for (const auto& entry : Model::parameter_table().numbers) {
    char value[64];
    std::snprintf(value, sizeof value, "%.17g", p.*entry.member);
    text += std::string("<Parameter name=\"") + entry.name + "\" type=\"double\" value=\"" + value +
            "\"/>";
  }
  return make_material("Copper", scan_card(text + "</ParameterList>", "copper.xml"), "copper.xml");
}
std::string name_of(const Material& material) {
  return std::visit(
      [](const auto& model) { return FullName<std::decay_t<decltype(model)>>::of(); },
      material.model
  );
}

TEST(OutsideMetals, CardsNameTheirParts) {
  using Soft = Usual<ZerilliArmstrong, MieGruneisen>;
  using Hot = Usual<JohnsonCookFlow, Tillotson>;
  using Both = Usual<ZerilliArmstrong, Tillotson>;
  EXPECT_EQ(name_of(card_of<Soft>(Sample<Soft>::parameters())), "Zerilli-Armstrong");
  EXPECT_EQ(name_of(card_of<Hot>(Sample<Hot>::parameters())), "Johnson-Cook with Tillotson");
  const std::string voids = R"(<Parameter name="Expansion Strain" type="string" value="on"/>)";
  EXPECT_EQ(
      name_of(card_of<Both>(Sample<Both>::parameters(), voids)),
      "Zerilli-Armstrong with Tillotson expanded"
  );
  EXPECT_EQ(
      find_model(Both::name).summary,
      "Metal at high rate: Zerilli-Armstrong flow stress and damage, Tillotson pressure, melting, "
      "spall."
  );
}

TEST(OutsideMetals, RulesOfTheirPartsRefuseACard) {
  const auto sentence = [](auto of, const auto& change) -> std::string {
    using Model = decltype(of);
    auto p = Sample<Model>::parameters();
    change(p);
    return Model::check(p, density);
  };
  using Both = Usual<ZerilliArmstrong, Tillotson>;
  const Both any(Sample<Both>::parameters(), density);
  const std::string stiff = sentence(any, [](auto& p) { p.shear_modulus = 300e9; });
  EXPECT_EQ(
      stiff,
      "Shear Modulus = 3e+11 exceeds 1.5 times the bulk modulus 1.39e+11 = Tillotson A (Poisson's "
      "ratio would be negative); check the units of both."
  );
  const std::string ends = sentence(any, [](auto& p) { p.ends = p.begins; });
  EXPECT_NE(ends.find("Vaporisation Ends = "), std::string::npos) << ends;
}

TEST(OutsideMetals, PartsSayWhichValuesAreUsual) {
  const std::string metal = Usual<ZerilliArmstrong, Tillotson>::name;
  const PlausibleRange* const yield = find_plausible_range(metal, "C0");
  ASSERT_NE(yield, nullptr);
  EXPECT_TRUE(yield->holds(65e6));
  EXPECT_FALSE(yield->holds(65.0)) << "MPa that were meant";
  EXPECT_NE(find_plausible_range(metal, "Spall Stress"), nullptr);
  EXPECT_EQ(plausible_ranges(metal).front().parameter, std::string("Density"));
  EXPECT_EQ(find_plausible_range("Johnson-Cook", "C0"), nullptr);
}

/// A failure without parameters and history.
struct NoFailure {
  static constexpr const char *name = "no failure", *of_flow = "", *of_pressure = "";
  struct Parameters {};
  static ParameterTable<Parameters> parameter_table() { return {}; }
  static std::string check(const Parameters& /*p*/, const metal::BulkModulus& /*bulk*/) {
    return "";
  }
  template <class R>
  struct HistoryOf {};
  static std::vector<HistoryField> history_table() { return {}; }
  static NoFailure make(const Parameters& /*p*/) { return {}; }
  template <class R>
  static MaskOf<R> broken(const HistoryOf<R>& /*history*/) {
    return R{} > 0.0;
  }
  template <class Strength, class R>
  MaskOf<R> grow(
      const Strength& /*strength*/,
      const metal::ReturnOf<R>& /*flow*/,
      const R& /*pressure*/,
      const R& /*temperature*/,
      const R& /*dt*/,
      const MaskOf<R>& /*was_broken*/,
      HistoryOf<R>& /*end*/
  ) const {
    return R{} > 0.0;
  }
};

/// Another failure is only a part: with one that never breaks, the metal is the published one
/// whose damage and spall are off, down to a tension of 5 GPa.
TEST(OutsideMetals, AFailureIsExchangeable) {
  using Whole = Metal<JohnsonCookFlow, MieGruneisen, NoFailure>;
  EXPECT_EQ(Whole::history_table().size() + 1, JohnsonCook::history_table().size());
  EXPECT_EQ(Whole::name, std::string("Johnson-Cook with no failure"));
  Whole::Parameters p{};
  set_copper<JohnsonCookFlow>(p);
  set_copper<MieGruneisen>(p);
  const Whole whole_model(p, density);
  const JohnsonCook usual_model(Sample<JohnsonCook>::parameters(), density);
  Point<Whole> whole(whole_model);
  Point<JohnsonCook> usual(usual_model);
  for (int i = 0; i < 200; ++i) {
    const double pull = i < 100 ? -4e-4 : 6e-4;
    const Sym3 strain{pull, 0.3 * pull, 0.0, 0.5 * pull, 0.0, 0.0};
    ASSERT_FALSE(whole.apply(strain, 1e-8).failed());
    ASSERT_FALSE(usual.apply(strain, 1e-8).failed());
    EXPECT_NEAR(whole.stress.xx, usual.stress.xx, 1e-9 * std::fabs(usual.stress.xx) + 1.0);
    EXPECT_NEAR(whole.stress.xy, usual.stress.xy, 1e-9 * std::fabs(usual.stress.xy) + 1.0);
    EXPECT_NEAR(whole.history.plastic_strain, usual.history.plastic_strain, 1e-12);
    EXPECT_NEAR(whole.history.temperature / usual.history.temperature, 1.0, 1e-12);
  }
  EXPECT_LT(pressure(whole.stress), -2e9);
}

/// In shear the equivalent stress is the published equation's, of the strain at the end of the
/// step, the step's plastic rate and the temperature at its start.
TEST(OutsideMetals, MetalFlowsAtTheNewStrength) {
  using Model = Usual<ZerilliArmstrong, MieGruneisen>;
  const auto p = Sample<Model>::parameters();
  const Model model(p, density);
  for (const double rate : {0.1, 1e3, 1e6}) {
    Point<Model> point(model);
    const double dt = 1e-3 / rate;
    double hottest = 0.0;
    for (int i = 0; i < 400; ++i) {
      const auto before = point.history;
      ASSERT_FALSE(point.apply({0, 0, 0, rate * dt, 0, 0}, dt).failed());
      const double ep = point.history.plastic_strain;
      if (ep == before.plastic_strain) continue;
      const double of_step = std::max((ep - before.plastic_strain) / dt, 1.0);
      const double flow =
          p.c0 +
          p.c2 * std::sqrt(ep) *
              std::exp(-p.c3 * before.temperature + p.c4 * before.temperature * std::log(of_step));
      EXPECT_NEAR(equivalent(point.stress) / flow, 1.0, 1e-9) << "rate " << rate << " step " << i;
      hottest = point.history.temperature;
    }
    EXPECT_GT(hottest, 320.0);
  }
}

/// The published equation, written out once more.
double tillotson(const Tillotson::Parameters& p, double v, double e) {
  const double h = 1.0 / v, mu = h - 1.0, w = 1.0 / (e / (p.energy * h * h) + 1.0);
  const double rho = density * h;
  const double cold = (p.gas + p.solid * w) * rho * e + p.linear * mu + p.square * mu * mu;
  if (h >= 1.0 || e <= p.begins) return cold;
  const double hot =
      p.gas * rho * e + (p.solid * w * rho * e + p.linear * mu * std::exp(-p.beta * (v - 1.0))) *
                            std::exp(-p.alpha * (v - 1.0) * (v - 1.0));
  const double share = std::min(1.0, (e - p.begins) / (p.ends - p.begins));
  return cold + share * (hot - cold);
}

/// Shocked by viscosity and released until it is a gas: at each step the pressure is that of the
/// volume and the energy that the point then has.
TEST(OutsideMetals, PressureIsTheNewEquationsOfState) {
  using Model = Usual<JohnsonCookFlow, Tillotson>;
  auto p = Sample<Model>::parameters();
  p.a = p.b = 0.0;  // no elastic energy: all of e is heat
  const Model model(p, density);
  for (const double viscosity : {0.0, 50e9, 400e9}) {
    Point<Model> point(model);
    double work = 0.0, thinnest = 1.0;
    for (int i = 0; i < 700; ++i) {
      const double before = point.volume_ratio, p_before = pressure(point.stress);
      const double q = i < 100 ? viscosity : 0.0;
      const double strain = i < 100 ? -1e-3 : (viscosity > 0.0 ? 1e-3 : 1.2e-4);
      ASSERT_FALSE(point.apply(isotropic(strain), 1e-9, q).failed());
      const double e = point.history.internal_energy, v = point.volume_ratio;
      const double exact = tillotson(p, v, e);
      const double scale = std::fabs(exact) + 1e8;
      EXPECT_NEAR(pressure(point.stress), exact, 1e-9 * scale)
          << "q " << viscosity << " step " << i;
      work -= (0.5 * (p_before + pressure(point.stress)) + q) * (v - before);
      EXPECT_NEAR(density * e, work, 1e-9 * (std::fabs(work) + 1e6));
      thinnest = std::max(thinnest, v);
    }
    if (viscosity == 400e9) {
      EXPECT_GT(point.history.internal_energy, p.begins) << "the gas must have been seen";
      EXPECT_GT(thinnest, 2.0);
    }
  }
}

/// What the update takes of the equation of state: its derivatives, everywhere.
TEST(OutsideMetals, DerivativesOfTheNewEquationOfStateAreItsDifferences) {
  Tillotson::Parameters p;
  Tillotson::example(p);
  const Tillotson eos = Tillotson::make(p, density);
  for (const double eta : {-4.0, -1.0, -0.2, -0.01, 0.02, 0.3})
    for (const double e : {-1e4, 1e5, 1e6, 3e6, 2e7}) {
      const double E = density * e;
      const auto r = eos.at(eta, E);
      const double h = 1e-6, k = 1e-6 * std::fabs(E);
      const double over_eta = (eos.pressure(eta + h, e) - eos.pressure(eta - h, e)) / (2.0 * h);
      const double over_E =
          (eos.pressure(eta, (E + k) / density) - eos.pressure(eta, (E - k) / density)) / (2.0 * k);
      EXPECT_NEAR(r.derivative, over_eta, 1e-6 * (std::fabs(over_eta) + 1e9)) << eta << ' ' << e;
      EXPECT_NEAR(r.per_energy, over_E, 1e-6 * (std::fabs(over_E) + 1e-2)) << eta << ' ' << e;
      EXPECT_NEAR(eos.pressure(eta, e) / tillotson(p, 1.0 - eta, e), 1.0, 1e-11);
    }
}

/// Lanes of a metal of new parts give what single points give.
TEST(OutsideMetals, LanesGiveWhatSinglePointsGive) {
#if BARRENO_HAS_LANES
  using Model = Usual<ZerilliArmstrong, Tillotson>;
  const Model model(Sample<Model>::parameters(), density);
  std::vector<Point<Model>> points(lane_count, Point<Model>(model));
  Sym3Of<Lanes> stress{};
  typename Model::HistoryOf<Lanes> history{};
  IncrementOf<Sym3Of<Lanes>> increment{};
  history.temperature += model.initial_history().temperature;
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < lane_count; ++i) {
      auto& point = points[static_cast<std::size_t>(i)];
      const double c = 1e-4 * (i + 1) * (step < 100 ? -1.0 : 0.6);
      const Increment one = point.increment({c, 0.2 * c, 0.0, 0.7 * c, 0.0, 0.0}, 1e-8);
      const double* from = reals_of<double>(one);
      for (std::size_t k = 0; k < sizeof(Increment) / sizeof(double); ++k)
        reals_of<Lanes>(increment)[k][i] = from[k];
      ASSERT_FALSE(point.apply(one.strain, one.dt).failed());
    }
    const auto outcome = model.update_points(increment, stress, history);
    ASSERT_TRUE(real::all(outcome.sound));
    for (int i = 0; i < lane_count; ++i) {
      const auto& point = points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(stress.xx[i], point.stress.xx, 1e-9 * (std::fabs(point.stress.xx) + 1e8));
      EXPECT_NEAR(stress.xy[i], point.stress.xy, 1e-9 * (std::fabs(point.stress.xy) + 1e8));
      EXPECT_NEAR(history.temperature[i] / point.history.temperature, 1.0, 1e-11);
      EXPECT_NEAR(history.plastic_strain[i], point.history.plastic_strain, 1e-11);
    }
  }
#else
  GTEST_SKIP() << "no lanes in this build";
#endif
}

}  // namespace
}  // namespace barreno::test
