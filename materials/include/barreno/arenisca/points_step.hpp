// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_flow.hpp"
#include "barreno/arenisca/points_middle.hpp"
#include "barreno/arenisca/points_rate.hpp"

namespace barreno::arenisca {

// A whole step of one or several points, in substeps that each chooses by its own local error.

/// Elastic prediction with the moduli of this plastic strain.
template <class R, class Law>
BARRENO_FUNCTION PredictionOf<R, Law> predict_points(
    const RockOf<R, Law>& rock, const SubstepOf<R, Law>& step, const R& evp
) {
  PredictionOf<R, Law> p;
  p.evp = evp;
  p.begin = rock.elasticity.state_at(step.n.x, evp);
  press_moduli(rock, step, step.n.x, p.begin.moduli);
  p.start = p.begin.moduli;
  const R strain = skeleton_guess<R>(rock, step, step.n.x, p.start.bulk);
  const MiddleOf<R> middle = used_moduli(rock, step, strain, step.cap, p.begin);
  if constexpr (Law::wet) p.per_matrix = middle.per_matrix;
  predict_pressure(rock, step, middle.moduli.bulk, p);
  predict_with(step, middle.moduli, p);
  find_angle(rock, p.s, p);
  return p;
}

/// Moduli of dry rock at an elastic prediction into those under the pressure of the fluid there.
template <class R, class Law>
BARRENO_FUNCTION void press_elastic_moduli(
    const RockOf<R, Law>& rock, const PredictionOf<R, Law>& p, ModuliOf<R>& moduli
) {
  if constexpr (has_poroplastic_fluid<Law>)
    moduli.bulk = bulk_under_pressure(rock.constituents, p.elastic, p.x, moduli.bulk);
}

/// End of elastic substeps, where `inside`.
template <class R, class Law>
BARRENO_FUNCTION void accept_elastic(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& inside,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const ModuliOf<R>& moduli,
    AttemptOf<R, Law>& a
) {
  const StateOf<R, Law>& n = step.n;
  assign_where(inside, StateOf<R, Law>{p.x, p.s, p.evp, n.shear_strain}, a.end);
  assign_where(inside, moduli, a.moduli);
  const R change = size_of_stress(R(p.x - n.x), squared(p.s - n.s));
  a.error = real::select(inside, mismatch_of(p.start, p.used, moduli) * change, a.error);
  if constexpr (Law::rated) assign_where(inside, p.used, a.used);
  a.allowed = real::select(inside, allowed_error_of(rock, n, p.x, p.J2), a.allowed);
  R work{};
  if constexpr (Law::wet) {
    assign_where(inside, p.elastic, a.pores);
    if constexpr (has_poroplastic_fluid<Law>) {
      const Constituents& c = rock.constituents;
      if (c.change) {
        const R of_grains =
            error_of_grains(c, step.pores, n.x, p.elastic, p.x, p.per_matrix, p.used.bulk);
        a.error = real::select(inside, a.error + of_grains, a.error);
      }
    }
    work = work_of_stress(step, a);
  } else {
    work = 0.5 * (n.x + p.x) * (step.dv * (1.0 / 3.0)) + dot(n.s + p.s, step.de);
  }
  a.elastic_work = real::select(inside, work, a.elastic_work);
  a.plastic_work = real::select(inside, 0.0, a.plastic_work);
  if constexpr (Law::damaged) a.breaking_work = real::select(inside, 0.0, a.breaking_work);
}

/// What becomes of attempts: taken, or tried again.
template <class R>
struct VerdictOf {
  MaskOf<R> takes;
  MaskOf<R> gives_up;  ///< no root or not finite, however short the substep
  MaskOf<R> crosses;   ///< goes beyond the jump of the moduli
  R factor;            ///< of the next substep
};
/// Every point chooses its own substeps, and whether a second pass is worth it.
struct OwnSubsteps {
  template <class Mask>
  BARRENO_FUNCTION Mask alike(const Mask& mask) const {
    return mask;
  }
  template <class R>
  BARRENO_FUNCTION void operator()(VerdictOf<R>& /*verdict*/) const {}
};
/// All lanes take the substeps of the first, whatever their own errors: the choice jumps with the
/// strain, and with it the stress by some tolerance; between points that choose alike it does not.
struct SubstepsOfTheFirst {
  template <class Mask>
  BARRENO_FUNCTION Mask alike(const Mask& mask) const {
    return Mask{} + mask[0];
  }
  template <class R>
  BARRENO_FUNCTION void operator()(VerdictOf<R>& v) const {
    v.takes = MaskOf<R>{} + v.takes[0];
    v.gives_up = MaskOf<R>{} + v.gives_up[0];
    // The way to the jump of the moduli moves with the strain, and smoothly.
    const MaskOf<R> own = v.crosses & (MaskOf<R>{} + v.crosses[0]);
    v.factor = real::select(own, v.factor, R{} + v.factor[0]);
  }
};

/// Flow that dilates from the jump of the moduli: those of dilated rock hold from where it begins
/// to flow.
/// @param[in,out] a replaced where `asked`
template <class R, class Law, class Choice>
BARRENO_FUNCTION void begin_to_dilate(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& asked,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const Choice& choose,
    AttemptOf<R, Law>& a
) {
  constexpr int halvings = 30;
  constexpr double other_side = 2.0 * Elasticity::at_jump;
  const StateOf<R, Law>& n = step.n;
  const R t = crossing_of(rock, asked, step, p, halvings);
  const ModuliOf<R> soft = predict_points(rock, step, R(R{} + other_side)).used;
  const ModuliOf<R> used = {
      t * p.used.bulk + (1.0 - t) * soft.bulk, t * p.used.shear + (1.0 - t) * soft.shear};
  PredictionOf<R, Law> mixed = p;
  mixed.evp = R{} + other_side;
  // Such a start that the mean of both ends is what was used.
  mixed.start = {2.0 * used.bulk - soft.bulk, 2.0 * used.shear - soft.shear};
  predict_pressure(rock, step, used.bulk, mixed);
  predict_with(step, used, mixed);
  find_angle(rock, mixed.s, mixed);
  const MeridianOf<R> m = meridian_at(rock.surface, mixed.x, step.cap);
  // A trace of dilation, and the softer rock may no longer reach the surface.
  const MaskOf<R> inside = asked & contained(rock.surface, mixed.x, scaled_J2(mixed), step.cap, m);
  AttemptOf<R, Law> b = flow_points(rock, MaskOf<R>(asked & !inside), step, mixed, m, choose);
  if (real::any(inside)) accept_elastic(rock, inside, step, mixed, soft, b);
  // The elastic part has its own error, that of its moduli on the way to the surface.
  const R x_flow = n.x + t * (p.x - n.x);
  ModuliOf<R> at_flow = rock.elasticity.moduli_at(x_flow, n.evp);
  press_moduli(rock, step, x_flow, at_flow);
  b.error =
      real::select(inside, 0.0, b.error) +
      t * mismatch_of(p.start, p.used, at_flow) * size_of_stress(R(p.x - n.x), squared(p.s - n.s));
  select_attempt(asked, b, a);
}

/// One substep: elastic, or plastic flow.
/// @param asked where it is asked for
template <class R, class Law, class Choice>
BARRENO_FUNCTION AttemptOf<R, Law> attempt_points(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& asked,
    const SubstepOf<R, Law>& step,
    const Choice& choose
) {
  const StateOf<R, Law>& n = step.n;
  const PredictionOf<R, Law> p = predict_points(rock, step, n.evp);
  const MeridianOf<R> m = meridian_at(rock.surface, p.x, step.cap);
  const MaskOf<R> inside = contained(rock.surface, p.x, scaled_J2(p), step.cap, m);
  const MaskOf<R> flows = asked & !inside;
  AttemptOf<R, Law> a{};
  if (real::any(flows)) {
    a = flow_points(rock, flows, step, p, m, choose);
    const MaskOf<R> jumps = flows & is_at_jump(rock, n.evp) & rock.elasticity.dilated(a.end.evp);
    if (real::any(jumps)) begin_to_dilate(rock, jumps, step, p, choose, a);
  }
  a.elastic = inside;
  if constexpr (has_poroplastic_fluid<Law>) a.refused = a.refused | p.unsolved;
  if (!real::any(asked & inside)) return a;
  ModuliOf<R> moduli = rock.elasticity.moduli_after(MaskOf<R>(asked & inside), p.begin, p.x);
  press_elastic_moduli(rock, p, moduli);
  accept_elastic(rock, inside, step, p, moduli, a);
  return a;
}

/// Largest integer not above x, for 0 <= x < 2^51.
inline Lanes whole_part(const Lanes& x) {
  const Lanes nearest = (x + real::rounder) - real::rounder;
  return real::select(nearest > x, nearest - 1.0, nearest);
}

/// Factor for the next substep, in sixteenths: then round-off does not reach the choice of
/// substeps, and two machines take the same ones.
template <class R, class Law>
BARRENO_FUNCTION R step_factor_of(const AttemptOf<R, Law>& a) {
  constexpr double safety = 0.9, smallest = 0.125, largest = 4.0, grain = 16.0;
  constexpr double most = 1e6;  // beyond any bound below
  const MaskOf<R> exact = !(a.error > 0.0);
  const R ratio = real::smaller(R(a.allowed / real::select(exact, 1.0, a.error)), most);
  R root = real::sqrt(ratio);
  if (real::any(a.elastic)) root = real::select(a.elastic, real::pow(ratio, 1.0 / 3.0), root);
  const R factor = whole_part(R(grain * safety * root)) * (1.0 / grain);
  return real::select(exact, largest, real::smaller(real::larger(factor, smallest), largest));
}

/// What a step of wet points adds up, and asks for.
template <class R, bool wet>
struct FluidOfStep {};
template <class R>
struct FluidOfStep<R, true> {
  PoresOf<R> pores;
  R inflow{};  ///< volume of fluid that comes in over the whole step, at the pressure in the pores
  R fluid_work{};  ///< p dv of that [stress]
};

/// A step of points in progress.
template <class R, class Law>
struct StepOf : FluidOfStep<R, Law::wet>,
                OfPieces<R, Law::scattered, Law::about_centre>,
                DamageOfStep<R, Law::damaged>,
                HeatOfStep<R, Law::heated>,
                Missed<R, Law, Law::rated>,
                ViscoplasticStrain<R, Law::rated && Law::damaged> {
  StateOf<R, Law> state;
  CapOf<R> cap;
  R dv;
  ShearIn<R, Law> de;
  R smallest;  ///< fraction below which a substep is taken as it is
  R done{}, fraction = R{} + 1.0;
  R elastic_work{}, plastic_work{}, modulus{};
  R substeps{};   ///< taken so far
  R crossings{};  ///< attempts at a substep that went beyond the moduli's jump
  R crossed_fraction{}, crossed_evp{};  ///< the last of them, and where it ended
  MaskOf<R> active;                     ///< still under way
  MaskOf<R> refused = none_of<R>();     ///< no substep is short enough
};

/// Adds what a substep that flows leaves of an elastic one, by its mean moduli; nothing where it is
/// elastic.
template <class R, class Law>
BARRENO_FUNCTION void add_missed(
    const Law& rock,
    const MaskOf<R>& takes,
    const R& fraction,
    const AttemptOf<R, Law>& a,
    StepOf<R, Law>& step
) {
  R strain = fraction * step.dv;
  if constexpr (has_poroplastic_fluid<Law>)
    strain = strain + (a.pores.pressure - step.pores.pressure) *
                          per_matrix_between(
                              rock.constituents,
                              R(a.pores.pressure + step.pores.pressure),
                              R(a.end.x + step.state.x)
                          );
  const R &bulk = a.used.bulk, &shear = a.used.shear;
  step.mean_moduli.bulk = step.mean_moduli.bulk + real::select(takes, fraction * bulk, 0.0);
  step.mean_moduli.shear = step.mean_moduli.shear + real::select(takes, fraction * shear, 0.0);
  const MaskOf<R> flows = takes & !a.elastic;
  R missed_x = 3.0 * bulk * strain - (a.end.x - step.state.x);
  if constexpr (Law::about_centre)
    missed_x = missed_x + 3.0 * (a.pores.pressure - step.pores.pressure);
  const ShearIn<R, Law> missed_s = R(2.0 * fraction * shear) * step.de - (a.end.s - step.state.s);
  step.missed_x = step.missed_x + real::select(flows, missed_x, 0.0);
  assign_where(flows, step.missed_s + missed_s, step.missed_s);
}

/// The substep of this fraction of the step.
template <class R, class Law>
BARRENO_FUNCTION SubstepOf<R, Law> substep_of(const StepOf<R, Law>& step, const R& fraction) {
  SubstepOf<R, Law> part;
  part.n = step.state;
  part.cap = step.cap;
  part.dv = fraction * step.dv;
  part.de = fraction * step.de;
  if constexpr (Law::wet) {
    part.pores = step.pores;
    part.pores.fluid = real::larger(R(step.pores.fluid + fraction * step.inflow), 0.0);
  }
  return part;
}

/// The state at the end of the substeps that were taken.
template <class R, class Law>
BARRENO_FUNCTION void take_substeps(
    const Law& rock,
    const MaskOf<R>& takes,
    const R& fraction,
    const AttemptOf<R, Law>& a,
    StepOf<R, Law>& step
) {
  if constexpr (Law::rated)
    if (rock.T1 != 0.0) add_missed(rock, takes, fraction, a, step);
  step.substeps = step.substeps + real::select(takes, 1.0, 0.0);
  assign_where(takes, a.end, step.state);
  step.elastic_work = step.elastic_work + real::select(takes, a.elastic_work, 0.0);
  step.plastic_work = step.plastic_work + real::select(takes, a.plastic_work, 0.0);
  if constexpr (Law::damaged)
    step.breaking_work = step.breaking_work + real::select(takes, a.breaking_work, 0.0);
  const R bulk = bulk_of<R>(rock, a, a.end.x, a.moduli.bulk);
  step.modulus = real::select(takes, bulk + (4.0 / 3.0) * a.moduli.shear, step.modulus);
  if constexpr (has_poroplastic_fluid<Law>) {
    if (real::any(step.inflow != 0.0)) {
      const R begin = step.pores.pressure, end = a.pores.pressure;
      // What comes later is compressed by then.
      const Constituents& c = rock.constituents;
      const R thinner = c.fluid_stiffening == 0.0 ? R(c.per_fluid * (begin - end))
                                                  : R(c.fluid_strain(begin) - c.fluid_strain(end));
      const R ratio = real::exp(thinner);
      const R volume = real::select(takes, fraction * step.inflow, 0.0);
      step.fluid_work = step.fluid_work + 0.5 * (begin + end * ratio) * volume;
      step.inflow = real::select(takes, step.inflow * ratio, step.inflow);
    }
  }
  assign_pores<Law>(takes, a, step);
}

/// The part of a substep that ends at the jump of the moduli. Flow in proportion to strain tells
/// it; where that has failed several times, since the flow has begun off the surface or in the
/// middle of the substep, the line through the ends of the last two attempts.
/// @param end  plastic volume strain, beyond the jump
template <class R, class Law>
BARRENO_FUNCTION R way_to_jump(const StepOf<R, Law>& step, const R& fraction, const R& end) {
  constexpr double several = 4.0;
  const R begin = step.state.evp;
  const R in_proportion = begin / real::select(begin != end, begin - end, 1.0);
  const MaskOf<R> known = (step.crossings >= several) & (step.crossed_fraction > fraction) &
                          (real::abs(step.crossed_evp) > real::abs(end));
  if (!real::any(known)) return in_proportion;
  const R longer = real::select(known, step.crossed_fraction / fraction - 1.0, 0.0);
  const R rise = real::select(known, step.crossed_evp - end, 1.0);
  const R secant = 1.0 - longer * end / rise;
  return real::select(known & (secant > 0.0), secant, in_proportion);
}

template <class R, class Law>
BARRENO_FUNCTION VerdictOf<R> verdict_on(
    const Law& rock, const StepOf<R, Law>& step, const R& fraction, const AttemptOf<R, Law>& a
) {
  constexpr double much_shorter = 0.125;
  const R begin = step.state.evp, end = a.end.evp;
  const MaskOf<R> divisible = fraction > step.smallest;
  const MaskOf<R> lost = a.refused | !real::is_finite(a.error);
  const MaskOf<R> crosses =
      divisible & (!lost) & (!is_at_jump(rock, begin)) & rock.elasticity.crosses_jump(begin, end);
  const MaskOf<R> fails = lost | ((a.error > a.allowed) & divisible);
  const R factor = real::select(lost, much_shorter, step_factor_of(a));
  return {
      MaskOf<R>(!(crosses | fails)),
      MaskOf<R>(lost & !divisible),
      crosses,
      real::any(crosses) ? R(real::select(crosses, way_to_jump(step, fraction, end), factor))
                         : factor};
}

/// What later attempts of the same substep are told.
template <class R, class Law>
BARRENO_FUNCTION void note_crossing(
    const MaskOf<R>& crosses, const R& fraction, const R& end, StepOf<R, Law>& step
) {
  step.crossings = real::select(crosses, step.crossings + 1.0, 0.0);
  step.crossed_fraction = real::select(crosses, fraction, step.crossed_fraction);
  step.crossed_evp = real::select(crosses, end, step.crossed_evp);
}

/// The strain of an attempt that damages rated rock: that which the dynamic stress leaves.
template <class R, class Law>
BARRENO_FUNCTION R viscoplastic_strain(
    const StepOf<R, Law>& step,
    const SubstepOf<R, Law>& part,
    const R& fraction,
    const AttemptOf<R, Law>& a
) {
  const ShearIn<R, Law> flow = part.de - R(0.5 / a.used.shear) * (a.end.s - part.n.s);
  const R squares =
      squared(step.taken * flow + fraction * step.released) + fraction * fraction * step.beside;
  return damaging_strain<R>(
      squares, step.taken * (a.end.evp - part.n.evp) + fraction * step.released_volume
  );
}

/// Damage at the end of attempts that began with that of the step.
template <class R, class Law>
BARRENO_FUNCTION R damage_after(
    const Law& law,
    const StepOf<R, Law>& step,
    const SubstepOf<R, Law>& part,
    const R& fraction,
    const AttemptOf<R, Law>& a
) {
  R strain{};
  if constexpr (Law::rated) {
    strain = viscoplastic_strain(step, part, fraction, a);
  } else {
    const R opened = real::larger(R(a.end.evp - part.n.evp), 0.0);
    const R sheared = a.end.shear_strain - part.n.shear_strain;
    strain = sheared + opened * (1.0 / 3.0);
  }
  const R share = law.damage.share(R(0.5 * (part.n.x + a.end.x)), part.cap);
  return real::smaller(R(step.damage + share * strain / step.fracture_strain), 1.0);
}

/// Points whose damage grows in an attempt. It is made once more with the strength at its end, but
/// where the loss is far below the allowed error. The difference of both counts as an error, and no
/// substep adds more than a tenth of all damage.
/// @param[in,out] a  replaced where it is made once more
/// @return damage at its end
template <class R, class Law, class Choice>
BARRENO_FUNCTION R damage_points(
    const Law& law,
    const StepOf<R, Law>& step,
    const SubstepOf<R, Law>& part,
    const R& fraction,
    const Choice& choose,
    AttemptOf<R, Law>& a
) {
  constexpr double largest_growth = 0.1, negligible = 0.02, per_shear = 1.4142135623730951;
  MaskOf<R> sound = step.active & !(a.elastic | a.refused) & real::is_finite(a.error);
  // Overstress makes plastic strain where the quasi-static answer is elastic too.
  if constexpr (Law::rated) sound = step.active & !a.refused & real::is_finite(a.error);
  const R guess = real::select(sound, damage_after(law, step, part, fraction, a), step.damage);
  const R lost = per_shear * law.damage.fall(a.end.x, step.coherence) * (guess - step.damage);
  const MaskOf<R> grows = sound & choose.alike(MaskOf<R>(lost > negligible * a.allowed));
  if (!real::any(grows)) return guess;
  const RockOf<R, Law> weaker = rock_with_damage<R>(law, step, guess);
  SubstepOf<R, Law> again = part;
  assign_where(grows, cap_of(weaker, part.n.evp), again.cap);
  AttemptOf<R, Law> b = attempt_points(weaker, grows, again, choose);
  const R damage = real::select(grows, damage_after(law, step, part, fraction, b), guess);
  const R missed =
      per_shear * law.damage.fall(b.end.x, step.coherence) * real::abs(R(damage - guess));
  const R growth = (damage - step.damage) * (1.0 / largest_growth);
  b.error = larger_of(R(b.error + missed), R(b.allowed * growth));
  select_attempt(grows, b, a);
  a.elastic = (a.elastic & !grows) | (b.elastic & grows);
  return damage;
}

/// One attempt of every active point, and what follows from it.
template <class R, class Law, class Choice = OwnSubsteps>
BARRENO_ONCE void advance_step(const Law& law, StepOf<R, Law>& step, Choice choose = {}) {
  const MaskOf<R> last = choose.alike(MaskOf<R>(step.done + step.fraction >= 1.0));
  const R fraction = real::select(last, 1.0 - step.done, step.fraction);
  const auto& rock = rock_of<R>(law, step);
  const SubstepOf<R, Law> part = substep_of(step, fraction);
  AttemptOf<R, Law> a = attempt_points(rock, step.active, part, choose);
  R damage{};
  if constexpr (Law::damaged) damage = damage_points(law, step, part, fraction, choose, a);
  VerdictOf<R> verdict = verdict_on(law, step, fraction, a);
  choose(verdict);
  step.refused = step.refused | (step.active & verdict.gives_up);
  step.active = step.active & !verdict.gives_up;
  const MaskOf<R> takes = step.active & verdict.takes;
  note_crossing(verdict.crosses, fraction, a.end.evp, step);
  take_substeps(law, takes, fraction, a, step);
  if constexpr (Law::damaged) step.damage = real::select(takes, damage, step.damage);
  step.active = step.active & !(takes & last);
  if (!real::any(step.active)) return;
  if (real::any(step.active & takes)) {
    if constexpr (Law::damaged)
      assign_where(takes, cap_of(rock_of<R>(law, step), step.state.evp), step.cap);
    else
      assign_where(takes, cap_of(rock, step.state.evp), step.cap);
  }
  step.done = step.done + real::select(takes, fraction, 0.0);
  step.fraction = fraction * verdict.factor;
}

}  // namespace barreno::arenisca
