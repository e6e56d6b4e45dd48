// SPDX-License-Identifier: BSD-3-Clause
#include "shape/shape_facts.hpp"

#include "deck/shape_words.hpp"
#include "shape/visit_kernels.hpp"

namespace barreno {

std::vector<std::string> shape_words() {
  std::vector<std::string> words;
  for_each_shape([&](auto shape) { words.emplace_back(decltype(shape)::word); });
  return words;
}

bool follows_deformation(const Scene& scene) {
  return visit_shape(scene.step.shape, [](auto shape) {
    return decltype(shape)::follows_deformation;
  });
}

const char* shape_warning(const Scene& scene) {
  return visit_shape(scene.step.shape, [](auto shape) { return decltype(shape)::warning; });
}

}  // namespace barreno
