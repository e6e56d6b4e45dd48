// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/models/johnson_cook_flow.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/models/mie_gruneisen.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace barreno {

/// Metal at high rate: Johnson-Cook flow stress, Mie-Grueneisen pressure, heating, melting,
/// breaking.
///
/// Flow stress: johnson_cook_flow.hpp. Pressure: mie_gruneisen.hpp.
///
/// Pressure comes from the volume ratios of the increment, not from the trace of the strain.
/// Deviator: linear elastic with constant G in logarithmic strain, radial return (J2, backward
/// Euler). The return is solved for the plastic strain and the plastic strain rate together; the
/// temperature in it is that of the start of the step plus the step's compression and viscous
/// heat, so plastic heat acts from the next step on. At and above T_melt the deviator is zero.
/// The flow stress follows the rate at once: where straining stops, a yielded point relaxes to the
/// flow stress of the rate that its relaxation has (to that of rate0 if dt = 0).
///
/// Energy: rho0 de = -p dV + V s : deps + q dV_viscous, each by the trapezoidal rule, the pressure
/// at the end of the step included (linear, solved in closed form). The equation of state takes e
/// without the elastic energy of the deviator, V s : s / 4G: with a constant G that energy is not
/// heat and gives no pressure. (Codes that put all of e there err by Gamma0 Y^2 / 6G, some MPa.)
///
/// Temperature: isentropic change with volume, dT/T = -Gamma0 d(V / V_ref), plus viscous work and
/// the Taylor-Quinney share of plastic work over the specific heat. With a constant specific heat
/// at constant volume this T belongs to the same Mie-Grueneisen material; the deck's specific heat
/// is taken for it.
///
/// Work: elastic_work is the change of V s : s / 4G plus all of -p dV (thermal pressure included);
/// plastic_work is the mean flow stress times the plastic strain; the host knows q and adds -q dV.
///
/// Breaking: a point whose damage is 1 is broken. It carries no tension afterwards: its pressure is
/// not negative, and its equivalent stress is at most 3p/2, so that no principal stress is tensile.
/// The volume it gains in tension must close before it bears load again. It breaks when the tension
/// -p reaches the Spall Stress (stress zero at once), or when the Johnson-Cook damage
///   dD = dep / ef,
///   ef = (D1 + D2 exp(D3 sigma*)) (1 + D4 ln max(rate / rate0, 1)) (1 + D5 T*),
/// sigma* = -p / Y (at most 1.5), has reached 1 (from the next step on). Neither is on by default.
/// @par Source  Johnson & Cook, 7th Int. Symp. Ballistics, The Hague, 1983, 541-547 (flow stress);
///              Johnson & Cook, Engng Fract. Mech. 21 (1985) 31-48 (damage);
///              Wilkins, Computer Simulation of Dynamic Phenomena, 1999 (energy, radial return).
struct JohnsonCook {
  static constexpr const char* name = "Johnson-Cook";
  static constexpr const char* summary =
      "Metal at high rate: Johnson-Cook flow stress and damage, Mie-Grueneisen pressure, melting, "
      "spall.";
  struct Parameters {
    double shear_modulus = 0.0;
    double a = 0.0, b = 0.0, c = 0.0, n = 1.0, m = 1.0;
    double reference_rate = 1.0;
    double room_temperature = 294.0, melt_temperature = 0.0;
    double specific_heat = 0.0;
    double sound_speed = 0.0, slope = 0.0, gamma = 0.0;
    double taylor_quinney = 0.9;
    double spall_stress = 0.0;
    double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
    int expansion_strain = 0;  ///< 1: as Expanded<JohnsonCook>
  };
  template <class R>
  struct HistoryOf {
    R plastic_strain{};
    R temperature{};
    R internal_energy{};
    R damage{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 4;

  static std::vector<ParameterEntry<Parameters>> strength_entries() {
    using P = Parameters;
    namespace dim = dimension;
    return {
        {required(&P::shear_modulus, "Shear Modulus", dim::stress, above(0.0), "shear modulus G"),
         required(&P::a, "A", dim::stress, at_least(0.0), "yield stress at no plastic strain"),
         required(&P::b, "B", dim::stress, at_least(0.0), "hardening coefficient"),
         required(&P::c, "C", dim::none, at_least(0.0), "rate coefficient"),
         required(&P::n, "n", dim::none, at_least(0.0), "hardening exponent"),
         required(&P::m, "m", dim::none, above(0.0), "thermal softening exponent"),
         optional(
             &P::reference_rate,
             "Reference Strain Rate",
             dim::rate,
             above(0.0),
             1.0,
             "plastic strain rate up to which A and B apply"
         ),
         optional(
             &P::room_temperature,
             "Room Temperature",
             dim::temperature,
             above(0.0),
             294.0,
             "temperature at the start; below it there is no thermal hardening"
         ),
         required(
             &P::melt_temperature,
             "Melt Temperature",
             dim::temperature,
             above(0.0),
             "no strength at or above it"
         )}};
  }
  static std::vector<ParameterEntry<Parameters>> heat_and_pressure_entries() {
    using P = Parameters;
    namespace dim = dimension;
    return {
        {required(
             &P::specific_heat, "Specific Heat", dim::heat_capacity, above(0.0), "heat capacity"
         ),
         required(
             &P::sound_speed,
             "Sound Speed",
             dim::velocity,
             above(0.0),
             "c0 in U_s = c0 + s u_p; K = rho0 c0^2"
         ),
         required(&P::slope, "Hugoniot Slope", dim::none, at_least(0.0), "s in U_s = c0 + s u_p"),
         required(
             &P::gamma, "Gruneisen", dim::none, at_least(0.0), "Gamma0; Gamma rho is constant"
         ),
         optional(
             &P::taylor_quinney,
             "Taylor Quinney",
             dim::none,
             between(0.0, 1.0),
             0.9,
             "share of plastic work that becomes heat; the usual measured value, the rest stays in "
             "the lattice"
         )}};
  }
  static std::vector<ParameterEntry<Parameters>> damage_entries() {
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
         optional(&P::d5, "D5", dim::none, any(), 0.0, "Johnson-Cook damage, temperature")}};
  }
  static ParameterTable<Parameters> parameter_table() {
    ParameterTable<Parameters> table;
    for (const auto& entries :
         {strength_entries(), heat_and_pressure_entries(), damage_entries()}) {
      table.numbers.insert(table.numbers.end(), entries.begin(), entries.end());
    }
    table.choices = {
        {&Parameters::expansion_strain,
         "Expansion Strain",
         {"off", "on"},
         0,
         "on: the metal may have voids, those of a porous body, of a continuous jet or of spall, "
         "which close at zero stress and without plastic work before the metal bears load"}};
    return table;
  }
  static std::vector<HistoryField> history_table() {
    return {
        {"plastic_strain", dimension::none, "equivalent plastic strain"},
        {"temperature", dimension::temperature, "temperature"},
        {"internal_energy", dimension::specific_energy, "specific internal energy, 0 at the start"},
        {"damage", dimension::none, "Johnson-Cook damage; 1: broken, by damage or by spall"}};
  }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& p, double density) {
    std::ostringstream text;
    const double bulk_modulus = density * p.sound_speed * p.sound_speed;
    if (p.melt_temperature <= p.room_temperature) {
      text << "Melt Temperature = " << p.melt_temperature
           << " does not exceed Room Temperature = " << p.room_temperature
           << " (the metal would be molten at the start); give both in kelvin.";
    } else if (p.shear_modulus > 1.5 * bulk_modulus) {
      text << "Shear Modulus = " << p.shear_modulus << " exceeds 1.5 times the bulk modulus "
           << bulk_modulus << " = Density * Sound Speed^2 (Poisson's ratio would be negative);"
           << " check the units of the three.";
    } else if (p.a > p.shear_modulus) {
      text << "A = " << p.a << " exceeds Shear Modulus = " << p.shear_modulus
           << " (the metal would yield at strains above 1/3); check the units of both.";
    } else if (p.spall_stress > bulk_modulus) {
      text << "Spall Stress = " << p.spall_stress << " exceeds the bulk modulus " << bulk_modulus
           << " = Density * Sound Speed^2 (no metal sustains that tension); check its units, or "
              "use 0 "
              "for no"
           << " limit.";
    } else if (has_damage(p) && p.d1 + p.d2 <= 0.0) {
      text << "D1 + D2 = " << p.d1 + p.d2
           << " is not positive (the metal would break at no plastic strain);"
           << " check both, or set D1 to D5 to 0 for no damage.";
    }
    return text.str();
  }

  JohnsonCook(const Parameters& p, double density)
      : p_(p),
        eos_{density, p.sound_speed, p.slope, p.gamma},
        flow_{
            p.a,
            p.b,
            p.c,
            p.n,
            p.m,
            p.reference_rate,
            p.room_temperature,
            1.0 / (p.melt_temperature - p.room_temperature),
            3.0 * p.shear_modulus},
        inverse_density_(1.0 / density),
        heat_per_work_(1.0 / (density * p.specific_heat)),
        energy_per_square_(0.25 / p.shear_modulus),
        has_damage_(has_damage(p)) {}

  History initial_history() const { return {0.0, p_.room_temperature, 0.0, 0.0}; }

  /// Stress, history and density of a point at rest under hydrostatic pressure, reached
  /// isentropically.
  InitialStateOf<Sym3, History> initial_state(double pressure) const;

  /// @param[in]     increment strain, dt, volume ratios and viscous pressure of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]
  /// @param[in,out] history   as in history_table(); with the stress left as it was if the outcome
  /// failed
  /// @return bad_input for values that are not finite, dt < 0, volume ratios that are not positive
  /// or beyond
  ///         the compression limit of the equation of state
  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& history) const;

  /// update() of one point or of several at once (real.hpp).
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
  ) const;

  /// Bound on K_s + 4G/3 of a point in this state, K_s = rho c^2 isentropic at the current density
  /// [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& history, double volume_ratio
  ) const {
    const double derivative = eos_.reference(1.0 - volume_ratio).derivative;
    return modulus(
        -trace(stress) / 3.0, volume_ratio, derivative, MaskOf<double>(history.damage >= 1.0)
    );
  }
  /// Gives a point another gain of energy than its update found; the difference is heat.
  /// @param before  history at the start of the update
  /// @param gain    of internal energy over the update [energy/mass]
  template <class R>
  BARRENO_FUNCTION void correct_energy(
      const HistoryOf<R>& before, const R& gain, HistoryOf<R>& history
  ) const {
    const R heat = gain - (history.internal_energy - before.internal_energy);
    history.internal_energy += heat;
    history.temperature += heat * (1.0 / p_.specific_heat);
  }

  /// Solid over mean density above which a shock from rest leaves voids, or this metal less dense
  /// than at reference: with the heat U^2/2, p = a(eta) / (1 - Gamma0 (alpha - 1 + eta) / 2).
  double largest_porous_expansion() const { return 1.0 + 2.0 / eos_.gamma; }
  /// Of a broken point that bears nothing: ln of its volume over that at no pressure [-]; of any
  /// other 0.
  template <class R>
  BARRENO_FUNCTION R
  opening(const R& volume_ratio, const Sym3Of<R>& stress, const HistoryOf<R>& history) const {
    const MaskOf<R> open = (history.damage >= 1.0) & (trace(stress) >= 0.0);
    if (!real::any(open)) return R{};
    const R excess = volume_ratio / (1.0 - eos_.relaxed_compression(history.internal_energy));
    return real::log(R(real::select(open & (excess > 1.0), excess, 1.0)));
  }

  const Parameters& parameters() const { return p_; }
  const MieGruneisen& equation_of_state() const { return eos_; }
  const JohnsonCookFlow& flow() const { return flow_; }

