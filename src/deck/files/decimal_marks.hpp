// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/files/table_text.hpp"

namespace barreno {

/// Finds which mark is the decimal one in the numbers of a table, and writes them with a point and
/// without marks between thousands. A comment "# decimal: comma" or "# decimal: point" decides.
/// @throws DeckError where the numbers contradict each other, or leave it open: "1,234"
void put_decimal_points(TableText& table, const std::string& source);

}  // namespace barreno
