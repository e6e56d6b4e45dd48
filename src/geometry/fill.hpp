// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/piece.hpp"

#include <functional>

namespace barreno {

/// Squares or cubes that fill a body, counted from its lower corner; one layer in two dimensions.
struct Lattice {
  Vector lower{};
  double size = 0.0;
  std::array<long long, 3> count{1, 1, 1};
};

/// The lattice of a grid around a box: places of particles are alike in every cell. A millionth of
/// `size` beyond the box's sides is round-off.
Lattice lattice_around(const Box& box, const Vector& origin, double size, int dimension);

/// The particles' pieces of a shape, the first coordinate running fastest: visit(cell, piece), the
/// cell being the index of its square or cube in every direction.
///
/// A piece below a quarter of its cell joins its fullest neighbour (if that is one too, the next
/// fuller), because a particle of little mass at a surface is pushed about by the nodes that others
/// fill (pressures of several times the yield stress in an imploding shell). Volume and first
/// moments are kept.
using VisitPiece = std::function<void(const std::array<long long, 3>& cell, const Piece& piece)>;
void for_each_lattice_piece(
    const Shape& shape, int dimension, const Lattice& lattice, const VisitPiece& visit
);

/// What fills a lattice in all.
struct Filling {
  long long cells = 0;   ///< with something in them, slivers joined
  double measure = 0.0;  ///< [length^dimension]
  double fullest = 0.0;  ///< part of the fullest cell that is filled, before slivers join
};
Filling filling_of(const Shape& shape, int dimension, const Lattice& lattice);

/// Some point of a lattice's cells is in both shapes: 2 points per direction and cell, at the
/// places of the Gauss rule, which faces at round figures do not meet.
bool have_common_points(const Shape& a, const Shape& b, int dimension, const Lattice& lattice);

}  // namespace barreno
