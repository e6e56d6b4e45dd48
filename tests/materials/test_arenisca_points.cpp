// SPDX-License-Identifier: BSD-3-Clause
// Arenisca's points in lanes against the law written apart for one point. That lanes and single
// points have the same bits: test_arenisca_forms.cpp.
#include "materials/arenisca_points.hpp"
#include "materials/scalar_arenisca.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace barreno::test {
namespace {

#if BARRENO_HAS_LANES

using Parameters = Arenisca::Parameters;

struct Result {
  Sym3 stress;
  Arenisca::History history;
  bool sound;
  double elastic_work, plastic_work, modulus;
};

Result by_one(const ScalarArenisca& model, const RockPoint& point) {
  Result r{point.stress, point.history, false, 0.0, 0.0, 0.0};
  arenisca::NoCounter none;
  const Outcome o = model.update_counted(point.increment, r.stress, r.history, none);
  return {r.stress, r.history, !o.failed(), o.elastic_work, o.plastic_work, o.longitudinal_modulus};
}
Result lane_result(const Arenisca::Points<Lanes>& p, int i) {
  const PointsOutcome<Lanes>& o = p.outcome;
  return {
      lane_of<Sym3>(p.stress, i),
      lane_of<Arenisca::History>(p.history, i),
      o.sound[i] != 0,
      o.elastic_work[i],
      o.plastic_work[i],
      o.longitudinal_modulus[i]};
}

/// Through the two parts of the update, as the host does it.
std::vector<Result> by_lanes(const Arenisca& model, const std::vector<RockPoint>& points) {
  std::vector<Result> results;
  std::array<Arenisca::Points<Lanes>, Arenisca::groups_together> groups;
  std::array<LaneMask, Arenisca::groups_together> rest;
  std::size_t count = 0;
  for (std::size_t first = 0; first < points.size(); first += lane_count) {
    std::array<std::size_t, lane_count> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = std::min(first + i, points.size() - 1);
    groups[count] = gather(points, of.data());
    rest[count] = model.start_points(groups[count]);
    if (++count < groups.size() && first + lane_count < points.size()) continue;
    model.finish_points(groups.data(), rest.data(), static_cast<int>(count));
    for (std::size_t g = 0; g < count; ++g)
      for (int i = 0; i < lane_count && results.size() < points.size(); ++i)
        results.push_back(lane_result(groups[g], i));
    count = 0;
  }
  return results;
}

/// Largest differences, relative to the larger of strength and trial stress.
struct Difference {
  double stress = 0.0, plastic_strain = 0.0, work = 0.0, modulus = 0.0;
  /// Plastic strain in the measure of the others: a tenth of what they may differ by.
  double largest() const { return std::max({stress, work, modulus, 10.0 * plastic_strain}); }
};
Difference difference(
    const ScalarArenisca& model, const RockPoint& point, const Result& a, const Result& b
) {
  const double bulk = model.rock().elasticity.published_bound().bulk;
  const double strain = norm(point.increment.strain);
  const double scale =
      std::max(model.rock().stress_floor, norm(point.stress) + 3.0 * bulk * strain);
  return {
      norm(a.stress - b.stress) / scale,
      std::fabs(a.history.plastic_volume_strain - b.history.plastic_volume_strain),
      (std::fabs(a.plastic_work - b.plastic_work) + std::fabs(a.elastic_work - b.elastic_work)) /
          (scale * strain),
      std::fabs(a.modulus / b.modulus - 1.0)};
}

/// How much update() itself makes of round-off: where a point sits at a knife's edge (the tip of
/// the cap, pores that are all but closed, a substep that is just accepted), its neighbours go
/// other ways.
double own_noise(const ScalarArenisca& model, const RockPoint& point, const Result& result) {
  double noise = 0.0;
  for (const double change : {-1e-13, -1e-14, -1e-15, 1e-15, 1e-14, 1e-13}) {
    for (const int what : {0, 1, 2}) {
      RockPoint near = point;
      if (what == 0) near.stress = (1.0 + change) * near.stress;
      if (what == 1) near.increment.strain = (1.0 + change) * near.increment.strain;
      if (what == 2) near.history.plastic_volume_strain *= 1.0 + 0.1 * change;
      const Result other = by_one(model, near);
      noise = std::max(noise, difference(model, point, other, result).largest());
    }
  }
  return noise;
}

/// Opening of pores that are all but closed, where the cap retracts a hundred times faster than the
/// stress changes, and stress that falls by more than the increment could change it elastically: a
/// long substep then has several solutions, and the two solvers may come to others.
bool has_several_ways(const ScalarArenisca& model, const RockPoint& point, const Result& result) {
  const double p3 = model.rock().crush.p3;
  if (p3 == 0.0 || result.plastic_work == 0.0) return false;
  constexpr double nearly_closed = 0.005;
  const double bulk = model.rock().elasticity.published_bound().bulk;
  return 1.0 + point.history.plastic_volume_strain / p3 < nearly_closed ||
         norm(result.stress - point.stress) > 3.0 * bulk * norm(point.increment.strain);
}

/// A trace of dilation from the jump of the moduli, so short that its second pass undoes it or not.
bool begins_to_dilate(const RockPoint& point, const Result& a, const Result& b) {
  constexpr double at_jump = arenisca::Elasticity::at_jump;
  const bool dilates = a.history.plastic_volume_strain > at_jump;
  const bool other = b.history.plastic_volume_strain > at_jump;
  return std::fabs(point.history.plastic_volume_strain) <= at_jump && dilates != other;
}

struct Tally {
  std::size_t points = 0, plastic = 0, edges = 0;
  Difference worst, worst_edge;
};
void keep_larger(const Difference& d, Difference& worst) {
  worst.stress = std::max(worst.stress, d.stress);
  worst.plastic_strain = std::max(worst.plastic_strain, d.plastic_strain);
  worst.work = std::max(worst.work, d.work);
  worst.modulus = std::max(worst.modulus, d.modulus);
}
Tally compare(const ScalarArenisca& model, const std::vector<RockPoint>& points) {
  const std::vector<Result> lanes = by_lanes(model, points);
  Tally tally;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Result one = by_one(model, points[i]);
    EXPECT_EQ(one.sound, lanes[i].sound) << i;
    EXPECT_TRUE(is_finite(lanes[i].stress)) << i;
    EXPECT_TRUE(std::isfinite(lanes[i].elastic_work + lanes[i].plastic_work)) << i;
    if (!one.sound) continue;
    ++tally.points;
    tally.plastic += one.plastic_work > 0.0 ? 1U : 0U;
    const Difference d = difference(model, points[i], lanes[i], one);
    const bool edge = d.largest() > 1e-9 && (has_several_ways(model, points[i], one) ||
                                             begins_to_dilate(points[i], one, lanes[i]) ||
                                             own_noise(model, points[i], one) > 0.1 * d.largest());
    tally.edges += edge ? 1U : 0U;
    keep_larger(d, edge ? tally.worst_edge : tally.worst);
  }
  return tally;
}

