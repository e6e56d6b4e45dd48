// SPDX-License-Identifier: BSD-3-Clause
#include "shape/shape_facts.hpp"

#include "deck/shape_words.hpp"
#include "shape/visit_kernels.hpp"

#include <string_view>

namespace barreno {
namespace {

/// Whether a deck calls these shape functions by their own words, in their order.
template <class... Shapes>
constexpr bool deck_names_all(ShapeList<Shapes...> /*list*/) {
  if (sizeof...(Shapes) != all_shape_words.size()) return false;
  const std::string_view words[] = {Shapes::word...};
  for (std::size_t i = 0; i < sizeof...(Shapes); ++i)
    if (words[i] != all_shape_words[i]) return false;
  return true;
}
static_assert(
    deck_names_all(AllShapes{}),
    "the words of deck/shape_words.hpp must be those of AllShapes (shape/visit_kernels.hpp), in "
    "the same order"
);

}  // namespace

bool follows_deformation(const Scene& scene) {
  return visit_shape(scene.step.shape, [](auto shape) {
    return decltype(shape)::follows_deformation;
  });
}

const char* shape_warning(const Scene& scene) {
  return visit_shape(scene.step.shape, [](auto shape) { return decltype(shape)::warning; });
}

}  // namespace barreno
