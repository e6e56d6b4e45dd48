// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/numbers.hpp"
#include "base/types.hpp"
#include "state/host_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace barreno {

/// Length that two intervals share.
inline double overlap(double from, double to, double lower, double upper) {
  return std::max(0.0, std::min(to, upper) - std::max(from, lower));
}

/// A particle as it is drawn: half edges of a parallelogram, or of a parallelepiped [length].
struct DrawnShape {
  std::array<Vector, 3> edge{};
  std::size_t dimensions = 2;

  DrawnShape(const std::vector<double>& corners, double scale) {
    dimensions = corners.size() == 8 ? 2 : 3;
    constexpr std::size_t beside[3] = {1, 3, 4};  // the first corner along each edge
    for (std::size_t k = 0; k < dimensions; ++k)
      for (std::size_t d = 0; d < dimensions; ++d)
        edge[k][d] = 0.5 * scale * (corners[dimensions * beside[k] + d] - corners[d]);
  }

  /// Half the extent along a unit vector of the box that has the moments of the shape.
  double half_extent(const Vector& along) const {
    double square = 0.0;
    for (const Vector& e : edge) {
      const double part = e[0] * along[0] + e[1] * along[1] + e[2] * along[2];
      square += part * part;
    }
    return std::sqrt(square);
  }

  /// Area, in three dimensions volume.
  double measure() const {
    const auto& [a, b, c] = edge;
    const double area = a[0] * b[1] - a[1] * b[0];
    if (dimensions == 2) return 4.0 * std::abs(area);
    return 8.0 *
           std::abs(
               area * c[2] + (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1]
           );
  }
};

/// Where the axis is: the direction away from it, and how far it is.
inline std::pair<Vector, double> away_from_axis(const HostParticles& particles, int p) {
  if (particles.dimensions() == 2) return {{1.0, 0.0, 0.0}, std::abs(particles.position(p, 0))};
  const double x = particles.position(p, 0), z = particles.position(p, 2);
  const double radius = std::hypot(x, z);
  if (!(radius > 0.0)) return {{1.0, 0.0, 0.0}, 0.0};
  return {{x / radius, 0.0, z / radius}, radius};
}

}  // namespace barreno
