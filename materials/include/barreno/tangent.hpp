// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

namespace barreno {

/// Stiffness of a point as the components C_ijkl, pairs in the order of Sym3 (xx yy zz xy yz zx):
/// c[i][j] = d sigma_i / d gamma_j, where gamma_j is the strain, twice the tensor's for shears.
/// Nonassociated flow makes it unsymmetric.
struct Tangent {
  double c[6][6]{};
};

/// Models whose moduli change with the state.
template <class Model, class = void>
inline constexpr bool has_moduli_of_state = false;
template <class Model>
inline constexpr bool has_moduli_of_state<
    Model,
    std::void_t<decltype(std::declval<const Model&>().drained_moduli(
        Sym3{}, std::declval<const typename Model::History&>()
    ))>> = true;

/// G of a point in this state [stress].
template <class Model>
double shear_modulus(const Model& model, const Sym3& stress, const typename Model::History& h) {
  if constexpr (has_moduli_of_state<Model>)
    return model.drained_moduli(stress, h).shear;
  else
    return model.parameters().shear_modulus;
}

/// Isotropic stiffness of an unloading point in this state.
template <class Model>
Tangent elastic_tangent(
    const Model& model, const Sym3& stress, const typename Model::History& h, double volume_ratio
) {
  const double shear = shear_modulus(model, stress, h);
  const double axial = model.longitudinal_modulus(stress, h, volume_ratio);
  Tangent tangent;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) tangent.c[i][j] = i == j ? axial : axial - 2.0 * shear;
    tangent.c[i + 3][i + 3] = shear;
  }
  return tangent;
}

/// Models whose updates of one point by several strains go in lanes, in common substeps.
template <class Model, class = void>
constexpr bool goes_in_lanes = false;
#if BARRENO_HAS_LANES
template <class Model>
constexpr bool goes_in_lanes<Model, std::enable_if_t<(Model::groups_together > 0)>> = true;
#endif

namespace tangent {

inline double* components(Sym3& s) {
  static_assert(sizeof(Sym3) == 6 * sizeof(double), "six components, nothing else");
  return &s.xx;
}

/// Strain to either side over which the stress is differenced: large against the round-off of the
/// solvers, small against the step.
inline double difference_step(Sym3 strain) {
  constexpr double smallest = 1e-7, largest = 1e-6, of_step = 1e-4;
  double size = 0.0;
  for (int i = 0; i < 6; ++i) size = std::fmax(size, std::fabs(components(strain)[i]));
  return std::fmin(std::fmax(smallest, of_step * size), largest);
}

/// The increment with a strain component changed by h; the volume follows.
inline Increment shifted(const Increment& increment, int component, double h) {
  Increment shifted = increment;
  components(shifted.strain)[component] += h;
  if (component < 3) shifted.volume_ratio_end *= std::exp(h);
  return shifted;
}

inline double largest(Sym3 s) {
  double size = 0.0;
  for (int i = 0; i < 6; ++i) size = std::fmax(size, std::fabs(components(s)[i]));
  return size;
}

/// Slope of the stress from three of its values, h apart. Centred, unless the stress jumps on one
/// side, which shows as a slope steeper than any material's (large steps can end on one branch of
/// the return or another, and moduli jump where rock becomes dilated): then the slope of the other
/// side.
inline Sym3 slope(const Sym3& left, const Sym3& middle, const Sym3& right, double h, double steep) {
  const Sym3 one = (1.0 / h) * (middle - left), other = (1.0 / h) * (right - middle);
  if (largest(one) > steep && largest(other) <= steep) return other;
  if (largest(other) > steep && largest(one) <= steep) return one;
  return 0.5 * (one + other);
}

/// Stresses at the end of a step: of the step itself, and of strains to both sides of it in each of
/// the six components.
struct Neighbours {
  Sym3 middle;
  Sym3 side[6][2];
};

template <class Model>
bool visit_neighbours(
    const Model& model,
    const Increment& increment,
    const Sym3& stress,
    const typename Model::History& begin,
    double h,
    Neighbours& n
) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 2; ++k) {
      n.side[j][k] = stress;
      typename Model::History end = begin;
      const Increment near = shifted(increment, j, k == 0 ? -h : h);
      if (model.update(near, n.side[j][k], end).failed()) return false;
    }
  }
  return true;
}

#if BARRENO_HAS_LANES
/// The same in lanes: the step itself in the first, strains of one side in those that follow.
template <class Model>
bool visit_neighbours_in_lanes(
    const Model& model,
    const Increment& increment,
    const Sym3& stress,
    const typename Model::History& begin,
    double h,
    Neighbours& n
) {
  constexpr int shifts_at_once = lane_count - 1;
  for (int k = 0; k < 2; ++k)
    for (int first = 0; first < 6; first += shifts_at_once) {
      Increment near[lane_count];
      Sym3 ends[lane_count];
      const int count = first + shifts_at_once < 6 ? shifts_at_once : 6 - first;
      for (int i = 0; i < lane_count; ++i) {
        const bool shifts = i >= 1 && i <= count;
        near[i] = shifts ? shifted(increment, first + i - 1, k == 0 ? -h : h) : increment;
      }
      if (!arenisca::update_alike(model, near, stress, begin, ends)) return false;
      n.middle = ends[0];
      for (int j = 0; j < count; ++j) n.side[first + j][k] = ends[j + 1];
    }
  return true;
}
#endif

}  // namespace tangent

/// update() and the tangent of this update: d sigma(end) / d strain increment by central
/// differences of the whole update, as accurate as its solvers (Arenisca: 1e-6 and better away from
/// kinks). A zero increment, or one whose neighbours fail, gets the elastic tangent at the end of
/// the step; a failed update gets the elastic tangent at its start.
template <class Model>
Outcome update_with_tangent(
    const Model& model,
    const Increment& increment,
    Sym3& stress,
    typename Model::History& history,
    Tangent& result
) {
  const Sym3 stress_begin = stress;
  const typename Model::History begin = history;
  const Outcome outcome = model.update(increment, stress, history);
  result = elastic_tangent(
      model,
      stress,
      history,
      outcome.failed() ? increment.volume_ratio_begin : increment.volume_ratio_end
  );
  if (outcome.failed() || contract(increment.strain, increment.strain) == 0.0) return outcome;
  const double h = tangent::difference_step(increment.strain);
  const double at_begin =
      model.longitudinal_modulus(stress_begin, begin, increment.volume_ratio_begin);
  constexpr double margin =
      4.0;  // nonlinear elasticity and nonassociated flow go a little beyond 1
  const double steep = margin * std::fmax(at_begin, result.c[0][0]);
  tangent::Neighbours near{stress, {}};
  bool found = false;
  if constexpr (goes_in_lanes<Model>)
    found = tangent::visit_neighbours_in_lanes(model, increment, stress_begin, begin, h, near);
  else
    found = tangent::visit_neighbours(model, increment, stress_begin, begin, h, near);
  if (!found) return outcome;
  Tangent differences;
  for (int j = 0; j < 6; ++j) {
    // A shear component counts twice in gamma.
    const double width = j < 3 ? h : 2.0 * h;
    Sym3 column = tangent::slope(near.side[j][0], near.middle, near.side[j][1], width, steep);
    for (int i = 0; i < 6; ++i) differences.c[i][j] = tangent::components(column)[i];
  }
  result = differences;
  return outcome;
}

}  // namespace barreno
