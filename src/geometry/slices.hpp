// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/piece.hpp"

#include <optional>

namespace barreno {

/// Volume and first moments about the centre, in place of the centroid, of what a ball fills of a
/// box: the integral of its disks along z. The integrand is smooth between the heights where a disk
/// reaches an edge or a corner of the box; there a Gauss rule in the angle of z = m - w cos(t)
/// takes up the square roots.
Piece slice_ball(const Vector& centre, double radius, const Box& box);

/// The same of a round body along a coordinate axis: centre is any point of the axis (moments are
/// about it), the radius is linear between two places of that axis.
struct Round {
  Vector centre{};
  std::size_t axis = 2;
  double from = 0.0, to = 0.0;  ///< from < to
  double radius_from = 0.0, radius_to = 0.0;
};
Piece slice_round(const Round& round, const Box& box);
/// A cone as a round body along a coordinate axis; nothing if it points elsewhere.
std::optional<Round> round_of(const Cone& cone);

Side side_of(const Ball& ball, const Box& box, int dimension);

}  // namespace barreno
