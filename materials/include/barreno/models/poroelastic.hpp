// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/models/poroelastic_rules.hpp"
#include "barreno/outcome.hpp"
#include "barreno/pore_point.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// Linear elasticity in logarithmic strain with a pore fluid, after Biot (J. Appl. Phys. 12, 1941).
///
///   d sigma = (K - 2G/3) tr(d eps) I + 2G d eps - alpha dp I
///   dp = M (d zeta - alpha tr(d eps)),   1/M = phi/Kf + (alpha - phi)/Ks,   alpha = 1 - K/Ks
///
/// zeta is the volume of fluid that has come in. update() is undrained, d zeta = 0; drain() is at
/// fixed strain. Linear: the fluid may be under tension.
struct Poroelastic {
  static constexpr const char* name = "Poroelastic";
  static constexpr const char* summary =
      "Isotropic linear elasticity in logarithmic strain with a pore fluid (Biot).";
  using Parameters = PoroelasticParameters;
  struct History {
    double pore_pressure = 0.0, fluid_mass_ratio = 1.0;
  };
  static constexpr int history_count = 2;

  static ParameterTable<Parameters> parameter_table() { return poroelastic_table(); }
  static std::vector<HistoryField> history_table() {
    return {
        {"pore_pressure", dimension::stress, "pressure of the fluid in the pores"},
        {"fluid_mass_ratio", dimension::none, "mass of pore fluid over its initial mass"}};
  }
  static std::string check(const Parameters& p, double /*density*/) { return check_poroelastic(p); }

  Poroelastic(const Parameters& p, double /*density*/)
      : p_(p), biot_(biot_coefficient(p)), storage_(poroelastic_storage(p)) {
    const double coupling = storage_ > 0.0 ? biot_ / storage_ : 0.0;
    pressure_per_strain_ = -coupling;
    undrained_bulk_ = p.bulk_modulus + biot_ * coupling;
  }

  History initial_history() const { return {p_.initial_pressure, 1.0}; }

  /// Stress and fluid of a point at rest: total pressure as given, pore pressure that of the card.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    return initial_state(pressure, p_.initial_pressure);
  }
  /// The same with this pore pressure, which leaves the fluid its initial mass.
  InitialStateOf<Sym3, History> initial_state(double pressure, double p) const {
    const double effective = pressure - biot_ * p;
    const double stored = 0.5 * (effective * effective / p_.bulk_modulus + p * p * storage_);
    return {isotropic(-pressure), {p, 1.0}, 1.0, stored, storage_ > 0.0 || p == 0.0};
  }

  /// Undrained: d sigma = (K + alpha^2 M - 2G/3) tr(d eps) I + 2G d eps, dp = -alpha M tr(d eps).
  BARRENO_FUNCTION Outcome
  update(const IncrementOf<Sym3>& increment, Sym3& stress, History& h) const {
    const double volume_strain = trace(increment.strain);
    const Sym3 end = stress +
                     isotropic((undrained_bulk_ - 2.0 / 3.0 * p_.shear_modulus) * volume_strain) +
                     (2.0 * p_.shear_modulus) * increment.strain;
    const double pressure = h.pore_pressure + pressure_per_strain_ * volume_strain;
    Outcome outcome;
    const double mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
    outcome.elastic_work = 0.5 * mean_ratio * contract(stress + end, increment.strain);
    outcome.longitudinal_modulus = longitudinal_modulus();
    // Finite work means that strain, stresses and volume ratios are finite.
    if (!std::isfinite(outcome.elastic_work) || !is_finite(end) || !sound(pressure, h)) {
      return refused();
    }
    stress = end;
    h.pore_pressure = pressure;
    return outcome;
  }

  BARRENO_FUNCTION PorePoint pore_point(const Sym3& /*stress*/, const History& h) const {
    PorePoint point{h.pore_pressure, biot_, storage_, p_.porosity, h.fluid_mass_ratio, 0.0};
    if (storage_ > 0.0) point.mass_per_volume = 1.0 / p_.porosity;
    return point;
  }

  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const {
    Outcome outcome;
    outcome.longitudinal_modulus = longitudinal_modulus();
    if (fluid_volume == 0.0) return outcome;
    if (!(storage_ > 0.0)) return refused();
    const double rise = fluid_volume / storage_;
    const double mass = fluid_mass_after(pore_point(stress, h), fluid_volume);
    const Sym3 end = stress - isotropic(biot_ * rise);
    outcome.elastic_work = (h.pore_pressure + 0.5 * rise) * fluid_volume;
    if (!(mass >= 0.0) || !std::isfinite(mass + outcome.elastic_work) || !is_finite(end)) {
      return refused();
    }
    stress = end;
    h.pore_pressure += rise;
    h.fluid_mass_ratio = mass;
    return outcome;
  }

  /// Ku + 4G/3, the modulus of plane waves; the fluid moves with the rock [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    return undrained_bulk_ + 4.0 / 3.0 * p_.shear_modulus;
  }
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& /*stress*/, const History& /*h*/, double /*volume_ratio*/
  ) const {
    return longitudinal_modulus();
  }
  /// K + alpha^2 M [stress].
  BARRENO_FUNCTION double undrained_bulk_modulus() const { return undrained_bulk_; }
  const Parameters& parameters() const { return p_; }

private:
  BARRENO_FUNCTION static bool sound(double pressure, const History& h) {
    return std::isfinite(pressure) && h.fluid_mass_ratio >= 0.0 && h.fluid_mass_ratio < HUGE_VAL;
  }
  BARRENO_FUNCTION static Outcome refused() {
    Outcome outcome;
    outcome.status = Status::bad_input;
    return outcome;
  }

  Parameters p_;
  double biot_, storage_;
  double pressure_per_strain_, undrained_bulk_;  ///< -alpha M; K + alpha^2 M [stress]
};

}  // namespace barreno
