// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

namespace barreno {

/// Over what a shape function takes the means of the grid's functions.
enum class ParticleForm { point, box, parallelogram };

/// Domains that follow their particles get no narrower than this about the centre, unless they
/// began so (widen_domain) [cells].
inline constexpr double thinnest_half = 1.0 / 16.0;

/// Where a particle is, in units of cells. `x` counts from the first node of the tile's patch;
/// `axis` is the radius of that node, so that r = axis + x[0] (axisymmetry only).
struct ParticleGeometry {
  double x[3] = {};
  double half[3] = {};  ///< half edges of the undeformed particle
  double axis = 0.0;
  double per_cell = 1.0;  ///< 1 / cell size
  int row = 0;            ///< slots from one row of the patch to the next
  double last = 0.0;      ///< last node of the patch, along each axis
  double low[3] = {};     ///< first and last node of the grid; far away beyond a symmetry plane
  double high[3] = {};
  double largest = 1.0;  ///< Largest Domain
  /// F and the diagonal of U, F = R U; only for a shape function that follows them.
  double f[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  double stretch[3] = {1.0, 1.0, 1.0};
};

}  // namespace barreno
