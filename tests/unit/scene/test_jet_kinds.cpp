// SPDX-License-Identifier: BSD-3-Clause
// The kinds of a jet: one mass, momentum and energy, three ways to fill its length.
#include "jet/kinds.hpp"
#include "scene/jet_kinds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

constexpr double density = 8930.0, radius = 1.5e-3, tip = 7000.0, origin = 0.05;

/// A jet that stretches from a virtual origin, v = x / t, as it passes a plane: touching slugs of
/// full density, of which a part is filled.
std::vector<JetSlug> stretching_jet(double filled, int count = 60) {
  std::vector<double> time, velocity;
  for (int i = 0; i < count; ++i) {
    velocity.push_back(tip * (1.0 - 0.01 * i));
    time.push_back(origin / velocity.back() - origin / tip);
  }
  std::vector<JetSlug> table;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double before = i == 0 ? time[1] - time[0] : time[i] - time[i - 1];
    const double after = i + 1 == time.size() ? before : time[i + 1] - time[i];
    table.push_back(
        {time[i], velocity[i], radius, 0.5 * (before + after) * velocity[i] * filled, density}
    );
  }
  return table;
}

/// Mass over pi, or over 2 in plane strain; momentum and energy.
std::array<double, 3> totals(const std::vector<JetSlug>& slugs, Mode mode) {
  std::array<double, 3> sum{};
  for (const JetSlug& slug : slugs) {
    const double section = mode == Mode::plane_strain ? slug.radius : slug.radius * slug.radius;
    const double mass = slug.density * section * slug.length;
    sum[0] += mass;
    sum[1] += mass * slug.velocity;
    sum[2] += 0.5 * mass * slug.velocity * slug.velocity;
  }
  return sum;
}

constexpr std::array<JetKind, 3> all_kinds{
    JetKind::discrete, JetKind::thinned, JetKind::continuous};

TEST(JetKinds, HaveTheTablesMassMomentumAndEnergy) {
  for (const Mode mode : {Mode::axisymmetric, Mode::plane_strain, Mode::three_dimensional})
    for (const double filled : {1.0, 0.8, 0.2}) {
      const std::vector<JetSlug> table = stretching_jet(filled);
      const auto expected = totals(table, mode);
      for (const JetKind kind : all_kinds) {
        ASSERT_EQ(problem_of_kind(table, kind, density), "");
        const auto found = totals(slugs_of_kind(table, kind, mode, density), mode);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-13) << word_of(kind);
      }
    }
}

/// The same jet as slugs with gaps and as touching slugs of less density.
TEST(JetKinds, GapsAndDensitiesOfATableMeanTheSameVoid) {
  std::vector<JetSlug> with_gaps = stretching_jet(0.5), with_density = stretching_jet(1.0);
  for (JetSlug& slug : with_density) slug.density *= 0.5;
  for (const JetKind kind : all_kinds) {
    const auto a = slugs_of_kind(with_gaps, kind, Mode::axisymmetric, density);
    const auto b = slugs_of_kind(with_density, kind, Mode::axisymmetric, density);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i].radius / b[i].radius, 1.0, 1e-13);
      EXPECT_NEAR(a[i].length / b[i].length, 1.0, 1e-13);
      EXPECT_NEAR(a[i].density / b[i].density, 1.0, 1e-13);
    }
  }
}

TEST(JetKinds, DiscreteLeavesGapsAndOnlyDiscrete) {
  const std::vector<JetSlug> table = stretching_jet(0.4);
  const auto end_of = [](const JetSlug& slug) {
    return slug.time + 0.5 * slug.length / slug.velocity;
  };
  const auto begin_of = [](const JetSlug& slug) {
    return slug.time - 0.5 * slug.length / slug.velocity;
  };
  for (const JetKind kind : all_kinds) {
    const auto slugs = slugs_of_kind(table, kind, Mode::axisymmetric, density);
    for (std::size_t i = 2; i + 1 < slugs.size(); ++i) {  // those with neighbours on both sides
      const double gap = begin_of(slugs[i]) - end_of(slugs[i - 1]);
      const double step = table[i].time - table[i - 1].time;
      EXPECT_NEAR(gap / step, kind == JetKind::discrete ? 0.6 : 0.0, 0.01) << i;
    }
    EXPECT_NEAR(slugs[3].radius / radius, kind == JetKind::thinned ? std::sqrt(0.4) : 1.0, 1e-12);
    EXPECT_NEAR(slugs[3].density / density, kind == JetKind::continuous ? 0.4 : 1.0, 1e-12);
  }
}

/// design figures: 1 : sqrt(2 alpha - 1) : alpha.
TEST(JetKinds, HydrodynamicDepths) {
  for (const auto& [alpha, continuous] :
       {std::pair{1.25, 1.2247449}, {1.5, 1.4142136}, {2.0, 1.7320508}}) {
    const std::vector<JetSlug> table = stretching_jet(1.0 / alpha);
    const JetVoids voids = jet_voids(table, density);
    const auto depth_of = [&](JetKind kind) {
      return hydrodynamic_depth(table, kind, Mode::axisymmetric, density);
    };
    EXPECT_NEAR(voids.filled, 1.0 / alpha, 1e-12);
    EXPECT_NEAR(voids.least_filled, 1.0 / alpha, 1e-12);
    EXPECT_NEAR(depth_of(JetKind::discrete), 1.0, 1e-12);
    EXPECT_NEAR(depth_of(JetKind::thinned), alpha, 1e-12);
    EXPECT_NEAR(depth_of(JetKind::continuous), continuous, 1e-6);
    // And as what digs: P = L sqrt(rho_j / rho_t).
    const JetSlug mean{0.0, 1.0, 1.0, alpha, density / alpha};
    const double depth =
        alpha * std::sqrt(digging_density(JetKind::continuous, mean, density) / density);
    EXPECT_NEAR(depth, continuous, 1e-6);
  }
  const JetVoids one = jet_voids({{0.0, 1000.0, 1e-3, 1e-3, 0.5 * density}}, density);
  EXPECT_NEAR(one.filled, 0.5, 1e-15);
}

TEST(JetKinds, ASlugAloneKeepsItsLength) {
  const std::vector<JetSlug> table{{1e-6, 1000.0, 1e-3, 2e-3, 0.5 * density}};
  EXPECT_EQ(slugs_of_kind(table, JetKind::continuous, Mode::axisymmetric, density)[0].length, 2e-3);
  EXPECT_EQ(slugs_of_kind(table, JetKind::discrete, Mode::axisymmetric, density)[0].length, 1e-3);
  EXPECT_NEAR(
      slugs_of_kind(table, JetKind::thinned, Mode::axisymmetric, density)[0].radius,
      1e-3 * std::sqrt(0.5),
      1e-18
  );
}

TEST(JetKinds, RefusesWhatCannotBeWhole) {
  std::vector<JetSlug> table = stretching_jet(1.0);
  table[5].length *= 1.1;
  EXPECT_EQ(problem_of_kind(table, JetKind::discrete, density), "");
  EXPECT_NE(
      problem_of_kind(table, JetKind::thinned, density).find("gives slug 6 a length"),
      std::string::npos
  );
  table[5] = table[4];
  EXPECT_EQ(problem_of_kind(table, JetKind::discrete, density), "");
  EXPECT_NE(
      problem_of_kind(table, JetKind::continuous, density).find("at the same time"),
      std::string::npos
  );
}

}  // namespace
}  // namespace barreno