private:
  template <class R>
  using Return = JohnsonCookFlow::ReturnOf<R>;

  /// What the volume change and the deviator of one step leave to the energy and the breaking.
  template <class R>
  struct Step {
    R dt;
    R change, mean_ratio;  ///< change of V / V_ref and its mean
    MaskOf<R> broken;      ///< at the start
    R elastic_work{}, plastic_work{};
  };
  /// An update between its parts.
  template <class R>
  struct Trial {
    Step<R> step;
    HistoryOf<R> end;
    Sym3Of<R> strain, s_n, s;  ///< deviators: increment, at the start, trial or at the end
    R p_n, squares_n;          ///< at the start: pressure, s_n : s_n
    R implicit, known;         ///< of the energy at the end (start_update)
    MieGruneisen::ReferenceOf<R> reference;
    R limit;  ///< equivalent stress a broken point can hold, if any is
    MaskOf<R> solved, may_flow;
    bool flows;  ///< whether any point may
    JohnsonCookFlow::ProblemOf<R> problem;
    JohnsonCookFlow::SearchOf<R> search;
    Return<R> flow;
  };

  static bool has_damage(const Parameters& p) {
    return p.d1 != 0.0 || p.d2 != 0.0 || p.d3 != 0.0 || p.d4 != 0.0 || p.d5 != 0.0;
  }
  template <class R>
  BARRENO_FUNCTION R modulus(
      const R& pressure,
      const R& volume_ratio,
      const R& reference_derivative,
      const MaskOf<R>& broken
  ) const {
    const double bulk = eos_.bulk_modulus();
    const double shear_part = 4.0 / 3.0 * p_.shear_modulus;
    // The isentropic modulus falls to zero at a tension of order K / Gamma0: keep a positive speed.
    constexpr double floor_fraction = 0.01;
    const R isentropic =
        eos_.isentropic_modulus(R(1.0 - volume_ratio), reference_derivative, pressure);
    const R closed = real::larger(isentropic, floor_fraction * bulk);
    const MaskOf<R> open = broken & (pressure <= 0.0);
    if (!real::any(open)) return shear_part + closed;
    // An open broken point bears nothing; the modulus it will have when it closes keeps the step
    // safe.
    return shear_part + real::select(open, bulk * real::smaller(volume_ratio, 1.0), closed);
  }
  BARRENO_FUNCTION static Outcome failure(Status status) {
    Outcome outcome;
    outcome.status = status;
    return outcome;
  }
  template <class R>
  BARRENO_FUNCTION MaskOf<R> admissible(
      const IncrementOf<Sym3Of<R>>& i, const Sym3Of<R>& stress, const HistoryOf<R>& h
  ) const;
  template <class R>
  BARRENO_FUNCTION void start_update(
      const IncrementOf<Sym3Of<R>>& increment,
      const Sym3Of<R>& stress,
      const HistoryOf<R>& history,
      Trial<R>& trial
  ) const;
  template <class R>
  BARRENO_FUNCTION void try_elastic(const R& ratio, Trial<R>& trial) const;
  template <class R>
  BARRENO_FUNCTION R broken_limit(const R& ratio, const Trial<R>& trial) const;
  template <class R>
  BARRENO_FUNCTION void return_deviator(Trial<R>& trial) const;
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> finish_update(
      const IncrementOf<Sym3Of<R>>& increment,
      Trial<R>& trial,
      Sym3Of<R>& stress,
      HistoryOf<R>& history
  ) const;
  template <class R>
  BARRENO_FUNCTION R release(const R& limit, Sym3Of<R>& s, R& plastic_strain) const;
  template <class R>
  BARRENO_FUNCTION static void keep_sound(
      const MaskOf<R>& sound, const HistoryOf<R>& end, HistoryOf<R>& history
  );
  template <class R>
  BARRENO_FUNCTION void break_points(
      const Return<R>& flow, Step<R>& step, HistoryOf<R>& end, Sym3Of<R>& s, R& p
  ) const;
  template <class R>
  BARRENO_FUNCTION void grow_damage(
      const Return<R>& flow, const R& pressure, const Step<R>& step, HistoryOf<R>& end
  ) const;

  Parameters p_;
  MieGruneisen eos_;
  JohnsonCookFlow flow_;
  double inverse_density_;    ///< 1 / rho0
  double heat_per_work_;      ///< 1 / (rho0 c): temperature per work per reference volume
  double energy_per_square_;  ///< 1 / 4G: s : s / 4G is the elastic energy of a deviator
  bool has_damage_;
};

