// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/fill.hpp"

#include "base/work_counts.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace barreno {
namespace {

/// Part of a cell below which a piece is a sliver.
constexpr double sliver = 0.25;
/// Part of a cell by which one of two neighbours must be fuller, so that round-off does not decide
/// between those of a sliver on a diagonal: a body that is its own mirror image gets particles that
/// are.
constexpr double clearly = 1e-9;

using LatticeCell = std::array<long long, 3>;

/// Cells [begin, end) along each axis.
struct Block {
  LatticeCell begin{}, end{1, 1, 1};
};

Box box_of(const Lattice& lattice, const LatticeCell& cell, int dimension) {
  Box box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    box.lower[i] = lattice.lower[i] + static_cast<double>(cell[i]) * lattice.size;
    box.upper[i] = box.lower[i] + lattice.size;
  }
  return box;
}

Box box_of(const Lattice& lattice, const Block& block, int dimension) {
  Box box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    box.lower[i] = lattice.lower[i] + static_cast<double>(block.begin[i]) * lattice.size;
    box.upper[i] = lattice.lower[i] + static_cast<double>(block.end[i]) * lattice.size;
  }
  return box;
}

long long index_of(const Lattice& lattice, const LatticeCell& cell) {
  return (cell[2] * lattice.count[1] + cell[1]) * lattice.count[0] + cell[0];
}

LatticeCell cell_at(const Lattice& lattice, long long index) {
  return {
      index % lattice.count[0],
      index / lattice.count[0] % lattice.count[1],
      index / lattice.count[0] / lattice.count[1]};
}

/// Pieces of a shape in the cells of a lattice, found where they are asked for. Those near the
/// surface are kept: neighbours ask for them again.
class Pieces {
public:
  Pieces(const Shape& shape, int dimension, const Lattice& lattice)
      : shape_(shape),
        dimension_(dimension),
        lattice_(lattice),
        cell_measure_(std::pow(lattice.size, dimension)) {}

  /// What the particle of a cell holds: nothing where its piece went elsewhere.
  Piece particle(const LatticeCell& cell) {
    const Box box = box_of(lattice_, cell, dimension_);
    const Side side = look(box);
    if (side == Side::outside) return {};
    if (side == Side::inside && is_deep(cell)) return whole(box, dimension_);
    if (at(cell).side == Side::outside || has_moved(cell)) return {};
    Piece sum = at(cell).piece;
    for (const long long other : slivers_of(cell)) add(sum, near_surface_.at(other).piece);
    return sum;
  }
  /// Cells that were asked for their side.
  long long looked_at() const { return looked_at_; }

private:
  struct Filled {
    Side side;  ///< a cut without a measure is outside
    Piece piece;
  };

  Side look(const Box& box) {
    ++looked_at_;
    return side_of(shape_, box, dimension_);
  }

  /// All cells around are inside too, so that no sliver is beside.
  bool is_deep(const LatticeCell& cell) const {
    Block around{cell, cell};
    for (std::size_t i = 0; i < 3; ++i) {
      --around.begin[i];
      around.end[i] += 2;
    }
    return side_of(shape_, box_of(lattice_, around, dimension_), dimension_) == Side::inside;
  }

  const Filled& at(const LatticeCell& cell) {
    const long long index = index_of(lattice_, cell);
    const auto found = near_surface_.find(index);
    if (found != near_surface_.end()) return found->second;
    const Box box = box_of(lattice_, cell, dimension_);
    Filled filled{look(box), {}};
    if (filled.side == Side::inside) filled.piece = whole(box, dimension_);
    if (filled.side == Side::cut) filled.piece = piece_of(shape_, box, dimension_);
    if (!(filled.piece.measure > 0.0)) filled = {Side::outside, {}};
    return near_surface_.emplace(index, filled).first->second;
  }

