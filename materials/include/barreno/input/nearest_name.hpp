// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno::input {

/// The known name that the user most likely meant; empty when none is near.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// What to do about an unknown name: "did you mean 'Cell Size'?", or the list of what is known.
std::string suggest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace barreno::input
