// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/metal/list.hpp"
#include "barreno/metal/solid_update.hpp"
#include "barreno/models/linear_elastic.hpp"

#include <string>
#include <vector>

namespace barreno {

namespace metal {

/// The share of plastic work that heats.
struct Heating {
  struct Parameters {
    double taylor_quinney = 0.9;
  };
  static ParameterTable<Parameters> parameter_table() {
    return {
        {optional(
            &Parameters::taylor_quinney,
            "Taylor Quinney",
            dimension::none,
            between(0.0, 1.0),
            0.9,
            "share of plastic work that becomes heat; the usual measured value, the rest stays in "
            "the lattice"
        )},
        {}};
  }
};

/// Whether the metal may have voids (voided_metal.hpp).
struct VoidsChoice {
  struct Parameters {
    int expansion_strain = 0;  ///< 1: the form with Voids
  };
  static ParameterTable<Parameters> parameter_table() {
    return {
        {},
        {{&Parameters::expansion_strain,
          "Expansion Strain",
          {"off", "on"},
          0,
          "on: the metal may have voids, those of a porous body, of a continuous jet or of spall, "
          "which close at zero stress and without plastic work before the metal bears load"}}};
  }
};

}  // namespace metal

/// A failure whose broken points, and whose porous bodies, have voids (voided_metal.hpp).
template <class Failure>
struct Voids {};

/// Metal at high rate: a flow stress with heating and melting, a pressure, breaking; each of them a
/// part (metal/list.hpp).
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
/// @par Source  Wilkins, Computer Simulation of Dynamic Phenomena, 1999 (energy, radial return).
template <class Strength, class EquationOfState, class Failure>
struct Metal {
  using WithVoids = Metal<Strength, EquationOfState, Voids<Failure>>;
  using Beside = metal::NameBeside<EquationOfState, metal::EquationsOfState>;
  using BesideBoth = metal::NameBeside<Failure, metal::Failures>;
  static constexpr JoinedText name_text = joined_text(
      Strength::name, Beside::preposition, Beside::name, BesideBoth::preposition, BesideBoth::name
  );
  static constexpr JoinedText summary_text = joined_text(
      "Metal at high rate: ",
      Strength::summary,
      Failure::of_flow,
      ", ",
      EquationOfState::summary,
      ", melting",
      Failure::of_pressure,
      "."
  );
  static constexpr const char* name = name_text.letters;
  static constexpr const char* summary = summary_text.letters;

  using Parts = PartList<Strength, EquationOfState, metal::Heating, Failure, metal::VoidsChoice>;
  struct Parameters : ParametersOf<Parts> {};
  template <class R>
  using HistoryOf = metal::HistoryOf<Strength, Failure, R>;
  using History = HistoryOf<double>;
  static constexpr int history_count = sizeof(History) / sizeof(double);

  static ParameterTable<Parameters> parameter_table() {
    ParameterTable<Parameters> table;
    for_each_part(Parts{}, [&](const auto* part) {
      add_table(std::decay_t<decltype(*part)>::parameter_table(), table);
    });
    return table;
  }
  static std::vector<HistoryField> history_table() {
    std::vector<HistoryField> table = Strength::history_table();
    table.push_back({"temperature", dimension::temperature, "temperature"});
    table.push_back(
        {"internal_energy", dimension::specific_energy, "specific internal energy, 0 at the start"}
    );
    for (const HistoryField& field : Failure::history_table()) table.push_back(field);
    return table;
  }

  static std::vector<PlausibleRange> plausible_ranges() {
    std::vector<PlausibleRange> all;
    for_each_part(Parts{}, [&](const auto* part) {
      using Of = std::decay_t<decltype(*part)>;
      if constexpr (says_plausible_ranges<Of>)
        for (const PlausibleRange& range : Of::plausible_ranges()) all.push_back(range);
    });
    return all;
  }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& p, double density) {
    const metal::BulkModulus bulk = EquationOfState::bulk(p, density);
    std::string text = EquationOfState::check(p);
    if (text.empty()) text = Strength::check(p, bulk);
    if (text.empty()) text = Failure::check(p, bulk);
    return text;
  }

