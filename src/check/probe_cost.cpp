// SPDX-License-Identifier: BSD-3-Clause
#include "check/probe_cost.hpp"

#include "base/process.hpp"
#include "base/region.hpp"
#include "base/work_counts.hpp"
#include "scene/build_scene.hpp"
#include "scene/tile_levels.hpp"
#include "state/build_state.hpp"
#include "step/advance.hpp"
#include "step/stable_step.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace barreno {
namespace {

constexpr double max_particles = 20000.0;
constexpr double enough_seconds = 0.04;
constexpr int warm_up = 2, max_steps = 40;
constexpr std::size_t fewest_steps = 4;

/// The scene with cells so large that it has few particles; the box grows to whole cells.
Scene probed_scene(const Scene& scene) {
  Scene probed = scene;
  probed.grid = uniform_grid(scene.grid, 0);  // a particle costs the same in cells of any size
  probed.pore_flow = {};
  probed.step.skip_dormant = false;  // nearly all is at rest in the first steps
  probed.step.subcycles = 1;         // of those that are left, each costs the same
  const int d = dimensions(scene.grid.mode);
  Scene bodies = probed;
  bodies.jet.slugs.clear();
  const double particles = particle_estimate(bodies);
  if (particles <= max_particles) return probed;
  const double factor = std::ceil(std::pow(particles / max_particles, 1.0 / d));
  const double h = probed.grid.cell_size *= factor;
  for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
    const double lower = scene.grid.lower[i];
    probed.grid.upper[i] = lower + h * std::ceil((scene.grid.upper[i] - lower) / h - 1e-9);
  }
  return probed;
}

double moving_particles(const State& state) {
  double count = 0.0;
  for (const Particles& particles : state.particles)
    if (!particles.rigid) count += particles.count;
  return count;
}

/// What a step takes without what else the machine does: that only makes steps longer.
double usual(std::vector<double>& seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 4];
}

/// Whether the verb holds others: its time is theirs.
bool is_whole(const PhaseTime& phase) {
  return std::string(phase.label) == "advance";
}

}  // namespace

Probe probe_cost(const Scene& scene) {
  Probe probe;
  probe.program_bytes = peak_resident_bytes();
  const Scene probed = probed_scene(scene);
  const double smallest = smallest_cell(scene.grid);
  const WorkCounts counted = work_counts();
  State state = build_state(probed, Teuchos::rcp(new Teuchos::SerialComm<int>));
  work_counts() = counted;  // a probe has few particles in a run of any size
  for (const Particles& particles : state.particles)
    state.stable_step =
        std::min(state.stable_step, stable_step_of_rows(probed.step, state.grid, particles, 0));
  std::vector<double> seconds;
  std::map<std::string, std::vector<double>> verbs;
  const double start = cpu_seconds();
  for (int i = 0; i < warm_up + max_steps && state.clock.time < probed.end_time; ++i) {
    clear_phase_times();
    const double before = cpu_seconds();
    if (advance(probed, probed.end_time, state).stopped) break;
    if (i < warm_up) continue;
    seconds.push_back(cpu_seconds() - before);
    for (const PhaseTime& phase : phase_times())
      if (!is_whole(phase)) verbs[phase.name].push_back(phase.seconds);
    // A jet's first touch shortens the step for a moment only.
    probe.dt = std::max(probe.dt, state.clock.dt * smallest / probed.grid.cell_size);
    if (seconds.size() > fewest_steps && cpu_seconds() - start > enough_seconds) break;
  }
  clear_phase_times();
  if (seconds.empty()) return probe;
  double total = 0.0;
  for (auto& [name, times] : verbs) total += usual(times);
  for (auto& [name, times] : verbs) probe.shares.emplace_back(name, usual(times) / total);
  probe.seconds = usual(seconds);
  probe.particles = moving_particles(state);
  return probe;
}

double share_of(const Probe& probe, const std::string& verb) {
  double share = 0.0;
  for (const auto& [name, part] : probe.shares)
    if (name.compare(0, verb.size(), verb) == 0) share += part;
  return share;
}

}  // namespace barreno
