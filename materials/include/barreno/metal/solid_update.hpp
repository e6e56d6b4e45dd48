// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/history_values.hpp"
#include "barreno/metal/radial_return.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::metal {

/// What a metal remembers whatever its parts are.
template <class R>
struct HeatOf {
  R temperature{};
  R internal_energy{};
};
template <class Strength, class Failure, class R>
struct HistoryOf : Strength::template HistoryOf<R>, HeatOf<R>, Failure::template HistoryOf<R> {};

/// The point update of a metal without voids, for one point or several at once (real.hpp); what it
/// computes, models/metal.hpp says.
template <class Strength, class EquationOfState, class Failure>
struct SolidUpdate {
  template <class R>
  using History = HistoryOf<Strength, Failure, R>;

  Strength strength;
  EquationOfState eos;
  Failure failure;
  double shear_modulus;
  double taylor_quinney;
  double heat_per_work;      ///< 1 / (rho0 c): temperature per work per reference volume
  double inverse_density;    ///< 1 / rho0
  double energy_per_square;  ///< 1 / 4G: s : s / 4G is the elastic energy of a deviator

  template <class R>
  BARRENO_FLAT PointsOutcome<R> update_points(
      const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, History<R>& history
  ) const {
    Trial<R> trial;
    start_update(increment, stress, history, trial);
    if (trial.flows) {
      search_return(strength, trial.end.temperature, trial.problem, trial.search);
      return_deviator(trial);
    }
    return finish_update(increment, trial, stress, history);
  }

  template <class R>
  BARRENO_FUNCTION MaskOf<R> admissible(
      const IncrementOf<Sym3Of<R>>& i, const Sym3Of<R>& stress, const History<R>& h
  ) const {
    const R change = i.volume_ratio_end - i.volume_ratio_begin;
    // One sum for all: it is finite only if every term is.
    R sum = i.strain.xx + i.strain.yy + i.strain.zz + i.strain.xy + i.strain.yz + i.strain.zx +
            stress.xx + stress.yy + stress.zz + stress.xy + stress.yz + stress.zx +
            i.viscous_pressure + i.dt + change;
    for (std::size_t k = 0; k < sizeof(History<R>) / sizeof(R); ++k) sum += reals_of<R>(h)[k];
    return real::is_finite(sum) & (i.dt >= 0.0) & (i.volume_ratio_begin > 0.0) &
           (i.volume_ratio_end > 0.0) & eos.allows(R(1.0 - i.volume_ratio_end), change);
  }

