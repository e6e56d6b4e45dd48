// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/detonation_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "geometry/shape.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace barreno {

/// When a detonation comes to the points of its explosive if it must go around what lies in its
/// way:
///
///   |grad t| = 1 / D, that is t = t_d + (shortest way through the explosive) / D
///
/// A front marches over the cells of a lattice, the earliest first. Every cell knows its origin,
/// which is a detonator or the cell where the way last turned: a neighbour that the origin sees
/// gets the time of the straight way from there; one that it does not see is reached from the cell
/// itself, which becomes the origin. Straight ways are exact, and what remains is that ways turn at
/// the centres of cells: first order in the size of a cell.
/// @par Source  Sethian, A fast marching level set method for monotonically advancing fronts, Proc.
///              Natl. Acad. Sci. 93 (1996) 1591-1595; Nash, Daniel, Koenig & Felner, Theta*:
///              any-angle path planning on grids, Proc. AAAI 22 (2007) 1177-1183 (origins).
class LightingMap {
public:
  /// Cells of the lattice along a cell of the grid.
  static constexpr int parts_in_plane = 4, parts_in_space = 2;

  /// @param shapes  what the explosive fills
  LightingMap(
      const GridSpec& grid, const std::vector<Shape>& shapes, const DetonationSpec& detonation
  );

  /// At any point of the explosive; infinite where no front comes [time].
  double time_at(const Vector& x) const;
  /// The front comes to all cells of the explosive, and there are some.
  bool reaches_all() const;

private:
  using Index = std::array<int, 3>;
  /// A cell of the lattice, or -1 - index of a detonator.
  using Origin = long;
  struct Arrival {
    double time;
    Origin origin;
  };
  struct Start {
    Vector x;
    double time;
  };

  std::size_t flat(const Index& at) const;
  Index index_of(std::size_t cell) const;
  Index cell_of(const Vector& x) const;
  Vector centre_of(const Index& at) const;
  bool has(const Index& at) const;  ///< in the table and in the explosive
  bool sees(const Vector& from, const Vector& x) const;
  Start start_of(Origin origin, const Vector& x) const;
  bool come_straight(Origin origin, const Vector& x, Arrival& arrival, bool& unseen) const;
  bool come_through(std::size_t cell, const Vector& x, Arrival& arrival) const;

  void place_table(const std::vector<Shape>& shapes);
  void mark_explosive(const std::vector<Shape>& shapes);
  void march();

  GridSpec grid_;
  DetonationSpec detonation_;
  std::size_t dimension_;
  double size_;                           ///< of a cell of the lattice [length]
  Index first_{}, count_{1, 1, 1};        ///< of the table in the lattice from the grid's corner on
  std::vector<unsigned char> explosive_;  ///< by cell of the table
  std::vector<double> time_;              ///< by cell, infinite where no front comes [time]
  std::vector<Origin> origin_;            ///< by cell
};

}  // namespace barreno
