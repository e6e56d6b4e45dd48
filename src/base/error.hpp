// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/error.hpp>
#include <exception>
#include <stdexcept>

namespace barreno {

/// Every error that a user can meet carries one sentence: deck path and value, what is wrong (why),
/// what to do.

/// A deck, a card, a table or an argument is wrong.
using DeckError = InputError;

/// The computation cannot continue; FileError is in barreno/input/error.hpp.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the process returns; never `finished` after a failure.
enum class ExitCode { finished = 0, deck = 1, file = 2, numerical = 3, internal = 4 };

/// The exit code that belongs to an error; `internal` for one that no user should meet.
ExitCode exit_code_of(const std::exception& error);

}  // namespace barreno
