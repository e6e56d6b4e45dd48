// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace barreno {

/// What a deck may call the shape functions, the default first. Said by the one list of them, in
/// shape/visit_kernels.hpp.
std::vector<std::string> shape_words();

}  // namespace barreno
