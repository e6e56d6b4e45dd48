// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// How far a pressure on one surface of a ball reaches into it: 1 on that surface, 0 on the other.
///
/// A pressure p on a surface is the same force as a stress and a body force inside,
///
///   -p int over the surface of N . w = -p int over the body of (e div w + grad e . w),
///
/// for any e that is 1 on the surface and 0 on the others (Gauss): no surface has to be found among
/// particles. Source of the idea: J. Given et al., Comput. Part. Mech. (2024), doi
/// 10.1007/s40571-024-00793-0, "virtual stress boundary".
struct SurfaceShare {
  double value = 0.0;  ///< e [-]
  Vector gradient{};   ///< of e at the start [1/length]
};

/// In a hollow ball of radii a and b, with s = (R - a) / min(b - a, a) and at most 1, e = 1 - s^2
/// (3 - 2 s) for the inner surface and 1 - e for the outer one; in a solid ball e = 1. The sum over
/// the surfaces of a ball is 1: under one pressure on all of them, a body with the stress -p is in
/// exact discrete equilibrium.
SurfaceShare surface_share(
    const Ball& ball, BallSurface surface, const Vector& point, int dimensions
);

/// Volume of a hollow ball's cavity at the start, of the part that is inside the grid (full circle
/// in axisymmetry, per length in plane strain).
double cavity_volume(const Ball& ball, const GridSpec& grid);

/// A load of surfaces of a ball, not of faces of a box.
bool is_on_surfaces(const PressureLoadSpec& load);

}  // namespace barreno
