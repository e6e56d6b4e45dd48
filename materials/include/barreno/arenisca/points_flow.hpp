// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_return.hpp"
#include "barreno/arenisca/points_state.hpp"

namespace barreno::arenisca {

// One plastic substep of one or several points: plastic_flow.hpp step by step, in the plane of
// stress and strain increment.

/// FlowStart.
template <class R>
struct FlowStartOf {
  R x;
  ShearOf<R> s;
  R q{}, scale{}, normal_x{}, normal_q{};
};

/// Where elastic paths from inside leave the surface, see crossing().
template <class R, class Law>
BARRENO_FUNCTION R crossing_of(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& asked,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    int halvings
) {
  const R dx = p.x - step.n.x;
  const ShearOf<R> ds = p.s - step.n.s;
  R inside{};
  double part = 0.5;
  for (int i = 0; i < halvings; ++i, part *= 0.5) {
    const R t = inside + part;
    const R J2 = squared(step.n.s + t * ds);
    const MaskOf<R> in = contains(rock.surface, asked, R(step.n.x + t * dx), J2, step.cap);
    inside = real::select(in, t, inside);
  }
  return inside;
}

/// find_flow_start().
template <class R, class Law>
BARRENO_FUNCTION FlowStartOf<R> flow_start_of(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& flows,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const R& metric
) {
  constexpr double shrink = 1.0 - 1e-6, near_vertex = 1e-6;
  const StateOf<R>& n = step.n;
  const auto& surface = rock.surface;
  FlowStartOf<R> f{n.x, n.s};
  R q_squared = squared(n.s);
  MeridianOf<R> m = meridian_at(surface, n.x, step.cap);
  const R limit = shrink * real::larger(m.limit, 0.0);
  const MaskOf<R> inside =
      flows & (n.x < surface.vertex) & (q_squared < limit * limit * m.cap_squared);
  if (real::any(inside)) {
    constexpr int halvings = 6;
    const R t = crossing_of(rock, inside, step, p, halvings);
    f.x = real::select(inside, n.x + t * (p.x - n.x), n.x);
    f.s = select_points<R>(inside, n.s + t * (p.s - n.s), n.s);
    q_squared = real::select(inside, squared(f.s), q_squared);
    const MeridianOf<R> there = meridian_at(surface, f.x, step.cap);
    m.limit = real::select(inside, there.limit, m.limit);
    m.slope = real::select(inside, there.slope, m.slope);
  }
  f.q = real::sqrt(q_squared);
  const R root_metric = real::sqrt(metric);
  const R along = -root_metric * m.limit * m.slope;
  const R length = real::sqrt(R(along * along + q_squared));
  const R reach = larger_of(f.q, R(surface.steepest * (surface.vertex - f.x)));
  const MaskOf<R> at_vertex = (reach <= near_vertex * p.q) | (length == 0.0);
  const R inverse = 1.0 / real::select(at_vertex, 1.0, length);
  f.scale = real::select(at_vertex, 0.0, 1.0);
  f.normal_x = along * inverse;
  f.normal_q = f.q * inverse;
  if (!real::any(at_vertex)) return f;
  const R side = root_metric * surface.steepest;
  const R hypotenuse = real::sqrt(R(side * side + 1.0));
  f.normal_x = real::select(at_vertex, side / hypotenuse, f.normal_x);
  f.normal_q = real::select(at_vertex, 1.0 / hypotenuse, f.normal_q);
  f.s = select_points<R>(at_vertex, p.s, f.s);
  f.q = real::select(at_vertex, p.q, f.q);
  return f;
}

/// Correction and what direction_error() makes of it.
template <class R>
struct TurnOf {
  R distance, normal_x, normal_q;
  R error{};
};
template <class R, class Law>
BARRENO_FUNCTION TurnOf<R> turn_of(
    const PredictionOf<R, Law>& p, const ReturnedOf<R>& r, const FlowStartOf<R>& f, const R& metric
) {
  const R back_x = p.x - r.x, q_apart = p.q - r.q;
  const R distance = real::sqrt(R(back_x * back_x + metric * q_apart * q_apart));
  const R inverse = real::select(distance > 0.0, 1.0 / distance, 0.0);
  TurnOf<R> c{distance, back_x * inverse, real::sqrt(metric) * q_apart * inverse};
  const R product = f.q * p.q;
  const MaskOf<R> sheared = product > 0.0;
  const R cosine = real::select(sheared, dot(f.s, p.s) / real::select(sheared, product, 1.0), 1.0);
  const R turn_x = c.normal_x - f.normal_x;
  const R turn = turn_x * turn_x + c.normal_q * c.normal_q + f.normal_q * f.normal_q -
                 2.0 * c.normal_q * f.normal_q * cosine;
  c.error = 0.5 * c.distance * real::sqrt(R(real::larger(turn, 0.0) * (1.0 / 3.0)));
  return c;
}

/// A shear stress of the given size made as long as `wanted`.
template <class R>
BARRENO_FUNCTION ShearOf<R> lengthened(const ShearOf<R>& s, const R& size, const R& wanted) {
  const MaskOf<R> sheared = size > 0.0;
  return R(real::select(sheared, wanted / real::select(sheared, size, 1.0), 0.0)) * s;
}

/// End of a substep from its return: state, moduli, work.
/// @param end shear stress that the return leaves
template <class R, class Law>
BARRENO_FUNCTION void finish_flow(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const ShearOf<R>& end,
    const ReturnedOf<R>& r,
    const FlowStartOf<R>& f,
    AttemptOf<R, Law>& a
) {
  const StateOf<R>& n = step.n;
  a.end = {r.x, end, r.evp, n.shear_strain};
  const R devp = r.evp - n.evp;
  const ShearOf<R> dep = R(0.5 / p.used.shear) * (p.s - a.end.s);
  a.end.shear_strain = n.shear_strain + real::sqrt(R((4.0 / 3.0) * squared(dep)));
  const R third = devp * (1.0 / 3.0);
  const R end_work = r.x * third + 2.0 * dot(a.end.s, dep);
  const R start_work = f.x * third + 2.0 * f.scale * dot(f.s, dep);
  const R mean_work = 0.5 * (start_work + end_work);
  a.plastic_work = real::select(mean_work >= 0.0, mean_work, end_work);
  if constexpr (!Law::wet) {
    a.elastic_work =
        0.5 * (n.x + r.x) * ((step.dv - devp) * (1.0 / 3.0)) + dot(n.s + a.end.s, step.de - dep);
  }
  // At the jump of the moduli itself those of the side it came from, see Elasticity::seen_from().
  constexpr double at_jump = Elasticity::at_jump;
  const MaskOf<R> from_dilated = (p.evp > at_jump) & (real::abs(r.evp) <= at_jump);
  a.moduli =
      moduli_of_state(rock.elasticity, r.x, R(real::select(from_dilated, 2.0 * at_jump, r.evp)));
  if constexpr (Law::wet) {
    const R rise = p.rise - p.fall * devp;
    const FilledOf<R> filled = fill_pores(
        rock.constituents,
        step.pores,
        loaded_grains(rock.constituents, step.pores, R(r.x - n.x)),
        step.dv,
        rise
    );
    a.pores = filled.end;
    a.elastic_work = work_of_stress(step, a) - a.plastic_work;
  }
}

/// Second pass of a substep: mean moduli of both ends, and the trial point moved by half the turn
/// of the flow direction, so that the closest-point return corrects along the mean direction.
/// Second-order accurate, and still on the hardened surface: evp starts where the moved trial point
/// keeps x = x_tr - 3K (evp - evp_n).
/// @param asked where the second pass is worth it
template <class R, class Law>
BARRENO_FUNCTION void refine_points(
    const RockOf<R, Law>& rock,
    MaskOf<R> asked,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& first,
    const TurnOf<R>& c,
    const FlowStartOf<R>& f,
    AttemptOf<R, Law>& a
) {
  const StateOf<R>& n = step.n;
  PredictionOf<R, Law> p = first;
  const ModuliOf<R> mean = {
      0.5 * (first.start.bulk + a.moduli.bulk), 0.5 * (first.start.shear + a.moduli.shear)};
  follow_pressure(rock, step, mean.bulk, a, p);
  predict_with(rock, step, mean, p);
  const R triple_bulk = stiffness_of_return(rock, p);
  const R metric = metric_of(rock, p);
  const R moved_x = p.x + 0.5 * c.distance * (c.normal_x - f.normal_x);
  const R half = 0.5 * c.distance / real::sqrt(metric);
  const R ahead = real::select(p.q > 0.0, half * c.normal_q / p.q, 0.0);
  const R behind = real::select(f.q > 0.0, half * f.normal_q / f.q, 0.0);
  const ShearOf<R> moved = p.s + ahead * p.s - behind * f.s;
  const R J2 = squared(moved), q = real::sqrt(J2);
  const R evp = n.evp + (p.x - moved_x) / triple_bulk;
  if (rock.crush.p3 > 0.0) {
    const MaskOf<R> stays_closed = (!step.cap.present) & (a.end.evp == n.evp) & (evp == n.evp);
    asked = asked & ((evp > rock.crush.last_open()) | stays_closed);
  }
  const CapOf<R> cap = cap_of(rock, evp);
  const MeridianOf<R> m = meridian_at(rock.surface, moved_x, cap);
  const MaskOf<R> outside = asked & !contained(rock.surface, moved_x, J2, cap, m);
  ReturnedOf<R> r = return_points(
      rock, TrialOf<R>{moved_x, q, metric, triple_bulk, evp, cap}, outside, m, R(a.end.evp - evp)
  );
  r.x = real::select(outside, r.x, moved_x);
  r.q = real::select(outside, r.q, q);
  r.evp = real::select(outside, r.evp, evp);
  AttemptOf<R, Law> b = a;
  finish_flow(rock, step, p, lengthened(moved, q, r.q), r, f, b);
  constexpr double round_off = 1e-9;
  const R flow = b.end.shear_strain - n.shear_strain;
  const MaskOf<R> better =
      asked & (b.plastic_work >= -round_off * flow * size_of_stress(b.end.x, J2));
  a.refused = a.refused | (outside & r.refused);
  a.end.x = real::select(better, b.end.x, a.end.x);
  a.end.s = select_points<R>(better, b.end.s, a.end.s);
  a.end.evp = real::select(better, b.end.evp, a.end.evp);
  a.end.shear_strain = real::select(better, b.end.shear_strain, a.end.shear_strain);
  a.elastic_work = real::select(better, b.elastic_work, a.elastic_work);
  a.plastic_work = real::select(better, b.plastic_work, a.plastic_work);
  a.moduli.bulk = real::select(better, b.moduli.bulk, a.moduli.bulk);
  a.moduli.shear = real::select(better, b.moduli.shear, a.moduli.shear);
  if constexpr (Law::wet) a.pores = select_points<R>(better, b.pores, a.pores);
}

/// Plastic substep: closest-point return, its error, and the second pass where that is worth it.
/// @param flows    where the trial state is outside
/// @param at_trial the meridian at the trial state
template <class R, class Law>
BARRENO_FUNCTION AttemptOf<R, Law> flow_points(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& flows,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const MeridianOf<R>& at_trial
) {
  const StateOf<R>& n = step.n;
  const R metric = metric_of(rock, p);
  const R no_guess = R{} + HUGE_VAL;
  const ReturnedOf<R> r = return_points(
      rock,
      TrialOf<R>{p.x, p.q, metric, stiffness_of_return(rock, p), n.evp, step.cap},
      flows,
      at_trial,
      no_guess
  );
  FlowStartOf<R> f = flow_start_of(rock, flows, step, p, metric);
  if (rock.crush.p3 > 0.0) {
    // flows_isochorically()
    const MaskOf<R> isochoric = (!step.cap.present) & (r.evp == n.evp) & (f.q > 0.0);
    f.normal_x = real::select(isochoric, 0.0, f.normal_x);
    f.normal_q = real::select(isochoric, 1.0, f.normal_q);
  }
  AttemptOf<R, Law> a;
  finish_flow(rock, step, p, lengthened(p.s, p.q, r.q), r, f, a);
  a.elastic = none_of<R>();
  a.refused = flows & r.refused;
  a.allowed = allowed_error_of(rock, n, r.x, R(r.q * r.q));
  const TurnOf<R> turn = turn_of(p, r, f, metric);
  const R of_moduli =
      mismatch_of(p.start, p.used, a.moduli) * size_of_stress(R(r.x - n.x), squared(a.end.s - n.s));
  const MaskOf<R> at_vertex = r.x >= rock.surface.vertex;
  const R way = f.scale * size_of_stress(R(f.x - r.x), R(f.q * f.q));
  a.error = of_moduli + real::select(at_vertex & (way < turn.error), way, turn.error);
  if constexpr (Law::wet) a.error = a.error + pressure_error(rock, step, p, a);
  constexpr double largest_retraction = 0.1, negligible = 0.01;
  const MaskOf<R> retracts =
      (!at_vertex) & (r.evp > n.evp) & step.cap.present & r.cap.present & (r.x < r.cap.kappa);
  const R length = real::select(retracts, step.cap.kappa - step.cap.X, 1.0);
  const R retraction = real::select(
      retracts, a.allowed * (r.cap.X - step.cap.X) / (largest_retraction * length), 0.0
  );
  a.error = larger_of(a.error, retraction);
  const MaskOf<R> worth =
      flows & (!at_vertex) & (a.error > negligible * a.allowed) & (a.error <= a.allowed);
  if (real::any(worth)) refine_points(rock, worth, step, p, turn, f, a);
  return a;
}

}  // namespace barreno::arenisca
