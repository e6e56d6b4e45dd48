// SPDX-License-Identifier: BSD-3-Clause
#include "jet/table.hpp"

#include "base/numbers.hpp"
#include "files/text_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace barreno {
namespace {

/// Of a slug's mass that is within R.
constexpr double enclosed_share = 0.95;

bool is_wide(const JetMonitorSpec& monitor, const JetCrossing& one) {
  return monitor.largest_radius > 0.0 && one.radius > monitor.largest_radius;
}
bool is_slow(const JetMonitorSpec& monitor, const JetCrossing& one) {
  return one.speed <= monitor.smallest_speed;
}

void add(const JetMonitorSpec& monitor, const JetCrossing& one, JetSums& sums) {
  const double mass = monitor.copies * one.mass;
  sums.count += 1.0;
  sums.mass += mass;
  sums.momentum += mass * one.speed;
  sums.kinetic += 0.5 * mass * one.speed * one.speed;
}

/// The radius that encloses so much of the mass [length].
double enclosing_radius(std::vector<JetCrossing> slice, double share) {
  std::sort(slice.begin(), slice.end(), [](const JetCrossing& a, const JetCrossing& b) {
    return a.radius != b.radius ? a.radius < b.radius : a.id < b.id;
  });
  double mass = 0.0, sum = 0.0;
  for (const JetCrossing& one : slice) mass += one.mass;
  for (const JetCrossing& one : slice) {
    sum += one.mass;
    if (sum >= share * mass) return one.radius;
  }
  return slice.empty() ? 0.0 : slice.back().radius;
}

JetSlug slug_of(
    const JetMonitorSpec& monitor, long interval, const std::vector<JetCrossing>& slice
) {
  JetSums sums;
  for (const JetCrossing& one : slice) add(monitor, one, sums);
  JetSlug slug;
  slug.time = (static_cast<double>(interval) + 0.5) * monitor.interval;
  slug.velocity = sums.momentum / sums.mass;
  slug.length = slug.velocity * monitor.interval;
  const double solid = std::sqrt(sums.mass / (pi * monitor.density * slug.length));
  slug.radius =
      std::max(solid, enclosing_radius(slice, enclosed_share) / std::sqrt(enclosed_share));
  const double filled = solid / slug.radius;
  slug.density = std::min(monitor.density, monitor.density * filled * filled);
  return slug;
}

void add(const JetSlug& slug, JetSums& sums) {
  const double mass = slug.density * pi * slug.radius * slug.radius * slug.length;
  sums.count += 1.0;
  sums.mass += mass;
  sums.momentum += mass * slug.velocity;
  sums.kinetic += 0.5 * mass * slug.velocity * slug.velocity;
}

}  // namespace

std::vector<JetSlug> jet_slugs(
    const JetMonitorSpec& monitor, const std::vector<JetCrossing>& crossings
) {
  std::map<long, std::vector<JetCrossing>> slices;
  for (const JetCrossing& one : crossings)
    if (!is_slow(monitor, one) && !is_wide(monitor, one))
      slices[std::lround(std::floor(one.time / monitor.interval))].push_back(one);
  std::vector<JetSlug> slugs;
  slugs.reserve(slices.size());
  for (const auto& [interval, slice] : slices) slugs.push_back(slug_of(monitor, interval, slice));
  return slugs;
}

JetAudit audit_jet(
    const JetMonitorSpec& monitor,
    const std::vector<JetCrossing>& crossings,
    const std::vector<JetSlug>& slugs
) {
  JetAudit audit;
  for (const JetCrossing& one : crossings) {
    if (is_slow(monitor, one)) {
      add(monitor, one, audit.slow);
    } else if (is_wide(monitor, one)) {
      add(monitor, one, audit.wide);
    } else {
      add(monitor, one, audit.crossed);
      audit.largest_particle = std::max(audit.largest_particle, monitor.copies * one.mass);
      audit.lateral += 0.5 * monitor.copies * one.mass * (one.square - one.speed * one.speed);
    }
  }
  for (const JetSlug& slug : slugs) {
    add(slug, audit.table);
    audit.largest_void = std::max(audit.largest_void, 1.0 - slug.density / monitor.density);
  }
  if (audit.crossed.mass > 0.0) audit.largest_particle /= audit.crossed.mass;
  if (audit.crossed.kinetic > 0.0)
    audit.slice_loss = 1.0 - audit.table.kinetic / audit.crossed.kinetic;
  return audit;
}

std::string jet_table_text(const JetMonitorSpec& monitor, const std::vector<JetSlug>& slugs) {
  std::string text =
      "# units: SI\n# Formed jet through the plane y = " + to_text(monitor.position) +
      " m; a slug for each " + to_text(monitor.interval) +
      " s. Jet/Kind says what becomes of its voids.\n"
      "time,velocity,radius,length,density\n";
  for (const JetSlug& slug : slugs)
    text += csv_line({slug.time, slug.velocity, slug.radius, slug.length, slug.density}) + "\n";
  return text;
}

}  // namespace barreno
