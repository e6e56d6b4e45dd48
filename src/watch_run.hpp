// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/state.hpp"

#include <string>

namespace barreno {

/// What a run that goes wrong without any bad particle is told by: time that stands still, energy
/// that nothing put in.
struct RunWatch {
  double max_energy_input = 0.0;  ///< energy, the most so far [energy]
  int standing = 0;               ///< steps in a row that the end time cannot tell from none
};

/// Look at the state after a step. Collective; the energies are looked at every `energy_interval`
/// steps and at the end, by one reduction.
///
/// Time stands where end time + dt == end time in ten steps in a row of which none grew by 1 %:
/// that many steps, 4e15 and more, are never done. Energy is wrong where
///
///   kinetic + |elastic| > 10 max over time of (initial + launched + prestress + |boundary| +
///   |body|
///   + |fluid| work)
///
/// @param last_dt  of the step before the last one [time]
/// @return what is wrong and what to do, a sentence; empty if nothing is
std::string watch_run(const Scene& scene, const State& state, double last_dt, RunWatch& watch);

inline constexpr int energy_interval = 50;  ///< steps

}  // namespace barreno
