// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/elasticity.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Overstress after a step, Duvaut-Lions with the relaxation time tau = T1 |D|^-T2, exact for
/// constant rates within the step:
///
///   o' = (elastic change - quasi-static change) (1 - exp(-dt/tau)) tau/dt + o exp(-dt/tau)
///
/// D = 0 with T2 > 0: tau is infinite, the overstress stays. dt = 0: rate terms are off and the
/// overstress stays.
/// @param elastic  stress change had the step been elastic [stress]
/// @param change   change of the quasi-static stress [stress]
BARRENO_FUNCTION Sym3 relax(
    double T1,
    double T2,
    const IncrementOf<Sym3>& increment,
    const Sym3& elastic,
    const Sym3& change,
    const Sym3& over
) {
  if (increment.dt <= 0.0) return over;
  const double rate = norm(increment.strain) / increment.dt;
  if (rate == 0.0 && T2 > 0.0) return over;
  const double tau = T1 * (T2 > 0.0 ? std::pow(rate, -T2) : 1.0);
  const double ratio = increment.dt / tau;
  const double mean = ratio > 0.0 ? -std::expm1(-ratio) / ratio : 1.0;
  return mean * (elastic - change) + std::exp(-ratio) * over;
}

/// Work of a step under the dynamic stress: what the stress change stores by the moduli and the
/// fluid by its pressure; the rest is dissipated, by plastic flow and by overstress.
BARRENO_FUNCTION void split_work(
    const Sym3& strain,
    const Sym3& before,
    const Sym3& after,
    double mean_zeta,
    const Moduli& m,
    Outcome& outcome
) {
  const Sym3 mean = 0.5 * (before + after), change = after - before;
  const double stored = contract(deviator(mean), deviator(change)) / (2.0 * m.shear) +
                        (trace(mean) - mean_zeta) * trace(change) / (9.0 * m.bulk) +
                        mean_zeta * trace(strain) / 3.0;
  outcome.elastic_work = stored;
  outcome.plastic_work = contract(mean, strain) - stored;
}

}  // namespace barreno::arenisca
