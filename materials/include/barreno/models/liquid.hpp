// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/metal/mie_gruneisen.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/outcome.hpp"
#include "barreno/plausible.hpp"
#include "barreno/real.hpp"
#include "barreno/select_members.hpp"
#include "barreno/tensor.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace barreno {

/// Liquid: Mie-Grueneisen pressure (metal/mie_gruneisen.hpp), cavitation, no shear stress.
///
///   p = max(P(V_liquid, e), p_v),   V = V_liquid + V_void,   V_void > 0 only where p = p_v
///
/// All V are over V_ref. Pressures count from the zero that the pressures of the deck have.
/// Where P would fall below the vapour pressure p_v, the liquid keeps the volume and the energy at
/// which P = p_v, and the rest of the volume is void. So a void closes where it opened, and the
/// temperature of the liquid stays. A step that opens or closes the void divides its volume change
/// between the two:
///
///   rho0 de = -1/2 (p_n + p_n+1) dV_liquid - q dV   (trapezoidal rule, q artificial viscosity)
///   elastic work = -1/2 (p_n + p_n+1) dV_liquid - p_v dV_void
///
/// Both are functions of the state, so a closed cycle without q gives no work. The void's share of
/// the energy, -p_v V_void, is not in e: evaporation takes no heat.
///
/// Temperature: dT / T = -Gamma0 dV_liquid, and the heat of q over the specific heat.
///
/// The modulus of a liquid with voids is that of the liquid times V_liquid / V: the sound speed
/// with the mean density is that of the liquid, because a step may close a small void. A strain of
/// more than 0.5 is more than a step may close (Step/Largest Strain): such a point has 1 %.
///
/// @par Source  Marsh (ed.), LASL Shock Hugoniot Data, 1980 (linear U_s-u_p); Cole, Underwater
///              Explosions, Princeton University Press, 1948 (cavitation behind a reflected wave).
struct Liquid {
  static constexpr const char* name = "Liquid";
  static constexpr const char* summary =
      "Liquid: Mie-Grueneisen pressure, no shear stress, cavitation at the vapour pressure.";
  struct Parameters : HugoniotParameters {
    double vapour_pressure = 0.0, initial_pressure = 0.0;
    double temperature = 293.0;
  };
  template <class R>
  struct HistoryOf {
    R temperature{};
    R internal_energy{};
    R void_volume{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 3;

  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace dim = dimension;
    ParameterTable<P> table;
    add_table(hugoniot_table(), table);
    const ParameterTable<P> own{
        {optional(
             &P::vapour_pressure,
             "Vapour Pressure",
             dim::stress,
             any(),
             0.0,
             "least pressure, at which voids open; negative where pressures count from that of the "
             "atmosphere, or where the liquid bears tension"
         ),
         optional(
             &P::initial_pressure,
             "Initial Pressure",
             dim::stress,
             at_least(0.0),
             0.0,
             "pressure at the start of bodies that Confinement does not name; Density is that at "
             "no pressure"
         ),
         optional(
             &P::temperature,
             "Room Temperature",
             dim::temperature,
             above(0.0),
             293.0,
             "temperature at no pressure, before the start"
         )},
        {}};
    add_table(own, table);
    return table;
  }
  static std::vector<HistoryField> history_table() {
    return {
        {"temperature", dimension::temperature, "temperature"},
        {"internal_energy",
         dimension::specific_energy,
         "specific internal energy of the liquid, 0 at no pressure"},
        {"void_volume", dimension::none, "volume of the voids over the reference volume"}};
  }
  static std::vector<PlausibleRange> plausible_ranges() {
    return {
        {"Specific Heat", 50.0, 2e4},
        {"Sound Speed", 100.0, 2e4},
        {"Vapour Pressure", 1.0, 1e8, true},
        {"Initial Pressure", 1e2, 1e10}};
  }

  /// Rules across parameters; an empty text means that the set is sound.
  static std::string check(const Parameters& p, double density) {
    const MieGruneisen law = law_of(p, density);
    std::ostringstream text;
    const double small = 0.01 * law.bulk_modulus();
    const double turn = convex_limit(law);
    if (!(std::fabs(p.vapour_pressure) <= small)) {
      text << "Vapour Pressure = " << p.vapour_pressure
           << " is more than 1 % of the bulk modulus Density * Sound Speed^2 = "
           << law.bulk_modulus()
           << " (no liquid boils or bears tension there); check the units of the three.";
    } else if (p.vapour_pressure > p.initial_pressure) {
      text
          << "Vapour Pressure = " << p.vapour_pressure
          << " is above the Initial Pressure = " << p.initial_pressure
          << " (the liquid would boil before it moves); raise Initial Pressure, or count both from "
             "the pressure of the atmosphere.";
    } else if (turn < law.compression_limit()) {
      text << "Gruneisen = " << p.gamma
           << " makes the equation of state lose its convexity at a compression of " << turn
           << ", before its limit " << law.compression_limit()
           << " (a shock would fall apart there); lower Gruneisen or check Hugoniot Slope.";
    } else if (!law.isentrope_at(p.initial_pressure).possible) {
      text << "Initial Pressure = " << p.initial_pressure
           << " is beyond the compression 1 / Hugoniot Slope (where the pressure is infinite); "
              "check its unit.";
    }
    return text.str();
  }

