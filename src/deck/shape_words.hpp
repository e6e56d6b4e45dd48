// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace barreno {

/// What a deck may call the shape functions, the default first. The shape functions themselves are
/// AllShapes in shape/visit_kernels.hpp: shape/shape_facts.cpp does not compile unless both lists
/// say the same.
inline constexpr std::array all_shape_words{
    "GIMP", "linear", "contiguous GIMP", "CPDI", "quadratic B-spline", "cubic B-spline"};

inline std::vector<std::string> shape_words() {
  return {all_shape_words.begin(), all_shape_words.end()};
}

}  // namespace barreno
