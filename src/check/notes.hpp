// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What the user should know of deck and scene besides errors, a sentence each.
std::vector<std::string> notes_of(const Deck& deck, const Scene& scene);

}  // namespace barreno
