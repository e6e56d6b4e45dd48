// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>
#include <ostream>
#include <string>

namespace barreno {

/// What an entry takes: "number [Pa]", "one of: off, on".
std::string type_text(const input::Entry& entry);

/// Its bounds and, of a model's parameter, its usual range, in SI.
/// @param model  that the entry is a parameter of; empty for one of the deck
std::string limits_text(const input::Entry& entry, const std::string& model);

/// "required", "optional", or its default.
std::string default_text(const input::Entry& entry);

/// Its name, meaning, type, limits and default, as `describe` prints them.
void write_entry(const input::Entry& entry, std::ostream& out, const std::string& model = {});

}  // namespace barreno
