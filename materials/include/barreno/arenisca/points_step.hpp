// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_flow.hpp"

namespace barreno::arenisca {

// A whole step of one or several points: substep.hpp in lanes, each point with its own substeps.

/// predict(), at the state's own plastic strain.
template <class R>
BARRENO_FUNCTION PredictionOf<R> predict_points(const Rock& rock, const SubstepOf<R>& step) {
  const StateOf<R>& n = step.n;
  const Elasticity& e = rock.elasticity;
  PredictionOf<R> p;
  p.term = pressure_term_of(e, n.x, n.evp);
  p.coupling = coupling_of(e, n.x, n.evp);
  p.start = moduli_of(e, p.term.value, p.coupling);
  predict_with(
      step, used_moduli(rock, n.x, R(3.0 * step.dv), step.cap, p.term, p.coupling, p.start), p
  );
  return p;
}

/// Moduli at the middle of a substep, I1 held within what the surface admits.
template <class R>
BARRENO_FUNCTION ModuliOf<R> used_moduli(
    const Rock& rock,
    const R& x_n,
    const R& triple_dv,
    const CapOf<R>& cap,
    const PressureTermOf<R>& term,
    const R& coupling,
    const ModuliOf<R>& start
) {
  R x = real::smaller(R(x_n + start.bulk * triple_dv), rock.surface.vertex);
  x = real::select(cap.present & (x < cap.X), cap.X, x);
  const R middle = term.value + 0.5 * term.slope * (x - x_n);
  return moduli_of(rock.elasticity, R(real::smaller(real::larger(middle, 0.0), 1.0)), coupling);
}

/// moduli_after(): at the end of elastic substeps.
/// @param asked where they are asked for
template <class R>
BARRENO_FUNCTION ModuliOf<R> moduli_after_points(
    const Rock& rock,
    const MaskOf<R>& asked,
    const R& x_n,
    const R& evp,
    const R& x_end,
    const PressureTermOf<R>& term,
    const R& coupling
) {
  constexpr double short_step = 0.01;
  const Elasticity& e = rock.elasticity;
  const R change = x_end - x_n;
  const MaskOf<R> is_short =
      (x_n < 0.0) & (evp <= Elasticity::at_jump) &
      (real::abs(change) * (real::abs(x_n) + e.B2) <= short_step * x_n * x_n);
  R value = term.value + change * (term.slope + 0.5 * change * term.curvature);
  R coupled = coupling;
  if (real::any(asked & !is_short)) {
    value = real::select(is_short, value, pressure_term_of(e, x_end, evp).value);
    coupled = real::select(is_short, coupled, coupling_of(e, x_end, evp));
  }
  return moduli_of(e, value, coupled);
}

/// attempt_substep().
/// @param asked where it is asked for
template <class R>
BARRENO_FUNCTION AttemptOf<R> attempt_points(
    const Rock& rock, const MaskOf<R>& asked, const SubstepOf<R>& step
) {
  const StateOf<R>& n = step.n;
  const PredictionOf<R> p = predict_points(rock, step);
  const MeridianOf<R> m = meridian_at(rock.surface, p.x, step.cap);
  const MaskOf<R> inside = contained(rock.surface, p.x, p.J2, step.cap, m);
  AttemptOf<R> a = flow_points(rock, MaskOf<R>(asked & !inside), step, p, m);
  // Flow that dilates from the jump of the moduli: begin_to_dilate().
  constexpr double at_jump = Elasticity::at_jump;
  a.refused = a.refused | ((!inside) & (real::abs(n.evp) <= at_jump) & (a.end.evp > at_jump));
  a.elastic = inside;
  if (!real::any(asked & inside)) return a;
  const ModuliOf<R> moduli =
      moduli_after_points(rock, MaskOf<R>(asked & inside), n.x, n.evp, p.x, p.term, p.coupling);
  a.end = {
      real::select(inside, p.x, a.end.x),
      select_points<R>(inside, p.s, a.end.s),
      real::select(inside, n.evp, a.end.evp),
      real::select(inside, n.shear_strain, a.end.shear_strain)};
  a.moduli = {
      real::select(inside, moduli.bulk, a.moduli.bulk),
      real::select(inside, moduli.shear, a.moduli.shear)};
  const R change = size_of_stress(R(p.x - n.x), squared(p.s - n.s));
  a.error = real::select(inside, mismatch_of(p.start, p.used, moduli) * change, a.error);
  a.allowed = real::select(inside, allowed_error_of(rock, n, p.x, p.J2), a.allowed);
  a.elastic_work = real::select(
      inside, 0.5 * (n.x + p.x) * (step.dv * (1.0 / 3.0)) + dot(n.s + p.s, step.de), a.elastic_work
  );
  a.plastic_work = real::select(inside, 0.0, a.plastic_work);
  return a;
}

/// Largest integer not above x, for 0 <= x < 2^52.
inline Lanes whole_part(const Lanes& x) {
  return __builtin_convertvector(__builtin_convertvector(x, LaneMask), Lanes);
}

/// step_factor().
template <class R>
BARRENO_FUNCTION R step_factor_of(const AttemptOf<R>& a) {
  constexpr double safety = 0.9, smallest = 0.125, largest = 4.0, grain = 16.0;
  constexpr double most = 1e6;  // beyond any bound below
  const MaskOf<R> exact = !(a.error > 0.0);
  const R ratio = real::smaller(R(a.allowed / real::select(exact, 1.0, a.error)), most);
  R root = real::sqrt(ratio);
  if (real::any(a.elastic)) root = real::select(a.elastic, real::pow(ratio, 1.0 / 3.0), root);
  const R factor = whole_part(R(grain * safety * root)) * (1.0 / grain);
  return real::select(exact, largest, real::smaller(real::larger(factor, smallest), largest));
}

/// A step of points in progress.
template <class R>
struct StepOf {
  StateOf<R> state;
  CapOf<R> cap;
  R dv;
  ShearOf<R> de;
  R smallest;  ///< fraction below which a substep is taken as it is
  R done{}, fraction = R{} + 1.0;
  R elastic_work{}, plastic_work{}, modulus{};
  MaskOf<R> active;                  ///< still under way
  MaskOf<R> refused = none_of<R>();  ///< left to the update of single points
};

/// One attempt of every active point, and what follows from it; as in integrate().
template <class R>
BARRENO_FUNCTION void advance_step(const Rock& rock, StepOf<R>& step) {
  const MaskOf<R> last = step.done + step.fraction >= 1.0;
  const R fraction = real::select(last, 1.0 - step.done, step.fraction);
  const AttemptOf<R> a = attempt_points(
      rock, step.active, SubstepOf<R>{step.state, step.cap, fraction * step.dv, fraction * step.de}
  );
  const MaskOf<R> refused = step.active & (a.refused | !real::is_finite(a.error));
  step.refused = step.refused | refused;
  step.active = step.active & !refused;

  constexpr double at_jump = Elasticity::at_jump;
  const Elasticity& e = rock.elasticity;
  const R begin = step.state.evp, end = a.end.evp;
  const MaskOf<R> divisible = fraction > step.smallest;
  MaskOf<R> crosses =
      ((begin < -at_jump) & (end > at_jump)) | ((begin > at_jump) & (end < -at_jump));
  crosses = crosses & divisible;
  if (e.B1 == 0.0 && e.B3 == 0.0 && !e.variable_ratio()) crosses = none_of<R>();
  const MaskOf<R> fails = (a.error > a.allowed) & divisible;
  const MaskOf<R> takes = step.active & (!crosses) & !fails;
  step.state.x = real::select(takes, a.end.x, step.state.x);
  step.state.s = select_points<R>(takes, a.end.s, step.state.s);
  step.state.evp = real::select(takes, end, begin);
  step.state.shear_strain = real::select(takes, a.end.shear_strain, step.state.shear_strain);
  step.elastic_work = step.elastic_work + real::select(takes, a.elastic_work, 0.0);
  step.plastic_work = step.plastic_work + real::select(takes, a.plastic_work, 0.0);
  step.modulus = real::select(takes, a.moduli.bulk + (4.0 / 3.0) * a.moduli.shear, step.modulus);
  step.active = step.active & !(takes & last);
  if (!real::any(step.active)) return;
  if (real::any(step.active & takes))
    step.cap = select_points<R>(takes, cap_of(rock, step.state.evp), step.cap);
  step.done = step.done + real::select(takes, fraction, 0.0);
  const R to_jump = begin / real::select(crosses, begin - end, 1.0);
  step.fraction = fraction * real::select(crosses, to_jump, step_factor_of(a));
}

}  // namespace barreno::arenisca
