// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_XMLObject.hpp>

#include <string>
#include <vector>

namespace barreno {

/// What a card leaves to defaults that it should state, one sentence each.
/// @param name  of the card, for sentences
std::vector<std::string> assumptions_of(const Teuchos::XMLObject& card, const std::string& name);

}  // namespace barreno
