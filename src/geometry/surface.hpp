// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/piece.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace barreno {

/// A closed surface of triangles whose corners run counterclockwise when seen from outside; it may
/// have several parts, and hollows. The triangles are found by their place in the plane {x, y}.
class Surface {
public:
  using Facet = std::array<int, 3>;  ///< indices of points
  Surface(std::vector<Vector> points, std::vector<Facet> facets);

  const std::vector<Vector>& points() const { return points_; }
  const std::vector<Facet>& facets() const { return facets_; }
  const Box& around() const { return around_; }

  /// How often the surface winds around a point: 1 inside, 0 outside of a sound one. Exactly one
  /// side of a common edge of two facets counts a point that lies in line with it.
  int winding(const Vector& x) const;
  /// What it encloses [length^3], by the divergence theorem.
  double volume() const;
  bool comes_near(const Box& box) const;
  /// Exact: the prisms below the facets, each clipped to the box, add up to what is inside with the
  /// sign of the facet's direction.
  Piece piece_in(const Box& box) const;

private:
  /// Facets whose place in the plane may meet a rectangle, once each.
  template <class Visit>
  void for_each_near(const Box& box, Visit&& visit) const;
  Box box_of(const Facet& facet) const;
  std::array<std::size_t, 2> bin_of(double x, double y) const;
  std::size_t members_of_bins() const;

  std::vector<Vector> points_;
  std::vector<Facet> facets_;
  std::vector<Box> boxes_;  ///< around every facet
  Box around_;
  std::array<std::size_t, 2> bins_{1, 1};
  std::vector<std::size_t> first_;  ///< of every bin in members_
  std::vector<int> members_;        ///< facets, bin after bin
};

/// What is wrong with a surface; all zero for a sound one.
struct SurfaceFaults {
  long open_edges = 0;       ///< belong to one facet only
  long branching_edges = 0;  ///< belong to more than two facets, not in pairs of opposite direction
  long flipped_facets = 0;   ///< run against their neighbours
  long wrong_facets = 0;  ///< do not have the inside below and the outside above them: inside out,
                          ///< or within the solid
};
SurfaceFaults faults_of(const Surface& surface);

}  // namespace barreno
