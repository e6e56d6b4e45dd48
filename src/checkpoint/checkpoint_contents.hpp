// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/run_numbers.hpp"
#include "state/state.hpp"

#include <string>

namespace barreno {

/// The group of a checkpoint that holds a material's particles.
inline std::string particle_group(const Particles& particles) {
  return "particles/" + std::to_string(particles.material) + "/";
}

/// Tiles take steps of several lengths, which fields tell (output.md); else none are kept.
inline bool has_tile_steps(const State& state) {
  return state.subcycling.most > 1;
}

/// visit(name, number) for all of a state's numbers that are the same on every rank: a checkpoint
/// writes and reads this one list.
/// @param state  a State to be changed, or a const one
template <class AnyState, class Visitor>
void for_each_number(AnyState& state, Visitor&& visit) {
  visit("time", state.clock.time);
  visit("dt", state.clock.dt);
  visit("step", state.clock.step);
  visit("begin", state.clock.begin);
  visit("next_slug", state.jet.next_slug);
  visit("retried_steps", state.ledger.retried_steps);
  visit("pore_flow_waiting", state.pore_flow.waiting);
  visit("pore_flow_interval", state.pore_flow.interval);
  visit("pore_flow_inflow", state.pore_flow.inflow);
  visit("pore_flow_removed", state.pore_flow.removed);
  visit("pore_flow_fluid", state.pore_flow.fluid);
  visit("pore_flow_initial_fluid", state.pore_flow.initial_fluid);
  visit("pore_flow_solves", state.pore_flow.solves);
  visit("pore_flow_iterations", state.pore_flow.iterations);
}

}  // namespace barreno
