// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "base/error.hpp"
#include "step/advance.hpp"
#include "step/place_particles.hpp"
#include "step/stable_step.hpp"

#include <algorithm>
#include <sstream>

namespace barreno {
namespace {

std::string failure_sentence(const Scene& scene, const State& state, const StepResult& result) {
  std::ostringstream text;
  text << "Particle " << result.failed << " of material '"
       << scene.materials[static_cast<std::size_t>(result.material)].material.name
       << "' failed in its stress update at t = " << state.clock.time
       << " s, dt = " << state.clock.dt
       << " s, and its policy is to stop. Set its \"Bad Particles\" to remove or hold, or take a "
          "smaller "
          "\"Courant Fraction\".";
  return text.str();
}

}  // namespace

RunVerdict run(const Scene& scene, State& state, Output& output) {
  for (const Particles& particles : state.particles)
    state.stable_step = std::min(state.stable_step, stable_step_of_rows(scene, particles, 0));
  while (state.clock.time < scene.end_time) {
    const StepResult result = advance(scene, output.next_time(state.clock.time), state);
    if (result.stopped)
      return {false, failure_sentence(scene, state, result), static_cast<int>(ExitCode::numerical)};
    if (result.interrupt != 0)
      return {
          false,
          "The run was interrupted by a signal and ended after its step.",
          128 + result.interrupt};
    output.write_if_due(scene, state);
  }
  return {true, "", static_cast<int>(ExitCode::finished)};
}

}  // namespace barreno