inline InitialStateOf<Sym3, JohnsonCook::History> JohnsonCook::initial_state(double pressure
) const {
  InitialStateOf<Sym3, History> state{isotropic(0.0), initial_history(), 1.0, 0.0, true};
  double limit = eos_.compression_limit();
  if (!(pressure < eos_.isentrope_pressure(limit))) limit = eos_.rising_limit();
  state.possible = pressure >= 0.0 && pressure < eos_.isentrope_pressure(limit);
  if (!state.possible) return state;
  double low = 0.0, high = limit;
  double eta = pressure / eos_.bulk_modulus();
  // Newton on the isentrope, where dP/deta = a' + Gamma0 P; bisection when a step leaves the
  // bracket.
  for (int i = 0; i < 100; ++i) {
    if (!(eta >= low && eta <= high)) eta = 0.5 * (low + high);
    const double p = eos_.pressure(eta, eos_.isentrope_energy(eta) * inverse_density_);
    (p > pressure ? high : low) = eta;
    const double step = (pressure - p) / (eos_.reference(eta).derivative + eos_.gamma * p);
    if (std::fabs(step) <= 1e-15 * eta) break;
    eta += step;
  }
  state.volume_ratio = 1.0 - eta;
  state.stored_energy = eos_.isentrope_energy(eta);
  state.history.internal_energy = state.stored_energy * inverse_density_;
  state.history.temperature *= std::exp(eos_.gamma * eta);
  state.stress = isotropic(-eos_.pressure(eta, state.history.internal_energy));
  return state;
}

}  // namespace barreno

#include "barreno/models/johnson_cook_update.hpp"
