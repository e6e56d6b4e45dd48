// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/frozen_substeps.hpp"
#include "barreno/arenisca/general_substep.hpp"
#include "barreno/outcome.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Result of a whole step of the general rock.
struct GeneralStep {
  Outcome outcome;
  double elastic_x = 0.0;  ///< change of I1 had the step been elastic [stress]
  Sym3 elastic_s;          ///< the same for the deviator [stress]
  Moduli last{};           ///< moduli of the last substep

  /// Counts a substep over these parts of the strain.
  BARRENO_FUNCTION void add(const GeneralEnd& end, double dv, const Sym3& de) {
    outcome.elastic_work += end.elastic_work;
    outcome.plastic_work += end.plastic_work;
    elastic_x += 3.0 * end.used.bulk * dv;
    elastic_s = elastic_s + (2.0 * end.used.shear) * de;
    last = end.used;
    ++outcome.substeps;
  }
};

/// What a counter is told of the last substep instead of its size.
constexpr double to_the_end = 0.0;

/// Integrates a step in error-controlled substeps. The counter is told of each its size over that
/// of the one before, or over what the way to the surface has left of it.
template <class Counter>
BARRENO_FUNCTION GeneralStep
integrate_general(const PointRock& point, GeneralState& state, const Sym3& strain, Counter& count) {
  constexpr int most_attempts = 2000;
  constexpr double smallest = 1.0 / 4096.0, smallest_strain = 1e-6;
  GeneralStep step;
  step.outcome.substeps = 0;
  const double volume = trace(strain), size = norm(strain);
  const Sym3 shape = deviator(strain);
  const double smallest_fraction =
      size * smallest > smallest_strain ? smallest_strain / size : smallest;
  double done = 0.0, fraction = 1.0, asked = 1.0;
  for (int i = 0; i < most_attempts; ++i) {
    const bool last = done + fraction >= 1.0;
    if (last) fraction = 1.0 - done;
    GeneralEnd end;
    double taken = 1.0;
    const Attempt a =
        attempt_general(point, state, fraction * volume, fraction * shape, end, taken, count);
    if (!std::isfinite(a.error)) break;
    const double way = point.rock.elasticity.way_to_jump(state.e, end.state.e);
    if (way < 1.0 && fraction > smallest_fraction) {
      fraction *= way;
      continue;
    }
    if (a.error > a.allowed && taken * fraction > smallest_fraction) {
      fraction *= taken * step_factor(a);
      continue;
    }
    state = end.state;
    count.took(last ? to_the_end : fraction / asked);
    const double part = taken * fraction;
    step.add(end, part * volume, part * shape);
    if (last && taken == 1.0) return step;
    done += part;
    asked = taken < 1.0 ? fraction - part : fraction;
    fraction = taken < 1.0 ? asked : fraction * step_factor(a);
  }
  step.outcome.status = Status::substep_limit;
  return step;
}

/// Integrates a step in the substeps of the record, whatever their error. The way to the surface is
/// found anew: where it ends moves with the strain, and smoothly.
BARRENO_FUNCTION GeneralStep integrate_general(
    const PointRock& point, GeneralState& state, const Sym3& strain, SubstepReplay& replay
) {
  const SubstepRecord& record = replay.record;
  const double volume = trace(strain);
  const Sym3 shape = deviator(strain);
  GeneralStep step;
  step.outcome.substeps = 0;
  double done = 0.0, asked = 1.0;
  for (int i = 0; i < SubstepRecord::most; ++i) {
    const double ratio = i < record.count ? record.fractions[i] : to_the_end;
    const bool last = ratio == to_the_end || done + ratio * asked >= 1.0;
    const double fraction = last ? 1.0 - done : ratio * asked;
    GeneralEnd end;
    double taken = 1.0;
    const Attempt a =
        attempt_general(point, state, fraction * volume, fraction * shape, end, taken, replay);
    if (!std::isfinite(a.error)) break;
    state = end.state;
    const double part = taken * fraction;
    step.add(end, part * volume, part * shape);
    if (last && taken == 1.0) return step;
    done += part;
    asked = taken < 1.0 ? fraction - part : fraction;
  }
  step.outcome.status = Status::not_converged;
  return step;
}

}  // namespace barreno::arenisca
