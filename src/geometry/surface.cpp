// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/surface.hpp"

#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace barreno {
namespace {

/// A triangle clipped by four sides of a box and its bottom has at most 3 + 5 corners, and one more
/// by the split at its top.
struct Outline {
  std::array<Vector, 12> corner;
  std::size_t count = 0;
};

/// The part of an outline with sign * (x_axis - place) >= 0.
Outline clip(const Outline& outline, std::size_t axis, double place, double sign) {
  Outline part;
  for (std::size_t i = 0; i < outline.count; ++i) {
    const Vector &a = outline.corner[i], &b = outline.corner[(i + 1) % outline.count];
    const double from = sign * (a[axis] - place), to = sign * (b[axis] - place);
    if (from >= 0.0) part.corner[part.count++] = a;
    if ((from >= 0.0) == (to >= 0.0)) continue;
    // From the same end for both facets of an edge.
    const bool forward = a < b;
    const Vector &u = forward ? a : b, &v = forward ? b : a;
    const double s = (place - u[axis]) / (v[axis] - u[axis]);
    Vector x{};
    for (std::size_t k = 0; k < 3; ++k) x[k] = u[k] + s * (v[k] - u[k]);
    x[axis] = place;
    part.corner[part.count++] = x;
  }
  return part;
}

/// Measure and first moments.
struct Sums {
  double volume = 0.0;
  Vector first{};
};

/// The prism between the plane z = 0 and an outline of heights: h is z, or `height` where it is
/// given.
void add_prism(const Outline& outline, double height, Sums& sums) {
  for (std::size_t k = 1; k + 1 < outline.count; ++k) {
    const std::array<const Vector*, 3> p{
        &outline.corner[0], &outline.corner[k], &outline.corner[k + 1]};
    const double area = 0.5 * (((*p[1])[0] - (*p[0])[0]) * ((*p[2])[1] - (*p[0])[1]) -
                               ((*p[1])[1] - (*p[0])[1]) * ((*p[2])[0] - (*p[0])[0]));
    double h = 0.0, x = 0.0, y = 0.0, hx = 0.0, hy = 0.0, hh = 0.0;
    for (const Vector* corner : p) {
      const double z = height < infinity ? height : (*corner)[2];
      h += z;
      x += (*corner)[0];
      y += (*corner)[1];
      hx += z * (*corner)[0];
      hy += z * (*corner)[1];
      hh += z * z;
    }
    sums.volume += area * h / 3.0;
    sums.first[0] += area / 12.0 * (hx + h * x);
    sums.first[1] += area / 12.0 * (hy + h * y);
    sums.first[2] += area / 24.0 * (hh + h * h);
  }
}

/// Height of a facet's plane over a place.
double height_at(const Vector& a, const Vector& b, const Vector& c, const Vector& x) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1];
  const double turn = ux * vy - uy * vx;
  const double s = ((x[0] - a[0]) * vy - (x[1] - a[1]) * vx) / turn;
  const double t = (ux * (x[1] - a[1]) - uy * (x[0] - a[0])) / turn;
  return a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
}

}  // namespace

Box Surface::box_of(const Facet& facet) const {
  Box box{points_[static_cast<std::size_t>(facet[0])], points_[static_cast<std::size_t>(facet[0])]};
  for (const int point : facet)
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = points_[static_cast<std::size_t>(point)][i];
      box.lower[i] = std::min(box.lower[i], x);
      box.upper[i] = std::max(box.upper[i], x);
    }
  return box;
}

std::array<std::size_t, 2> Surface::bin_of(double x, double y) const {
  std::array<std::size_t, 2> bin{};
  const std::array<double, 2> place{x, y};
  for (std::size_t i = 0; i < 2; ++i) {
    const double length = around_.upper[i] - around_.lower[i];
    const auto n = static_cast<double>(bins_[i]);
    const double share = length > 0.0 ? (place[i] - around_.lower[i]) / length : 0.0;
    bin[i] = static_cast<std::size_t>(std::clamp(std::floor(share * n), 0.0, n - 1.0));
  }
  return bin;
}

Surface::Surface(std::vector<Vector> points, std::vector<Facet> facets)
    : points_(std::move(points)), facets_(std::move(facets)) {
  around_ = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Facet& facet : facets_) {
    boxes_.push_back(box_of(facet));
    for (std::size_t i = 0; i < 3; ++i) {
      around_.lower[i] = std::min(around_.lower[i], boxes_.back().lower[i]);
      around_.upper[i] = std::max(around_.upper[i], boxes_.back().upper[i]);
    }
  }
  // About two facets over each bin of a simple surface.
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(facets_.size())));
  bins_ = {std::clamp<std::size_t>(side, 1, 1000), std::clamp<std::size_t>(side, 1, 1000)};
  // Facets as wide as the whole surface would be in every bin.
  while (bins_[0] > 1 && members_of_bins() > 64 * facets_.size())
    bins_ = {bins_[0] / 2, bins_[1] / 2};
  first_.assign(bins_[0] * bins_[1] + 1, 0);
  const auto over_bins = [&](const Box& box, const auto& visit) {
    const auto from = bin_of(box.lower[0], box.lower[1]), to = bin_of(box.upper[0], box.upper[1]);
    for (std::size_t j = from[1]; j <= to[1]; ++j)
      for (std::size_t i = from[0]; i <= to[0]; ++i) visit(j * bins_[0] + i);
  };
  for (const Box& box : boxes_) over_bins(box, [&](std::size_t bin) { ++first_[bin + 1]; });
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  members_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t f = 0; f < boxes_.size(); ++f)
    over_bins(boxes_[f], [&](std::size_t bin) { members_[next[bin]++] = static_cast<int>(f); });
}

