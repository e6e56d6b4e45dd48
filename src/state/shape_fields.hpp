// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/patch_frame.hpp"
#include "state/particles.hpp"

namespace barreno {

/// What shape functions read of a particle set.
KOKKOS_INLINE_FUNCTION ShapeFields shape_fields(const Particles& particles) {
  return {
      particles.position.values,
      particles.half_size.values,
      particles.deformation_gradient.values,
      particles.rotation.values};
}

}  // namespace barreno
