// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// What a ball fills of a rectangle: area and centroid.
struct Piece {
  double area = 0.0;        ///< [length^2]
  double x = 0.0, y = 0.0;  ///< centroid of the area
};

/// Area and centroid of the part of the rectangle that lies inside a ball and outside its hollow,
/// in closed form. A ring of the piece, 2 pi x * area, has its volume exactly (Pappus).
Piece piece_of_ball(const Ball& ball, const Box& rectangle);

/// Squares that fill a body, counted from its lower corner.
struct Lattice {
  double lower[2], size;
  long long count[2];
};

/// What the particle in one square of the lattice holds of a ball: the piece in the square, and
/// those slivers beside it that are too small to be particles. No area: there is no particle.
///
/// A sliver joins its fullest neighbour, because a particle of little mass at a surface is pushed
/// about by the nodes that others fill (pressures of several times the yield stress in an imploding
/// shell). Volume and first moment are kept.
Piece ball_particle(const Ball& ball, const Lattice& lattice, long long i, long long j);

}  // namespace barreno