  Liquid(const Parameters& p, double density)
      : p_(p), law_(law_of(p, density)), inverse_density_(1.0 / density) {}

  History initial_history() const { return {p_.temperature, 0.0, 0.0}; }

  /// Stress, history and density of a point at rest under a pressure, reached isentropically.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    InitialStateOf<Sym3, History> state{isotropic(0.0), initial_history(), 1.0, 0.0, true};
    const metal::IsentropeState at = law_.isentrope_at(pressure);
    state.possible = at.possible && pressure >= p_.vapour_pressure;
    if (!state.possible) return state;
    state.volume_ratio = 1.0 - at.compression;
    state.stored_energy = at.energy;
    state.history.internal_energy = at.energy * inverse_density_;
    state.history.temperature *= at.temperature_ratio;
    state.stress = isotropic(-law_.pressure(at.compression, state.history.internal_energy));
    return state;
  }

  /// @param[in]     increment dt, volume ratios and viscous pressure of the step
  /// @param[in,out] stress    unrotated Cauchy stress, an isotropic one [stress]
  /// @param[in,out] history   as in history_table()
  /// @return bad_input for values that are not finite, dt < 0, volume ratios that are not positive
  ///         or beyond the compression limit of the equation of state; nothing changes then
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
    Step<R> step;
    step.liquid_begin = increment.volume_ratio_begin - history.void_volume;
    step.p_begin = trace(stress) * (-1.0 / 3.0);
    step.heat = -increment.viscous_pressure * (v - increment.volume_ratio_begin);
    step.given = history.internal_energy * law_.density + step.heat;
    fill_with_liquid(v, step);
    const MaskOf<R> open = step.pressure < p_.vapour_pressure;
    if (real::any(open)) open_void(open, MaskOf<R>(history.void_volume > 0.0), step);
    const R change = step.liquid - step.liquid_begin;
    const R opened = real::select(open, v - step.liquid, 0.0);
    const R work = -0.5 * (step.p_begin + step.pressure) * change;
    const R elastic_work = work - p_.vapour_pressure * (opened - history.void_volume);
    HistoryOf<R> end;
    end.internal_energy = (step.given + work) * inverse_density_;
    end.temperature = history.temperature * temperature_ratio(change) +
                      step.heat * (inverse_density_ / p_.specific_heat);
    end.void_volume = opened;
    const MaskOf<R> sound = admissible(increment, stress, history, step) &
                            real::is_finite(R(elastic_work + end.temperature));
    const R p = step.pressure;
    stress = select_points(sound, isotropic(R(-p)), stress);
    assign_where(sound, end, history);
    return {sound, elastic_work, R{}, modulus(v, step.liquid, p)};
  }

  /// Bound on rho c^2 of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& history, double volume_ratio
  ) const {
    return modulus(volume_ratio, volume_ratio - history.void_volume, -trace(stress) / 3.0);
  }
  /// V / V_ref of what has expanded: the liquid without its voids, which may have any size.
  template <class R>
  BARRENO_FUNCTION static R expanded_ratio(const R& volume_ratio, const HistoryOf<R>& history) {
    return volume_ratio - history.void_volume;
  }
  /// Gives a point another gain of energy than its update found; the difference is heat.
  /// @param before  history at the start of the update
  /// @param gain    of energy over the update, that of the void included [energy/mass]
  template <class R>
  BARRENO_FUNCTION void correct_energy(
      const HistoryOf<R>& before, const R& gain, HistoryOf<R>& history
  ) const {
    const R of_void =
        (history.void_volume - before.void_volume) * (-p_.vapour_pressure * inverse_density_);
    const R heat = gain - of_void - (history.internal_energy - before.internal_energy);
    history.internal_energy += heat;
    history.temperature += heat * (1.0 / p_.specific_heat);
  }

  const Parameters& parameters() const { return p_; }
  const MieGruneisen& equation_of_state() const { return law_; }

