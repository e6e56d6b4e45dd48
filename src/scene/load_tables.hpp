// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Pressure or Times and Pressures of the list at `path`. @throws DeckError unless one of them is
/// there
Table read_pressure(const Deck& deck, const std::string& path);

/// The list at `path` says Pressure, Times or Pressures.
bool has_pressure(const Deck& deck, const std::string& path);

/// Times and Factors of the list at `path`; 1 without them. @throws DeckError
/// @param of  what stands before both names: "", "Motion "
Table read_factors(const Deck& deck, const std::string& path, const std::string& of);

}  // namespace barreno
