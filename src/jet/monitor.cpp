// SPDX-License-Identifier: BSD-3-Clause
#include "jet/monitor.hpp"

#include "base/region.hpp"
#include "state/host_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace barreno {
namespace {

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

bool is_monitored(const JetMonitorSpec& monitor, int body) {
  const int whole = body & ~debris_bit;
  return std::find(monitor.bodies.begin(), monitor.bodies.end(), whole) != monitor.bodies.end();
}

/// visit(particles, row, how far beyond the plane) for those of this rank that are beyond it.
template <class Visit>
void for_each_beyond(const JetMonitorSpec& monitor, const State& state, Visit&& visit) {
  for (const Particles& set : state.particles) {
    const HostParticles particles(set);
    for (int p = 0; p < particles.count; ++p) {
      const double beyond = monitor.direction * (particles.position(p, 1) - monitor.position);
      if (beyond > 0.0 && is_monitored(monitor, particles.body(p))) visit(particles, p, beyond);
    }
  }
}

}  // namespace

JetMonitor::JetMonitor(const JetMonitorSpec& monitor, const RunNumbers& position)
    : monitor_(monitor) {
  const auto kept = position.find(crossings_name);
  if (kept == position.end()) return;
  last_ = number_of(position, look_name);
  for (std::size_t i = 0; i + numbers_each <= kept->second.size(); i += numbers_each) {
    crossings_.push_back(crossing_at(kept->second, i));
    known_.insert(crossings_.back().id);
  }
}

void JetMonitor::watch(const State& state) {
  if (!on()) return;
  const Region region("monitor_jet");
  std::vector<double> numbers;  // of those that this rank has not told of
  for_each_beyond(monitor_, state, [&](const HostParticles& particles, int p, double beyond) {
    if (told_.insert(particles.id(p)).second)
      append(crossing_of(particles, p, beyond, monitor_.direction), numbers);
  });
  const double now = state.clock.time;
  const std::vector<double> all = gather_to_root(*state.grid.comm, numbers);
  if (!all.empty()) note(all, now);
  last_ = now;
}

void JetMonitor::note(const std::vector<double>& numbers, double now) {
  for (std::size_t i = 0; i < numbers.size(); i += numbers_each) {
    JetCrossing one = crossing_at(numbers, i);
    if (!known_.insert(one.id).second) continue;  // another rank had it before
    one.time = std::max(last_, now + one.time);
    crossings_.push_back(one);
  }
  std::sort(crossings_.begin(), crossings_.end(), earlier);
}

double JetMonitor::mass_beyond(const State& state) const {
  ReproducibleSum mass;
  for_each_beyond(monitor_, state, [&](const HostParticles& particles, int p, double) {
    mass += monitor_.copies * particles.mass(p, 0);
  });
  std::array<ReproducibleSum, 1> sum{mass};
  sum_over_ranks(*state.grid.comm, sum);
  return sum[0].value();
}

RunNumbers JetMonitor::numbers() const {
  if (!on()) return {};
  std::vector<double> all;
  for (const JetCrossing& one : crossings_) append(one, all);
  return {{look_name, {last_}}, {crossings_name, all}};
}

}  // namespace barreno