  template <class Visit>
  void for_each_neighbour(const LatticeCell& cell, Visit&& visit) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension_); ++i)
      for (const long long step : {-1LL, 1LL}) {
        LatticeCell next = cell;
        next[i] += step;
        if (next[i] >= 0 && next[i] < lattice_.count[i]) visit(next);
      }
  }

  bool is_sliver(const LatticeCell& cell) {
    const Filled& filled = at(cell);
    return filled.side == Side::cut && filled.piece.measure < sliver * cell_measure_;
  }

  /// The fullest of a cell and its neighbours, to which a sliver goes; from there it may go on.
  LatticeCell fullest_beside(const LatticeCell& cell) {
    LatticeCell found = cell;
    double fullest = at(cell).piece.measure;
    for_each_neighbour(cell, [&](const LatticeCell& next) {
      const double other = at(next).piece.measure;
      if (!(other > fullest + clearly * cell_measure_)) return;
      fullest = other;
      found = next;
    });
    return found;
  }

  bool has_moved(const LatticeCell& cell) {
    return is_sliver(cell) && fullest_beside(cell) != cell;
  }

  /// Cells whose slivers come to a cell, up through ever fuller neighbours; ascending.
  std::vector<long long> slivers_of(const LatticeCell& cell) {
    std::vector<long long> found;
    std::vector<LatticeCell> open{cell};
    while (!open.empty()) {
      const LatticeCell to = open.back();
      open.pop_back();
      for_each_neighbour(to, [&](const LatticeCell& from) {
        if (!is_sliver(from) || fullest_beside(from) != to) return;
        found.push_back(index_of(lattice_, from));
        open.push_back(from);
      });
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  const Shape& shape_;
  int dimension_;
  const Lattice& lattice_;
  double cell_measure_;
  std::unordered_map<long long, Filled> near_surface_;
  long long looked_at_ = 0;
};

bool is_cell(const Block& block) {
  for (std::size_t i = 0; i < 3; ++i)
    if (block.end[i] - block.begin[i] > 1) return false;
  return true;
}

/// What is to be said of a block: the search is over, there is nothing in it, or its halves decide.
enum class Look { found, nothing, closer };

/// Whether `look(block)` finds something in a block or the halves of halves down to cells.
template <class LookAt>
bool search(const Block& block, LookAt&& look) {
  const Look seen = look(block);
  if (seen != Look::closer) return seen == Look::found;
  std::size_t axis = 0;
  const auto length = [&](std::size_t i) { return block.end[i] - block.begin[i]; };
  for (const std::size_t i : {1U, 2U})
    if (length(i) > length(axis)) axis = i;
  Block lower = block, upper = block;
  lower.end[axis] = upper.begin[axis] = block.begin[axis] + length(axis) / 2;
  return search(lower, look) || search(upper, look);
}

/// The same for a whole lattice, by every rank.
template <class LookAt>
bool search_lattice(const Lattice& lattice, LookAt&& look) {
  if (count_cells(lattice) == 0) return false;
  return search({{}, lattice.count}, [&](const Block& block) {
    ++work_counts().undivided_points;
    return look(block);
  });
}

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

long long count_cells(const Lattice& lattice) {
  return lattice.count[0] * lattice.count[1] * lattice.count[2];
}

CellSpan share_of_cells(const Lattice& lattice, int rank, int ranks) {
  const long long all = count_cells(lattice), part = all / ranks, more = all % ranks;
  const auto begin = [&](long long r) { return r * part + std::min(r, more); };
  return {begin(rank), begin(rank + 1)};
}

void for_each_lattice_piece(
    const Shape& shape,
    int dimension,
    const Lattice& lattice,
    const CellSpan& span,
    const VisitPiece& visit
) {
  Pieces pieces(shape, dimension, lattice);
  for (long long index = span.begin; index < span.end; ++index) {
    const LatticeCell cell = cell_at(lattice, index);
    const Piece piece = pieces.particle(cell);
    if (piece.measure > 0.0) visit(cell, piece);
  }
  work_counts().candidate_points += pieces.looked_at();
}

void for_each_lattice_piece(
    const Shape& shape, int dimension, const Lattice& lattice, const VisitPiece& visit
) {
  for_each_lattice_piece(shape, dimension, lattice, {0, count_cells(lattice)}, visit);
}

double fullest_cell(const Shape& shape, int dimension, const Lattice& lattice, double enough) {
  const double cell_measure = std::pow(lattice.size, dimension);
  double fullest = 0.0;
  search_lattice(lattice, [&](const Block& block) {
    const Box box = box_of(lattice, block, dimension);
    const Side side = side_of(shape, box, dimension);
    if (side == Side::outside) return Look::nothing;
    if (side == Side::cut && !is_cell(block)) return Look::closer;
    const double filled =
        side == Side::inside ? 1.0 : piece_of(shape, box, dimension).measure / cell_measure;
    fullest = std::max(fullest, filled);
    return fullest >= enough ? Look::found : Look::nothing;
  });
  return fullest;
}

namespace {

/// At 2 points per direction of a cell, at the places of the Gauss rule, which faces at round
/// figures do not meet.
bool have_common_points_in(const Shape& a, const Shape& b, int dimension, const Box& cell) {
  constexpr double gauss = 0.21132486540518713;  // (1 - 1/sqrt(3)) / 2
  for (unsigned k = 0; k < (1U << static_cast<unsigned>(dimension)); ++k) {
    Vector x{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
      x[i] = cell.lower[i] +
             ((k >> i & 1U) != 0U ? 1.0 - gauss : gauss) * (cell.upper[i] - cell.lower[i]);
    if (holds(a, x, dimension) && holds(b, x, dimension)) return true;
  }
  return false;
}

}  // namespace

bool have_common_points(const Shape& a, const Shape& b, int dimension, const Lattice& lattice) {
  return search_lattice(lattice, [&](const Block& block) {
    const Box box = box_of(lattice, block, dimension);
    const Side in_a = side_of(a, box, dimension), in_b = side_of(b, box, dimension);
    if (in_a == Side::outside || in_b == Side::outside) return Look::nothing;
    if (in_a == Side::inside && in_b == Side::inside) return Look::found;
    if (!is_cell(block)) return Look::closer;
    return have_common_points_in(a, b, dimension, box_of(lattice, block.begin, dimension))
               ? Look::found
               : Look::nothing;
  });
}

}  // namespace barreno