std::size_t Surface::members_of_bins() const {
  std::size_t members = 0;
  for (const Box& box : boxes_) {
    const auto from = bin_of(box.lower[0], box.lower[1]), to = bin_of(box.upper[0], box.upper[1]);
    members += (to[0] - from[0] + 1) * (to[1] - from[1] + 1);
  }
  return members;
}

template <class Visit>
void Surface::for_each_near(const Box& box, Visit&& visit) const {
  const auto from = bin_of(box.lower[0], box.lower[1]), to = bin_of(box.upper[0], box.upper[1]);
  for (std::size_t j = from[1]; j <= to[1]; ++j)
    for (std::size_t i = from[0]; i <= to[0]; ++i)
      for (std::size_t m = first_[j * bins_[0] + i]; m < first_[j * bins_[0] + i + 1]; ++m) {
        const auto f = static_cast<std::size_t>(members_[m]);
        const Box& own = boxes_[f];
        if (own.lower[0] > box.upper[0] || own.upper[0] < box.lower[0] ||
            own.lower[1] > box.upper[1] || own.upper[1] < box.lower[1])
          continue;
        // A facet of several bins is visited in the first one that both reach.
        const auto own_from = bin_of(own.lower[0], own.lower[1]);
        if (i != std::max(from[0], own_from[0]) || j != std::max(from[1], own_from[1])) continue;
        visit(f);
      }
}

int Surface::winding(const Vector& x) const {
  int sum = 0;
  if (x[2] >= around_.upper[2]) return 0;
  for_each_near({x, x}, [&](std::size_t f) {
    if (boxes_[f].upper[2] <= x[2]) return;
    std::array<const Vector*, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = &points_[static_cast<std::size_t>(facets_[f][k])];
    int own = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &a = *p[k], &b = *p[(k + 1) % 3];
      own += crossing({a[0], a[1]}, {b[0], b[1]}, {x[0], x[1]});
    }
    if (own == 0) return;
    if (boxes_[f].lower[2] > x[2] || height_at(*p[0], *p[1], *p[2], x) > x[2]) sum += own;
  });
  return sum;
}

double Surface::volume() const {
  double sum = 0.0;
  for (const Facet& facet : facets_) {
    std::array<Vector, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        p[k][i] = points_[static_cast<std::size_t>(facet[k])][i] - around_.lower[i];
    sum += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
            p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
            p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
           6.0;
  }
  return sum;
}

bool Surface::comes_near(const Box& box) const {
  bool near = false;
  for_each_near(box, [&](std::size_t f) {
    near = near || (boxes_[f].lower[2] <= box.upper[2] && boxes_[f].upper[2] >= box.lower[2]);
  });
  return near;
}

Piece Surface::piece_in(const Box& box) const {
  Sums sums;
  const double top = box.upper[2] - box.lower[2];
  for_each_near(box, [&](std::size_t f) {
    if (boxes_[f].upper[2] <= box.lower[2]) return;
    Outline outline;
    outline.count = 3;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        outline.corner[k][i] = points_[static_cast<std::size_t>(facets_[f][k])][i] - box.lower[i];
    for (std::size_t i = 0; i < 2; ++i) {
      outline = clip(outline, i, 0.0, 1.0);
      outline = clip(outline, i, box.upper[i] - box.lower[i], -1.0);
    }
    outline = clip(outline, 2, 0.0, 1.0);
    if (outline.count < 3) return;
    // One of the two alone for a facet that only touches the top.
    if (boxes_[f].upper[2] > box.upper[2]) add_prism(clip(outline, 2, top, 1.0), top, sums);
    if (boxes_[f].lower[2] < box.upper[2] || !(boxes_[f].upper[2] > box.upper[2]))
      add_prism(clip(outline, 2, top, -1.0), infinity, sums);
  });
  constexpr double least = 1e-12;  // of the box: round-off of the sum
  if (!(sums.volume > least * measure_of(box, 3))) return {};
  Piece piece{sums.volume, box.lower};
  for (std::size_t i = 0; i < 3; ++i) piece.centroid[i] += sums.first[i] / sums.volume;
  return piece;
}

}  // namespace barreno
