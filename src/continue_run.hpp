// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checkpoint/find_checkpoint.hpp"
#include "checkpoint/take_over.hpp"
#include "deck/deck.hpp"
#include "deck/sections/continue_section.hpp"
#include "scene/scene.hpp"

#include <Teuchos_RCP.hpp>

#include <optional>
#include <string>
#include <vector>

namespace barreno {

/// A finished run that a deck continues, found and compared with the deck, but not read yet.
struct Stage {
  ContinueSpec said;  ///< by the deck
  Checkpoint checkpoint;
  Scene run;
  Succession succession;
  Origin origin;
};

/// The run that a deck continues; nothing if it continues none. Collective.
/// @throws DeckError  if the deck does not fit the run, or the run has not finished
/// @throws FileError  if the run's folder has no whole checkpoint
std::optional<Stage> find_stage(
    const Deck& deck, const Scene& scene, const Teuchos::RCP<const Comm>& comm
);

/// What the plan of the deck says of it.
std::string stage_note(const Stage& stage);

/// Fills the bodies of the deck with the particles of that run. Collective.
/// @param state  as build_empty_state made it
/// @throws DeckError  if particles are wider than cells, or a body gets none
/// @throws FileError  if a table of the checkpoint cannot be
Continued start_from_run(const Stage& stage, const Deck& deck, const Scene& scene, State& state);

/// Ids of all particles, in ascending order.
std::vector<IdRange> ids_in_order(const Continued& continued);

}  // namespace barreno
