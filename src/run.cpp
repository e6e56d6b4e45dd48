// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/interrupt.hpp"
#include "step/advance.hpp"
#include "step/order/remove_lost.hpp"
#include "step/stable_step.hpp"
#include "watch_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace barreno {
namespace {

/// What went wrong with the particle that stopped the run, by its cause.
constexpr std::array<const char*, removal_causes> what_failed{
    "left the grid",
    "has a position or velocity that is not a finite number",
    "failed in its stress update",
    "expanded beyond \"Largest Expansion\"",
    "was inverted or flattened by its deformation"};

/// Its cause, known to the rank that holds it and told to all.
int failure_cause(const State& state, const StepResult& result) {
  std::array<double, 1> cause{-1.0};
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      if (particles.id(p) == result.failed && particles.material == result.material)
        cause[0] = RemovalRule(state.grid, particles).cause_of(p);
  max_over_ranks(*state.grid.comm, cause);
  return static_cast<int>(cause[0]);
}

/// The verdict on a run that ends before its time for no fault of the computation, behind a
/// checkpoint of its step if the disk takes one.
/// @param fault  why files could not be written; empty: a signal came
RunVerdict cut_off(
    const std::string& fault, int signal, State& state, Output& output, Checkpoints& checkpoints
) {
  std::array<double, 1> received{static_cast<double>(std::max(signal, received_signal()))};
  max_over_ranks(*state.grid.comm, received);
  signal = static_cast<int>(received[0]);
  RunVerdict verdict;
  verdict.exit_code = signal != 0 ? 128 + signal : static_cast<int>(ExitCode::file);
  verdict.files_failed = !fault.empty();
  verdict.may_be_resumed = true;
  if (!fault.empty()) output.give_up_files();
  const std::string lost = checkpoints.write_last(output, state);
  verdict.reason = fault.empty() ? "The run was interrupted by " + signal_name(signal) : fault;
  if (lost.empty())
    verdict.reason += fault.empty() ? "; the checkpoint was written at this step."
                                    : " The checkpoint was written at this step.";
  else
    verdict.reason +=
        fault.empty() ? "; " + lost : " No checkpoint of this step could be written either.";
  return verdict;
}

/// The verdict on a run that has reached its end. A run whose last checkpoint is lost has not
/// finished: nobody could prolong it, and its folder belongs to an older step.
RunVerdict end_run(State& state, Output& output, Checkpoints& checkpoints) {
  const std::string lost = checkpoints.write_last(output, state);
  RunVerdict verdict;
  verdict.at_rest = output.at_rest();
  verdict.finished = lost.empty();
  if (verdict.finished) return verdict;
  verdict.exit_code = static_cast<int>(ExitCode::file);
  verdict.files_failed = true;
  verdict.may_be_resumed = true;
  verdict.reason = "The run reached its end, but its last checkpoint is lost: " + lost;
  return verdict;
}

/// What is due. @return why a file could not be written; empty: all were
std::string write_output(const Scene& scene, const State& state, Output& output) {
  try {
    output.write_if_due(scene, state);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

bool has_finite_stress(const Particles& particles, int p) {
  double sum = 0.0;
  for (int c = 0; c < particles.stress.components; ++c) sum += particles.stress(p, c);
  return std::isfinite(sum);
}

/// A particle by its id and material; id -1: none.
struct Named {
  ParticleId id = -1;
  int material = -1;
};

/// The first particle of all ranks whose stress was not finite before the step: it has kept it, and
/// what failed around it had its forces.
Named find_source(const State& state) {
  constexpr double none = std::numeric_limits<double>::max();
  Named mine;
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      if (!has_finite_stress(particles, p) && (mine.id < 0 || particles.id(p) < mine.id))
        mine = {particles.id(p), particles.material};
  std::array<double, 1> first{mine.id < 0 ? none : static_cast<double>(mine.id)};
  min_over_ranks(*state.grid.comm, first);
  if (first[0] == none) return {};
  const bool here = static_cast<double>(mine.id) == first[0];
  std::array<double, 1> material{here ? mine.material : -1.0};
  max_over_ranks(*state.grid.comm, material);
  return {static_cast<ParticleId>(first[0]), static_cast<int>(material[0])};
}

}  // namespace

std::string failure_sentence(const Scene& scene, const State& state, const StepResult& result) {
  const int cause = failure_cause(state, result);
  const int failed = static_cast<int>(RemovalCause::material_failure);
  const char* words = what_failed[static_cast<std::size_t>(cause < 0 ? failed : cause)];
  Named named{result.failed, result.material};
  if (const Named source = find_source(state); source.id >= 0) {
    named = source;
    words = "has a stress that is not a finite number";
  }
  std::ostringstream text;
  text << "Particle " << named.id << " of material '"
       << scene.materials[static_cast<std::size_t>(named.material)].name() << "' " << words
       << " at t = " << state.clock.time << " s, dt = " << state.clock.dt
       << " s, and its policy is to stop. Set its \"Bad Particles\" to remove or hold, or take a "
          "smaller \"Courant Fraction\".";
  return text.str();
}

RunVerdict run(const Scene& scene, State& state, Output& output, Checkpoints& checkpoints) {
  if (state.clock.step == 0)
    for (Particles& particles : state.particles) {
      particles.stable_step = stable_step_of_rows(scene.step, state.grid, particles, 0);
      state.stable_step = std::min(state.stable_step, particles.stable_step);
    }
  int interrupt = 0;
  RunWatch watch;
  // A step whose rows a checkpoint would not keep is no end.
  while (state.clock.time < scene.end_time && !(output.at_rest() && Checkpoints::may_write(state))
  ) {
    const double last_dt = state.clock.dt;
    const StepResult result = advance(scene, output.next_time(state.clock.time), state);
    if (result.stopped)
      return {false, failure_sentence(scene, state, result), static_cast<int>(ExitCode::numerical)};
    if (!result.not_drained.empty())
      return {false, result.not_drained, static_cast<int>(ExitCode::numerical)};
    const std::string wrong = watch_run(scene, state, last_dt, watch);
    if (!wrong.empty()) return {false, wrong, static_cast<int>(ExitCode::numerical)};
    const std::string fault = write_output(scene, state, output);
    interrupt = std::max(interrupt, result.interrupt);
    if (!fault.empty() || (interrupt != 0 && Checkpoints::may_write(state)))
      return cut_off(fault, interrupt, state, output, checkpoints);
    checkpoints.write_if_due(output, state);
  }
  return end_run(state, output, checkpoints);
}

int run_to_end(
    const Scene& scene, State& state, Output& output, const RunDescription& description
) {
  Checkpoints checkpoints(scene, description);
  const RunVerdict verdict = run(scene, state, output, checkpoints);
  output.finish(scene, state, verdict);
  return verdict.exit_code;
}

}  // namespace barreno
