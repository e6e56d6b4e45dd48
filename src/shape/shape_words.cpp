// SPDX-License-Identifier: BSD-3-Clause
#include "deck/shape_words.hpp"

#include "shape/visit_kernels.hpp"

namespace barreno {

std::vector<std::string> shape_words() {
  std::vector<std::string> words;
  for_each_shape([&](auto shape) { words.emplace_back(decltype(shape)::word); });
  return words;
}

}  // namespace barreno
