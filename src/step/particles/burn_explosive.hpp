// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/explosive_traits.hpp"

#include <barreno/real.hpp>

namespace barreno {

/// Advance the burn of an explosive's particles to the end of their step, from their lighting times
/// (programmed burn; the rule is JwlExplosive::burn in materials/include/barreno/models,
/// jwl_explosive.hpp). Other models have none.
/// @param end_time   of the step
/// @param cell_size  that the particles are in
/// @return the artificial viscosity, which acts from the first burning on
template <class Model, class R, class History>
KOKKOS_INLINE_FUNCTION R burn_explosive(
    const Model& model, double end_time, const R& cell_size, const R& viscous, History& history
) {
  if constexpr (burns_by_program<Model>) {
    model.burn(end_time, cell_size, history);
    return real::select(history.burn > 0.0, viscous, 0.0);
  }
  return viscous;
}

}  // namespace barreno
