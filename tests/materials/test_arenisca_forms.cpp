// SPDX-License-Identifier: BSD-3-Clause
// Every form of Arenisca that goes in lanes: points have the same bits alone and in company.
#include "barreno/tangent.hpp"
#include "materials/arenisca_points.hpp"
#include "materials/every_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <type_traits>
#include <vector>

namespace barreno::test {
namespace {

#if BARRENO_HAS_LANES

template <class Model>
using GoesInLanes = std::bool_constant<goes_in_lanes<Model>>;
using Forms = ModelsOf<GoesInLanes, AnyModel>::type;

/// A point of a form, before or after a step.
template <class Form>
struct FormPoint {
  Increment increment{};
  Sym3 stress;
  typename Form::History history;
  Outcome outcome{};
};

/// The features of a form in another rock; all of them depend on the state.
template <class Form>
Arenisca::Parameters with_features(Arenisca::Parameters p) {
  const Arenisca::Parameters features = Sample<Form>::parameters();
  p.fluid_B0 = features.fluid_B0;
  p.backstress_strain = features.backstress_strain;
  p.matrix_bulk_modulus = p.fluid_B0 > 0.0 ? 40e9 : 0.0;
  p.T1_rate_dependence = features.T1_rate_dependence;
  p.T2_rate_dependence = p.T1_rate_dependence > 0.0 ? 0.3 : 0.0;
  if (p.PEAKI1 > 0.0) {  // else nothing scatters
    p.weibull_modulus = features.weibull_modulus;
    p.weibull_reference_volume = features.weibull_reference_volume;
  }
  p.fracture_strain = features.fracture_strain;
  p.fracture_energy = features.fracture_energy;
  p.tension_cutoff = features.tension_cutoff;
  p.residual_slope = features.residual_slope;
  p.damage_pressure = features.damage_pressure;
  p.breakage_energy = features.breakage_energy;
  p.breakage_pressure = features.breakage_pressure;
  p.specific_heat = features.specific_heat;
  p.grueneisen = features.grueneisen;
  p.grain_density = features.grain_density;
  p.melting_temperature = features.melting_temperature;
  p.J3_type = features.J3_type;
  p.J3_psi = features.J3_psi;
  return p;
}

/// Points of a form: those of the dry rock, with what else the form knows of them.
template <class Form>
class FormSampler {
public:
  using Law = typename Form::Law;
  FormSampler(const Form& form, const Arenisca::Parameters& p, unsigned seed)
      : form_(form), dry_(p, 1.0), sampler_(dry_, seed), random_(seed) {}

  /// Flowing as in a penetration, anywhere with steps of 1e-6 to 0.1, and quiet ones.
  std::vector<FormPoint<Form>> draw(std::size_t count) {
    std::vector<FormPoint<Form>> points;
    const bool porous = dry_.rock().crush.p3 > 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 5 == 0)
        points.push_back(complete(sampler_.elastic()));
      else
        points.push_back(
            complete(porous && i % 5 < 3 ? sampler_.flowing() : sampler_.anywhere(-6.0, -1.0))
        );
    }
    return points;
  }

private:
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  FormPoint<Form> complete(const RockPoint& rock) {
    FormPoint<Form> p{rock.increment, rock.stress, form_.initial_history()};
    auto& h = p.history;
    h.plastic_volume_strain = rock.history.plastic_volume_strain;
    h.equivalent_plastic_strain = rock.history.equivalent_plastic_strain;
    if constexpr (Law::scattered) h.coherence = 0.5 + unit();
    if constexpr (Law::damaged) {
      h.damage = unit() < 0.5 ? unit() : 0.0;
      h.breakage = unit() < 0.5 ? unit() : 0.0;
    }
    if constexpr (Law::heated) {
      h.temperature = 300.0 + (unit() < 0.5 ? 2400.0 * unit() : 0.0);
      h.thermal_expansion = unit() < 0.5 ? 1e-4 * unit() : 0.0;
    }
    if constexpr (Law::rated) {
      h.overstress_xx = 1e7 * (unit() - 0.5);
      h.overstress_xy = 1e7 * (unit() - 0.5);
      p.stress = p.stress + arenisca::overstress_of<double>(h);
    }
    if constexpr (arenisca::has_poroplastic_fluid<Law>) {
      h.porosity = 0.01 + 0.3 * unit();
      h.pore_pressure = unit() < 0.7 ? 1e8 * unit() : 0.0;
      if (h.pore_pressure == 0.0) h.gas = h.porosity * unit();
      p.stress = p.stress - isotropic(h.pore_pressure);
    }
    return p;
  }

  const Form& form_;
  Arenisca dry_;
  RockSampler sampler_;
  std::mt19937_64 random_;
};

template <class Form>
using Lanesful = typename Form::template Points<Lanes>;

template <class Form>
Lanesful<Form> gather_form(const std::vector<FormPoint<Form>>& points, std::size_t first) {
  Lanesful<Form> lanes{};
  for (std::size_t i = 0; i < lane_count; ++i) {
    const FormPoint<Form>& p = points[std::min(first + i, points.size() - 1)];
    const int lane = static_cast<int>(i);
    set_lane(p.increment.strain, lane, lanes.increment.strain);
    set_lane(p.stress, lane, lanes.stress);
    set_lane(p.history, lane, lanes.history);
    lanes.increment.volume_ratio_begin[i] = p.increment.volume_ratio_begin;
    lanes.increment.volume_ratio_end[i] = p.increment.volume_ratio_end;
    lanes.increment.dt[i] = p.increment.dt;
  }
  return lanes;
}
template <class Form>
FormPoint<Form> lane_of_form(const Lanesful<Form>& lanes, int i) {
  FormPoint<Form> p;
  p.stress = lane_of<Sym3>(lanes.stress, i);
  p.history = lane_of<typename Form::History>(lanes.history, i);
  p.outcome.elastic_work = lanes.outcome.elastic_work[i];
  p.outcome.plastic_work = lanes.outcome.plastic_work[i];
  p.outcome.longitudinal_modulus = lanes.outcome.longitudinal_modulus[i];
  p.outcome.status = lanes.outcome.sound[i] != 0 ? Status::ok : Status::not_converged;
  return p;
}

