// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/disk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace barreno {
namespace {

/// Integrals from 0 to x of h, x h and h^2 with h = sqrt(R^2 - x^2).
struct Integrals {
  double h, xh, hh;
};
Integrals integrals(double radius, double x) {
  const double h = std::sqrt(std::max(0.0, radius * radius - x * x));
  // From h, so that its round-off near x = R, which is a root's (1e-8), leaves the sum below.
  const double angle = std::atan2(x, h);
  return {
      0.5 * (x * h + radius * radius * angle),
      (radius * radius * radius - h * h * h) / 3.0,
      radius * radius * x - x * x * x / 3.0};
}

/// Part of the disk between x = a and x = b, where its lower and its upper bound are each either
/// the rectangle's edge or the circle; `r` has the disk's centre as origin.
DiskMoments strip(double radius, const Rectangle& r, double a, double b) {
  const double middle = 0.5 * (a + b);
  const double h = std::sqrt(std::max(0.0, radius * radius - middle * middle));
  const double low = r.lower[1], high = r.upper[1];
  if (std::min(high, h) <= std::max(low, -h)) return {};
  const Integrals to = integrals(radius, b), from = integrals(radius, a);
  const double length = b - a, first = 0.5 * (b * b - a * a);
  DiskMoments m;
  const auto add = [&](double sign, bool circle, double side, double edge) {
    m.area += sign * (circle ? side * (to.h - from.h) : edge * length);
    m.x += sign * (circle ? side * (to.xh - from.xh) : edge * first);
    m.y += sign * 0.5 * (circle ? to.hh - from.hh : edge * edge * length);
  };
  add(1.0, h < high, 1.0, high);
  add(-1.0, -h > low, -1.0, low);
  return m;
}

}  // namespace

DiskMoments disk_moments(double radius, const Rectangle& r) {
  if (!(radius > 0.0)) return {};
  std::array<double, 8> breaks{r.lower[0], r.upper[0], -radius, radius};
  int i = 4;
  for (const double y : {r.lower[1], r.upper[1]}) {
    const double x = std::sqrt(std::max(0.0, radius * radius - y * y));
    breaks[static_cast<std::size_t>(i++)] = -x;
    breaks[static_cast<std::size_t>(i++)] = x;
  }
  const double from = std::max(r.lower[0], -radius), to = std::min(r.upper[0], radius);
  for (double& x : breaks) x = std::clamp(x, from, std::max(from, to));
  std::sort(breaks.begin(), breaks.end());
  DiskMoments sum;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (!(breaks[k + 1] > breaks[k])) continue;
    const DiskMoments part = strip(radius, r, breaks[k], breaks[k + 1]);
    sum.area += part.area;
    sum.x += part.x;
    sum.y += part.y;
  }
  return sum;
}

}  // namespace barreno
