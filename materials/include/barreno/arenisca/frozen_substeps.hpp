// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A step again, with the substeps of another one. Read first: substep.hpp, which includes this.
#include "barreno/arenisca/substep.hpp"

namespace barreno::arenisca {

/// Counter that keeps the fractions of the step that its substeps were; none: the step was taken
/// whole. Of the general form it keeps the verdicts on its attempts (general_step.hpp).
///
/// The choice of substeps jumps with the strain, and with it the stress by some tolerance. Between
/// steps that take the same ones it does not: differences of those are the tangent.
struct SubstepRecord {
  static constexpr int most = 2000;  ///< no more than integrate() attempts
  int count = 0;
  double fractions[most];
  BARRENO_FUNCTION void add() {}
  BARRENO_FUNCTION void took(double fraction) {
    if (count < most) fractions[count++] = fraction;
  }
};

/// Counter that makes integrate() take the substeps of a record.
struct SubstepReplay {
  const SubstepRecord& record;
  int next = 0;  ///< where the general form is in it
  BARRENO_FUNCTION void add() {}
  BARRENO_FUNCTION void took(double /*fraction*/) {}
};

/// Integrates a step in the substeps of the record, whatever their error.
/// @param[in,out] state  stress and history; meaningful only when the outcome is ok
BARRENO_FUNCTION Outcome
integrate(const Rock& rock, PointState& state, const Sym3& strain, SubstepReplay& replay) {
  const SubstepRecord& record = replay.record;
  const double volume = trace(strain);
  const Sym3 shape = deviator(strain);
  Outcome outcome;
  outcome.substeps = record.count > 0 ? record.count : 1;
  for (int i = 0; i < outcome.substeps; ++i) {
    const double fraction = record.count > 0 ? record.fractions[i] : 1.0;
    const Attempt a = attempt_substep(rock, state, fraction * volume, fraction * shape, replay);
    if (!std::isfinite(a.error)) {
      outcome.status = Status::not_converged;
      return outcome;
    }
    state = a.end;
    outcome.elastic_work += a.elastic_work;
    outcome.plastic_work += a.plastic_work;
    outcome.longitudinal_modulus = a.moduli.bulk + 4.0 / 3.0 * a.moduli.shear;
  }
  return outcome;
}

}  // namespace barreno::arenisca
