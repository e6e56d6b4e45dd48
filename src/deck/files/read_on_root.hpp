// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>

#include <functional>
#include <string>

namespace barreno {

/// Rank 0 reads, every rank receives the same text or throws the same error. Collective.
std::string read_on_root(const std::function<std::string()>& read, const Teuchos::Comm<int>& comm);

/// Contents of a file of at most `largest` bytes. Throws FileError, or DeckError when it is larger.
/// @param what  "the deck", for sentences
std::string read_file(const std::string& file, std::size_t largest, const std::string& what);

}  // namespace barreno
