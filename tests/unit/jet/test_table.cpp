// SPDX-License-Identifier: BSD-3-Clause
#include "jet/monitor.hpp"
#include "jet/table.hpp"
#include "scene/jet/jet_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace barreno {
namespace {

constexpr double pi = 3.14159265358979323846;

JetMonitorSpec monitor() {
  JetMonitorSpec made;
  made.position = 1.0;
  made.interval = 0.5;
  made.smallest_speed = 1.0;
  made.largest_radius = 3.0;
  made.bodies = {0};
  made.density = 2.0;
  return made;
}

TEST(JetTable, ASlugHasMassAndMomentumOfWhatCrossedInItsInterval) {
  const std::vector<JetCrossing> crossings = {
      {1, 0.1, 3.0, 4.0, 16.0, 0.5}, {2, 0.4, 1.0, 8.0, 64.0, 1.0}, {3, 0.6, 2.0, 2.0, 5.0, 0.1}};
  const std::vector<JetSlug> slugs = jet_slugs(monitor(), crossings);
  ASSERT_EQ(slugs.size(), 2u);
  EXPECT_DOUBLE_EQ(slugs[0].time, 0.25);
  EXPECT_DOUBLE_EQ(slugs[0].velocity, 5.0);
  EXPECT_DOUBLE_EQ(slugs[0].length, 2.5);
  EXPECT_DOUBLE_EQ(slugs[0].radius, 1.0 / std::sqrt(0.95));  // of the outer one, wider than solid
  const auto volume = [](const JetSlug& s) { return pi * s.radius * s.radius * s.length; };
  EXPECT_NEAR(slugs[0].density * volume(slugs[0]), 4.0, 1e-14);
  EXPECT_DOUBLE_EQ(slugs[1].density, 2.0);  // solid: wider than 95 % of it
  EXPECT_NEAR(2.0 * volume(slugs[1]), 2.0, 1e-14);
}

TEST(JetTable, AuditComparesTheTableWithWhatCrossed) {
  JetMonitorSpec quarter = monitor();
  quarter.copies = 4.0;
  const std::vector<JetCrossing> crossings = {
      {1, 0.1, 3.0, 4.0, 16.0, 0.5},
      {2, 0.4, 1.0, 8.0, 66.0, 1.0},
      {3, 0.6, 2.0, 1.0, 1.0, 0.1},    // slow
      {4, 0.6, 5.0, 9.0, 81.0, 3.5}};  // wide
  const JetAudit audit = audit_jet(quarter, crossings, jet_slugs(quarter, crossings));
  EXPECT_DOUBLE_EQ(audit.crossed.count, 2.0);
  EXPECT_DOUBLE_EQ(audit.crossed.mass, 16.0);
  EXPECT_DOUBLE_EQ(audit.crossed.momentum, 80.0);
  EXPECT_DOUBLE_EQ(audit.crossed.kinetic, 224.0);
  EXPECT_NEAR(audit.table.mass, 16.0, 1e-13);
  EXPECT_NEAR(audit.table.momentum, 80.0, 1e-13);
  EXPECT_NEAR(audit.slice_loss, 24.0 / 224.0, 1e-14);
  EXPECT_DOUBLE_EQ(audit.lateral, 4.0);
  EXPECT_DOUBLE_EQ(audit.largest_particle, 0.75);  // of those that are of the jet
  EXPECT_DOUBLE_EQ(audit.slow.mass, 8.0);
  EXPECT_DOUBLE_EQ(audit.wide.mass, 20.0);
}

TEST(JetTable, TheMonitorGoesOnFromItsNumbers) {
  RunNumbers kept;
  kept["jet_monitored_to"] = {0.7};
  kept["jet_crossings"] = {1.0, 0.1, 3.0, 4.0, 16.0, 0.5, 3.0, 0.6, 2.0, 2.0, 5.0, 0.1};
  const JetMonitor resumed(monitor(), kept);
  ASSERT_EQ(resumed.crossings().size(), 2u);
  EXPECT_EQ(resumed.crossings()[1].id, 3);
  EXPECT_EQ(resumed.numbers(), kept);
  EXPECT_TRUE(JetMonitor(JetMonitorSpec{}, {}).numbers().empty());
}

}  // namespace
}  // namespace barreno
