// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace barreno {
namespace {

/// The facets of an edge from its lower to its higher point, and of the opposite direction.
struct Edge {
  std::vector<std::size_t> with, against;
  std::size_t count() const { return with.size() + against.size(); }
};
using Edges = std::map<std::pair<int, int>, Edge>;

Edges edges_of(const std::vector<Surface::Facet>& facets) {
  Edges edges;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = facets[f][k], b = facets[f][(k + 1) % 3];
      Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
      (a < b ? edge.with : edge.against).push_back(f);
    }
  return edges;
}

struct Neighbour {
  std::size_t facet;
  bool agrees;
};

/// Facets that must be turned so that neighbours agree: per connected part the fewer of the two
/// kinds.
long count_flipped(const std::vector<Surface::Facet>& facets, const Edges& edges) {
  std::vector<std::vector<Neighbour>> neighbours(facets.size());
  for (const auto& [ends, edge] : edges) {
    if (edge.count() != 2) continue;
    const bool agrees = edge.with.size() == 1;
    const std::size_t a = edge.with.empty() ? edge.against[0] : edge.with[0];
    const std::size_t b = edge.against.empty() ? edge.with[1] : edge.against.back();
    neighbours[a].push_back({b, agrees});
    neighbours[b].push_back({a, agrees});
  }
  std::vector<int> turned(facets.size(), -1);
  long flipped = 0;
  for (std::size_t seed = 0; seed < facets.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    std::vector<std::size_t> part{seed};
    turned[seed] = 0;
    long count = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      count += turned[part[i]];
      for (const Neighbour& next : neighbours[part[i]]) {
        if (turned[next.facet] >= 0) continue;
        turned[next.facet] = next.agrees ? turned[part[i]] : 1 - turned[part[i]];
        part.push_back(next.facet);
      }
    }
    flipped += std::min(count, static_cast<long>(part.size()) - count);
  }
  return flipped;
}

/// Looks a little to both sides of every facet's middle.
long count_wrong(const Surface& surface) {
  long wrong = 0;
  double size = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    size = std::max(size, surface.around().upper[i] - surface.around().lower[i]);
  for (const Surface::Facet& facet : surface.facets()) {
    std::array<Vector, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = surface.points()[static_cast<std::size_t>(facet[k])];
    Vector normal{}, middle{};
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      normal[i] =
          (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
      // Not in the middle: lines of neighbours often go through there.
      middle[i] = 0.31 * p[0][i] + 0.33 * p[1][i] + 0.36 * p[2][i];
      length += normal[i] * normal[i];
    }
    length = std::sqrt(length);
    // A needle says nothing about its sides.
    if (!(length > 1e-12 * size * size)) continue;
    const double step = std::min(1e-3 * std::sqrt(length), 1e-6 * size) / length;
    Vector inner = middle, outer = middle;
    for (std::size_t i = 0; i < 3; ++i) {
      inner[i] -= step * normal[i];
      outer[i] += step * normal[i];
    }
    if (surface.winding(inner) != 1 || surface.winding(outer) != 0) ++wrong;
  }
  return wrong;
}

}  // namespace

SurfaceFaults faults_of(const Surface& surface) {
  SurfaceFaults faults;
  const Edges edges = edges_of(surface.facets());
  for (const auto& [ends, edge] : edges) {
    if (edge.count() == 1) ++faults.open_edges;
    if (edge.count() > 2 && edge.with.size() != edge.against.size()) ++faults.branching_edges;
  }
  if (faults.open_edges + faults.branching_edges > 0) return faults;
  faults.flipped_facets = count_flipped(surface.facets(), edges);
  if (faults.flipped_facets == 0) faults.wrong_facets = count_wrong(surface);
  return faults;
}

}  // namespace barreno
