// SPDX-License-Identifier: BSD-3-Clause
#include "jet/failure.hpp"

#include <barreno/models.hpp>
#include <type_traits>
#include <utility>
#include <variant>

namespace barreno {
namespace {

/// Models with the parameters of Johnson and Cook.
template <class Model>
constexpr bool has_metal_parameters = std::is_same_v<
    std::decay_t<decltype(std::declval<const Model&>().parameters())>,
    JohnsonCook::Parameters>;

bool has_failure(const JohnsonCook::Parameters& p) {
  return p.spall_stress > 0.0 || p.d1 != 0.0 || p.d2 != 0.0 || p.d3 != 0.0 || p.d4 != 0.0 ||
         p.d5 != 0.0;
}

}  // namespace

bool is_metal(const MaterialSpec& material) {
  return std::visit(
      [](const auto& model) { return has_metal_parameters<std::decay_t<decltype(model)>>; },
      material.material().model
  );
}

bool breaks(const MaterialSpec& material) {
  return std::visit(
      [](const auto& model) {
        if constexpr (has_metal_parameters<std::decay_t<decltype(model)>>)
          return has_failure(model.parameters());
        return false;
      },
      material.material().model
  );
}

}  // namespace barreno
