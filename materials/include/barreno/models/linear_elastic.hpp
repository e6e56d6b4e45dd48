// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <string>
#include <vector>

namespace barreno {

using Increment = IncrementOf<Sym3>;

/// Isotropic linear elasticity in logarithmic strain, integrated exactly along the step.
///
///   d sigma = (K - 2G/3) tr(d eps) I + 2G d eps
struct LinearElastic {
  static constexpr const char* name = "Linear Elastic";
  static constexpr const char* summary = "Isotropic linear elasticity in logarithmic strain.";
  struct Parameters {
    double bulk_modulus, shear_modulus;
  };
  template <class R>
  struct HistoryOf {};
  using History = HistoryOf<double>;
  static constexpr int history_count = 0;

  static ParameterTable<Parameters> parameter_table() {
    return {
        {required(
             &Parameters::bulk_modulus,
             "Bulk Modulus",
             dimension::stress,
             above(0.0),
             "bulk modulus K"
         ),
         required(
             &Parameters::shear_modulus,
             "Shear Modulus",
             dimension::stress,
             at_least(0.0),
             "shear modulus G"
         )},
        {}};
  }
  static std::vector<HistoryField> history_table() { return {}; }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& /*p*/, double /*density*/) { return {}; }

  LinearElastic(const Parameters& p, double /*density*/) : p_(p) {}

  History initial_history() const { return {}; }

  /// Stress, history and density of a point at rest under hydrostatic pressure.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    return {
        isotropic(-pressure), History{}, 1.0, pressure * pressure / (2.0 * p_.bulk_modulus), true};
  }

  /// @param[in]     increment strain, dt and volume ratios of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]
  /// @return bad_input where strain, stress or volume ratios are not finite; nothing changes then
  BARRENO_FUNCTION Outcome
  update(const Increment& increment, Sym3& stress, History& history) const {
    return outcome_of(update_points(increment, stress, history));
  }

  /// update() of one point or of several at once (real.hpp).
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& /*h*/
  ) const {
    const R volume_strain = trace(increment.strain);
    const Sym3Of<R> end =
        stress + isotropic(R((p_.bulk_modulus - 2.0 / 3.0 * p_.shear_modulus) * volume_strain)) +
        (2.0 * p_.shear_modulus) * increment.strain;
    const R mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
    const R work = 0.5 * mean_ratio * contract(stress + end, increment.strain);
    // Finite work means that strain, stresses and volume ratios are finite: every component of the
    // stress enters it, unless its strain is zero.
    const MaskOf<R> sound = real::is_finite(work) & is_finite(end);
    stress = select_points(sound, end, stress);
    return {sound, work, R{}, R{} + longitudinal_modulus()};
  }

  /// K + 4G/3, the modulus of plane waves [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    return p_.bulk_modulus + 4.0 / 3.0 * p_.shear_modulus;
  }
  /// Bound on K + 4G/3 of a point in this state, used for the first step [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& /*stress*/, const History& /*h*/, double /*volume_ratio*/
  ) const {
    return longitudinal_modulus();
  }
  const Parameters& parameters() const { return p_; }

private:
  Parameters p_;
};

}  // namespace barreno
