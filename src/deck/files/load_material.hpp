// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <Teuchos_XMLObject.hpp>

#include <barreno/registry.hpp>
#include <string>
#include <vector>

namespace barreno {

/// A material by itself, without a deck, and what was assumed about its card.
struct LoadedMaterial {
  Material material;
  std::vector<std::string> notes;
};

/// What a card leaves to defaults that it should state, one sentence each.
/// @param name  of the card, for sentences
std::vector<std::string> assumptions_of(const Teuchos::XMLObject& card, const std::string& name);

/// The material of a card, which is searched like that of a deck in the working directory; every
/// "PARAMETER=value" replaces or adds one value of it, in the card's units unless it names its own.
///
/// Collective: rank 0 reads. Throws FileError, or DeckError with the parameter's nearest name.
LoadedMaterial load_material(
    const std::string& card, const std::vector<std::string>& overrides, const Comm& comm
);

}  // namespace barreno
