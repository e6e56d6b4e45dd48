// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"

namespace barreno {

ExitCode exit_code_of(const std::exception& error) {
  if (dynamic_cast<const DeckError*>(&error) != nullptr) return ExitCode::deck;
  if (dynamic_cast<const FileError*>(&error) != nullptr) return ExitCode::file;
  if (dynamic_cast<const NumericalError*>(&error) != nullptr) return ExitCode::numerical;
  return ExitCode::internal;
}

}  // namespace barreno
