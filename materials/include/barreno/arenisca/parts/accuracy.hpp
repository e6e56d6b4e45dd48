// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"

namespace barreno::arenisca {

/// How steps are divided and returned.
struct Accuracy {
  struct Parameters {
    double tolerance;
    int return_solver;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
            &P::tolerance,
            "Tolerance",
            d::none,
            Bounds{0.0, 1.0, true, true},
            // Measured over random updates like those of a penetration: mean error 2e-4 for 1.5
            // substeps; ten times tighter costs twice as much for a third of the error.
            1e-2,
            "relative local error of a substep; results are of second order in the step down to "
            "errors of about a tenth of this, then of first order"
        )},
        {{&P::return_solver,
          "Return solver",
          {"fast", "bisection"},
          0,
          "fast: one superlinear scalar solve; bisection: the published nested method, the oracle "
          "(not "
          "with poroplastic fluid)"}}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
};

}  // namespace barreno::arenisca