  /// Bound on K_s + 4G/3, K_s = rho c^2 isentropic at the current density [stress].
  template <class R, class Reference>
  BARRENO_FUNCTION R modulus(
      const R& pressure,
      const R& volume_ratio,
      const Reference& at,
      const R& temperature,
      const MaskOf<R>& broken
  ) const {
    // The isentropic modulus falls to zero at a tension of order K / Gamma0: keep a positive speed.
    constexpr double floor_fraction = 0.01;
    const R isentropic = eos.isentropic_modulus(R(1.0 - volume_ratio), at, pressure);
    const R volumetric = real::larger(isentropic, floor_fraction * eos.bulk_modulus());
    const R closed = 4.0 / 3.0 * shear_modulus + volumetric;
    if (!real::any(broken)) return closed;
    const MaskOf<R> open = broken & (pressure <= 0.0);
    return real::select(
        open,
        open_modulus(volume_ratio),
        R(real::select(broken & stays_molten<R>(temperature), volumetric, closed))
    );
  }
  /// A step may cool a point by a fifth.
  template <class R>
  BARRENO_FUNCTION MaskOf<R> stays_molten(const R& temperature) const {
    return strength.homologous(R(0.8 * temperature)) >= 1.0;
  }
  /// The same of an open broken point, which bears nothing: the modulus it will have when it closes
  /// keeps the step safe.
  template <class R>
  BARRENO_FUNCTION R open_modulus(const R& volume_ratio) const {
    return 4.0 / 3.0 * shear_modulus + eos.bulk_modulus() * real::smaller(volume_ratio, 1.0);
  }

private:
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
    History<R> end;
    Sym3Of<R> strain, s_n, s;  ///< deviators: increment, at the start, trial or at the end
    R p_n, squares_n;          ///< at the start: pressure, s_n : s_n
    R implicit, known;         ///< of the energy at the end (find_pressure)
    typename EquationOfState::template ReferenceOf<R> reference;
    R limit = R{} + HUGE_VAL;  ///< equivalent stress that a point can hold if it is broken
    MaskOf<R> solved, may_flow;
    bool flows;  ///< whether any point may
    ReturnProblemOf<R> problem;
    ReturnSearchOf<Strength, R> search;
    ReturnOf<R> flow;
  };

  /// The trapezoidal p dV contains P(end), which is linear in the thermal energy: that is
  /// implicit * (known + deviatoric work - shear energy). Where the pressure is not linear in the
  /// energy, it is so about that of the pass before, which does not know the deviatoric work.
  template <class R>
  BARRENO_FUNCTION void find_pressure(
      const R& ratio, const R& viscous_work, const History<R>& history, Trial<R>& trial
  ) const {
    const R& change = trial.step.change;
    R energy = history.internal_energy * eos.density;
    const R given = energy + viscous_work;
    for (int pass = 0; pass < EquationOfState::passes; ++pass) {
      trial.reference = eos.at(R(1.0 - ratio), energy);
      trial.implicit = 1.0 / (1.0 + 0.5 * eos.per_energy(trial.reference) * change);
      trial.known = given - 0.5 * (trial.p_n + trial.reference.pressure) * change;
      energy = trial.implicit * trial.known;
    }
  }

  /// The energy as far as it is known, and the elastic trial.
  template <class R>
  BARRENO_FUNCTION void start_update(
      const IncrementOf<Sym3Of<R>>& increment,
      const Sym3Of<R>& stress,
      const History<R>& history,
      Trial<R>& trial
  ) const {
    const R ratio = increment.volume_ratio_end;
    const R change = ratio - increment.volume_ratio_begin;
    trial.step = {
        increment.dt, change, ratio - 0.5 * change, failure.template broken<R>(history), R{}, R{}};
    const R viscous_work = -increment.viscous_pressure * change;
    trial.p_n = trace(stress) * (-1.0 / 3.0);
    trial.s_n = stress + isotropic(trial.p_n);
    trial.squares_n = contract(trial.s_n, trial.s_n);
    find_pressure(ratio, viscous_work, history, trial);
    trial.end = history;
    trial.end.temperature =
        history.temperature *
            eos.isentropic_temperature_ratio(trial.reference, change, trial.implicit) +
        viscous_work * heat_per_work * trial.implicit;
    trial.strain = deviator(increment.strain);
    trial.s = trial.s_n + (2.0 * shear_modulus) * trial.strain;
    try_elastic(ratio, trial);
  }

  /// Equivalent stress that a broken point can hold, infinite for others [stress]. It takes the
  /// pressure without this step's plastic heat.
  template <class R>
  BARRENO_FUNCTION R broken_limit(const R& ratio, const Trial<R>& trial) const {
    const R thermal = trial.known - ratio * energy_per_square * trial.squares_n;
    const R p_known =
        trial.reference.pressure + eos.per_energy(trial.reference) * trial.implicit * thermal;
    return real::select(trial.step.broken, 1.5 * real::larger(p_known, 0.0), HUGE_VAL);
  }

  /// Which points may flow, and the problem that their return solves.
  /// @param ratio V / V_ref at the end of the step
  template <class R>
  BARRENO_FUNCTION void try_elastic(const R& ratio, Trial<R>& trial) const {
    const R trial_squared = 1.5 * contract(trial.s, trial.s);
    // A trial too large for a double has no return.
    trial.solved = real::is_finite(trial_squared);
    R least = strength.lower_bound(trial.end.plastic_strain, trial.end.temperature);
    if (real::any(trial.step.broken)) {
      trial.limit = broken_limit(ratio, trial);
      least = real::select(least < trial.limit, least, trial.limit);
    }
    // Ahead of a wave deviators are as small as 1e-150 Pa: their squares are no longer exact, and
    // without strength the return would not converge on them.
    const double negligible = 1e-30 * strength.stiffness;
    trial.may_flow =
        trial.solved & (trial_squared > least * least) & (trial_squared > negligible * negligible);
    trial.flow = {};
    trial.flows = real::any(trial.may_flow);
    if (!trial.flows) return;
    const R equivalent = real::select(trial.may_flow, real::sqrt(trial_squared), 0.0);
    const R start =
        1.5 * contract(trial.s_n, trial.s) / real::select(trial.may_flow, equivalent, 1.0);
    trial.problem = {
        equivalent,
        start,
        rate_scale(trial.step.dt, strength.reference_rate),
        trial.end.plastic_strain};
  }

  /// Radial return, once its search has ended: the deviator and the plastic work.
  template <class R>
  BARRENO_FUNCTION void return_deviator(Trial<R>& trial) const {
    ReturnOf<R>& flow = trial.flow;
    flow = end_return(strength, trial.problem, trial.search);
    const R& equivalent = trial.problem.trial;
    if (real::any(trial.step.broken)) {
      const R& limit = trial.limit;
      const R& start = trial.problem.start;
      const MaskOf<R> limited = flow.stress > limit;
      flow.plastic_increment = real::select(
          limited, (equivalent - limit) * (1.0 / strength.stiffness), flow.plastic_increment
      );
      flow.mean_stress = real::select(
          limited, limit + real::select(start > limit, 0.5 * (start - limit), 0.0), flow.mean_stress
      );
      flow.stress = real::select(limited, limit, flow.stress);
    }
    const R safe_trial = real::select(trial.may_flow, equivalent, 1.0);
    trial.s =
        R(real::select(flow.plastic_increment > 0.0, flow.stress / safe_trial, 1.0)) * trial.s;
    trial.end.plastic_strain = trial.end.plastic_strain + flow.plastic_increment;
    trial.step.plastic_work = trial.step.mean_ratio * flow.mean_stress * flow.plastic_increment;
    trial.solved = trial.solved & flow.converged;
  }

  /// Lower the equivalent stress to the limit at constant strain.
  /// @return the elastic energy set free, all of it dissipated, per current volume [stress]
  template <class R>
  BARRENO_FUNCTION R release(const R& limit, Sym3Of<R>& s, R& plastic_strain) const {
    const R equivalent = real::sqrt(R(1.5 * contract(s, s)));
    const MaskOf<R> above = equivalent > limit;
    const R increment = real::select(above, (equivalent - limit) * (1.0 / strength.stiffness), 0.0);
    plastic_strain = plastic_strain + increment;
    s = R(real::select(above, limit / equivalent, 1.0)) * s;
    return real::select(above, 0.5 * (equivalent + limit) * increment, 0.0);
  }

  /// What breaks at the end of a step, where tension is let go and does no work on the way; and the
  /// stress limit of a point that was broken before.
  template <class R>
  BARRENO_FUNCTION void break_points(Trial<R>& trial, R& p) const {
    Step<R>& step = trial.step;
    History<R>& end = trial.end;
    const MaskOf<R> breaks = failure.template grow<Strength, R>(
        strength, trial.flow, p, end.temperature, step.dt, step.broken, end
    );
    if (!real::any(step.broken | breaks)) return;
    p = real::select(breaks, 0.0, p);
    const R limit = real::select(step.broken | breaks, 1.5 * p, HUGE_VAL);
    const R freed = step.mean_ratio * release(limit, trial.s, end.plastic_strain);
    step.plastic_work = step.plastic_work + freed;
    step.elastic_work = step.elastic_work - freed;
  }

  template <class Base, class R>
  BARRENO_FUNCTION static void keep_sound(
      const MaskOf<R>& sound, const History<R>& end, History<R>& history
  ) {
    if constexpr (!std::is_empty_v<Base>)
      assign_where(sound, static_cast<const Base&>(end), static_cast<Base&>(history));
  }

  /// Pressure and energy, per reference volume; breaking, plastic heat, and what is reported.
  template <class R>
  BARRENO_FUNCTION PointsOutcome<R> finish_update(
      const IncrementOf<Sym3Of<R>>& increment,
      Trial<R>& trial,
      Sym3Of<R>& stress,
      History<R>& history
  ) const {
    Step<R>& step = trial.step;
    Sym3Of<R>& s = trial.s;
    History<R>& end = trial.end;
    const auto& reference = trial.reference;
    const R ratio = increment.volume_ratio_end;
    const R squares = contract(s, s);
    const R shear_energy = ratio * energy_per_square * squares;
    const R deviatoric_work = 0.5 * step.mean_ratio * contract(trial.s_n + s, trial.strain);
    const R thermal = trial.implicit * (trial.known + deviatoric_work - shear_energy);
    R p = reference.pressure + eos.per_energy(reference) * thermal;
    R energy = thermal + shear_energy;
    const MaskOf<R> open = step.broken & (p < 0.0);
    if (real::any(open)) {
      energy = real::select(
          open, trial.known + 0.5 * reference.pressure * step.change + deviatoric_work, energy
      );
      p = real::select(open, 0.0, p);
    }
    end.internal_energy = energy * inverse_density;
    step.elastic_work = step.mean_ratio * energy_per_square * (squares - trial.squares_n) -
                        0.5 * (trial.p_n + p) * step.change;

    break_points(trial, p);
    end.temperature =
        end.temperature + taylor_quinney * step.plastic_work * heat_per_work * trial.implicit;
    s = s - isotropic(p);
    const R all = s.xx + s.yy + s.zz + s.xy + s.yz + s.zx + end.temperature + end.internal_energy;
    const MaskOf<R> sound =
        admissible(increment, stress, history) & trial.solved & real::is_finite(all);
    stress = select_points(sound, s, stress);
    keep_sound<typename Strength::template HistoryOf<R>>(sound, end, history);
    keep_sound<HeatOf<R>>(sound, end, history);
    keep_sound<typename Failure::template HistoryOf<R>>(sound, end, history);
    return {
        sound,
        step.elastic_work,
        step.plastic_work,
        modulus(p, ratio, reference, end.temperature, MaskOf<R>(failure.template broken<R>(end)))};
  }
};

}  // namespace barreno::metal
