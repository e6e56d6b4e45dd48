// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <barreno/models.hpp>
#include <string>
#include <vector>

namespace barreno {

/// A material by itself, without a deck, and what was assumed about its card.
struct LoadedMaterial {
  Material material;
  std::vector<std::string> notes;
};

/// The material of a card, which is searched like that of a deck in the working directory; every
/// "PARAMETER=value" replaces or adds one value of it, in the card's units unless it names its own.
///
/// Collective: rank 0 reads. Throws FileError, or DeckError with the parameter's nearest name.
LoadedMaterial load_material(
    const std::string& card, const std::vector<std::string>& overrides, const Comm& comm
);

}  // namespace barreno
