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

long long count_cells(const Lattice& lattice);

/// Cells [begin, end) of a lattice in their order, the first coordinate running fastest.
struct CellSpan {
  long long begin = 0, end = 0;
};
/// The part of one of so many ranks that share the cells evenly, rank after rank.
CellSpan share_of_cells(const Lattice& lattice, int rank, int ranks);

/// The particles' pieces of a shape in the order of their cells: visit(cell, piece), the cell being
/// the index of its square or cube in every direction.
///
/// A piece below a quarter of its cell joins its fullest neighbour (if that is one too, the next
/// fuller), because a particle of little mass at a surface is pushed about by the nodes that others
/// fill (pressures of several times the yield stress in an imploding shell). Volume and first
/// moments are kept.
///
/// Pieces of a span are the same, to the last bit, as in a walk over all cells: of what lies
/// outside of it only neighbours of cells at the surface are looked at.
using VisitPiece = std::function<void(const std::array<long long, 3>& cell, const Piece& piece)>;
void for_each_lattice_piece(
    const Shape& shape,
    int dimension,
    const Lattice& lattice,
    const CellSpan& span,
    const VisitPiece& visit
);
void for_each_lattice_piece(
    const Shape& shape, int dimension, const Lattice& lattice, const VisitPiece& visit
);

/// The part of its fullest cell that a shape fills, before slivers join; 0 if it fills nothing.
/// Looks at the surface alone, and at no more than it takes to find `enough` (at most 1).
double fullest_cell(const Shape& shape, int dimension, const Lattice& lattice, double enough);

/// Some point of a lattice's cells is in both shapes: where both surfaces cut a cell, 2 points per
/// direction are tried. What is inside or outside in whole is not divided into cells.
bool have_common_points(const Shape& a, const Shape& b, int dimension, const Lattice& lattice);

}  // namespace barreno
