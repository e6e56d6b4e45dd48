// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/piece.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// The part {x : n . x < offset} of the unit box, n > 0 in `count` directions: measure and first
/// moments.
///
/// The measure is sum over corners c of (-1)^|c| max(0, offset - n . c)^d / (d! prod n)
/// (Scardovelli and Zaleski, J. Comput. Phys. 164 (2000) 228); the moment along i is its
/// integral over the offset, differentiated to -n_i.
struct UnitMoments {
  double measure = 0.0;
  std::array<double, 3> first{};
};
UnitMoments below_plane(const std::array<double, 3>& n, std::size_t count, double offset) {
  UnitMoments m;
  double product = 1.0, factorial = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    product *= n[i];
    factorial *= static_cast<double>(i + 1);
  }
  for (unsigned corner = 0; corner < (1U << count); ++corner) {
    double depth = offset, sign = 1.0;
    for (std::size_t i = 0; i < count; ++i)
      if ((corner >> i & 1U) != 0U) {
        depth -= n[i];
        sign = -sign;
      }
    if (!(depth > 0.0)) continue;
    const double power = sign * std::pow(depth, static_cast<double>(count)) / (factorial * product);
    m.measure += power;
    for (std::size_t i = 0; i < count; ++i)
      m.first[i] += power * (depth / (static_cast<double>(count + 1) * n[i]) +
                             ((corner >> i & 1U) != 0U ? 1.0 : 0.0));
  }
  return m;
}

}  // namespace

Piece piece_of_half_space(const HalfSpace& half, const Box& box, int dimension) {
  // Components below this are left out: the box is then cut straight along them. Smaller ones would
  // lose the sum's digits.
  const double straight = dimension == 2 ? 1e-4 : 1e-3;
  std::array<double, 3> n{};
  std::array<std::size_t, 3> axes{};
  std::size_t count = 0;
  double largest = 0.0, offset = 0.0;
  const Piece box_piece = whole(box, dimension);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < d; ++i)
    largest = std::max(largest, std::abs(half.normal[i]) * (box.upper[i] - box.lower[i]));
  if (!(largest > 0.0)) return {};
  for (std::size_t i = 0; i < d; ++i) {
    offset += half.normal[i] * (half.point[i] - box_piece.centroid[i]);
    const double edge = std::abs(half.normal[i]) * (box.upper[i] - box.lower[i]);
    if (!(edge > straight * largest)) continue;
    axes[count] = i;
    n[count++] = edge;
  }
  for (std::size_t i = 0; i < count; ++i) offset += 0.5 * n[i];
  double reach = 0.0;
  for (std::size_t i = 0; i < count; ++i) reach += n[i];
  if (offset <= 0.0) return {};
  if (offset >= reach) return box_piece;
  if (2.0 * offset > reach) {
    const Vector back{-half.normal[0], -half.normal[1], -half.normal[2]};
    return rest_of(box, piece_of_half_space({half.point, back}, box, dimension), dimension);
  }
  const UnitMoments m = below_plane(n, count, offset);
  if (!(m.measure > 0.0)) return {};
  Piece piece = box_piece;
  piece.measure *= std::min(1.0, m.measure);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t axis = axes[i];
    const double share = m.first[i] / m.measure;
    const double edge = box.upper[axis] - box.lower[axis];
    piece.centroid[axis] =
        half.normal[axis] > 0.0 ? box.lower[axis] + share * edge : box.upper[axis] - share * edge;
  }
  return piece;
}

}  // namespace barreno
