// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "scene/voids.hpp"

#include <barreno/models.hpp>
#include <barreno/pore_point.hpp>

namespace barreno {

/// Stress, fluid and density of a body's points at rest under its initial pressure, with the pore
/// pressure and the expansion that it is given; not possible where its material has no fluid to
/// give one but 0, or cannot have voids.
template <class Model>
auto initial_state_of(const Model& model, const BodySpec& body) {
  if constexpr (is_drainable<Model>)
    if (body.pore_pressure) return model.initial_state(body.initial_pressure, *body.pore_pressure);
  if constexpr (holds_voids<Model>)
    if (body.expansion > 1.0) return model.expanded_state(body.expansion);
  auto start = model.initial_state(body.initial_pressure);
  start.possible =
      start.possible && body.pore_pressure.value_or(0.0) == 0.0 && body.expansion == 1.0;
  return start;
}

/// A point of rock before anything has happened to it.
template <class Model>
PorePoint initial_pore_point(const Model& model) {
  const auto start = model.initial_state(0.0);
  return model.pore_point(start.stress, start.history);
}

}  // namespace barreno