  Metal(const Parameters& p, double density)
      : p_(p),
        update_{
            Strength::make(p),
            EquationOfState::make(p, density),
            Failure::make(p),
            p.shear_modulus,
            p.taylor_quinney,
            1.0 / (density * p.specific_heat),
            1.0 / density,
            0.25 / p.shear_modulus} {}

  History initial_history() const {
    History history{};
    history.temperature = p_.room_temperature;
    return history;
  }

  /// Stress, history and density of a point at rest under hydrostatic pressure, reached
  /// isentropically.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    InitialStateOf<Sym3, History> state{isotropic(0.0), initial_history(), 1.0, 0.0, true};
    const metal::IsentropeState at = equation_of_state().isentrope_at(pressure);
    state.possible = at.possible;
    if (!state.possible) return state;
    state.volume_ratio = 1.0 - at.compression;
    state.stored_energy = at.energy;
    state.history.internal_energy = state.stored_energy * update_.inverse_density;
    state.history.temperature *= at.temperature_ratio;
    state.stress =
        isotropic(-equation_of_state().pressure(at.compression, state.history.internal_energy));
    return state;
  }

  /// @param[in]     increment strain, dt, volume ratios and viscous pressure of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]
  /// @param[in,out] history   as in history_table(); with the stress left as it was if the outcome
  /// failed
  /// @return bad_input for values that are not finite, dt < 0, volume ratios that are not positive
  /// or beyond
  ///         the compression limit of the equation of state
  BARRENO_FUNCTION Outcome
  update(const Increment& increment, Sym3& stress, History& history) const {
    Outcome outcome;
    outcome.status = Status::bad_input;
    if (!update_.admissible(increment, stress, history)) return outcome;
    const PointsOutcome<double> points = update_points(increment, stress, history);
    outcome.status = Status::not_converged;
    if (!points.sound) return outcome;
    return {Status::ok, 1, points.elastic_work, points.plastic_work, points.longitudinal_modulus};
  }

  /// update() of one point or of several at once (real.hpp).
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
  ) const {
    return update_.update_points(increment, stress, history);
  }

  /// Bound on K_s + 4G/3 of a point in this state, K_s = rho c^2 isentropic at the current density
  /// [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& history, double volume_ratio
  ) const {
    const auto& eos = equation_of_state();
    const auto at = eos.at(1.0 - volume_ratio, history.internal_energy * eos.density);
    return update_.modulus(
        -trace(stress) / 3.0, volume_ratio, at, history.temperature, is_broken(history)
    );
  }
  static bool is_broken(const History& history) {
    return Failure::template broken<double>(history);
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

  /// Solid over mean density above which a shock from rest leaves voids.
  double largest_porous_expansion() const { return equation_of_state().largest_porous_expansion(); }
  /// Of a broken point that bears nothing: ln of its volume over that at no pressure [-]; of any
  /// other 0.
  template <class R>
  BARRENO_FUNCTION R
  opening(const R& volume_ratio, const Sym3Of<R>& stress, const HistoryOf<R>& history) const {
    const MaskOf<R> open = Failure::template broken<R>(history) & (trace(stress) >= 0.0);
    if (!real::any(open)) return R{};
    const R excess =
        volume_ratio / (1.0 - equation_of_state().relaxed_compression(history.internal_energy));
    return real::log(R(real::select(open & (excess > 1.0), excess, 1.0)));
  }

  const Parameters& parameters() const { return p_; }
  const Strength& strength() const { return update_.strength; }
  const EquationOfState& equation_of_state() const { return update_.eos; }

protected:
  double inverse_density() const { return update_.inverse_density; }
  /// update_points() of broken metal that bears nothing over a step that leaves it as it is.
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> leave_open(
      const IncrementOf<Sym3Of<R>>& increment, const Sym3Of<R>& stress, const HistoryOf<R>& history
  ) const {
    return {
        update_.template admissible<R>(increment, stress, history),
        R{},
        R{},
        update_.open_modulus(increment.volume_ratio_end)};
  }

private:
  Parameters p_;
  metal::SolidUpdate<Strength, EquationOfState, Failure> update_;
};

}  // namespace barreno
