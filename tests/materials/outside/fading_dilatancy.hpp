// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno::arenisca::outside {

/// A flow rule of which the dilatancy fades as the rock dilates, as that of loosened rock does:
///
///   beta = BETA exp(-max(evp, 0)/w)
struct FadingDilatancy {
  struct Parameters {
    double dilation_scale;
  };
  static ParameterTable<Parameters> parameter_table() {
    return {
        {optional(
            &Parameters::dilation_scale,
            "Dilation scale",
            dimension::none,
            at_least(0.0),
            0.0,
            "w: volumetric plastic strain over which the dilatancy fades; 0: the published flow "
            "rule"
        )},
        {}};
  }
  static constexpr const char* word = "Dilation scale";
  template <class P>
  static bool asked(const P& p) {
    return p.dilation_scale > 0.0;
  }
  template <class P>
  static std::string check(const P& /*p*/) {
    return {};
  }
  /// A sound card with it.
  template <class P>
  static void ask(P& p) {
    p.dilation_scale = 0.02;
  }
  template <class P>
  static FadingDilatancy make(const P& p) {
    return {p.BETA_nonassociativity, -1.0 / p.dilation_scale};
  }

  double beta, per_scale;

  template <class R>
  BARRENO_FUNCTION R
  metric(const ModuliOf<R>& m, const R& /*x*/, const R& evp, const CapOf<R>& /*cap*/) const {
    const R factor = beta * real::exp(R(per_scale * real::larger(evp, 0.0)));
    return 9.0 * factor * factor * m.bulk / m.shear;
  }
};

}  // namespace barreno::arenisca::outside
