// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_XMLObject.hpp>

#include <functional>
#include <string>

namespace barreno {

/// The list of a card. @param material  path of the material that names it
using ParsedCard =
    std::function<Teuchos::XMLObject(const std::string& card, const std::string& material)>;

/// Whether the jet's metal breaks, as far as a deck can be understood before it is read: values of
/// the deck go before those of the card.
bool jet_breaks(const Teuchos::XMLObject& root, const ParsedCard& parsed_card);

}  // namespace barreno
