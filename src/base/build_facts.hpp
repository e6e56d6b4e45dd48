// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace barreno {

/// Name and value of what the program was built from: commit, compiler, libraries.
using BuildFacts = std::vector<std::pair<std::string, std::string>>;

}  // namespace barreno
