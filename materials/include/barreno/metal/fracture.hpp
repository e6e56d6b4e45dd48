// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/metal/part.hpp"
#include "barreno/metal/radial_return.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// Spall and Johnson-Cook damage, a failure (list.hpp). Neither is on by default.
///
/// A point whose damage is 1 is broken. It carries no tension afterwards: its pressure is not
/// negative, and its equivalent stress is at most 3p/2, so that no principal stress is tensile. The
/// volume it gains in tension must close before it bears load again. It breaks when the tension -p
/// reaches the Spall Stress (stress zero at once; with Thermal Spall that stress times 1 - T*,
/// none where molten), or when the damage
///   dD = dep / ef,
///   ef = (D1 + D2 exp(D3 sigma*)) (1 + D4 ln max(rate / rate0, 1)) (1 + D5 T*),
/// sigma* = -p / Y (at most 1.5), has reached 1 (from the next step on).
/// @par Source  Johnson & Cook, Engng Fract. Mech. 21 (1985) 31-48 (damage)
struct Fracture {
  static constexpr const char* name = "spall and damage";
  static constexpr const char* of_flow = " and damage";  ///< of the model's summary
  static constexpr const char* of_pressure = ", spall";
  struct Parameters {
    double spall_stress = 0.0;
    int thermal_spall = 0;  ///< 1: Spall Stress falls with T*
    double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace dim = dimension;
    return {
        {optional(
             &P::spall_stress,
             "Spall Stress",
             dim::stress,
             at_least(0.0),
             0.0,
             "hydrostatic tension at which the point breaks; 0: no limit"
         ),
         optional(
             &P::d1, "D1", dim::none, any(), 0.0, "Johnson-Cook damage; D1 to D5 all 0: no damage"
         ),
         optional(
             &P::d2, "D2", dim::none, any(), 0.0, "Johnson-Cook damage, factor of the exponential"
         ),
         optional(
             &P::d3,
             "D3",
             dim::none,
             any(),
             0.0,
             "Johnson-Cook damage, triaxiality (tension positive)"
         ),
         optional(&P::d4, "D4", dim::none, any(), 0.0, "Johnson-Cook damage, rate"),
         optional(&P::d5, "D5", dim::none, any(), 0.0, "Johnson-Cook damage, temperature")},
        {{&P::thermal_spall,
          "Thermal Spall",
          {"off", "on"},
          0,
          "on: Spall Stress falls with the temperature, by the factor 1 - T*, and molten metal "
          "bears no tension"}}};
  }
  static std::vector<PlausibleRange> plausible_ranges() { return {{"Spall Stress", 1e4, 1e11}}; }
  static std::string check(const Parameters& p, const metal::BulkModulus& bulk) {
    std::ostringstream text;
    if (p.thermal_spall != 0 && p.spall_stress == 0.0) {
      text
          << "Thermal Spall = on needs a Spall Stress above 0 (that at Room Temperature); give it, "
             "or set Thermal Spall to off.";
    } else if (p.spall_stress > bulk.value) {
      text << "Spall Stress = " << p.spall_stress << " exceeds " << bulk
           << " (no metal sustains that tension); check its units, or use 0 for no limit.";
    } else if (has_damage(p) && p.d1 + p.d2 <= 0.0) {
      text << "D1 + D2 = " << p.d1 + p.d2
           << " is not positive (the metal would break at no plastic strain);"
           << " check both, or set D1 to D5 to 0 for no damage.";
    }
    return text.str();
  }
  template <class R>
  struct HistoryOf {
    R damage{};
  };
  static std::vector<HistoryField> history_table() {
    return {
        {"damage",
         dimension::none,
         "damage from 0 to 1; 1: broken, in metal by damage or by spall"}};
  }
  static Fracture make(const Parameters& p) { return {p, has_damage(p)}; }
  static bool has_damage(const Parameters& p) {
    return p.d1 != 0.0 || p.d2 != 0.0 || p.d3 != 0.0 || p.d4 != 0.0 || p.d5 != 0.0;
  }

  Parameters p;
  bool damages;

  template <class R>
  BARRENO_FUNCTION static MaskOf<R> broken(const HistoryOf<R>& h) {
    return h.damage >= 1.0;
  }

  /// What the end of a step does to the damage of points that were not broken before.
  /// @return the points that break at once, whose tension is let go
  template <class Strength, class R>
  BARRENO_FUNCTION MaskOf<R> grow(
      const Strength& strength,
      const metal::ReturnOf<R>& flow,
      const R& pressure,
      const R& temperature,
      const R& dt,
      const MaskOf<R>& was_broken,
      HistoryOf<R>& end
  ) const {
    if (damages) grow_damage(strength, flow, pressure, temperature, dt, was_broken, end);
    if (!(p.spall_stress > 0.0)) return R{} > 0.0;
    R borne = R{} + p.spall_stress;
    if (p.thermal_spall != 0)
      borne = p.spall_stress * real::larger(R(1.0 - strength.homologous(temperature)), 0.0);
    const MaskOf<R> spalls = (!was_broken) & (pressure < -borne);
    end.damage = real::select(spalls, 1.0, end.damage);
    return spalls;
  }

private:
  template <class Strength, class R>
  BARRENO_FUNCTION void grow_damage(
      const Strength& strength,
      const metal::ReturnOf<R>& flow,
      const R& pressure,
      const R& temperature,
      const R& dt,
      const MaskOf<R>& was_broken,
      HistoryOf<R>& end
  ) const {
    // Molten points have no ductile fracture to count.
    const MaskOf<R> grows = (!was_broken) & (flow.plastic_increment > 0.0) & (flow.stress > 0.0);
    if (!real::any(grows)) return;
    const R triaxiality = real::smaller(R(-pressure / real::select(grows, flow.stress, 1.0)), 1.5);
    R fracture_strain = p.d1 + p.d2 * real::exp(R(p.d3 * triaxiality));
    if (p.d4 != 0.0) {
      const R scale = metal::rate_scale(dt, strength.reference_rate);
      fracture_strain *= 1.0 + p.d4 * metal::log_rate(flow.plastic_increment, scale);
    }
    fracture_strain *= 1.0 + p.d5 * strength.homologous(temperature);
    // Published sets with D1 < 0 give no fracture strain at high tension: the point breaks at once.
    const R grown = real::select(
        flow.plastic_increment >= (1.0 - end.damage) * fracture_strain,
        1.0,
        end.damage + flow.plastic_increment / fracture_strain
    );
    end.damage = real::select(grows, grown, end.damage);
  }
};

}  // namespace barreno
