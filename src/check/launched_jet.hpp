// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// The slugs of a jet as JSON, SI: {"table": [slug, ...], "slugs": [slug, ...]}, as the deck has
/// them and as they are launched; a slug has time, velocity, radius, length, density and piece.
/// @throws DeckError  of a deck without a jet
std::string launched_jet_json(const Deck& deck, const Scene& scene);

}  // namespace barreno
