// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/parts/part.hpp"
#include "barreno/outcome.hpp"
#include "barreno/real.hpp"
#include "barreno/tensor.hpp"

namespace barreno::arenisca {

// Overstress of one point or several (real.hpp): Duvaut-Lions with the relaxation time tau = T1
// |D|^-T2, exact for constant rates within the step,
//
//   o' = (elastic change - quasi-static change) (1 - exp(-dt/tau)) tau/dt + o exp(-dt/tau).
//
// The stress that hosts see is the dynamic one, quasi-static stress and overstress; the latter is
// history.

/// Whether and how fast overstress relaxes.
struct Rate {
  struct Parameters {
    double T1_rate_dependence, T2_rate_dependence;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(
             &P::T1_rate_dependence,
             "T1_rate_dependence",
             d::none,
             at_least(0.0),
             0.0,
             "overstress relaxes in T1 |D|^-T2 (in seconds, D per second); 0: no rate dependence"
         ),
         optional(
             &P::T2_rate_dependence,
             "T2_rate_dependence",
             d::none,
             at_least(0.0),
             0.0,
             "exponent of the rate; 0: constant relaxation time T1"
         )},
        {}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
};

/// How overstress relaxes in a step.
template <class R>
struct RelaxationOf {
  MaskOf<R> moves;  ///< where it does
  R mean;           ///< (1 - exp(-dt/tau)) tau/dt
  R left;           ///< exp(-dt/tau)
};
/// D = 0 with T2 > 0: tau is infinite, the overstress stays. dt = 0: rate terms are off and it
/// stays too.
template <class R>
BARRENO_FUNCTION RelaxationOf<R> relaxation_in(
    double T1, double T2, const IncrementOf<Sym3Of<R>>& increment
) {
  constexpr double small = 1e-4;
  const R size = real::sqrt(contract(increment.strain, increment.strain));
  const MaskOf<R> timed = increment.dt > 0.0;
  const MaskOf<R> strained = size > 0.0;
  const R dt = real::select(timed, increment.dt, 1.0);
  R per_tau = R{} + 1.0 / T1;
  if (T2 > 0.0) per_tau = real::select(strained, real::pow(R(size / dt), T2) * (1.0 / T1), 0.0);
  const R ratio = real::select(timed, increment.dt * per_tau, 0.0);
  const R left = real::exp(R(-ratio));
  const MaskOf<R> slow = ratio < small;
  const R series = 1.0 - ratio * (0.5 - ratio * (1.0 / 6.0));
  const R mean = real::select(slow, series, (1.0 - left) / real::select(slow, 1.0, ratio));
  return {timed & (strained | (T2 == 0.0 ? timed : !timed)), mean, left};
}

/// Overstress after a step.
/// @param missed  change of an elastic step less the quasi-static change [stress]
template <class R>
BARRENO_FUNCTION Sym3Of<R> relaxed(
    const RelaxationOf<R>& r, const Sym3Of<R>& missed, const Sym3Of<R>& over
) {
  return select_points(r.moves, r.mean * missed + r.left * over, over);
}

/// Strain that takes this stress.
template <class R>
BARRENO_FUNCTION Sym3Of<R> elastic_strain(const Sym3Of<R>& stress, const ModuliOf<R>& m) {
  return R(0.5 / m.shear) * deviator(stress) + isotropic(R(trace(stress) / (9.0 * m.bulk)));
}

/// Work that a step under the dynamic stress dissipates, by plastic flow and by overstress: what
/// its change does not store by the moduli [stress].
/// @param strain  of the skeleton
/// @param before, after  effective stress
template <class R>
BARRENO_FUNCTION R dissipated_work(
    const Sym3Of<R>& strain, const Sym3Of<R>& before, const Sym3Of<R>& after, const ModuliOf<R>& m
) {
  const Sym3Of<R> mean = 0.5 * (before + after), change = after - before;
  const R stored = contract(deviator(mean), deviator(change)) / (2.0 * m.shear) +
                   trace(mean) * trace(change) / (9.0 * m.bulk);
  return contract(mean, strain) - stored;
}

}  // namespace barreno::arenisca
