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

/// What becomes of an attempt: it is taken, and the next substep is this times as large (> 0); it
/// is tried again so many times as large (< 0); it is tried again up to the jump of the moduli (0).
BARRENO_FUNCTION double verdict_on(
    const Attempt& a, double way, double fraction, double taken, double smallest
) {
  if (way < 1.0 && fraction > smallest) return 0.0;
  const double factor = step_factor(a);
  return a.error > a.allowed && taken * fraction > smallest ? -factor : factor;
}
template <class Counter>
BARRENO_FUNCTION double settled(double verdict, Counter& count) {
  count.took(verdict);
  return verdict;
}
/// That of the step which is repeated. All else moves with the strain, and smoothly: where the
/// surface is reached, where the moduli jump.
BARRENO_FUNCTION double settled(double verdict, SubstepReplay& replay) {
  const bool known = replay.next < replay.record.count;
  return known ? replay.record.fractions[replay.next++] : verdict;
}

/// Integrates a step in error-controlled substeps, or in those of a replay.
template <class Counter>
BARRENO_FUNCTION GeneralStep
integrate_general(const PointRock& point, GeneralState& state, const Sym3& strain, Counter& count) {
  constexpr int max_attempts = SubstepRecord::most;
  constexpr double smallest = 1.0 / 4096.0, smallest_strain = 1e-6, round_off = 1e-14;
  GeneralStep step;
  step.outcome.substeps = 0;
  const double volume = trace(strain), size = norm(strain);
  const Sym3 shape = deviator(strain);
  const double smallest_fraction =
      size * smallest > smallest_strain ? smallest_strain / size : smallest;
  double left = 1.0, fraction = 1.0;
  for (int i = 0; i < max_attempts; ++i) {
    const bool last = fraction >= left;
    if (last) fraction = left;
    GeneralEnd end;
    double taken = 1.0;
    const Attempt a =
        attempt_general(point, state, fraction * volume, fraction * shape, end, taken, count);
    if (!std::isfinite(a.error)) break;
    const double way = point.rock.elasticity.way_to_jump(state.e, end.state.e);
    const double verdict = settled(verdict_on(a, way, fraction, taken, smallest_fraction), count);
    if (verdict <= 0.0) {
      fraction *= verdict == 0.0 ? smaller(way, 1.0) : -verdict * taken;
      continue;
    }
    state = end.state;
    const double part = taken * fraction;
    step.add(end, part * volume, part * shape);
    left -= part;
    if ((last && taken == 1.0) || left < round_off) return step;
    // The surface may be reached where the substep ends, but for round-off.
    fraction = state.on_surface ? larger(fraction - part, smallest_fraction) : fraction * verdict;
  }
  step.outcome.status = Status::substep_limit;
  return step;
}

}  // namespace barreno::arenisca
