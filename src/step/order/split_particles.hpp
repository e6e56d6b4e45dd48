// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Divides particles that have become as wide as their set's SplitRule allows: gas that expands
/// stays connected on the grid, and metal of a jet that flows aside stays a film instead of lumps.
/// Along the longest edge of its domain, F e_i0, a particle becomes two:
///
///   x = x_p -+ F e_i0 / 2,  e_i0 -> e_i0 / 2,  m and V in proportion to what each has of the
///   domain
///
/// (halves; in axisymmetry, where the domain is a ring, in proportion to the radius), and all else
/// as it was: mass, momentum, energy and domain are those of the parent. Ids follow from the
/// parent's: a set whose particles may be divided k times has 2^k of them for every particle, and
/// the n-th division of a particle gives the second child that of its parent plus 2^(k-n).
///
/// One division a particle and step; none where a child would leave the box.
/// @par Source  Ma, Zhang, Lian & Zhou, Simulation of high explosive explosion using adaptive
/// material
///              point method, CMES 39 (2009) 101-123.
/// @return how many particles were divided
int split_particles(const Grid& grid, Particles& particles);

}  // namespace barreno
