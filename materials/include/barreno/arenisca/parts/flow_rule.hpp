// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/cap_shape.hpp"
#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/parts/part.hpp"

#include <limits>

namespace barreno::arenisca {

/// The published flow rule: the return is the closest point in z = I1/sqrt(3), r = beta sqrt(3K/G)
/// sqrt(J2), see TrialOf; so beta acts squared on the dilatancy, which a limit or a pressure bound:
///
///   beta^2 = BETA^2 (s + (1 - s) c),   s = max(m, least) exp(-max(p, 0)/p_d) + D b n
///   m = (1 - D) (1 - max(evp, 0)/w),   n = min(max(-evp/w, 0), 1) min(max(1 - x/kappa, 0), 1)
///
/// Sheared rock stops dilating near the volumetric plastic strain w, and dilates less under
/// pressure, p = -I1/3. Broken rock (D) that is denser than it was when whole dilates b times as
/// much as whole rock does without pressure, the less the nearer it is to its critical state: the
/// volume at the start, or the pressure at which the cap begins, I1 = x = kappa (A. Schofield and
/// P. Wroth, Critical State Soil Mechanics (1968), whose critical states are the top of a surface,
/// where that joins the cap). On the cap, from its branch point (c = 0) to its end (c = 1), the
/// flow becomes that of BETA again: it compacts.
struct FlowRule {
  struct Parameters {
    double BETA_nonassociativity, dilatancy_limit, dilatancy_pressure, broken_dilatancy;
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
         ),
         optional(
             &P::dilatancy_limit,
             "Dilatancy limit",
             d::none,
             at_least(0.0),
             0.0,
             "w: volumetric plastic strain towards which sheared rock dilates; beta^2 falls with "
             "1 - evp/w. 0: without limit, as published"
         ),
         optional(
             &P::dilatancy_pressure,
             "Dilatancy pressure",
             d::stress,
             at_least(0.0),
             0.0,
             "p_d: beta^2 falls with exp(-p/p_d), p the (effective) mean pressure. 0: the same at "
             "any pressure, as published"
         ),
         optional(
             &P::broken_dilatancy,
             "Broken dilatancy",
             d::none,
             Bounds{0.0, 1.0, false, false},
             0.0,
             "b: of the dilatancy of whole rock without pressure, what fully damaged rock has "
             "where it is denser than in its critical state. 0: none"
         )},
        {}};
  }
  static std::string check(const Parameters& p) {
    if (p.broken_dilatancy == 0.0 || p.dilatancy_limit > 0.0) return {};
    return named("Broken dilatancy", p.broken_dilatancy) +
           " needs a Dilatancy limit, but that is 0 (rock that dilates without end); set one, 0.05 "
           "for example, or leave Broken dilatancy out.";
  }
  static FlowRule make(const Parameters& p) {
    const auto inverse = [](double scale) { return scale > 0.0 ? 1.0 / scale : 0.0; };
    return {
        p.BETA_nonassociativity,
        inverse(p.dilatancy_limit),
        inverse(p.dilatancy_pressure),
        p.broken_dilatancy};
  }

  /// Of beta^2, where rock is dilated and at any pressure: the return needs a direction.
  static constexpr double least = 1e-4, least_of_all = 1e-100;

  double beta, per_strain, per_pressure, broken;

  /// 1 - x/kappa: 1 without pressure, 0 from the branch point of the cap on.
  template <class R>
  BARRENO_FUNCTION static R before_cap(const R& x, const CapOf<R>& cap) {
    const R kappa = real::select(cap.present, cap.kappa, -std::numeric_limits<double>::infinity());
    return real::larger(real::smaller(R(1.0 - x / kappa), 1.0), 0.0);
  }

  /// What is left of BETA^2 at I1 = x and volumetric plastic strain evp.
  /// @param intact  1 - D
  template <class R>
  BARRENO_FUNCTION R
  share(const R& x, const R& evp, const CapOf<R>& cap, const R& intact = R{} + 1.0) const {
    const R room = real::larger(R(intact * (1.0 - per_strain * real::larger(evp, 0.0))), least);
    const R pressed = real::exp(R((per_pressure / 3.0) * real::smaller(x, 0.0)));
    R left = real::larger(R(room * pressed), least_of_all);
    if (broken > 0.0)
      left += broken * (1.0 - intact) *
              real::smaller(real::larger(R(-per_strain * evp), 0.0), 1.0) * before_cap(x, cap);
    return left + (1.0 - left) * place_on_cap(x, cap);
  }

  /// The weight of (q_tr - q)^2 beside (x_tr - x)^2: 9 beta^2 K/G.
  /// @param x, evp  I1 and volumetric plastic strain at the start of the substep, and the cap there
  template <class R>
  BARRENO_FUNCTION R metric(
      const ModuliOf<R>& m,
      const R& x,
      const R& evp,
      const CapOf<R>& cap,
      const R& intact = R{} + 1.0
  ) const {
    const R whole = (9.0 * beta * beta) * m.bulk / m.shear;
    if (per_strain == 0.0 && per_pressure == 0.0) return whole;
    return whole * share(x, evp, cap, intact);
  }
};

}  // namespace barreno::arenisca
