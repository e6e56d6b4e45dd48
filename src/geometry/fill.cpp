// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/fill.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace barreno {
namespace {

/// Part of a cell below which a piece is a sliver.
constexpr double sliver = 0.25;
/// Part of a cell by which one of two neighbours must be fuller, so that round-off does not decide
/// between those of a sliver on a diagonal: a body that is its own mirror image gets particles that
/// are.
constexpr double clearly = 1e-9;

using LatticeCell = std::array<long long, 3>;

Box box_of(const Lattice& lattice, const LatticeCell& cell, int dimension) {
  Box box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    box.lower[i] = lattice.lower[i] + static_cast<double>(cell[i]) * lattice.size;
    box.upper[i] = box.lower[i] + lattice.size;
  }
  return box;
}

template <class Visit>
void for_each_cell(const Lattice& lattice, Visit&& visit) {
  LatticeCell cell{};
  for (cell[2] = 0; cell[2] < lattice.count[2]; ++cell[2])
    for (cell[1] = 0; cell[1] < lattice.count[1]; ++cell[1])
      for (cell[0] = 0; cell[0] < lattice.count[0]; ++cell[0]) visit(cell);
}

long long index_of(const Lattice& lattice, const LatticeCell& cell) {
  return (cell[2] * lattice.count[1] + cell[1]) * lattice.count[0] + cell[0];
}

/// Every cell's side, and the pieces of those that are cut.
class Pieces {
public:
  Pieces(const Shape& shape, int dimension, const Lattice& lattice)
      : dimension_(dimension), lattice_(lattice) {
    for_each_cell(lattice, [&](const LatticeCell& cell) {
      const Box box = box_of(lattice, cell, dimension);
      Side side = side_of(shape, box, dimension);
      if (side == Side::cut) {
        const Piece piece = piece_of(shape, box, dimension);
        if (piece.measure > 0.0)
          cut_[index_of(lattice, cell)] = piece;
        else
          side = Side::outside;
      }
      sides_.push_back(side);
    });
    cell_measure_ = std::pow(lattice.size, dimension);
    join_slivers();
  }

  Side side(const LatticeCell& cell) const {
    return sides_[static_cast<std::size_t>(index_of(lattice_, cell))];
  }
  Piece piece(const LatticeCell& cell) const {
    if (side(cell) == Side::outside) return {};
    if (side(cell) == Side::inside) return whole(box_of(lattice_, cell, dimension_), dimension_);
    return cut_.at(index_of(lattice_, cell));
  }
  /// What the particle of a cell holds: nothing where its piece went elsewhere.
  Piece particle(const LatticeCell& cell) const {
    const long long index = index_of(lattice_, cell);
    if (side(cell) == Side::outside || moved_.count(index) != 0) return {};
    Piece sum = piece(cell);
    const auto joined = joined_.find(index);
    if (joined == joined_.end()) return sum;
    for (const long long other : joined->second) add(sum, cut_.at(other));
    return sum;
  }

private:
  template <class Visit>
  void for_each_neighbour(const LatticeCell& cell, Visit&& visit) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension_); ++i)
      for (const long long step : {-1LL, 1LL}) {
        LatticeCell next = cell;
        next[i] += step;
        if (next[i] >= 0 && next[i] < lattice_.count[i]) visit(next);
      }
  }

  /// The cell whose particle holds a sliver: up through ever fuller neighbours, until one is no
  /// sliver.
  LatticeCell holder(const LatticeCell& cell) const {
    LatticeCell found = cell;
    double fullest = piece(cell).measure;
    while (fullest < sliver * cell_measure_) {
      const LatticeCell from = found;
      for_each_neighbour(from, [&](const LatticeCell& next) {
        const double other = piece(next).measure;
        if (!(other > fullest + clearly * cell_measure_)) return;
        fullest = other;
        found = next;
      });
      if (found == from) break;
    }
    return found;
  }

  void join_slivers() {
    for_each_cell(lattice_, [&](const LatticeCell& cell) {
      if (side(cell) != Side::cut) return;
      const LatticeCell found = holder(cell);
      if (found == cell) return;
      joined_[index_of(lattice_, found)].push_back(index_of(lattice_, cell));
      moved_.insert(index_of(lattice_, cell));
    });
  }

  int dimension_;
  const Lattice& lattice_;
  double cell_measure_ = 0.0;
  std::vector<Side> sides_;
  std::unordered_map<long long, Piece> cut_;
  std::unordered_map<long long, std::vector<long long>> joined_;  ///< slivers by their holder
  std::unordered_set<long long> moved_;
};

}  // namespace

Lattice lattice_around(const Box& box, const Vector& origin, double size, int dimension) {
  Lattice lattice;
  lattice.size = size;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    const double from = (box.lower[i] - origin[i]) / size;
    const double to = (box.upper[i] - origin[i]) / size;
    const auto first = static_cast<long long>(std::floor(from + 1e-6));
    const auto last = static_cast<long long>(std::ceil(to - 1e-6));
    lattice.lower[i] = origin[i] + static_cast<double>(first) * size;
    lattice.count[i] = std::max(0LL, last - first);
  }
  return lattice;
}

void for_each_lattice_piece(
    const Shape& shape, int dimension, const Lattice& lattice, const VisitPiece& visit
) {
  const Pieces pieces(shape, dimension, lattice);
  for_each_cell(lattice, [&](const LatticeCell& cell) {
    const Piece piece = pieces.particle(cell);
    if (piece.measure > 0.0) visit(cell, piece);
  });
}

Filling filling_of(const Shape& shape, int dimension, const Lattice& lattice) {
  const Pieces pieces(shape, dimension, lattice);
  const double cell_measure = std::pow(lattice.size, dimension);
  Filling filling;
  for_each_cell(lattice, [&](const LatticeCell& cell) {
    filling.fullest = std::max(filling.fullest, pieces.piece(cell).measure / cell_measure);
    const Piece piece = pieces.particle(cell);
    if (!(piece.measure > 0.0)) return;
    ++filling.cells;
    filling.measure += piece.measure;
  });
  return filling;
}

bool have_common_points(const Shape& a, const Shape& b, int dimension, const Lattice& lattice) {
  constexpr double gauss = 0.21132486540518713;  // (1 - 1/sqrt(3)) / 2
  bool shared = false;
  for_each_cell(lattice, [&](const LatticeCell& cell) {
    if (shared) return;
    const Box box = box_of(lattice, cell, dimension);
    const Side in_a = side_of(a, box, dimension), in_b = side_of(b, box, dimension);
    if (in_a == Side::outside || in_b == Side::outside) return;
    for (unsigned k = 0; k < (1U << static_cast<unsigned>(dimension)) && !shared; ++k) {
      Vector x{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
        x[i] = box.lower[i] + ((k >> i & 1U) != 0U ? 1.0 - gauss : gauss) * lattice.size;
      shared = holds(a, x, dimension) && holds(b, x, dimension);
    }
  });
  return shared;
}

}  // namespace barreno
