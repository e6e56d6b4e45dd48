// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/bodies/body_census.hpp"
#include "state/continued.hpp"
#include "state/state.hpp"

#include <string>
#include <vector>

namespace barreno {

/// How the bodies of a finished run belong to those of a deck that continues it.
struct Succession {
  std::vector<int> body_of;  ///< by body of the run, its jet last: body of the deck; -1: none
  std::vector<bool> same_material;  ///< by body of the deck: its material has the same numbers
  bool at_rest = false;             ///< velocities become zero
};

/// Where the particles of a run were made: the scene of its deck, or of the deck of the first run
/// where one run has continued another.
struct Origin {
  Scene scene;
  BodyCensus census;
};

/// Moves the particles of a run into an empty state of another scene (build_empty_state), each to
/// the rank that owns its tile there: place, size, mass, volume, deformation, stress and history
/// stay, bit for bit. Steps, time, ledger and pore flow start anew. Masses follow the reference
/// density of the deck's material, so that strains stay too. Particles outside of the grid, and
/// those that the run was about to remove, are left. The same on any ranks. Collective.
///
/// @param run     its scene, and `ended` its state at its end, which is emptied
/// @param ids     that particles of the run have, by body of the run, its jet last
/// @return what was taken and left
Continued take_over(
    const Scene& run,
    State& ended,
    const std::vector<IdRange>& ids,
    const Succession& succession,
    const Scene& scene,
    State& state
);

/// Loads of the scene on particles that were taken over: faces and surfaces are those of the bodies
/// as they were made.
void put_loads_on_taken(const Origin& origin, const Scene& scene, State& state);

}  // namespace barreno
