// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

namespace barreno::arenisca {

/// Counts yield-function evaluations for benchmarks; the default counts nothing and costs nothing.
struct NoCounter {
  BARRENO_FUNCTION void add() const {}
};
struct EvaluationCounter {
  long evaluations = 0;
  BARRENO_FUNCTION void add() { ++evaluations; }
};

}  // namespace barreno::arenisca
