// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point update of Arenisca for several points at once (real.hpp). Read first: arenisca.hpp,
// which includes this.
#include "barreno/history_values.hpp"
#include "barreno/models/arenisca.hpp"
#include "barreno/real.hpp"

#if BARRENO_HAS_LANES

#include "barreno/arenisca/points_overstress.hpp"
#include "barreno/arenisca/points_queue.hpp"
#include "barreno/arenisca/points_start.hpp"
#include "barreno/arenisca/points_tension.hpp"

namespace barreno {

/// One lane of a structure that consists of reals, and back.
template <class One, class Several>
inline One lane_of(const Several& from, int lane) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  One to;
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reals_of<double>(to)[c] = reals_of<Lanes>(from)[c][lane];
  return to;
}
template <class One, class Several>
inline void set_lane(const One& from, int lane, Several& to) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reals_of<Lanes>(to)[c][lane] = reals_of<double>(from)[c];
}

namespace arenisca {

/// The stress without overstress.
template <class R, class Law, class Points>
BARRENO_FUNCTION Sym3Of<R> quasi_static(const Points& p) {
  if constexpr (Law::rated)
    return p.stress - overstress_of<R>(p.history);
  else
    return p.stress;
}

/// @param Points PointsOf<Sym3Of<R>, History>; wet where the history holds pores
template <class R, class Law, class Points>
BARRENO_FUNCTION StartOf<R, Law> start_of(const RockOf<R, Law>& rock, const Points& p) {
  StartOf<R, Law> n;
  const Sym3Of<R> stress = quasi_static<R, Law>(p);
  n.x = trace(stress);
  n.s = deviator(stress);
  n.evp = p.history.plastic_volume_strain;
  n.dv = trace(p.increment.strain);
  if constexpr (Law::heated) n.dv = n.dv - p.history.thermal_expansion;
  n.de = deviator(p.increment.strain);
  if constexpr (Law::wet) {
    n.pores = pores_before<R>(rock, p.history);
    n.x = n.x + 3.0 * n.pores.pressure;
  }
  n.elastic = rock.elasticity.state_at(n.x, n.evp);
  press_moduli(rock, n, n.x, n.elastic.moduli);
  return n;
}

/// A shear stress of a step as a tensor.
template <class R, class Law, class Points>
BARRENO_FUNCTION Sym3Of<R> tensor_of(
    const ShearIn<R, Law>& s, const StepOf<R, Law>& step, const Points& p
) {
  if constexpr (Law::angled) {
    return s.tensor;
  } else {
    const Sym3Of<R> begin = deviator(quasi_static<R, Law>(p));
    if constexpr (Law::damaged)
      return plane_of(begin, step.strain).tensor(s);
    else
      return plane_of(begin, deviator(p.increment.strain)).tensor(s);
  }
}

/// What pores are asked of: the points' own rock where that has a centre, else the law.
template <class R, class Law, class Holder>
BARRENO_FUNCTION decltype(auto) rock_of_pores(const Law& law, const Holder& holder) {
  if constexpr (Law::about_centre)
    return rock_of<R>(law, holder);
  else
    return (law);
}

/// Breakage of grains by the work of a step.
template <class R, class Law, class History>
BARRENO_FUNCTION void break_grains(
    const Law& law, const MaskOf<R>& choice, const R& work, History& h
) {
  if (law.breakage.per_energy == 0.0) return;
  h.breakage = real::select(choice, law.breakage.after(h.breakage, work), h.breakage);
}

/// End of steps that flow, from the stress and strain increment that they began with.
/// @param[in,out] step  at its end; the bound on tension may change that
/// @return where the step is left to update()
template <class R, class Law, class Points>
BARRENO_ALIKE MaskOf<R> end_step(
    const Law& rock, const MaskOf<R>& flows, StepOf<R, Law>& step, Points& p
) {
  auto& h = p.history;
  const MaskOf<R> good =
      flows & (!step.refused) & sound_end<R>(h.plastic_volume_strain, step.state.evp);
  R mean_stress = step.state.x * (1.0 / 3.0);
  if constexpr (Law::wet) mean_stress = mean_stress - step.pores.pressure;
  StepEnd<R> end{
      tensor_of<R, Law>(step.state.s, step, p) + isotropic(mean_stress),
      {},
      step.elastic_work,
      step.plastic_work};
  if constexpr (Law::wet) end.pores = step.pores;
  Sym3Of<R> cut{};
  if constexpr (Law::damaged)
    if (rock.tension.cutoff > 0.0)
      cut = cut_step(
          rock,
          good,
          p,
          tensor_of<R, Law>(step.state.s, step, p),
          quasi_static<R, Law>(p),
          step,
          end
      );
  const R mean_ratio = 0.5 * (p.increment.volume_ratio_begin + p.increment.volume_ratio_end);
  if constexpr (Law::rated) {
    Sym3Of<R> missed =
        tensor_of<R, Law>(step.missed_s, step, p) + isotropic(R(step.missed_x * (1.0 / 3.0)));
    if constexpr (Law::damaged)
      if (rock.tension.cutoff > 0.0) missed = missed + (step.missed_before + cut);
    const PoresOf<R> begin = pores_before<R>(rock_of_pores<R>(rock, step), h);
    add_overstress<R>(rock, good, missed, step.mean_moduli, begin, p, end);
  }
  R mean_before{};
  if constexpr (Law::heated) mean_before = trace(p.stress) * (1.0 / 3.0);
  assign_where(good, end.stress, p.stress);
  h.plastic_volume_strain = real::select(good, step.state.evp, h.plastic_volume_strain);
  h.equivalent_plastic_strain =
      real::select(good, step.state.shear_strain, h.equivalent_plastic_strain);
  if constexpr (Law::damaged) {
    h.damage = real::select(good, step.damage, h.damage);
    break_grains<R>(rock, good, R(mean_ratio * step.breaking_work), h);
  }
  keep_pores<R>(rock_of_pores<R>(rock, step), good, step.state.x, end.pores, h);
  PointsOutcome<R>& out = p.outcome;
  out.elastic_work = real::select(good, mean_ratio * end.elastic_work, out.elastic_work);
  out.plastic_work = real::select(good, mean_ratio * end.plastic_work, out.plastic_work);
  out.longitudinal_modulus = real::select(good, step.modulus, out.longitudinal_modulus);
  if constexpr (Law::heated) heat_points<R>(rock, good, mean_before, p);
  return flows & !good;
}

/// The strain that overstress from before gives up in a step, in the plane of the step.
template <class R, class Law, class Points>
BARRENO_FUNCTION void begin_release(
    const Law& law, const StartOf<R, Law>& n, const Points& p, StepOf<R, Law>& step
) {
  const RelaxationOf<R> relaxation = relaxation_in(law.T1, law.T2, p.increment);
  const Sym3Of<R> over = overstress_of<R>(p.history);
  const Sym3Of<R> released = released_strain(relaxation, over, n.elastic.moduli);
  const Sym3Of<R> shear = deviator(released);
  const PlaneOf<R> plane = plane_of(n.s, n.de);
  const auto part = [&](const Sym3Of<R>& axis, const R& size) {
    return R(0.5 * PlaneOf<R>::ratio(contract(shear, axis), size));
  };
  step.taken = share_taken(relaxation);
  step.released = {part(plane.s, plane.s_size), part(plane.across, plane.across_size)};
  step.beside = real::larger(R(0.5 * contract(shear, shear) - squared(step.released)), 0.0);
  step.released_volume = trace(released);
}

/// Damage of rated points in steps whose quasi-static answer is elastic: overstress flows on.
/// @param x  mean I1 of the quasi-static stress
template <class R, class Law, class Points>
BARRENO_FUNCTION R damage_of_elastic(
    const Law& law, const MaskOf<R>& elastic, const StartOf<R, Law>& n, const R& x, const Points& p
) {
  const auto& h = p.history;
  const RelaxationOf<R> relaxation = relaxation_in(law.T1, law.T2, p.increment);
  const Sym3Of<R> over = overstress_of<R>(h);
  const Sym3Of<R> released = released_strain(relaxation, over, n.elastic.moduli);
  const Sym3Of<R> shear = deviator(released);
  const R strain = damaging_strain(R(0.5 * contract(shear, shear)), trace(released));
  const MaskOf<R> grows = elastic & (strain > 0.0);
  if (!real::any(grows)) return h.damage;
  const R share = law.damage.share(x, cap_of(rock_of<R>(law, h), n.evp));
  const R damage = real::smaller(R(h.damage + share * strain / h.fracture_strain), 1.0);
  return real::select(grows, damage, h.damage);
}

/// A step that flows, from the point as it is before it.
template <class R, class Law, class Points>
BARRENO_ALIKE StepOf<R, Law> begin_rock(const Law& law, const MaskOf<R>& flows, const Points& p) {
  auto&& rock = rock_of<R>(law, p.history);
  StartOf<R, Law> n = start_of<R, Law>(rock, p);
  StepOf<R, Law> step;
  if constexpr (Law::damaged) {
    CutOf<R> c = cut_of<R>(p.history);
    c.shear_strain = p.history.equivalent_plastic_strain;
    if constexpr (Law::rated) c.taken = share_taken(relaxation_in(law.T1, law.T2, p.increment));
    if (law.tension.cutoff > 0.0 && real::any(open_before<R>(rock, law, flows, n, c)))
      rock = rock_with_damage<R>(law, p.history, c.damage);
    step = begin_step(rock, n, c.shear_strain, flows);
    step.strain = n.de;
    step.damage = c.damage;
    step.fracture_strain = c.fracture_strain;
    step.elastic_work = c.elastic_work;
    step.plastic_work = c.plastic_work;
    if constexpr (Law::rated) step.missed_before = c.missed;
  } else {
    step = begin_step(rock, n, R(p.history.equivalent_plastic_strain), flows);
  }
  if constexpr (Law::scattered) step.coherence = p.history.coherence;
  if constexpr (Law::heated) step.temperature = p.history.temperature;
  if constexpr (Law::rated && Law::damaged) begin_release(law, n, p, step);
  if constexpr (Law::about_centre) step.fluid_mass_ratio = p.history.fluid_mass_ratio;
  return step;
}

inline LaneMask first_lane() {
  LaneMask mask{};
  mask[0] = -1;
  return mask;
}
/// The same point in all lanes.
template <class Points, class History>
inline void repeat_point(
    const Increment& increment, const Sym3& stress, const History& h, Points& p
) {
  for (int i = 0; i < lane_count; ++i) {
    set_lane(increment.strain, i, p.increment.strain);
    set_lane(stress, i, p.stress);
    set_lane(h, i, p.history);
  }
  p.increment.dt = Lanes{} + increment.dt;
  p.increment.volume_ratio_begin = Lanes{} + increment.volume_ratio_begin;
  p.increment.volume_ratio_end = Lanes{} + increment.volume_ratio_end;
  p.increment.viscous_pressure = Lanes{} + increment.viscous_pressure;
  p.outcome = PointsOutcome<Lanes>{};
}

/// First part of an update (outcome.hpp): steps that are elastic.
/// @return where more is to do
template <class R, class Law, class Points>
BARRENO_FUNCTION MaskOf<R> start_rock(const Law& law, const MaskOf<R>& sound, Points& p) {
  const auto& rock = rock_of<R>(law, p.history);
  const StartOf<R, Law> n = start_of<R, Law>(rock, p);
  p.outcome.sound = sound;
  WholeStepOf<R, Law> whole;
  MaskOf<R> elastic = step_elastically(rock, n, sound, whole, p.outcome);
  if constexpr (Law::damaged) {
    R damage = p.history.damage;
    if constexpr (Law::rated)
      damage = damage_of_elastic(law, elastic, n, R(0.5 * (n.x + whole.x)), p);
    if (law.tension.cutoff > 0.0) {
      const R bound = tension_bound(law, damage, p.history.coherence);
      elastic = elastic & !near_bound(law, elastic, bound, whole.x, whole.s);
    }
    if constexpr (Law::rated) p.history.damage = real::select(elastic, damage, p.history.damage);
  }
  const R mean_ratio = 0.5 * (p.increment.volume_ratio_begin + p.increment.volume_ratio_end);
  R mean_stress = whole.x * (1.0 / 3.0);
  if constexpr (Law::wet) mean_stress = mean_stress - whole.pores.pressure;
  PointsOutcome<R>& out = p.outcome;
  StepEnd<R> end{whole.s + isotropic(mean_stress), {}, out.elastic_work, out.plastic_work};
  if constexpr (Law::wet) end.pores = whole.pores;
  if constexpr (Law::rated) {
    const PoresOf<R> begin = pores_before<R>(rock_of_pores<R>(law, p.history), p.history);
    add_overstress<R>(law, elastic, Sym3Of<R>{}, whole.used, begin, p, end);
    out.elastic_work = end.elastic_work;
    out.plastic_work = mean_ratio * end.plastic_work;
  }
  out.elastic_work = mean_ratio * out.elastic_work;
  keep_pores<R>(rock, elastic, whole.x, end.pores, p.history);
  R mean_before{};
  if constexpr (Law::heated) mean_before = trace(p.stress) * (1.0 / 3.0);
  assign_where(elastic, end.stress, p.stress);
  if constexpr (Law::heated) heat_points<R>(law, elastic, mean_before, p);
  return sound & !elastic;
}

/// Second part of an update: steps that flow.
template <class R, class Law, class Points, std::size_t room>
BARRENO_FUNCTION void finish_rock(
    const Law& rock,
    StepOf<R, Law> (&steps)[room],
    Points* groups,
    const MaskOf<R>* flows,
    int count
) {
  for (int g = 0; g < count; ++g) steps[g] = begin_rock<R>(rock, flows[g], groups[g]);
  finish_steps(rock, steps, count);
  for (int g = 0; g < count; ++g) {
    const MaskOf<R> refused = end_step<R>(rock, flows[g], steps[g], groups[g]);
    groups[g].outcome.sound = groups[g].outcome.sound & !refused;
  }
}

/// One point: the update of lanes with it in the first of them, so that a host with a single point
/// gets the bits of one with many.
template <class Law, class Model>
inline Outcome update_point(
    const Model& model,
    const Law& rock,
    const Increment& increment,
    Sym3& stress,
    typename Model::History& h
) {
  typename Model::template Points<Lanes> p;
  repeat_point(increment, stress, h, p);
  Outcome outcome;
  const LaneMask flows = model.start_points(p) & first_lane();
  if (p.outcome.sound[0] == 0) {
    outcome.status = Status::bad_input;
    outcome.substeps = 0;
    return outcome;
  }
  if (real::any(flows)) {
    StepOf<Lanes, Law> step[1] = {begin_rock<Lanes>(rock, flows, p)};
    finish_steps(rock, step, 1);
    outcome.substeps = static_cast<int>(step[0].substeps[0]);
    if (real::any(end_step<Lanes>(rock, flows, step[0], p))) {
      outcome.status = Status::substep_limit;
      return outcome;
    }
  }
  stress = lane_of<Sym3>(p.stress, 0);
  h = lane_of<typename Model::History>(p.history, 0);
  outcome.elastic_work = p.outcome.elastic_work[0];
  outcome.plastic_work = p.outcome.plastic_work[0];
  outcome.longitudinal_modulus = p.outcome.longitudinal_modulus[0];
  return outcome;
}

/// Updates of one point by increments next to each other, in the substeps that the first one
/// chooses, so that the ends are smooth in the increment (tangent.hpp).
/// @return false where one failed
template <class Model>
inline bool update_alike(
    const Model& model,
    const Increment (&increments)[lane_count],
    const Sym3& stress,
    const typename Model::History& h,
    Sym3 (&ends)[lane_count]
) {
  typename Model::template Points<Lanes> p;
  repeat_point(increments[0], stress, h, p);
  for (int i = 0; i < lane_count; ++i) set_lane(increments[i].strain, i, p.increment.strain);
  const LaneMask all = !LaneMask{};
  auto step = begin_rock<Lanes>(model.rock(), all, p);
  for (int i = 0; i < max_attempts_together && real::any(step.active); ++i)
    advance_step(model.rock(), step, SubstepsOfTheFirst{});
  if (real::any(step.active) || real::any(end_step<Lanes>(model.rock(), all, step, p)))
    return false;
  for (int i = 0; i < lane_count; ++i) ends[i] = lane_of<Sym3>(p.stress, i);
  return true;
}

}  // namespace arenisca

template <class Parts>
template <class R>
BARRENO_FUNCTION MaskOf<R> AreniscaOf<Parts>::start_points(Points<R>& p) const {
  using namespace arenisca;
  const MaskOf<R> sound = sound_points(
      p.increment, p.stress, p.history.plastic_volume_strain, p.history.equivalent_plastic_strain
  );
  return start_rock<R>(rock_, sound, p);
}

template <class Parts>
template <class R>
BARRENO_FUNCTION void AreniscaOf<Parts>::finish_points(
    Points<R>* groups, const MaskOf<R>* flows, int count
) const {
  constexpr std::size_t room = groups_together;
  arenisca::StepOf<R, Law> steps[room];
  arenisca::finish_rock(rock_, steps, groups, flows, count);
}

template <class Parts>
Outcome AreniscaOf<Parts>::update(const Increment& increment, Sym3& stress, History& h) const {
  return arenisca::update_point(*this, rock_, increment, stress, h);
}

}  // namespace barreno

#endif
