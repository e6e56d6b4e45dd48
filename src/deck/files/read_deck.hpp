// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"

#include <Teuchos_Comm.hpp>

#include <string>
#include <vector>

namespace barreno {

/// Read, scan and check a deck, with its cards and its jet table. Collective: rank 0 reads the
/// files, every rank receives their text and parses it, so that all ranks agree on values and on
/// errors.
/// @param overrides  "Sub List/Parameter=value" each, applied before anything is checked
/// @throws DeckError, FileError  with one sentence, the same on every rank
Deck read_deck(
    const std::string& file,
    const std::vector<std::string>& overrides,
    const Teuchos::Comm<int>& comm
);

}  // namespace barreno
