// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_ParameterList.hpp>

#include <string>

namespace barreno {

/// Makes the path of the run that a deck continues absolute, so that the effective deck can lie
/// anywhere. Collective. @throws DeckError  where it is empty
/// @param source     the deck's name, for sentences
/// @param directory  of the deck
void find_run(
    const std::string& source,
    const std::string& directory,
    const Teuchos::Comm<int>& comm,
    Teuchos::ParameterList& values
);

}  // namespace barreno
