// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <Kokkos_Macros.hpp>

namespace barreno {

/// Share of the grid's own velocity in a particle's new one: the PIC fraction, and damping for what
/// of v_p the grid does not see. Forces of damping act on nodes alone; particles that move against
/// each other within their cells, seen by no node, would go on for ever. Captured by value in
/// kernels.
///
///   a = b + (1 - b) min(1, c dt),   b the PIC fraction, c the damping
struct GridShare {
  double pic_fraction, damping;

  explicit GridShare(const StepSpec& step)
      : pic_fraction(step.pic_fraction), damping(step.damping) {}

  KOKKOS_INLINE_FUNCTION double operator()(double dt) const {
    const double damped = damping * dt < 1.0 ? damping * dt : 1.0;
    return pic_fraction + (1.0 - pic_fraction) * damped;
  }
};

}  // namespace barreno
