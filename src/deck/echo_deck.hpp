// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"

#include <Teuchos_ParameterEntry.hpp>

#include <string>

namespace barreno {

/// The deck that was really run: every value in SI, defaults and cards and jet table included,
/// without reference to another file. Numbers are written so that reading gives the same doubles.
std::string effective_deck_xml(const Deck& deck);

/// A value as it is written in a deck.
std::string value_text(const Teuchos::ParameterEntry& entry);

}  // namespace barreno
