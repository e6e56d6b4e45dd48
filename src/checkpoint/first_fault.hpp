// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace barreno {

/// Leaves with what is wrong in a row of a table.
struct WrongTable {
  std::string words;
  std::size_t row = 0;
};

/// Says that a table has a value in a row that cannot be there. @throws WrongTable
[[noreturn]] void refuse_value(const std::string& name, std::size_t row, double value);

/// Runs a rank's part of a check that all ranks share. If any leaves with a WrongTable or a
/// FileError, all do: with that of the lowest row, or the lowest of ranks that met it there, so
/// that what is told does not depend on the ranks. Collective.
/// @param begin  the first row of this rank's part, where an error of the file is counted
void check_together(const Comm& comm, std::size_t begin, const std::function<void()>& check);

}  // namespace barreno
