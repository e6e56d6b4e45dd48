// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/outcome.hpp"
#include "barreno/real.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace barreno {

/// Jones-Wilkins-Lee equation of state of detonation products, v = V / V_ref, E the internal energy
/// per reference volume:
///
///   p(v, E) = A (1 - w / (R1 v)) exp(-R1 v) + B (1 - w / (R2 v)) exp(-R2 v) + w E / v
///
/// A gas of constant exponent gamma has A = B = 0 and w = gamma - 1.
/// @par Source  Lee, Hornig & Kury, Adiabatic expansion of high explosive detonation products,
///              Lawrence Radiation Laboratory, UCRL-50422, 1968.
struct JwlProducts {
  double density;  ///< rho0 [mass/length^3]
  double a, b;     ///< A, B [stress]
  double r1, r2;   ///< R1, R2 [-]
  double omega;    ///< w [-]
  double energy;   ///< E0, at the start [stress]

  /// The part of the pressure without E, and what the modulus takes of it.
  template <class R>
  struct ReferenceOf {
    R pressure;  ///< p(v, 0) [stress]
    R modulus;   ///< -v dp(v, 0)/dv [stress]
  };
  template <class R>
  BARRENO_FUNCTION ReferenceOf<R> reference(const R& v) const {
    const R first = a * real::exp(R(-r1 * v)), second = b * real::exp(R(-r2 * v));
    const R inverse = 1.0 / v;
    const R w1 = (omega / r1) * inverse, w2 = (omega / r2) * inverse;
    return {
        first * (1.0 - w1) + second * (1.0 - w2),
        first * (r1 * v - omega - w1) + second * (r2 * v - omega - w2)};
  }
  /// p [stress]; E per reference volume [stress].
  BARRENO_FUNCTION double pressure(double v, double e) const {
    return reference(v).pressure + omega * e / v;
  }
  /// Isentropic bulk modulus K_s = -v (dp/dv)_s = rho c^2 [stress], from dE = -p dv.
  BARRENO_FUNCTION double isentropic_modulus(double v, double e) const {
    const auto from = reference(v);
    return from.modulus + omega * e / v + omega * (from.pressure + omega * e / v);
  }

  /// State behind an undisturbed detonation, where the Rayleigh line touches the Hugoniot.
  struct ChapmanJouguet {
    bool found = false;
    double volume_ratio = 0.0;  ///< v
    double pressure = 0.0;      ///< [stress]
    double speed = 0.0;         ///< D of the detonation [length/time]
  };
  /// Pressure on the Hugoniot from rest, p = p(v, E0 + p (1 - v) / 2) [stress].
  double hugoniot_pressure(double v) const {
    return (reference(v).pressure + omega * energy / v) / (1.0 - 0.5 * omega * (1.0 - v) / v);
  }
  /// K_s / p = v / (1 - v) on the Hugoniot, by bisection. Set-up only.
  ChapmanJouguet chapman_jouguet() const {
    const auto excess = [&](double v) {
      const double p = hugoniot_pressure(v);
      return isentropic_modulus(v, energy + 0.5 * p * (1.0 - v)) * (1.0 - v) - p * v;
    };
    // The weakest compression first: towards v = 1 the Rayleigh line is steeper than the isentrope.
    double high = 1.0, low = 0.999;
    const double closed = omega / (2.0 + omega);  // of the Hugoniot, where its pressure is infinite
    while (low > closed && !(excess(low) > 0.0)) low -= 0.001;
    if (!(low > closed)) return {};
    high = low + 0.001;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (excess(middle) > 0.0 ? low : high) = middle;
    }
    ChapmanJouguet state{true, low, hugoniot_pressure(low), 0.0};
    state.speed = std::sqrt(state.pressure / (density * (1.0 - low)));
    state.found = state.pressure > 0.0 && std::isfinite(state.speed);
    return state;
  }
};

