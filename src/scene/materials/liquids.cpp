// SPDX-License-Identifier: BSD-3-Clause
#include "scene/materials/liquids.hpp"

#include <barreno/models.hpp>
#include <variant>

namespace barreno {

bool is_liquid(const MaterialSpec& material) {
  return std::holds_alternative<Liquid>(material.material().model);
}

double own_pressure(const MaterialSpec& material) {
  const auto* const liquid = std::get_if<Liquid>(&material.material().model);
  return liquid == nullptr ? 0.0 : liquid->parameters().initial_pressure;
}

}  // namespace barreno
