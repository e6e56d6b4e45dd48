// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

namespace barreno::arenisca {

/// Counts yield-function evaluations for benchmarks; the default counts nothing and costs nothing.
/// Every counter also hears of the substeps that were taken (frozen_substeps.hpp).
struct NoCounter {
  BARRENO_FUNCTION void add() const {}
  BARRENO_FUNCTION void took(double /*fraction*/) const {}
};
struct EvaluationCounter {
  long evaluations = 0;
  BARRENO_FUNCTION void add() { ++evaluations; }
  BARRENO_FUNCTION void took(double /*fraction*/) const {}
};

}  // namespace barreno::arenisca
