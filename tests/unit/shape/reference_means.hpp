// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unit/shape/shape_cases.hpp"

namespace barreno::testing {

/// The means of the field x y over a particle by Gauss points, for every form that a shape function
/// gives it. Positions in lengths, x = r in axisymmetry.

struct GaussPoint {
  double at, weight;
};
inline constexpr GaussPoint gauss[3] = {
    {-0.7745966692414833770, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414833770, 5.0 / 9.0}};

/// Sums of f w and of w = r (1 in plane modes), and of f alone for the hoop mean.
template <class M>
struct WeightedSums {
  Means sum;
  double size = 0.0;
  void add(double volume, double r, double value, const double (&gradient)[2]) {
    const double w = volume * (M::hoop ? r : 1.0);
    size += w;
    sum.value += w * value;
    sum.gradient[0] += w * gradient[0];
    sum.gradient[1] += w * gradient[1];
    sum.hoop += volume * value;
  }
  Means means() const {
    Means out = sum;
    out.value /= size;
    for (double& g : out.gradient) g /= size;
    out.hoop = M::hoop ? out.hoop / size : 0.0;
    return out;
  }
};

template <class M>
Means means_at_point(const ParticleGeometry& particle) {
  const double r = position(particle, 0, particle.x[0]);
  const double y = position(particle, 1, particle.x[1]);
  return {r * y, {y, r, 0.0}, M::hoop ? y : 0.0};
}

/// The box of a particle along one axis, with half sizes stretched by U_ii where S follows F, cut
/// at the axis.
struct Interval {
  double lower, upper;
};
template <class M, class S>
Interval box_along(const ShapeCase& c, int d) {
  const ParticleGeometry& particle = c.particle;
  double half = particle.half[d];
  if (S::follows_deformation) half = std::min({half * c.stretch[d], particle.largest, 1.0});
  double lower = position(particle, d, particle.x[d] - half);
  if (M::hoop && d == 0) lower = std::max(lower, 0.0);
  return {lower, position(particle, d, particle.x[d] + half)};
}

template <class M, class S>
Means means_over_box(const ShapeCase& c) {
  const Interval x = box_along<M, S>(c, 0);
  const Interval y = box_along<M, S>(c, 1);
  WeightedSums<M> sums;
  for (const GaussPoint& i : gauss)
    for (const GaussPoint& j : gauss) {
      const double r = 0.5 * (x.lower + x.upper) + 0.5 * i.at * (x.upper - x.lower);
      const double z = 0.5 * (y.lower + y.upper) + 0.5 * j.at * (y.upper - y.lower);
      sums.add(i.weight * j.weight, r, r * z, {z, r});
    }
  return sums.means();
}

/// The field between the corners of a domain is that of its corners, interpolated.
template <class M, class S>
Means means_over_domain(const ShapeCase& c) {
  constexpr int D = M::dimensions;
  const Domain<D> domain = S::template domain<M>(c.particle);
  const Domain<D> slope = dual(domain);
  const int points = D == 3 ? 27 : 9;
  WeightedSums<M> sums;
  for (int k = 0; k < points; ++k) {
    const GaussPoint xi[3] = {gauss[k % 3], gauss[k / 3 % 3], gauss[D == 3 ? k / 9 : 1]};
    double weight = 1.0;
    double r = c.particle.x[0];
    for (int i = 0; i < D; ++i) {
      weight *= xi[i].weight;
      r += xi[i].at * domain.e[i][0];
    }
    double value = 0.0;
    double along[3] = {};  // d value / d xi_i
    for (int corner = 0; corner < 1 << D; ++corner) {
      double x[3] = {c.particle.x[0], c.particle.x[1], c.particle.x[2]};
      double m = 1.0;
      double dm[3] = {1.0, 1.0, 1.0};
      for (int i = 0; i < D; ++i) {
        const double sign = (corner >> i & 1) != 0 ? 1.0 : -1.0;
        for (int d = 0; d < D; ++d) x[d] += sign * domain.e[i][d];
        m *= 0.5 * (1.0 + sign * xi[i].at);
        for (int j = 0; j < D; ++j) dm[j] *= i == j ? 0.5 * sign : 0.5 * (1.0 + sign * xi[i].at);
      }
      const double field = position(c.particle, 0, x[0]) * position(c.particle, 1, x[1]);
      value += m * field;
      for (int i = 0; i < D; ++i) along[i] += dm[i] * field;
    }
    double gradient[2] = {};
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < 2; ++d) gradient[d] += along[i] * slope.e[i][d] / cell;
    sums.add(weight, position(c.particle, 0, r), value, gradient);
  }
  return sums.means();
}

template <class M, class S>
Means reference_means(const ShapeCase& c) {
  if constexpr (S::form == ParticleForm::point) return means_at_point<M>(c.particle);
  if constexpr (S::form == ParticleForm::box) return means_over_box<M, S>(c);
  if constexpr (S::form == ParticleForm::parallelogram) return means_over_domain<M, S>(c);
}

}  // namespace barreno::testing
