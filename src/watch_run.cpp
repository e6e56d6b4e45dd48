// SPDX-License-Identifier: BSD-3-Clause
#include "watch_run.hpp"

#include "base/gather.hpp"
#include "state/balance.hpp"
#include "state/ledger_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace barreno {
namespace {

constexpr double max_gain = 10.0;
constexpr int max_stalled_steps = 10;

/// Particle, material and speed of the fastest of all ranks; the first of equal ones.
struct Fastest {
  ParticleId id = 0;
  int material = 0;
  double speed = -1.0;
};

double speed_of(const Particles& particles, int p) {
  const Vector v = vector_of(particles.velocity, p);
  const double speed = std::hypot(v[0], v[1], v[2]);
  return std::isfinite(speed) ? speed : std::numeric_limits<double>::max();
}

Fastest find_fastest(const State& state) {
  Fastest mine;
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      const double speed = speed_of(particles, p);
      if (speed > mine.speed) mine = {particles.id(p), particles.material, speed};
    }
  constexpr double none = std::numeric_limits<double>::max();
  std::array<double, 1> top{mine.speed};
  max_over_ranks(*state.grid.comm, top);
  std::array<double, 1> first{mine.speed == top[0] ? static_cast<double>(mine.id) : none};
  min_over_ranks(*state.grid.comm, first);
  const bool here = static_cast<double>(mine.id) == first[0];
  std::array<double, 1> material{here ? mine.material : -1.0};
  max_over_ranks(*state.grid.comm, material);
  return {static_cast<ParticleId>(first[0]), static_cast<int>(material[0]), top[0]};
}

std::string fastest_words(const Scene& scene, const State& state) {
  const Fastest found = find_fastest(state);
  std::ostringstream text;
  if (found.material < 0) return "there is no particle";
  text << "the fastest particle is " << found.id << " of material '"
       << scene.materials[static_cast<std::size_t>(found.material)].name() << "', with "
       << found.speed << " m/s";
  return text.str();
}

std::string standing_sentence(const Scene& scene, const State& state) {
  std::ostringstream text;
  text << "Time has stalled at t = " << state.clock.time << " s, step " << state.clock.step
       << ": steps of dt = " << state.clock.dt << " s will never reach the end at "
       << scene.end_time << " s (" << fastest_words(scene, state)
       << "). Look for a velocity, stiffness or density in a wrong unit, or for a \"Largest Step\" "
          "that is too small.";
  return text.str();
}

bool time_stands(const Scene& scene, const Clock& clock, double last_dt, RunWatch& watch) {
  const bool tiny = scene.end_time + clock.dt == scene.end_time && !(clock.dt > 1.01 * last_dt);
  watch.standing = tiny ? watch.standing + 1 : 0;
  return watch.standing >= max_stalled_steps;
}

/// Energies now, and the energy supplied, of all ranks.
struct Energies {
  double kinetic = 0.0, elastic = 0.0, supplied = 0.0;
};

Energies sum_energies(const State& state) {
  const Ledger l = sum_over_ranks(*state.grid.comm, state.ledger);
  const double put_in = energy_balance(l).put_in;
  const double supplied = add_magnitudes(l, Conserved::energy, Part::exchanged, put_in);
  return {l.kinetic, l.elastic, supplied};
}

/// What makes steps stable, without what the run does already. Returned losses come first: sprays
/// of metal that failed with them were stable without, and those need Order stress last.
std::string stability_advice(const Scene& scene) {
  const StepSpec& step = scene.step;
  std::string text;
  const auto advise = [&](bool applies, const std::string& words) {
    if (applies) text += (text.empty() ? "" : ", or ") + words;
  };
  advise(step.return_losses, "set \"Return Losses\" to false");
  advise(
      !step.stable_alone && !step.return_losses,
      "set \"Stable Alone\" if particles fly in isolation"
  );
  advise(true, "halve the \"Courant Fraction\"");
  advise(
      step.order == Order::stress_last && !step.return_losses,
      "set \"Order\" to modified stress last"
  );
  advise(true, "set \"Bad Particles\" to remove with a smaller \"Largest Expansion\"");
  return text;
}

std::string gain_sentence(
    const Scene& scene, const State& state, const Energies& energies, double max_energy_input
) {
  std::ostringstream text;
  text << "The particles have more than " << max_gain
       << " times the energy supplied at t = " << state.clock.time << " s, step "
       << state.clock.step << ", dt = " << state.clock.dt << " s: " << energies.kinetic
       << " J kinetic and " << energies.elastic << " J elastic of " << max_energy_input << " J ("
       << fastest_words(scene, state) << "). The steps are unstable: " << stability_advice(scene)
       << ".";
  return text.str();
}

}  // namespace

std::string watch_run(const Scene& scene, const State& state, double last_dt, RunWatch& watch) {
  const Clock& clock = state.clock;
  if (time_stands(scene, clock, last_dt, watch)) return standing_sentence(scene, state);
  if (clock.step % energy_interval != 0 && clock.time < scene.end_time) return {};
  const Energies energies = sum_energies(state);
  watch.max_energy_input = std::max(watch.max_energy_input, energies.supplied);
  // Neither compensates for the other, and values that are not finite are wrong too.
  const double energy = energies.kinetic + std::abs(energies.elastic);
  if (energy <= max_gain * watch.max_energy_input) return {};
  // What moves the grid strains the material in a first step; its force does work from the next one
  // on.
  if (clock.step == 1 && energies.supplied == 0.0 && std::isfinite(energy)) return {};
  return gain_sentence(scene, state, energies, watch.max_energy_input);
}

}  // namespace barreno
