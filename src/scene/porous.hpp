// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/models.hpp>
#include <barreno/pore_point.hpp>
#include <type_traits>
#include <variant>

namespace barreno {

/// True of a material whose fluid can drain.
inline bool is_porous(const Material& material) {
  return std::visit(
      [](const auto& model) { return is_drainable<std::decay_t<decltype(model)>>; }, material.model
  );
}

/// A point of rock before anything has happened to it.
template <class Model>
PorePoint initial_pore_point(const Model& model) {
  const auto start = model.initial_state(0.0);
  return model.pore_point(start.stress, start.history);
}

}  // namespace barreno
