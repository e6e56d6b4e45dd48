// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_pores.hpp"

namespace barreno::arenisca {

// Moduli at the middle of an elastic step of one or several points.

template <class R>
struct MiddleOf {
  ModuliOf<R> moduli;
  R per_matrix{};  ///< 1/Km there [1/stress]
};
/// The middle of dry rock into that under the pressure of a fluid, where moduli change.
/// @param dv      volume strain
/// @param strain  that of the skeleton
template <class R>
BARRENO_ALIKE void press_middle(
    const Constituents& c,
    PoresOf<R> pores,
    const R& dv,
    const R& strain,
    const R& x,
    const R& x_begin,
    MiddleOf<R>& middle
) {
  const R rise = (strain - dv) / changed_compliances(c, pores.pressure, x_begin).whole;
  pores.pressure = real::larger(R(pores.pressure + 0.5 * rise), 0.0);
  const R x_middle = 0.5 * (x_begin + x);
  middle.moduli.bulk = bulk_of_pressed_grains(c, pores, x_middle, middle.moduli.bulk);
  middle.per_matrix = c.grain_compliance(R(pores.pressure - x_middle * (1.0 / 3.0)));
}
/// Moduli at the middle of a step, I1 kept within what the surface admits.
/// @param holder  of the pores, and of the volume strain `dv`
/// @param strain  that of the skeleton
template <class R, class Law, class Holder>
BARRENO_FUNCTION MiddleOf<R> used_moduli(
    const Law& rock,
    [[maybe_unused]] const Holder& holder,
    const R& strain,
    const CapOf<R>& cap,
    const ElasticStateOf<R>& n
) {
  R x = smaller_of(R(n.x + n.moduli.bulk * R(3.0 * strain)), R(R{} + rock.surface.vertex));
  x = real::select(cap.present & (x < cap.X), cap.X, x);
  MiddleOf<R> middle{rock.elasticity.moduli_midway(n, R(x - n.x))};
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& c = rock.constituents;
    middle.per_matrix = R{} + c.per_matrix;
    if (c.change) press_middle(c, holder.pores, holder.dv, strain, x, n.x, middle);
  }
  return middle;
}

}  // namespace barreno::arenisca
