// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/slices.hpp"

#include "base/numbers.hpp"
#include "geometry/disk.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr std::size_t gauss_points = 12;
struct GaussRule {
  std::array<double, gauss_points> place{}, weight{};
};

/// Gauss-Legendre rule on [-1, 1]: roots of P_n by Newton's method.
GaussRule make_gauss_rule() {
  GaussRule rule;
  constexpr double n = gauss_points;
  for (std::size_t i = 0; i < gauss_points; ++i) {
    double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (n + 0.5)), slope = 1.0;
    for (int newton = 0; newton < 20; ++newton) {
      double value = 1.0, before = 0.0;
      for (double k = 1.0; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    rule.place[i] = x;
    rule.weight[i] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

/// Radii at which a circle around the origin reaches an edge or a corner of a rectangle.
std::array<double, 8> critical_radii(const Rectangle& r) {
  std::array<double, 8> radii{};
  std::size_t k = 0;
  for (const double x : {r.lower[0], r.upper[0]}) radii[k++] = std::abs(x);
  for (const double y : {r.lower[1], r.upper[1]}) radii[k++] = std::abs(y);
  for (const double x : {r.lower[0], r.upper[0]})
    for (const double y : {r.lower[1], r.upper[1]}) radii[k++] = std::hypot(x, y);
  return radii;
}

/// The integral of disks between sorted heights, local to the axis.
template <class Radius>
Piece integrate(
    const Rectangle& rectangle, std::vector<double>& heights, std::size_t axis, const Radius& radius
) {
  static const GaussRule rule = make_gauss_rule();
  const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  std::sort(heights.begin(), heights.end());
  Piece sum;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    const double middle = 0.5 * (heights[k] + heights[k + 1]);
    const double half = 0.5 * (heights[k + 1] - heights[k]);
    if (!(half > 0.0)) continue;
    for (std::size_t g = 0; g < gauss_points; ++g) {
      const double angle = 0.5 * pi * (1.0 + rule.place[g]);
      const double z = middle - half * std::cos(angle);
      const double weight = 0.5 * pi * rule.weight[g] * half * std::sin(angle);
      const DiskMoments disk = disk_moments(radius(z), rectangle);
      sum.measure += weight * disk.area;
      sum.centroid[first] += weight * disk.x;
      sum.centroid[second] += weight * disk.y;
      sum.centroid[axis] += weight * z * disk.area;
    }
  }
  return sum;
}

Rectangle rectangle_across(const Box& box, const Vector& centre, std::size_t axis) {
  const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  return {
      {box.lower[first] - centre[first], box.lower[second] - centre[second]},
      {box.upper[first] - centre[first], box.upper[second] - centre[second]}};
}

}  // namespace

Piece slice_ball(const Vector& centre, double radius, const Box& box) {
  const double from = std::max(box.lower[2] - centre[2], -radius);
  const double to = std::min(box.upper[2] - centre[2], radius);
  if (!(to > from)) return {};
  const Rectangle rectangle = rectangle_across(box, centre, 2);
  std::vector<double> heights{from, to};
  for (const double r : critical_radii(rectangle)) {
    if (r >= radius) continue;
    const double z = std::sqrt(radius * radius - r * r);
    for (const double height : {-z, z})
      if (height > from && height < to) heights.push_back(height);
  }
  return integrate(rectangle, heights, 2, [radius](double z) {
    return std::sqrt(std::max(0.0, radius * radius - z * z));
  });
}

Piece slice_round(const Round& round, const Box& box) {
  const double origin = round.centre[round.axis];
  const double from = std::max(box.lower[round.axis], round.from) - origin;
  const double to = std::min(box.upper[round.axis], round.to) - origin;
  if (!(to > from)) return {};
  const double slope = (round.radius_to - round.radius_from) / (round.to - round.from);
  const double start = round.from - origin;
  const Rectangle rectangle = rectangle_across(box, round.centre, round.axis);
  std::vector<double> heights{from, to};
  for (const double r : critical_radii(rectangle)) {
    if (slope == 0.0) break;
    const double height = start + (r - round.radius_from) / slope;
    if (height > from && height < to) heights.push_back(height);
  }
  return integrate(rectangle, heights, round.axis, [&](double z) {
    return std::max(0.0, round.radius_from + slope * (z - start));
  });
}

}  // namespace barreno