template <class Draw>
std::vector<RockPoint> draw_points(std::size_t count, const Draw& draw) {
  std::vector<RockPoint> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(draw());
  return points;
}

void expect_agreement(const ScalarArenisca& model, const std::vector<RockPoint>& points) {
  const Tally tally = compare(model, points);
  std::printf(
      "%zu points, %zu flow: worst stress %.1e; %zu at edges, worst stress %.1e\n",
      tally.points,
      tally.plastic,
      tally.worst.stress,
      tally.edges,
      tally.worst_edge.stress
  );
  EXPECT_EQ(tally.points, points.size());
  EXPECT_GT(tally.plastic, points.size() / 10);
  EXPECT_LE(tally.worst.stress, 1e-9);
  EXPECT_LE(tally.worst.modulus, 1e-9);
  EXPECT_LE(tally.worst.plastic_strain, 1e-10);
  // Of stress times strain, which is small beside the stress that round-off is measured by.
  EXPECT_LE(tally.worst.work, 1e-8);
  // At the edges both are answers within the model's own tolerance: mostly pores that are all but
  // closed and open again, where the two solvers take other ones of three roots.
  EXPECT_LT(tally.edges, points.size() / 150);
  EXPECT_LE(tally.worst_edge.stress, model.rock().tolerance);
}

// A million updates: half as in a penetration run, half over every state of every kind of rock.
TEST(AreniscaLanes, GiveWhatSinglePointsGive) {
  const auto sets = sets_of_all_kinds();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    SCOPED_TRACE(k);
    ASSERT_EQ(Arenisca::check(sets[k], 1.0), "");
    const ScalarArenisca model(sets[k], 1.0);
    RockSampler sampler(model, static_cast<unsigned>(k));
    constexpr std::size_t count = 62500;
    if (sets[k].p3_crush_curve > 0.0)
      expect_agreement(model, draw_points(count, [&] { return sampler.flowing(); }));
    expect_agreement(model, draw_points(count, [&] { return sampler.anywhere(-6.0, -3.0); }));
  }
}

// Long steps: many substeps, which in both forms are many roundings and choices.
TEST(AreniscaLanes, TakeLongSteps) {
  for (const Parameters& set : sets_of_all_kinds()) {
    const ScalarArenisca model(set, 1.0);
    RockSampler sampler(model, 77);
    const auto points = draw_points(2000, [&] { return sampler.anywhere(-3.0, 0.0); });
    const std::vector<Result> lanes = by_lanes(model, points);
    std::vector<double> differences;
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(is_finite(lanes[i].stress));
      const Result one = by_one(model, points[i]);
      // update() may run out of substeps where compressed rock expands by 100 % in one step.
      if (!one.sound) continue;
      ASSERT_TRUE(lanes[i].sound) << i;
      differences.push_back(difference(model, points[i], lanes[i], one).stress);
    }
    EXPECT_GT(differences.size(), points.size() * 99 / 100);
    std::sort(differences.begin(), differences.end());
    EXPECT_LE(differences[differences.size() * 98 / 100], 1e-9);
    EXPECT_LE(differences.back(), model.rock().tolerance);
  }
}

TEST(AreniscaLanes, RefuseWhatIsNotFinite) {
  const ScalarArenisca model(berea(), 1.0);
  RockSampler sampler(model, 6);
  auto points = draw_points(lane_count, [&] { return sampler.flowing(); });
  points[1].stress.xy = NAN;
  points[2].increment.strain.zz = HUGE_VAL;
  points[3].history.plastic_volume_strain = NAN;
  points[5].increment.strain = {20.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  const std::vector<Result> lanes = by_lanes(model, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(lanes[i].sound, by_one(model, points[i]).sound) << i;
    if (lanes[i].sound) continue;
    EXPECT_EQ(lanes[i].stress.xx, points[i].stress.xx) << i;
    EXPECT_EQ(lanes[i].history.equivalent_plastic_strain, 0.1) << i;
  }
}

#endif

}  // namespace
}  // namespace barreno::test
