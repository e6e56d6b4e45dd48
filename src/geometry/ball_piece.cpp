// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/disk.hpp"
#include "geometry/slices.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// Distances of the nearest and the farthest point of a box from a centre, squared.
struct Reach {
  double near = 0.0, far = 0.0;
};
Reach reach_of(const Vector& centre, const Box& box, int dimension) {
  Reach reach;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
    const double lower = box.lower[i] - centre[i], upper = box.upper[i] - centre[i];
    const double nearest = std::clamp(0.0, lower, upper), farthest = std::max(-lower, upper);
    reach.near += nearest * nearest;
    reach.far += farthest * farthest;
  }
  return reach;
}

/// Measure and first moments about the centre of a solid ball.
Piece moments_of(const Vector& centre, double radius, const Box& box, int dimension) {
  if (!(radius > 0.0)) return {};
  if (dimension == 3) return slice_ball(centre, radius, box);
  const Rectangle local{
      {box.lower[0] - centre[0], box.lower[1] - centre[1]},
      {box.upper[0] - centre[0], box.upper[1] - centre[1]}};
  const DiskMoments m = disk_moments(radius, local);
  return {m.area, {m.x, m.y, 0.0}};
}

}  // namespace

Side side_of(const Ball& ball, const Box& box, int dimension) {
  const Reach reach = reach_of(ball.centre, box, dimension);
  const double outer = ball.radius * ball.radius, inner = ball.inner_radius * ball.inner_radius;
  if (reach.near >= outer || reach.far <= inner) return Side::outside;
  return reach.far <= outer && reach.near >= inner ? Side::inside : Side::cut;
}

Piece piece_of_ball(const Ball& ball, const Box& box, int dimension) {
  const Piece ball_moments = moments_of(ball.centre, ball.radius, box, dimension);
  const Piece hollow = moments_of(ball.centre, ball.inner_radius, box, dimension);
  const double measure = ball_moments.measure - hollow.measure;
  // Less than this is round-off of the difference, and no particle.
  constexpr double least = 1e-9;
  if (!(measure > least * measure_of(box, dimension))) return {};
  Piece piece{measure, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    piece.centroid[i] = ball.centre[i] + (ball_moments.centroid[i] - hollow.centroid[i]) / measure;
  return piece;
}

}  // namespace barreno
