// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_TwoDArray.hpp>

#include <string>
#include <vector>

namespace barreno {

/// A jet table's text in SI: a row per slug, columns time, velocity, radius, length, density.
///
/// '#' starts a comment; a comment "# units: mm-us-g" names the system of the plain numbers
/// (default SI). The first other line is the header. Throws DeckError with the line's number.
/// @param notes  what was guessed of the table, a sentence each
Teuchos::TwoDArray<double> read_jet_table(
    const std::string& text, const std::string& source, std::vector<std::string>* notes = nullptr
);

}  // namespace barreno
