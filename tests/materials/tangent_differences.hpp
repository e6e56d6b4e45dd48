// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sample_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <barreno/tangent.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string>

/// What tests of tangents compare with.
namespace barreno::test {

inline double largest(const Tangent& t) {
  double size = 0.0;
  for (const auto& row : t.c) {
    for (const double c : row) size = std::fmax(size, std::fabs(c));
  }
  return size;
}
inline double difference(const Tangent& a, const Tangent& b) {
  Tangent d;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) d.c[i][j] = a.c[i][j] - b.c[i][j];
  }
  return largest(d);
}

/// d sigma / d gamma of a model's step by differences over 4 points, fourth order; plain update().
template <class Model>
struct Differences {
  Tangent central, left, right;
  bool same_substeps = true;  ///< else they are differences of a function that jumps
};

template <class Model>
Differences<Model> differences(
    const Point<Model>& begin, const Sym3& strain, double time_step = 0.0
) {
  constexpr double h = 4e-7;
  Differences<Model> result;
  const auto stress_at = [&](int component, double shift, int& substeps) {
    Point<Model> point = begin;
    Sym3 shifted = strain;
    tangent::components(shifted)[component] += component < 3 ? shift : 0.5 * shift;
    EXPECT_FALSE(point.apply(shifted, time_step).failed());
    substeps = point.last.substeps;
    return point.stress;
  };
  int n[5];
  Sym3 s[5];
  s[2] = stress_at(0, 0.0, n[2]);
  for (int j = 0; j < 6; ++j) {
    for (const int k : {0, 1, 3, 4}) s[k] = stress_at(j, (k - 2) * h, n[k]);
    result.same_substeps = result.same_substeps && std::equal(n + 1, n + 5, n);
    for (int i = 0; i < 6; ++i) {
      const auto v = [&](int k) { return tangent::components(s[k])[i]; };
      result.central.c[i][j] = (8.0 * (v(3) - v(1)) - (v(4) - v(0))) / (12.0 * h);
      result.right.c[i][j] = (-3.0 * v(2) + 4.0 * v(3) - v(4)) / (2.0 * h);
      result.left.c[i][j] = (3.0 * v(2) - 4.0 * v(1) + v(0)) / (2.0 * h);
    }
  }
  return result;
}

/// Strain increments that lead everywhere: the six kinds of a path.
inline Sym3 direction(int kind, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  Sym3 d{};
  for (int i = 0; i < 6; ++i) tangent::components(d)[i] = normal(engine);
  d = deviator(d);
  switch (kind) {
    case 0:
      return 0.02 * d + isotropic(-1.0);  // towards the tip of the cap
    case 1:
      return d + isotropic(-0.8);  // cap
    case 2:
      return d + isotropic(-0.25);  // about the corner
    case 3:
      return d;  // shear, dilating
    case 4:
      return 0.3 * d + isotropic(0.5);  // tension
    default:
      return d + isotropic(normal(engine));
  }
}

inline const char* const through_jump = "through the moduli's jump";

/// Where on the yield surface a step has ended that flowed; x = I1 and q = sqrt(J2) about the
/// elastic centre.
inline std::string region(double x, double q, double vertex, const arenisca::Cap& cap) {
  if (x >= vertex * (1.0 - 1e-9)) return "vertex";
  if (!cap.present || x >= cap.kappa) return "shear";
  const double towards_tip = (cap.kappa - x) / (cap.kappa - cap.X);
  if (towards_tip < 0.1) return "corner of shear and cap";
  return q < 0.02 * std::fabs(x) ? "tip of the cap" : "cap";
}

struct TangentTally {
  int checked = 0, at_kinks = 0, jumped = 0;
  double worst = 0.0;
};
using Tallies = std::map<std::string, TangentTally>;

/// Compares a model's tangents with differences of another solver's steps: paths of 12 steps from
/// 1e-4 to 2e-3.
/// @param region_of  (point at the end, plastic volume strain at the start) to the name of a region
template <class Model, class Oracle, class RegionOf>
Tallies compare_tangents(
    const Model& model, const Oracle& oracle, double time_step, int paths, const RegionOf& region_of
) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> exponent(-4.0, -2.7);
  Tallies regions;
  for (int path = 0; path < paths; ++path) {
    Point<Oracle> point(oracle);
    point.stress = oracle.initial_state(0.0).stress;
    const Sym3 way = direction(path % 6, engine);
    for (int i = 0; i < 12; ++i) {
      const double size = std::pow(10.0, exponent(engine)) * (i % 8 == 7 ? -1.0 : 1.0);
      const Sym3 strain = size * way;
      const auto expected = differences(point, strain, time_step);
      Sym3 stress = point.stress;
      typename Model::History history = point.history;
      Tangent tangent;
      const Increment increment = point.increment(strain, time_step);
      EXPECT_FALSE(update_with_tangent(model, increment, stress, history, tangent).failed());
      const double evp_begin = point.history.plastic_volume_strain;
      EXPECT_FALSE(point.apply(strain, time_step).failed());
      TangentTally& tally = regions[region_of(point, evp_begin)];
      const double scale = point.last.longitudinal_modulus;
      if (!expected.same_substeps) {
        ++tally.jumped;
      } else if (difference(expected.left, expected.right) > 1e-5 * scale) {
        ++tally.at_kinks;
      } else {
        ++tally.checked;
        tally.worst = std::fmax(tally.worst, difference(tangent, expected.central) / scale);
      }
    }
  }
  return regions;
}

inline void demand_tangents(const Tallies& regions) {
  for (const auto& [name, tally] : regions) {
    std::printf(
        "%-26s %5d checked, worst %.1e; %d at kinks, %d where substeps change\n",
        name.c_str(),
        tally.checked,
        tally.worst,
        tally.at_kinks,
        tally.jumped
    );
    EXPECT_LT(tally.worst, 2e-5) << name;
    if (name == through_jump) continue;
    EXPECT_GE(tally.checked, 10) << name;
    EXPECT_LE(tally.at_kinks + tally.jumped, tally.checked) << name;
  }
  EXPECT_EQ(regions.size(), 7U);
}

}  // namespace barreno::test
