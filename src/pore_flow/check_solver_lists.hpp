// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "deck/deck.hpp"
#include "scene/scene.hpp"

namespace barreno {

/// Asks the packages what they think of the deck's Belos, Ifpack2 and MueLu lists: Belos by the
/// names that it knows, the others by setting them up for a small matrix.
/// @throws DeckError if one of them does not know a name or a value
void check_solver_lists(const Deck& deck, const Scene& scene, const Comm& comm);

}  // namespace barreno
