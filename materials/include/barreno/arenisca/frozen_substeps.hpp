// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

namespace barreno::arenisca {

/// Counter that keeps the verdicts on a step's attempts (general_step.hpp).
///
/// The choice of substeps jumps with the strain, and with it the stress by some tolerance. Between
/// steps that take the same ones it does not: differences of those are the tangent.
struct SubstepRecord {
  static constexpr int most = 2000;  ///< no more attempts than integrate_general() makes
  int count = 0;
  double fractions[most];
  BARRENO_FUNCTION void add() {}
  BARRENO_FUNCTION void took(double fraction) {
    if (count < most) fractions[count++] = fraction;
  }
};

/// Counter that makes a step take the substeps of a record.
struct SubstepReplay {
  const SubstepRecord& record;
  int next = 0;  ///< where the general form is in it
  BARRENO_FUNCTION void add() {}
  BARRENO_FUNCTION void took(double /*fraction*/) {}
};

}  // namespace barreno::arenisca