/// Through the two parts of the update, many groups at once, as the host does it.
template <class Form>
std::vector<FormPoint<Form>> in_company(
    const Form& form, const std::vector<FormPoint<Form>>& points
) {
  std::vector<FormPoint<Form>> ends;
  std::vector<Lanesful<Form>> groups;
  std::vector<LaneMask> rest;
  for (std::size_t first = 0; first < points.size(); first += lane_count) {
    groups.push_back(gather_form(points, first));
    rest.push_back(form.start_points(groups.back()));
    if (groups.size() < Form::groups_together && first + lane_count < points.size()) continue;
    form.finish_points(groups.data(), rest.data(), static_cast<int>(groups.size()));
    for (const Lanesful<Form>& group : groups)
      for (int i = 0; i < lane_count && ends.size() < points.size(); ++i)
        ends.push_back(lane_of_form<Form>(group, i));
    groups.clear();
    rest.clear();
  }
  return ends;
}

template <class Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
/// Both failed, or both have the same bits of everything.
template <class Form>
void expect_same(const FormPoint<Form>& a, const FormPoint<Form>& b, std::size_t which) {
  ASSERT_EQ(a.outcome.failed(), b.outcome.failed()) << which;
  ASSERT_TRUE(same_bits(a.stress, b.stress)) << which;
  ASSERT_TRUE(same_bits(a.history, b.history)) << which;
  if (a.outcome.failed()) return;
  ASSERT_EQ(a.outcome.elastic_work, b.outcome.elastic_work) << which;
  ASSERT_EQ(a.outcome.plastic_work, b.outcome.plastic_work) << which;
  ASSERT_EQ(a.outcome.longitudinal_modulus, b.outcome.longitudinal_modulus) << which;
}

template <class Form>
class AreniscaForm : public ::testing::Test {
protected:
  using Points = std::vector<FormPoint<Form>>;

  /// Calls test(form, points) for every kind of rock that can have the form.
  template <class Test>
  static void with_every_rock(std::size_t count, const Test& test) {
    const auto sets = sets_of_all_kinds();
    int rocks = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
      SCOPED_TRACE(k);
      const bool porous = sets[k].p3_crush_curve > 0.0;
      const Arenisca::Parameters p = with_features<Form>(sets[k]);
      const bool dry_only = sets[k].grain_stiffening > 0.0;  // refused in wet rock
      if (Form::Law::wet && (!porous || dry_only)) continue;
      if (Form::Law::damaged && !(p.PEAKI1 > 0.0)) continue;  // no cohesion that is lost
      ASSERT_EQ(Form::check(p, 1.0), "");
      const Form form(p, 1.0);
      FormSampler<Form> sampler(form, p, static_cast<unsigned>(k));
      test(form, sampler.draw(count));
      if (::testing::Test::HasFatalFailure()) return;
      ++rocks;
    }
    EXPECT_GE(rocks, 7) << "rocks that have the form";
  }
};
TYPED_TEST_SUITE(AreniscaForm, Forms, ModelName);

/// A host with a single point (finite elements, drive) runs the same code.
TYPED_TEST(AreniscaForm, GivesTheBitsOfSinglePoints) {
  std::size_t flow = 0, all = 0;
  this->with_every_rock(1500, [&](const TypeParam& form, const auto& points) {
    const auto ends = in_company(form, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      FormPoint<TypeParam> one = points[i];
      one.outcome = form.update(one.increment, one.stress, one.history);
      expect_same(one, ends[i], i);
      if (::testing::Test::HasFatalFailure()) return;
      flow += one.outcome.plastic_work > 0.0 ? 1U : 0U;
      all += one.outcome.failed() ? 0U : 1U;
    }
  });
  EXPECT_GT(flow, all / 5);
  EXPECT_GT(all - flow, all / 10);
}

/// A point's bits depend neither on its lane nor on its neighbours nor on their number: on that the
/// reproducibility of runs rests.
TYPED_TEST(AreniscaForm, NoPointDependsOnAnother) {
  this->with_every_rock(2000, [&](const TypeParam& form, const auto& points) {
    const auto ends = in_company(form, points);
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937_64(4));
    std::vector<FormPoint<TypeParam>> shuffled;
    shuffled.reserve(order.size());
    for (const std::size_t i : order) shuffled.push_back(points[i]);
    const auto others = in_company(form, shuffled);
    for (std::size_t i = 0; i < order.size(); ++i) {
      expect_same(ends[order[i]], others[i], i);
      if (::testing::Test::HasFatalFailure()) return;
    }
    for (std::size_t i = 0; i < 200; ++i) {
      expect_same(in_company<TypeParam>(form, {points[i]}).front(), ends[i], i);
      if (::testing::Test::HasFatalFailure()) return;
    }
  });
}

#endif

}  // namespace
}  // namespace barreno::test
