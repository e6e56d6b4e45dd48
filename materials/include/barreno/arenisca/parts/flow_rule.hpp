// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/parts/part.hpp"

namespace barreno::arenisca {

/// The published flow rule: the return is the closest point in z = I1/sqrt(3), r = beta sqrt(3K/G)
/// sqrt(J2), see TrialOf; so beta acts squared on the dilatancy.
struct FlowRule {
  struct Parameters {
    double BETA_nonassociativity;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
            &P::BETA_nonassociativity,
            "BETA_nonassociativity",
            d::none,
            Bounds{0.0, 1.0, true, false},
            1.0,
            "beta: dilatancy slope / friction slope = beta^2; above 1 plastic work could be "
            "negative"
        )},
        {}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
  static FlowRule make(const Parameters& p) { return {p.BETA_nonassociativity}; }

  double beta;

  /// The weight of (q_tr - q)^2 beside (x_tr - x)^2: 9 beta^2 K/G.
  /// @param x, evp  I1 and volumetric plastic strain at the start of the substep, which other rules
  /// depend on
  template <class R>
  BARRENO_FUNCTION R metric(const ModuliOf<R>& m, const R& /*x*/, const R& /*evp*/) const {
    return (9.0 * beta * beta) * m.bulk / m.shear;
  }
};

}  // namespace barreno::arenisca
