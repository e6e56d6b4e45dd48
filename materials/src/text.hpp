// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace barreno::input {

std::string_view trim(std::string_view text);

/// Parts between separators, trimmed; "a,,b" has an empty second part, an empty text has no part.
std::vector<std::string> split(std::string_view text, char separator);

/// At most `longest` bytes of a text, "..." where some are left out: at its end, or in its middle.
std::string cut_end(std::string_view text, std::size_t longest);
std::string cut_middle(std::string_view text, std::size_t longest);

/// The first control character besides tab, line feed and carriage return; -1 if there is none.
int control_character(std::string_view text);

}  // namespace barreno::input