/// High explosive: JWL products (above), set free by programmed burn.
///
/// The detonation travels with a prescribed speed D: every point has a lighting time t_b, at which
/// the front comes to it, and burns from then on, across a front of k cells of width h:
///
///   F = min(1, D (t - t_b) / (k h)), 0 below 1e-4, never falling
///   p = F p(v, E) + (1 - F) K_u (1 / v - 1)   (the second part in compression only; p >= 0)
///
/// E0 is in the material from the start; dE = -(p + q) dv by the trapezoidal rule, the pressure at
/// the end of the step included (it is linear in E: closed form). There is no deviator. The sound
/// speed, which bounds the step, is at least D (1 - F): nothing is ahead of the front.
///
/// A host other than Barreno has no lighting times: it lights a point by setting its history
/// variable `burn` to 1.
/// @par Source  Giroux, HEMP User's Manual, Lawrence Livermore Laboratory, UCRL-51079, 1973
///              (programmed burn); the same rule is in OpenRadioss (LAW5) and blastFoam.
struct JwlExplosive {
  static constexpr const char* name = "JWL Explosive";
  static constexpr const char* summary =
      "High explosive: programmed burn with a prescribed speed, JWL equation of state of the "
      "products. Where and when it is lit stands in the list Detonation.";
  struct Parameters {
    double detonation_speed = 0.0;
    double a = 0.0, b = 0.0, r1 = 1.0, r2 = 1.0, omega = 0.0, energy = 0.0;
    double unreacted_modulus = 0.0;
    double burn_width = 2.5;
    double splits = 0.0;
  };
  template <class R>
  struct HistoryOf {
    R lighting_time{};
    R burn{};
    R internal_energy{};
    R splits{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 4;
  static constexpr int lighting_column = 0, burn_column = 1, splits_column = 3;  ///< of the history
  /// Products expand far more than solids before a step need not follow them [-]; the pressure on
  /// the isentrope of Comp B is 2 MPa there.
  static constexpr double largest_expansion = 100.0;

  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace dim = dimension;
    return {
        {required(
             &P::detonation_speed,
             "Detonation Speed",
             dim::velocity,
             above(0.0),
             "D, with which the front travels; within 1 % of the Chapman-Jouguet speed of the "
             "equation of state"
         ),
         required(&P::a, "A", dim::stress, at_least(0.0), "first coefficient of the JWL equation"),
         required(&P::b, "B", dim::stress, any(), "second coefficient"),
         required(&P::r1, "R1", dim::none, above(0.0), "exponent of A"),
         required(&P::r2, "R2", dim::none, above(0.0), "exponent of B"),
         required(&P::omega, "Omega", dim::none, above(0.0), "Gruneisen coefficient of the gas"),
         required(
             &P::energy, "Energy", dim::stress, above(0.0), "E0, energy per volume of the explosive"
         ),
         optional(
             &P::unreacted_modulus,
             "Unreacted Bulk Modulus",
             dim::stress,
             at_least(0.0),
             0.0,
             "bulk modulus of what has not burnt, in compression; 0: it bears nothing"
         ),
         optional(
             &P::burn_width,
             "Burn Width",
             dim::none,
             at_least(1.0),
             2.5,
             "width of the front in cells, over which the pressure rises"
         ),
         optional(
             &P::splits,
             "Splits",
             dim::none,
             between(0.0, 8.0),
             0.0,
             "how often a particle wider than a cell is divided in two, a whole number; files keep "
             "a "
             "place for all of its 2^Splits parts"
         )},
        {}};
  }
  static std::vector<HistoryField> history_table() {
    return {
        {"lighting_time", dimension::time, "time at which the detonation comes to the point"},
        {"burn", dimension::none, "fraction that has burnt"},
        {"internal_energy",
         dimension::specific_energy,
         "specific internal energy, Energy / Density at the start"},
        {"splits", dimension::none, "how often the particle was divided in two"}};
  }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& p, double density) {
    std::ostringstream text;
    const auto state = products_of(p, density).chapman_jouguet();
    constexpr double accepted = 0.01;
    if (p.splits != std::floor(p.splits)) {
      text << "Splits = " << p.splits
           << " is not a whole number (a particle is divided once or not); round it.";
    } else if (!state.found) {
      text << "Energy = " << p.energy
           << " gives no detonation with A, B, R1, R2, Omega and Density (no state of the equation "
              "of state meets the Chapman-Jouguet condition); check the units of all.";
    } else if (std::fabs(p.detonation_speed / state.speed - 1.0) > accepted) {
      text << "Detonation Speed = " << p.detonation_speed
           << " contradicts the equation of state, whose Chapman-Jouguet speed is " << state.speed
           << " (more than 1 % apart, so the front would be over- or underdriven); check the units "
              "of A, B, Energy and Density, or take a consistent set.";
    }
    return text.str();
  }

  JwlExplosive(const Parameters& p, double density)
      : p_(p), eos_(products_of(p, density)), inverse_density_(1.0 / density) {}

  History initial_history() const { return {0.0, 0.0, p_.energy * inverse_density_, 0.0}; }

