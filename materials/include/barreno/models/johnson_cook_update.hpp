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

/// Radial return: s is the trial deviator on entry and the deviator at the end of the step on
/// return.
/// @param s_n   deviator at the start of the step [stress]
/// @param limit equivalent stress a broken point can hold [stress]
/// @return false if the trial is too large for a double or the return has not converged
template <class R>
BARRENO_FUNCTION MaskOf<R> JohnsonCook::return_deviator(
    const Sym3Of<R>& s_n,
    const R& limit,
    Step<R>& step,
    HistoryOf<R>& end,
    Sym3Of<R>& s,
    Return<R>& flow
) const {
  const R trial_squared = 1.5 * contract(s, s);
  const MaskOf<R> finite = real::is_finite(trial_squared);
  const R bound = flow_.lower_bound(end.plastic_strain, end.temperature);
  const R least = real::select(bound < limit, bound, limit);
  // Ahead of a wave deviators are as small as 1e-150 Pa: their squares are no longer exact, and
  // without strength the return would not converge on them.
  const double negligible = 1e-30 * flow_.stiffness;
  const MaskOf<R> may_flow =
      finite & (trial_squared > least * least) & (trial_squared > negligible * negligible);
  if (!real::any(may_flow)) return finite;
  const R trial = real::select(may_flow, real::sqrt(trial_squared), 0.0);
  const R safe_trial = real::select(may_flow, trial, 1.0);
  const R start = 1.5 * contract(s_n, s) / safe_trial;
  flow = flow_.return_to_flow_stress(trial, start, step.dt, end.temperature, end.plastic_strain);
  const MaskOf<R> limited = flow.stress > limit;
  flow.plastic_increment =
      real::select(limited, (trial - limit) * (1.0 / flow_.stiffness), flow.plastic_increment);
  flow.mean_stress = real::select(
      limited, limit + real::select(start > limit, 0.5 * (start - limit), 0.0), flow.mean_stress
  );
  flow.stress = real::select(limited, limit, flow.stress);
  s = R(real::select(flow.plastic_increment > 0.0, flow.stress / safe_trial, 1.0)) * s;
  end.plastic_strain = end.plastic_strain + flow.plastic_increment;
  step.plastic_work = step.mean_ratio * flow.mean_stress * flow.plastic_increment;
  return finite & flow.converged;
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
  const R fracture_strain = (p_.d1 + p_.d2 * real::exp(R(p_.d3 * triaxiality))) *
                            (1.0 + p_.d4 * flow_.log_rate(flow.plastic_increment, step.dt)) *
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
  const double strength = p_.spall_stress > 0.0 ? p_.spall_stress : HUGE_VAL;
  const MaskOf<R> spalls = (!step.broken) & (p < -strength);
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

template <class R>
BARRENO_FUNCTION PointsOutcome<R> JohnsonCook::update_points(
    const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
) const {
  const double density = eos_.density;
  const R ratio = increment.volume_ratio_end;
  const R change = ratio - increment.volume_ratio_begin;
  Step<R> step{increment.dt, change, ratio - 0.5 * change, history.damage >= 1.0};
  const R viscous_work = -increment.viscous_pressure * change;
  const R implicit = 1.0 / (1.0 + 0.5 * eos_.gamma * change);
  HistoryOf<R> end = history;
  end.temperature = history.temperature * eos_.isentropic_temperature_ratio(change, implicit) +
                    viscous_work * heat_per_work_ * implicit;

  // 1. Energy at the end as far as known. The trapezoidal p dV contains P(end), which is linear in
  //    the thermal energy: that is implicit * (known + deviatoric work - shear energy).
  const R p_n = trace(stress) * (-1.0 / 3.0);
  const Sym3Of<R> s_n = stress + isotropic(p_n);
  const R squares_n = contract(s_n, s_n);
  const auto reference = eos_.reference(R(1.0 - ratio));
  const R known =
      history.internal_energy * density + viscous_work - 0.5 * (p_n + reference.pressure) * change;

  // 2. Deviator. The limit of a broken point takes the pressure without this step's plastic heat.
  const Sym3Of<R> strain = deviator(increment.strain);
  Sym3Of<R> s = s_n + (2.0 * p_.shear_modulus) * strain;
  const R shear_per_square = ratio * energy_per_square_;
  const R p_known =
      reference.pressure + eos_.gamma * implicit * (known - shear_per_square * squares_n);
  const R limit = real::select(step.broken, 1.5 * real::larger(p_known, 0.0), HUGE_VAL);
  Return<R> flow;
  const MaskOf<R> solved = return_deviator(s_n, limit, step, end, s, flow);

  // 3. Pressure and energy, per reference volume.
  const R squares = contract(s, s);
  const R shear_energy = shear_per_square * squares;
  const R deviatoric_work = 0.5 * step.mean_ratio * contract(s_n + s, strain);
  const R thermal = implicit * (known + deviatoric_work - shear_energy);
  R p = reference.pressure + eos_.gamma * thermal;
  const MaskOf<R> open = step.broken & (p < 0.0);
  const R energy = real::select(
      open, known + 0.5 * reference.pressure * change + deviatoric_work, thermal + shear_energy
  );
  p = real::select(open, 0.0, p);
  end.internal_energy = energy * inverse_density_;
  step.elastic_work =
      step.mean_ratio * energy_per_square_ * (squares - squares_n) - 0.5 * (p_n + p) * change;

  // 4. Breaking, plastic heat, and what is reported.
  break_points(flow, step, end, s, p);
  end.temperature =
      end.temperature + p_.taylor_quinney * step.plastic_work * heat_per_work_ * implicit;
  s = s - isotropic(p);
  const R all = s.xx + s.yy + s.zz + s.xy + s.yz + s.zx + end.temperature + end.internal_energy;
  const MaskOf<R> sound = admissible(increment, stress, history) & solved & real::is_finite(all);
  stress = select_points(sound, s, stress);
  keep_sound(sound, end, history);
  return {
      sound,
      step.elastic_work,
      step.plastic_work,
      modulus(p, ratio, reference.derivative, MaskOf<R>(end.damage >= 1.0))};
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
