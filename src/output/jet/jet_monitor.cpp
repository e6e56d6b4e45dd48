// SPDX-License-Identifier: BSD-3-Clause
#include "output/jet/jet_monitor.hpp"

#include "base/region.hpp"
#include "output/particle_fields.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr double looks_per_interval = 8.0;
/// Numbers of a crossing in a checkpoint and between ranks.
constexpr std::size_t numbers_each = 6;
constexpr const char* crossings_name = "jet_crossings";
constexpr const char* look_name = "jet_monitored_to";

void append(const JetCrossing& one, std::vector<double>& numbers) {
  numbers.insert(
      numbers.end(),
      {static_cast<double>(one.id), one.time, one.mass, one.speed, one.square, one.radius}
  );
}

JetCrossing crossing_at(const std::vector<double>& numbers, std::size_t i) {
  return {
      static_cast<ParticleId>(numbers[i]),
      numbers[i + 1],
      numbers[i + 2],
      numbers[i + 3],
      numbers[i + 4],
      numbers[i + 5]};
}

bool earlier(const JetCrossing& a, const JetCrossing& b) {
  return a.time != b.time ? a.time < b.time : a.id < b.id;
}

/// A particle that is `beyond` the plane now; it crossed after the last look.
JetCrossing crossing_of(const HostParticles& particles, int p, double beyond, double direction) {
  JetCrossing one;
  one.id = particles.id(p);
  one.mass = particles.mass(p, 0);
  one.speed = direction * particles.velocity(p, 1);
  for (int d = 0; d < particles.dimensions(); ++d)
    one.square += particles.velocity(p, d) * particles.velocity(p, d);
  const double z = particles.dimensions() == 3 ? particles.position(p, 2) : 0.0;
  one.radius = std::hypot(particles.position(p, 0), z);
  one.time = one.speed > 0.0 ? -beyond / one.speed : 0.0;  // from now on
  return one;
}

/// Those of this rank that are beyond the plane, their times counted from `clock.time`.
std::vector<double> particles_beyond(const JetMonitorSpec& monitor, const State& state) {
  std::vector<double> numbers;
  for (const Particles& set : state.particles) {
    const HostParticles particles(set);
    for (int p = 0; p < particles.count; ++p) {
      const double beyond = monitor.direction * (particles.position(p, 1) - monitor.position);
      if (!(beyond > 0.0)) continue;
      const int body = particles.body(p) & ~debris_bit;
      if (std::find(monitor.bodies.begin(), monitor.bodies.end(), body) == monitor.bodies.end())
        continue;
      append(crossing_of(particles, p, beyond, monitor.direction), numbers);
    }
  }
  return numbers;
}

}  // namespace

JetMonitor::JetMonitor(const JetMonitorSpec& monitor, const RunNumbers& position)
    : monitor_(monitor), looks_(monitor.interval / looks_per_interval) {
  const auto kept = position.find(crossings_name);
  if (kept == position.end()) return;
  last_ = number_of(position, look_name);
  looks_.done(last_);
  for (std::size_t i = 0; i + numbers_each <= kept->second.size(); i += numbers_each) {
    crossings_.push_back(crossing_at(kept->second, i));
    known_.insert(crossings_.back().id);
  }
}

void JetMonitor::watch_if_due(const State& state) {
  if (!on() || !looks_.due(state.clock.time)) return;
  watch(state);
  looks_.done(state.clock.time);
}

void JetMonitor::watch(const State& state) {
  const Region region("monitor_jet");
  const Comm& comm = *state.grid.comm;
  const std::vector<double> numbers = gather_to_root(comm, particles_beyond(monitor_, state));
  const double now = state.clock.time;
  if (is_root(comm)) {
    std::vector<JetCrossing> beyond;
    for (std::size_t i = 0; i < numbers.size(); i += numbers_each)
      beyond.push_back(crossing_at(numbers, i));
    std::sort(beyond.begin(), beyond.end(), [](const JetCrossing& a, const JetCrossing& b) {
      return a.id < b.id;
    });
    mass_beyond_ = 0.0;
    for (JetCrossing& one : beyond) {
      mass_beyond_ += monitor_.copies * one.mass;
      if (!known_.insert(one.id).second) continue;
      one.time = std::max(last_, now + one.time);
      crossings_.push_back(one);
    }
    std::sort(crossings_.begin(), crossings_.end(), earlier);
  }
  last_ = now;
}

RunNumbers JetMonitor::numbers() const {
  if (!on()) return {};
  std::vector<double> all;
  for (const JetCrossing& one : crossings_) append(one, all);
  return {{look_name, {last_}}, {crossings_name, all}};
}

}  // namespace barreno
