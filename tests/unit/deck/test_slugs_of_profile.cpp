// SPDX-License-Identifier: BSD-3-Clause
// A jet from tip, tail and mass: integrals by a rule of their own, slug by slug and as a whole.
#include "base/numbers.hpp"
#include "deck/slugs_of_profile.hpp"
#include "deck/touching_duration.hpp"
#include "scene/jet_kinds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace barreno {
namespace {

constexpr double density = 8930.0;

JetProfileSpec profile_of(double break_up_time) {
  JetProfileSpec profile;
  profile.tip_velocity = 7000.0;
  profile.tail_velocity = 900.0;
  profile.virtual_origin = 0.12;
  profile.tip_radius = 1.1e-3;
  profile.tail_radius = 2.3e-3;
  if (break_up_time > 0.0) profile.break_up_time = break_up_time;
  return profile;
}

/// Mass, momentum and energy between two velocities by Simpson's rule.
std::array<double, 3> integrals(const JetProfileSpec& profile, double low, double high) {
  constexpr int halves = 20000;
  std::array<double, 3> sum{};
  for (int i = 0; i <= halves; ++i) {
    const double v = low + (high - low) * i / halves;
    const double share =
        (profile.tip_velocity - v) / (profile.tip_velocity - profile.tail_velocity);
    const double radius =
        *profile.tip_radius + share * (*profile.tail_radius - *profile.tip_radius);
    const double time = profile.virtual_origin / v;
    const double stretch = profile.break_up_time ? std::min(time, *profile.break_up_time) : time;
    const double weight = (i == 0 || i == halves ? 1.0
                           : i % 2 == 1          ? 4.0
                                                 : 2.0) *
                          (high - low) / halves / 3.0;
    const double mass = weight * density * pi * radius * radius * stretch;
    sum[0] += mass;
    sum[1] += mass * v;
    sum[2] += 0.5 * mass * v * v;
  }
  return sum;
}

std::array<double, 3> totals(const std::vector<JetSlug>& slugs) {
  std::array<double, 3> sum{};
  for (const JetSlug& slug : slugs) {
    const double mass = slug.density * pi * slug.radius * slug.radius * slug.length;
    sum[0] += mass;
    sum[1] += mass * slug.velocity;
    sum[2] += 0.5 * mass * slug.velocity * slug.velocity;
  }
  return sum;
}

/// Whole; broken from 3000 m/s on; broken before the plane.
constexpr std::array<double, 3> break_ups{0.0, 40e-6, 10e-6};

TEST(SlugsOfProfile, HaveMassAndMomentumOfTheJet) {
  for (const double break_up : break_ups) {
    const JetProfileSpec profile = profile_of(break_up);
    const auto expected = integrals(profile, profile.tail_velocity, profile.tip_velocity);
    const ProfileSums sums = sums_of_profile(profile, density);
    const auto found = totals(slugs_of_profile(profile, density));
    EXPECT_NEAR(sums.mass / expected[0], 1.0, 1e-8);
    EXPECT_NEAR(sums.momentum / expected[1], 1.0, 1e-8);
    EXPECT_NEAR(sums.kinetic / expected[2], 1.0, 1e-8);
    EXPECT_NEAR(found[0] / sums.mass, 1.0, 1e-12);
    EXPECT_NEAR(found[1] / sums.momentum, 1.0, 1e-12);
    EXPECT_NEAR(found[2] / sums.kinetic, 1.0, 2e-5);
  }
}

TEST(SlugsOfProfile, TheEnergyOfASlugsSpreadFallsWithTheirNumberSquared) {
  JetProfileSpec profile = profile_of(0.0);
  const double exact = sums_of_profile(profile, density).kinetic;
  profile.rows = 50;
  const double coarse = 1.0 - totals(slugs_of_profile(profile, density))[2] / exact;
  profile.rows = 100;
  const double fine = 1.0 - totals(slugs_of_profile(profile, density))[2] / exact;
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(SlugsOfProfile, FlyFromTheVirtualOriginAndHaveTheRadiusAsked) {
  const JetProfileSpec profile = profile_of(0.0);
  const auto slugs = slugs_of_profile(profile, density);
  ASSERT_EQ(slugs.size(), 200U);
  for (std::size_t i = 1; i + 1 < slugs.size(); ++i) {
    const JetSlug& slug = slugs[i];
    const double since = profile.virtual_origin / profile.tip_velocity + slug.time;
    EXPECT_NEAR(slug.velocity * since, profile.virtual_origin, 1e-12);
    const double share = (7000.0 - slug.velocity) / 6100.0;
    EXPECT_NEAR(slug.radius, 1.1e-3 + share * 1.2e-3, 1e-6);
  }
}

TEST(SlugsOfProfile, WholeMetalTouchesAndEveryKindLaunchesIt) {
  for (const double break_up : break_ups) {
    const JetProfileSpec profile = profile_of(break_up);
    std::vector<JetSlug> table = slugs_of_profile(profile, density);
    for (JetSlug& slug : table) slug.piece = slug.velocity < pieces_below(profile);
    EXPECT_EQ(problem_of_kind(table, JetKind::thinned, density), "");
    const auto launched = slugs_of_kind(table, JetKind::thinned, Mode::axisymmetric, density);
    for (std::size_t i = 0; i < table.size(); ++i) {
      EXPECT_NEAR(launched[i].length / table[i].length, 1.0, 1e-12) << i;
      EXPECT_NEAR(launched[i].radius / table[i].radius, 1.0, 1e-12) << i;
    }
  }
}

TEST(SlugsOfProfile, PiecesKeepTheLengthThatTheyHadWhenTheyBroke) {
  const JetProfileSpec profile = profile_of(40e-6);
  EXPECT_DOUBLE_EQ(broken_below(profile), 3000.0);
  const auto slugs = slugs_of_profile(profile, density);
  for (std::size_t i = 0; i + 1 < slugs.size(); ++i) {
    const double room =
        0.5 * (slugs[i].velocity + slugs[i + 1].velocity) * (slugs[i + 1].time - slugs[i].time);
    const double filled = 0.5 * (slugs[i].length + slugs[i + 1].length) / room;
    const double v = 0.5 * (slugs[i].velocity + slugs[i + 1].velocity);
    EXPECT_NEAR(filled, std::min(1.0, v / 3000.0), 0.01) << i;
  }
}

TEST(SlugsOfProfile, AMassDecidesTheRadiiThatAreLeftOut) {
  for (const double break_up : break_ups) {
    const JetProfileSpec both = profile_of(break_up);
    const double mass = sums_of_profile(both, density).mass;
    for (const int left : {0, 1, 2}) {
      JetProfileSpec profile = both;
      profile.mass = mass;
      if (left != 0) profile.tip_radius.reset();
      if (left != 1) profile.tail_radius.reset();
      ASSERT_EQ(problem_of_profile(profile, density).sentence, "");
      const auto slugs = slugs_of_profile(profile, density);
      EXPECT_NEAR(totals(slugs)[0] / mass, 1.0, 1e-12);
      const bool round = left == 2;
      EXPECT_NEAR(slugs[1].radius, round ? slugs[100].radius : 1.1e-3, round ? 1e-7 : 3e-5);
      if (!round) EXPECT_NEAR(slugs[197].radius, 2.3e-3, 2e-5);
    }
  }
}

TEST(TouchingDuration, IsFromHalfWayToHalfWayBetweenWholeNeighbours) {
  std::vector<JetSlug> slugs(5);
  const std::array times{0.0, 1.0, 3.0, 6.0, 10.0};
  for (std::size_t i = 0; i < slugs.size(); ++i) slugs[i].time = times[i];
  EXPECT_EQ(touching_duration(slugs, 0), 1.0);
  EXPECT_EQ(touching_duration(slugs, 1), 1.5);
  EXPECT_EQ(touching_duration(slugs, 4), 4.0);
  slugs[3].piece = true;
  EXPECT_EQ(touching_duration(slugs, 2), 2.0);
  EXPECT_EQ(touching_duration(slugs, 3), std::nullopt);
  EXPECT_EQ(touching_duration(slugs, 4), std::nullopt);
  EXPECT_EQ(touching_duration({slugs[0]}, 0), std::nullopt);
}

TEST(SlugsOfProfile, TheSlugOfTheLinerFollowsInOnePiece) {
  JetProfileSpec profile = profile_of(0.0);
  profile.slug_velocity = 500.0;
  profile.slug_mass = 0.05;
  profile.slug_radius = 8e-3;
  ASSERT_EQ(problem_of_profile(profile, density).sentence, "");
  const auto slugs = slugs_of_profile(profile, density);
  ASSERT_EQ(slugs.size(), 201U);
  EXPECT_NEAR(slugs.back().length, 0.05 / (density * pi * 64e-6), 1e-12);
  EXPECT_GT(pieces_below(profile), 500.0);
  EXPECT_LT(pieces_below(profile), slugs[199].velocity);
  profile.slug_velocity = 899.0;
  EXPECT_NE(
      problem_of_profile(profile, density).sentence.find("begins in the tail"), std::string::npos
  );
}

}  // namespace
}  // namespace barreno
