// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLObject.hpp>

#include <string>

namespace barreno {

/// Copies the lists of "Pore Flow" that solver packages check themselves. A value without a type
/// has that which it looks like.
///
/// @param source  the deck's name, for sentences
/// @throws InputError if Teuchos cannot read a list
void read_solver_lists(
    const Teuchos::XMLObject& root, const std::string& source, Teuchos::ParameterList& values
);

}  // namespace barreno
