// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point update of JohnsonCook, for one point or several at once (real.hpp). Read first:
// johnson_cook.hpp, which includes this.
#include "barreno/models/johnson_cook.hpp"

namespace barreno {

template <class R>
BARRENO_FUNCTION MaskOf<R> JohnsonCook::admissible(
    const IncrementOf<Sym3Of<R>>& i, const Sym3Of<R>& stress, const HistoryOf<R>& h
) const {
  const R change = i.volume_ratio_end - i.volume_ratio_begin;
  // One sum for all: it is finite only if every term is.
  const R sum = i.strain.xx + i.strain.yy + i.strain.zz + i.strain.xy + i.strain.yz + i.strain.zx +
                stress.xx + stress.yy + stress.zz + stress.xy + stress.yz + stress.zx +
                i.viscous_pressure + i.dt + change + h.plastic_strain + h.temperature +
                h.internal_energy + h.damage;
  const R compression = 1.0 - i.volume_ratio_end;
  return real::is_finite(sum) & (i.dt >= 0.0) & (i.volume_ratio_begin > 0.0) &
         (i.volume_ratio_end > 0.0) & (compression < eos_.compression_limit()) &
         (1.0 + 0.5 * eos_.gamma * change > 0.0);
}

/// Equivalent stress that a broken point can hold, infinite for others [stress]. It takes the
/// pressure without this step's plastic heat.
template <class R>
BARRENO_FUNCTION R JohnsonCook::broken_limit(const R& ratio, const Trial<R>& trial) const {
  const R thermal = trial.known - ratio * energy_per_square_ * trial.squares_n;
  const R p_known = trial.reference.pressure + eos_.gamma * trial.implicit * thermal;
  return real::select(trial.step.broken, 1.5 * real::larger(p_known, 0.0), HUGE_VAL);
}

/// Which points may flow, and the problem that their return solves.
/// @param ratio V / V_ref at the end of the step
template <class R>
BARRENO_FUNCTION void JohnsonCook::try_elastic(const R& ratio, Trial<R>& trial) const {
  const R trial_squared = 1.5 * contract(trial.s, trial.s);
  // A trial too large for a double has no return.
  trial.solved = real::is_finite(trial_squared);
  R least = flow_.lower_bound(trial.end.plastic_strain, trial.end.temperature);
  if (real::any(trial.step.broken)) {
    trial.limit = broken_limit(ratio, trial);
    least = real::select(least < trial.limit, least, trial.limit);
  }
  // Ahead of a wave deviators are as small as 1e-150 Pa: their squares are no longer exact, and
  // without strength the return would not converge on them.
  const double negligible = 1e-30 * flow_.stiffness;
  trial.may_flow =
      trial.solved & (trial_squared > least * least) & (trial_squared > negligible * negligible);
  trial.flow = Return<R>{};
  trial.flows = real::any(trial.may_flow);
  if (!trial.flows) return;
  const R equivalent = real::select(trial.may_flow, real::sqrt(trial_squared), 0.0);
  const R start =
      1.5 * contract(trial.s_n, trial.s) / real::select(trial.may_flow, equivalent, 1.0);
  trial.problem = {equivalent, start, flow_.rate_scale(trial.step.dt), trial.end.plastic_strain};
}

/// Radial return, once its search has ended: the deviator and the plastic work.
template <class R>
BARRENO_FUNCTION void JohnsonCook::return_deviator(Trial<R>& trial) const {
  Return<R>& flow = trial.flow;
  flow = flow_.end_return(trial.problem, trial.search);
  const R& equivalent = trial.problem.trial;
  if (real::any(trial.step.broken)) {
    const R& limit = trial.limit;
    const R& start = trial.problem.start;
    const MaskOf<R> limited = flow.stress > limit;
    flow.plastic_increment = real::select(
        limited, (equivalent - limit) * (1.0 / flow_.stiffness), flow.plastic_increment
    );
    flow.mean_stress = real::select(
        limited, limit + real::select(start > limit, 0.5 * (start - limit), 0.0), flow.mean_stress
    );
    flow.stress = real::select(limited, limit, flow.stress);
  }
  const R safe_trial = real::select(trial.may_flow, equivalent, 1.0);
  trial.s = R(real::select(flow.plastic_increment > 0.0, flow.stress / safe_trial, 1.0)) * trial.s;
  trial.end.plastic_strain = trial.end.plastic_strain + flow.plastic_increment;
  trial.step.plastic_work = trial.step.mean_ratio * flow.mean_stress * flow.plastic_increment;
  trial.solved = trial.solved & flow.converged;
}

/// Lower the equivalent stress to the limit at constant strain.
/// @return the elastic energy set free, all of it dissipated, per current volume [stress]
template <class R>
BARRENO_FUNCTION R JohnsonCook::release(const R& limit, Sym3Of<R>& s, R& plastic_strain) const {
  const R equivalent = real::sqrt(R(1.5 * contract(s, s)));
  const MaskOf<R> above = equivalent > limit;
  const R increment = real::select(above, (equivalent - limit) * (1.0 / flow_.stiffness), 0.0);
  plastic_strain = plastic_strain + increment;
  s = R(real::select(above, limit / equivalent, 1.0)) * s;
  return real::select(above, 0.5 * (equivalent + limit) * increment, 0.0);
}

template <class R>
BARRENO_FUNCTION void JohnsonCook::grow_damage(
    const Return<R>& flow, const R& pressure, const Step<R>& step, HistoryOf<R>& end
) const {
  // Molten points have no ductile fracture to count.
  const MaskOf<R> grows = (!step.broken) & (flow.plastic_increment > 0.0) & (flow.stress > 0.0);
  if (!real::any(grows)) return;
  const R triaxiality = real::smaller(R(-pressure / real::select(grows, flow.stress, 1.0)), 1.5);
  const R fracture_strain =
      (p_.d1 + p_.d2 * real::exp(R(p_.d3 * triaxiality))) *
      (1.0 + p_.d4 * flow_.log_rate(flow.plastic_increment, flow_.rate_scale(step.dt))) *
      (1.0 + p_.d5 * flow_.homologous(end.temperature));
  // Published sets with D1 < 0 give no fracture strain at high tension: the point breaks at once.
  const R grown = real::select(
      flow.plastic_increment >= (1.0 - end.damage) * fracture_strain,
      1.0,
      end.damage + flow.plastic_increment / fracture_strain
  );
  end.damage = real::select(grows, grown, end.damage);
}

/// Damage and spall at the end of a step, where tension is let go and does no work on the way; and
/// the stress limit of a point that was broken before.
template <class R>
BARRENO_FUNCTION void JohnsonCook::break_points(
    const Return<R>& flow, Step<R>& step, HistoryOf<R>& end, Sym3Of<R>& s, R& p
) const {
  if (has_damage_) grow_damage(flow, p, step, end);
  MaskOf<R> spalls = R{} > 0.0;
  if (p_.spall_stress > 0.0) spalls = (!step.broken) & (p < -p_.spall_stress);
  if (!real::any(step.broken | spalls)) return;
  p = real::select(spalls, 0.0, p);
  end.damage = real::select(spalls, 1.0, end.damage);
  const R limit = real::select(step.broken | spalls, 1.5 * p, HUGE_VAL);
  const R freed = step.mean_ratio * release(limit, s, end.plastic_strain);
  step.plastic_work = step.plastic_work + freed;
  step.elastic_work = step.elastic_work - freed;
}

/// The new history where the step was sound.
template <class R>
BARRENO_FUNCTION void JohnsonCook::keep_sound(
    const MaskOf<R>& sound, const HistoryOf<R>& end, HistoryOf<R>& history
) {
  history = {
      real::select(sound, end.plastic_strain, history.plastic_strain),
      real::select(sound, end.temperature, history.temperature),
      real::select(sound, end.internal_energy, history.internal_energy),
      real::select(sound, end.damage, history.damage)};
}

/// The energy as far as it is known, and the elastic trial.
template <class R>
BARRENO_FUNCTION void JohnsonCook::start_update(
    const IncrementOf<Sym3Of<R>>& increment,
    const Sym3Of<R>& stress,
    const HistoryOf<R>& history,
    Trial<R>& trial
) const {
  const R ratio = increment.volume_ratio_end;
  const R change = ratio - increment.volume_ratio_begin;
  trial.step = {increment.dt, change, ratio - 0.5 * change, history.damage >= 1.0, R{}, R{}};
  const R viscous_work = -increment.viscous_pressure * change;
  const R implicit = 1.0 / (1.0 + 0.5 * eos_.gamma * change);
  trial.implicit = implicit;
  trial.end = history;
  trial.end.temperature =
      history.temperature * eos_.isentropic_temperature_ratio(change, implicit) +
      viscous_work * heat_per_work_ * implicit;

  // The trapezoidal p dV contains P(end), which is linear in the thermal energy: that is
  // implicit * (known + deviatoric work - shear energy).
  trial.p_n = trace(stress) * (-1.0 / 3.0);
  trial.s_n = stress + isotropic(trial.p_n);
  trial.squares_n = contract(trial.s_n, trial.s_n);
  trial.reference = eos_.reference(R(1.0 - ratio));
  trial.known = history.internal_energy * eos_.density + viscous_work -
                0.5 * (trial.p_n + trial.reference.pressure) * change;

  trial.strain = deviator(increment.strain);
  trial.s = trial.s_n + (2.0 * p_.shear_modulus) * trial.strain;
  try_elastic(ratio, trial);
}

/// Pressure and energy, per reference volume; breaking, plastic heat, and what is reported.
template <class R>
BARRENO_FUNCTION PointsOutcome<R> JohnsonCook::finish_update(
    const IncrementOf<Sym3Of<R>>& increment,
    Trial<R>& trial,
    Sym3Of<R>& stress,
    HistoryOf<R>& history
) const {
  Step<R>& step = trial.step;
  Sym3Of<R>& s = trial.s;
  HistoryOf<R>& end = trial.end;
  const auto& reference = trial.reference;
  const R ratio = increment.volume_ratio_end;
  const R squares = contract(s, s);
  const R shear_energy = ratio * energy_per_square_ * squares;
  const R deviatoric_work = 0.5 * step.mean_ratio * contract(trial.s_n + s, trial.strain);
  const R thermal = trial.implicit * (trial.known + deviatoric_work - shear_energy);
  R p = reference.pressure + eos_.gamma * thermal;
  R energy = thermal + shear_energy;
  const MaskOf<R> open = step.broken & (p < 0.0);
  if (real::any(open)) {
    energy = real::select(
        open, trial.known + 0.5 * reference.pressure * step.change + deviatoric_work, energy
    );
    p = real::select(open, 0.0, p);
  }
  end.internal_energy = energy * inverse_density_;
  step.elastic_work = step.mean_ratio * energy_per_square_ * (squares - trial.squares_n) -
                      0.5 * (trial.p_n + p) * step.change;

  break_points(trial.flow, step, end, s, p);
  end.temperature =
      end.temperature + p_.taylor_quinney * step.plastic_work * heat_per_work_ * trial.implicit;
  s = s - isotropic(p);
  const R all = s.xx + s.yy + s.zz + s.xy + s.yz + s.zx + end.temperature + end.internal_energy;
  const MaskOf<R> sound =
      admissible(increment, stress, history) & trial.solved & real::is_finite(all);
  stress = select_points(sound, s, stress);
  keep_sound(sound, end, history);
  return {
      sound,
      step.elastic_work,
      step.plastic_work,
      modulus(p, ratio, reference.derivative, MaskOf<R>(end.damage >= 1.0))};
}

template <class R>
BARRENO_FLAT PointsOutcome<R> JohnsonCook::update_points(
    const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
) const {
  Trial<R> trial;
  start_update(increment, stress, history, trial);
  if (trial.flows) {
    flow_.begin_return(trial.end.temperature, trial.problem, trial.search);
    flow_.take_steps(trial.problem, trial.search);
    return_deviator(trial);
  }
  return finish_update(increment, trial, stress, history);
}

BARRENO_FUNCTION Outcome
JohnsonCook::update(const Increment& increment, Sym3& stress, History& history) const {
  if (!admissible(increment, stress, history)) return failure(Status::bad_input);
  const PointsOutcome<double> points = update_points(increment, stress, history);
  if (!points.sound) return failure(Status::not_converged);
  Outcome outcome;
  outcome.elastic_work = points.elastic_work;
  outcome.plastic_work = points.plastic_work;
  outcome.longitudinal_modulus = points.longitudinal_modulus;
  return outcome;
}

}  // namespace barreno
