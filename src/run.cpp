// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "step/advance.hpp"
#include "step/place_particles.hpp"
#include "step/stable_step.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace barreno {
namespace {

/// What went wrong with the particle that stopped the run, by its cause.
constexpr std::array<const char*, removal_causes> what_failed{
    "left the grid",
    "moved to a place or with a velocity that is no number",
    "failed in its stress update",
    "expanded beyond \"Largest Expansion\"",
    "was turned inside out or flat by its deformation"};

/// Its cause, known to the rank that holds it and told to all.
int failure_cause(const State& state, const StepResult& result) {
  std::array<double, 1> cause{-1.0};
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      if (particles.id(p) == result.failed && particles.material == result.material)
        cause[0] = removal_cause(state.grid, particles, p);
  max_over_ranks(*state.grid.comm, cause);
  return static_cast<int>(cause[0]);
}

RunVerdict interrupted(int signal, bool kept) {
  return {
      false,
      kept ? "The run was interrupted by a signal; its checkpoint is of this step."
           : "The run was interrupted by a signal, and no checkpoint could be written.",
      128 + signal};
}

}  // namespace

std::string failure_sentence(const Scene& scene, const State& state, const StepResult& result) {
  const int cause = failure_cause(state, result);
  const int failed = static_cast<int>(RemovalCause::material_failure);
  std::ostringstream text;
  text << "Particle " << result.failed << " of material '"
       << scene.materials[static_cast<std::size_t>(result.material)].material.name << "' "
       << what_failed[static_cast<std::size_t>(cause < 0 ? failed : cause)]
       << " at t = " << state.clock.time << " s, dt = " << state.clock.dt
       << " s, and its policy is to stop. Set its \"Bad Particles\" to remove or hold, or take a "
          "smaller \"Courant Fraction\".";
  return text.str();
}

RunVerdict run(const Scene& scene, State& state, Output& output, Checkpoints& checkpoints) {
  for (const Particles& particles : state.particles)
    state.stable_step = std::min(state.stable_step, stable_step_of_rows(scene, particles, 0));
  int interrupt = 0;
  while (state.clock.time < scene.end_time) {
    const StepResult result = advance(scene, output.next_time(state.clock.time), state);
    if (result.stopped)
      return {false, failure_sentence(scene, state, result), static_cast<int>(ExitCode::numerical)};
    if (!result.not_drained.empty())
      return {false, result.not_drained, static_cast<int>(ExitCode::numerical)};
    output.write_if_due(scene, state);
    interrupt = std::max(interrupt, result.interrupt);
    if (interrupt != 0 && Checkpoints::may_write(state))
      return interrupted(interrupt, checkpoints.write(output, state));
    checkpoints.write_if_due(output, state);
  }
  checkpoints.write(output, state);
  return {true, "", static_cast<int>(ExitCode::finished)};
}

}  // namespace barreno