  /// Stress, history and density of an unlit point at rest under hydrostatic pressure.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    InitialStateOf<Sym3, History> state{isotropic(-pressure), initial_history(), 1.0, 0.0, true};
    if (pressure == 0.0) return state;
    state.possible = pressure > 0.0 && p_.unreacted_modulus > 0.0;
    if (!state.possible) return state;
    state.volume_ratio = 1.0 / (1.0 + pressure / p_.unreacted_modulus);
    // The integral of K_u (1 / v - 1) over the compression.
    const double v = state.volume_ratio;
    state.stored_energy = p_.unreacted_modulus * (v - 1.0 - std::log(v));
    state.history.internal_energy += state.stored_energy * inverse_density_;
    return state;
  }

  /// Burns what is lit, before the update of a step.
  /// @param time       end of the step [time]
  /// @param cell_size  h [length]
  template <class R>
  BARRENO_FUNCTION void burn(double time, const R& cell_size, HistoryOf<R>& history) const {
    const R age = time - history.lighting_time;
    const R lit = real::smaller(R(age * (p_.detonation_speed / p_.burn_width) / cell_size), 1.0);
    constexpr double least = 1e-4;
    history.burn = real::select((lit >= least) & (lit > history.burn), lit, history.burn);
  }

  /// @param[in]     increment dt, volume ratios and viscous pressure of the step
  /// @param[in,out] stress    unrotated Cauchy stress, an isotropic one [stress]
  /// @param[in,out] history   `burn` as at the end of the step
  /// @return bad_input for values that are not finite, dt < 0 or volume ratios that are not
  /// positive
  BARRENO_FUNCTION Outcome
  update(const Increment& increment, Sym3& stress, History& history) const {
    return outcome_of(update_points(increment, stress, history));
  }

  /// update() of one point or of several at once (real.hpp).
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
  ) const {
    const R v = increment.volume_ratio_end;
    const R change = v - increment.volume_ratio_begin;
    const R p_n = trace(stress) * (-1.0 / 3.0);
    const R begin = history.internal_energy * eos_.density;
    const auto from = eos_.reference(v);
    const R solid = (1.0 - history.burn) * unreacted_pressure(v);
    const R fixed = history.burn * from.pressure + solid;  // p without what is linear in E
    const R slope = history.burn * eos_.omega / v;         // dp/dE
    // E = begin - ((p_n + fixed + slope E) / 2 + q) change, and p = fixed + slope E.
    const R implicit = 1.0 + 0.5 * slope * change;
    const R known = begin - (0.5 * (p_n + fixed) + increment.viscous_pressure) * change;
    const R p = real::larger(R(fixed + slope * known / implicit), 0.0);
    const R elastic_work = -0.5 * (p_n + p) * change;
    const R energy = begin + elastic_work - increment.viscous_pressure * change;
    // One sum for all: it is finite only if every term is. The strain is not used, but a strain
    // that is no motion is refused.
    const R sum = contract(increment.strain, increment.strain) + stress.xx + stress.yy + stress.zz +
                  stress.xy + stress.yz + stress.zx + increment.dt + p + energy + v + history.burn +
                  history.lighting_time;
    const MaskOf<R> sound = real::is_finite(sum) & (increment.dt >= 0.0) &
                            (increment.volume_ratio_begin > 0.0) & (v > 0.0) & (implicit > 0.0);
    stress = select_points(sound, isotropic(R(-p)), stress);
    history.internal_energy =
        real::select(sound, energy * inverse_density_, history.internal_energy);
    return {sound, elastic_work, R{}, modulus(v, energy, p, from, history.burn)};
  }

  /// Bound on rho c^2 of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& history, double volume_ratio
  ) const {
    return modulus(
        volume_ratio,
        history.internal_energy * eos_.density,
        -trace(stress) / 3.0,
        eos_.reference(volume_ratio),
        history.burn
    );
  }
  /// Gives a point another gain of energy than its update found.
  /// @param before  history at the start of the update
  /// @param gain    of internal energy over the update [energy/mass]
  template <class R>
  BARRENO_FUNCTION void correct_energy(
      const HistoryOf<R>& before, const R& gain, HistoryOf<R>& history
  ) const {
    history.internal_energy = before.internal_energy + gain;
  }

  const Parameters& parameters() const { return p_; }
  const JwlProducts& products() const { return eos_; }

private:
  static JwlProducts products_of(const Parameters& p, double density) {
    return {density, p.a, p.b, p.r1, p.r2, p.omega, p.energy};
  }
  /// K_u (1 / v - 1), nothing in expansion [stress].
  template <class R>
  BARRENO_FUNCTION R unreacted_pressure(const R& v) const {
    return real::larger(R(p_.unreacted_modulus * (1.0 / v - 1.0)), 0.0);
  }
  /// K_s of the mixture at fixed F, and rho (D (1 - F))^2 if that is more.
  template <class R>
  BARRENO_FUNCTION R modulus(
      const R& v,
      const R& energy,
      const R& pressure,
      const JwlProducts::ReferenceOf<R>& from,
      const R& burn
  ) const {
    const double unburnt = eos_.density * p_.detonation_speed * p_.detonation_speed;
    const R gas = burn * (from.modulus + eos_.omega * (energy / v + pressure));
    const R solid = real::select(v < 1.0, (1.0 - burn) * p_.unreacted_modulus / v, 0.0);
    const R ahead = (1.0 - burn) * (1.0 - burn) * unburnt / v;
    const R mixed = gas + solid;
    constexpr double floor_fraction = 1e-9;  // keeps the speed of thin gas positive
    return real::larger(R(real::select(mixed > ahead, mixed, ahead)), floor_fraction * unburnt);
  }

  Parameters p_;
  JwlProducts eos_;
  double inverse_density_;  ///< 1 / rho0: energy per mass from energy per reference volume
};

/// Neither the solid nor its products resist shear [stress].
inline double shear_modulus(
    const JwlExplosive& /*model*/, const Sym3& /*stress*/, const JwlExplosive::History& /*h*/
) {
  return 0.0;
}

}  // namespace barreno