private:
  /// A step of the liquid between its voids; volumes over V_ref, energies per V_ref.
  template <class R>
  struct Step {
    R liquid_begin, p_begin;
    R heat;              ///< of the artificial viscosity [stress]
    R given;             ///< energy at the start and heat [stress]
    R liquid, pressure;  ///< at the end
  };

  static MieGruneisen law_of(const Parameters& p, double density) {
    return {density, p.sound_speed, p.slope, p.gamma, 0.0, 0.0};
  }

  /// First compression, to 1/256 of the limit, from which dP/deta on the isentrope falls; the limit
  /// if there is none. Set-up only.
  static double convex_limit(const MieGruneisen& law) {
    constexpr int parts = 256;
    const double part = law.compression_limit() / parts;
    double before = 0.0;
    for (int i = 0; i < parts; ++i) {
      const double eta = i * part;
      const double rise = law.reference(eta).derivative + law.gamma * law.isentrope_pressure(eta);
      if (!(rise >= before * (1.0 - 1e-12))) return eta;
      before = rise;
    }
    return law.compression_limit();
  }

  /// All of V is liquid: P is linear in e, which contains 1/2 P dV.
  template <class R>
  BARRENO_FUNCTION void fill_with_liquid(const R& v, Step<R>& step) const {
    const R change = v - step.liquid_begin;
    const auto at = law_.reference(R(1.0 - v));
    const R implicit = 1.0 / (1.0 + 0.5 * law_.gamma * change);
    const R energy = implicit * (step.given - 0.5 * (step.p_begin + at.pressure) * change);
    step.liquid = v;
    step.pressure = at.pressure + law_.gamma * energy;
  }

  /// Where a void is open at the end, the liquid fills the volume at which P = p_v:
  ///   a(eta) + Gamma0 (given - 1/2 (p_n + p_v) (1 - eta - V_begin)) = p_v,
  /// a line where the liquid is expanded, and next to one where it is compressed by p_v.
  template <class R>
  BARRENO_FUNCTION void open_void(const MaskOf<R>& open, const MaskOf<R>& was_open, Step<R>& step)
      const {
    const double vapour = p_.vapour_pressure;
    const R mean = 0.5 * (step.p_begin + vapour);
    R eta = 1.0 - step.liquid;
    for (int i = 0; i < 4; ++i) {
      const auto at = law_.reference(eta);
      const R energy = step.given - mean * (1.0 - eta - step.liquid_begin);
      eta =
          eta - (at.pressure + law_.gamma * energy - vapour) / (at.derivative + law_.gamma * mean);
    }
    // A liquid that gets no heat keeps its volume to the last bit.
    const R liquid = real::select(was_open & (step.heat == 0.0), step.liquid_begin, R(1.0 - eta));
    step.liquid = real::select(open, liquid, step.liquid);
    step.pressure = real::select(open, vapour, step.pressure);
  }

  template <class R>
  BARRENO_FUNCTION R temperature_ratio(const R& change) const {
    const typename MieGruneisen::template ReferenceOf<R> gamma{R{}, R{}, R{} + law_.gamma};
    return law_.isentropic_temperature_ratio(
        gamma, change, R(1.0 / (1.0 + 0.5 * law_.gamma * change))
    );
  }

  template <class R>
  BARRENO_FUNCTION MaskOf<R> admissible(
      const IncrementOf<Sym3Of<R>>& i,
      const Sym3Of<R>& stress,
      const HistoryOf<R>& history,
      const Step<R>& step
  ) const {
    // One sum for all: it is finite only if every term is. The strain is not used, but a strain
    // that is no motion is refused.
    const R sum = contract(i.strain, i.strain) + stress.xx + stress.yy + stress.zz + stress.xy +
                  stress.yz + stress.zx + i.dt + i.viscous_pressure + step.given + step.pressure;
    const R v = i.volume_ratio_end;
    return real::is_finite(sum) & (i.dt >= 0.0) & (i.volume_ratio_begin > 0.0) & (v > 0.0) &
           (history.void_volume >= 0.0) & (step.liquid_begin > 0.0) &
           law_.allows(R(1.0 - v), R(v - step.liquid_begin));
  }

  /// rho c^2 with the mean density, rho_liquid c^2 V_liquid / V.
  template <class R>
  BARRENO_FUNCTION R modulus(const R& v, const R& liquid, const R& pressure) const {
    constexpr double next_to_none = 0.01;
    constexpr double beyond_a_step = 1.6487212707001282;  // exp(0.5)
    const R eta = 1.0 - liquid;
    const R of_liquid = real::larger(
        law_.isentropic_modulus(eta, law_.reference(eta), pressure),
        next_to_none * law_.bulk_modulus()
    );
    const R share = liquid / v;
    return of_liquid * real::select(v > beyond_a_step * liquid, next_to_none * share, share);
  }

  Parameters p_;
  MieGruneisen law_;
  double inverse_density_;  ///< 1 / rho0: energy per mass from energy per reference volume
};

/// A liquid bears no shear stress [stress].
inline double shear_modulus(
    const Liquid& /*model*/, const Sym3& /*stress*/, const Liquid::History& /*h*/
) {
  return 0.0;
}

}  // namespace barreno
