// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/outcome.hpp"
#include "barreno/pore_point.hpp"
#include "barreno/tensor.hpp"

#include <string>
#include <vector>

namespace barreno {

/// placeholder until the library's own
struct Poroelastic {
  static constexpr const char* name = "Poroelastic";
  static constexpr const char* summary = "Isotropic linear poroelasticity.";
  struct Parameters {
    double bulk_modulus, shear_modulus, biot, porosity, fluid;
  };
  struct History {
    double pore_pressure = 0.0;
  };
  static constexpr int history_count = 1;
  static ParameterTable<Parameters> parameter_table() {
    return {
        {required(&Parameters::bulk_modulus, "Bulk Modulus", dimension::stress, above(0.0), "K"),
         required(&Parameters::shear_modulus, "Shear Modulus", dimension::stress, above(0.0), "G"),
         required(&Parameters::biot, "Biot Coefficient", dimension::none, above(0.0), "alpha"),
         required(&Parameters::porosity, "Porosity", dimension::none, above(0.0), "phi"),
         required(&Parameters::fluid, "Fluid Bulk Modulus", dimension::stress, above(0.0), "Kf")},
        {}};
  }
  static std::vector<HistoryField> history_table() {
    return {{"pore_pressure", dimension::stress, "p"}};
  }
  static std::string check(const Parameters& /*p*/, double /*density*/) { return {}; }
  Poroelastic(const Parameters& p, double /*density*/) : p_(p) {}
  History initial_history() const { return {}; }
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    return {isotropic(-pressure), History{}, 1.0, 0.0, true};
  }
  double storage() const {
    return p_.porosity / p_.fluid + (p_.biot - p_.porosity) * (1.0 - p_.biot) / p_.bulk_modulus;
  }
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& /*stress*/, const History& h) const {
    return {h.pore_pressure, p_.biot, storage(), p_.porosity, 1.0};
  }
  BARRENO_FUNCTION Outcome drain(double volume, Sym3& stress, History& h) const {
    const double dp = volume / storage();
    h.pore_pressure += dp;
    stress = stress + isotropic(-p_.biot * dp);
    return {};
  }
  BARRENO_FUNCTION Outcome
  update(const IncrementOf<Sym3>& increment, Sym3& stress, History& h) const {
    const Sym3 old = stress;
    const double v = trace(increment.strain), m = 1.0 / storage();
    const double k = p_.bulk_modulus + p_.biot * p_.biot * m;
    stress = stress + isotropic((k - 2.0 / 3.0 * p_.shear_modulus) * v) +
             (2.0 * p_.shear_modulus) * increment.strain;
    h.pore_pressure -= p_.biot * m * v;
    Outcome outcome;
    outcome.elastic_work = 0.5 * contract(old + stress, increment.strain);
    outcome.longitudinal_modulus = longitudinal_modulus();
    return outcome;
  }
  BARRENO_FUNCTION double longitudinal_modulus() const {
    return p_.bulk_modulus + p_.biot * p_.biot / storage() + 4.0 / 3.0 * p_.shear_modulus;
  }
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& /*s*/, const History& /*h*/, double /*v*/
  ) const {
    return longitudinal_modulus();
  }
  const Parameters& parameters() const { return p_; }

private:
  Parameters p_;
};

}  // namespace barreno
