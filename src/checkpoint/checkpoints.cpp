// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/checkpoints.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "step/ranks/place_particles.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace barreno {
namespace {

/// Only rank 0's clock counts, and it is asked now and then.
constexpr long steps_per_look = 16;

/// What a run that begins with the checkpoint would not have.
void forget_scratch(State& state) {
  for (Particles& particles : state.particles) particles.sorted = false;
  state.pore_flow.network.reset();
}

}  // namespace

Checkpoints::Checkpoints(const Scene& scene, const RunDescription& run)
    : spec_(scene.output.checkpoint),
      folder_(run.folder),
      deck_text_(run.deck_text),
      continued_(run.continued) {}

bool Checkpoints::may_write(const State& state) {
  return state.clock.step % steps_per_permutation != 0;
}

/// Whether more of an interval has passed; 0 stands for never.
bool Checkpoints::is_due(const State& state) {
  const Clock& clock = state.clock;
  if (spec_.steps > 0 && clock.step - last_step_ >= spec_.steps) return true;
  if (spec_.interval > 0.0 && clock.time - last_time_ >= spec_.interval) return true;
  if (!(spec_.wall_interval > 0.0) || clock.step % steps_per_look != 1) return false;
  int due = watch_.seconds() >= spec_.wall_interval ? 1 : 0;
  Teuchos::broadcast<int, int>(*state.grid.comm, 0, 1, &due);
  return due == 1;
}

void Checkpoints::write_if_due(Output& output, State& state) {
  if (last_step_ < 0) {
    last_step_ = state.clock.step - 1;
    last_time_ = state.clock.begin;
  }
  if (is_due(state) && may_write(state)) write(output, state);
}

void Checkpoints::write(Output& output, State& state) {
  const std::string fault = write_last(output, state);
  if (!fault.empty()) output.warn("checkpoints that could not be written", fault);
}

std::string Checkpoints::write_last(Output& output, State& state) {
  last_step_ = state.clock.step;
  last_time_ = state.clock.time;
  watch_ = {};
  try {
    write_checkpoint(folder_, deck_text_, output.position(), state, continued_);
  } catch (const FileError& error) {
    return error.what();
  }
  forget_scratch(state);
  return {};
}

}  // namespace barreno
