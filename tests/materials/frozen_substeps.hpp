// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/portability.hpp>

namespace barreno::arenisca {

/// Counter that keeps the substeps which a step takes: two solvers can then be compared on the same
/// ones.
struct SubstepRecord {
  static constexpr int most = 2000;
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
  BARRENO_FUNCTION void add() {}
};

}  // namespace barreno::arenisca
