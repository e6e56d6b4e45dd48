// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"
#include "materials/scalar_arenisca.hpp"

#include <cmath>
#include <vector>

/// Updates of Arenisca in equal substeps, for what the error-controlled ones are compared with.
namespace barreno {

inline arenisca::PointState state_of(const test::RockPoint& p) {
  return {
      trace(p.stress),
      deviator(p.stress),
      p.history.plastic_volume_strain,
      p.history.equivalent_plastic_strain};
}

/// The step in `count` equal substeps of one return each, first-order accurate: the published
/// scheme.
template <class Counter>
arenisca::PointState take_equal_steps(
    arenisca::Rock rock, const test::RockPoint& point, int count, Counter& counter
) {
  // No error is below this, so no substep takes its second pass.
  rock.tolerance = 1e-300;
  arenisca::PointState state = state_of(point);
  const double part = 1.0 / count, volume = part * trace(point.increment.strain);
  const Sym3 shape = part * deviator(point.increment.strain);
  for (int i = 0; i < count; ++i)
    state = arenisca::attempt_substep(rock, state, volume, shape, counter).end;
  return state;
}

/// One substep with its second pass, whatever its error: second-order accurate.
inline arenisca::ScalarAttempt take_second_order_step(
    arenisca::Rock& rock, const arenisca::PointState& state, double volume, const Sym3& shape
) {
  arenisca::NoCounter none;
  arenisca::ScalarAttempt a;
  // The second pass is taken where the error is somewhat below what is allowed.
  constexpr int max_tries = 6;
  constexpr double least = 0.02, wanted = 0.5;
  for (int i = 0; i < max_tries; ++i) {
    a = arenisca::attempt_substep(rock, state, volume, shape, none);
    const double share = a.error / a.allowed;
    if (a.error == 0.0 || (share > least && share <= 1.0)) break;
    rock.tolerance *= share / wanted;
  }
  return a;
}

/// The step in `count` equal substeps, second-order accurate, divided where the moduli jump.
inline arenisca::PointState take_exact_steps(
    arenisca::Rock rock, const test::RockPoint& point, int count
) {
  arenisca::PointState state = state_of(point);
  const Sym3 shape = deviator(point.increment.strain);
  const double volume = trace(point.increment.strain), part = 1.0 / count;
  for (int i = 0; i < count; ++i) {
    double left = part;
    auto a = take_second_order_step(rock, state, left * volume, left * shape);
    const double way = way_to_jump(rock.elasticity, state.evp, a.end.evp);
    if (way < 1.0) {
      a = take_second_order_step(rock, state, way * left * volume, way * left * shape);
      left *= 1.0 - way;
      a = take_second_order_step(rock, a.end, left * volume, left * shape);
    }
    state = a.end;
  }
  return state;
}

/// Distance of two stresses [stress].
inline double distance(const arenisca::PointState& a, const arenisca::PointState& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) / 3.0 + contract(a.s - b.s, a.s - b.s));
}

}  // namespace barreno
