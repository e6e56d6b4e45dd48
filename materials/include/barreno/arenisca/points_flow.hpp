// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_over_angles.hpp"
#include "barreno/arenisca/points_state.hpp"

namespace barreno::arenisca {

// One plastic substep of one or several points: closest-point return, the error of its direction,
// and a second pass along the mean direction.

/// Direction of flow of points whose strength depends on the angle: its part in shear, which does
/// not point along the stress.
template <class R, bool angled>
struct WithNormal {};
template <class R>
struct WithNormal<R, true> {
  DeviatorOf<R> normal_s;
  R edge{};  ///< |Gamma'|/Gamma where the stress is on an edge of the surface
};

/// Where a substep begins to flow and in which direction, over the metric of the return.
template <class R, class Law>
struct FlowStartOf : WithNormal<R, Law::angled> {
  R x;
  ShearIn<R, Law> s;
  R q{}, scale{}, normal_x{}, normal_q{};
};

/// The same where the strength depends on the angle, which makes an evaluation dear: by the
/// Illinois form of the false position.
/// @param asked where the path begins inside and ends outside
template <class R, class Law>
BARRENO_FUNCTION R crossing_over_angles(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& asked,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    int iterations
) {
  const R dx = p.x - step.n.x;
  const ShearIn<R, Law> ds = p.s - step.n.s;
  // Negative inside, also beyond vertex and tip of a regular sign.
  const auto excess = [&](const R& t) {
    const MeridianOf<R> m = meridian_at(rock.surface, R(step.n.x + t * dx), step.cap);
    const R J2 = scaled_J2<R>(rock, ShearIn<R, Law>(step.n.s + t * ds));
    return R(J2 - m.limit * real::abs(m.limit) * m.cap_squared);
  };
  R inside{}, outside = R{} + 1.0;
  R f_inside = excess(inside), f_outside = excess(outside);
  // The nearest place so far, on either side: which of two it is round-off decides.
  R nearest = inside, least = real::abs(f_inside);
  MaskOf<R> last_inside = none_of<R>(), last_outside = none_of<R>();
  for (int i = 0; i < iterations; ++i) {
    const MaskOf<R> regular = asked & (f_inside < 0.0) & (f_outside > 0.0);
    const R part = f_inside / real::select(regular, f_inside - f_outside, 1.0);
    const R t = inside + real::select(regular, part, 0.0) * (outside - inside);
    const R f = excess(t);
    const MaskOf<R> in = regular & (f < 0.0), out = regular & !in;
    f_outside = real::select(in & last_inside, 0.5 * f_outside, real::select(out, f, f_outside));
    f_inside = real::select(out & last_outside, 0.5 * f_inside, real::select(in, f, f_inside));
    const MaskOf<R> nearer = regular & (real::abs(f) < least);
    nearest = real::select(nearer, t, nearest);
    least = real::select(nearer, real::abs(f), least);
    inside = real::select(in, t, inside);
    outside = real::select(out, t, outside);
    last_inside = in;
    last_outside = out;
  }
  return nearest;
}

/// Fraction of elastic paths from inside at which they leave the surface; roughly, since it only
/// weighs work and the flow direction.
template <class R, class Law>
BARRENO_FUNCTION R crossing_of(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& asked,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    int halvings
) {
  if constexpr (Law::angled)
    return crossing_over_angles<R, Law>(rock, asked, step, p, 3 + halvings / 4);
  const R dx = p.x - step.n.x;
  const ShearIn<R, Law> ds = p.s - step.n.s;
  R inside{};
  double part = 0.5;
  for (int i = 0; i < halvings; ++i, part *= 0.5) {
    const R t = inside + part;
    const R J2 = scaled_J2<R>(rock, ShearIn<R, Law>(step.n.s + t * ds));
    const MaskOf<R> in = contains(rock.surface, asked, R(step.n.x + t * dx), J2, step.cap);
    inside = real::select(in, t, inside);
  }
  return inside;
}

/// Where points begin to flow, and the normal of the surface there. Slightly inside counts as on
/// the surface: the last step left the point there. As near the vertex as `near_vertex`, in terms
/// of the trial shear, the shear direction is noise: flow leaves the vertex along the steepest
/// generator of the cone, in its own direction.
template <class R, class Law>
BARRENO_FUNCTION FlowStartOf<R, Law> flow_start_of(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& flows,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const R& metric
) {
  constexpr double shrink = 1.0 - 1e-6, near_vertex = 1e-6;
  const StateOf<R, Law>& n = step.n;
  const auto& surface = rock.surface;
  FlowStartOf<R, Law> f;
  f.x = n.x;
  f.s = n.s;
  R q_squared = squared(n.s);
  MeridianOf<R> m = meridian_at(surface, n.x, step.cap);
  AngleOf<R> angle;
  if constexpr (Law::angled) {
    angle = angle_of(rock.lode, f.s);
    m = scaled_meridian(m, angle.gamma);
  }
  const R limit = shrink * real::larger(m.limit, 0.0);
  const MaskOf<R> inside =
      flows & (n.x < surface.vertex) & (q_squared < limit * limit * m.cap_squared);
  if (real::any(inside)) {
    constexpr int halvings = 6;
    const R t = crossing_of(rock, inside, step, p, halvings);
    f.x = real::select(inside, n.x + t * (p.x - n.x), n.x);
    f.s = select_points(inside, n.s + t * (p.s - n.s), n.s);
    q_squared = real::select(inside, squared(f.s), q_squared);
    MeridianOf<R> there = meridian_at(surface, f.x, step.cap);
    if constexpr (Law::angled) {
      angle = angle_of(rock.lode, f.s);
      there = scaled_meridian(there, angle.gamma);
    }
    m.limit = real::select(inside, there.limit, m.limit);
    m.slope = real::select(inside, there.slope, m.slope);
  }
  f.q = real::sqrt(q_squared);
  const R root_metric = real::sqrt(metric);
  const R along = -root_metric * m.limit * m.slope;
  R length_squared = along * along + q_squared;
  if constexpr (Law::angled) {
    const R bend = real::select(angle.turnable, angle.bend, 0.0);
    length_squared = length_squared + q_squared * bend * bend;
  }
  const R length = real::sqrt(length_squared);
  const R reach = larger_of(f.q, R(surface.steepest * (surface.vertex - f.x)));
  MaskOf<R> at_vertex = (reach <= near_vertex * p.q) | (length == 0.0);
  if constexpr (Law::damaged) at_vertex = at_vertex | (f.x >= surface.vertex);  // it has come down
  const R inverse = 1.0 / real::select(at_vertex, 1.0, length);
  f.scale = real::select(at_vertex, 0.0, 1.0);
  f.normal_x = along * inverse;
  f.normal_q = f.q * inverse;
  if constexpr (Law::angled) {
    f.normal_s = f.normal_q * (angle.along - angle.bend * angle.across);
    f.edge = real::select(angle.turnable, 0.0, real::abs(angle.bend));
  }
  if (!real::any(at_vertex)) return f;
  const R side = root_metric * surface.steepest;
  const R hypotenuse = real::sqrt(R(side * side + 1.0));
  f.normal_x = real::select(at_vertex, side / hypotenuse, f.normal_x);
  f.normal_q = real::select(at_vertex, 1.0 / hypotenuse, f.normal_q);
  assign_where(at_vertex, p.s, f.s);
  f.q = real::select(at_vertex, p.q, f.q);
  if constexpr (Law::angled) assign_where(at_vertex, f.normal_q * p.angle.along, f.normal_s);
  return f;
}

/// The correction of a return, and the error from the turn of the flow's direction on the way.
template <class R, class Law>
struct DirectionChangeOf : WithNormal<R, Law::angled> {
  R distance, normal_x, normal_q;
  R error{};
};
/// On an edge of the surface the flow can take any direction of a cone: the one nearest to that of
/// the correction.
template <class R, class Law>
BARRENO_FUNCTION void lean_into_edge(
    const PredictionOf<R, Law>& p, const ShearIn<R, Law>& end, FlowStartOf<R, Law>& f
) {
  const DeviatorOf<R> apart = p.s - end;
  const DeviatorOf<R> along = lengthened(f.s, f.q, R(R{} + 1.0));
  const R straight = dot(apart, along);
  const MaskOf<R> leans = (f.edge > 0.0) & (straight > 0.0);
  if (!real::any(leans)) return;
  const DeviatorOf<R> aside =
      R(1.0 / real::select(leans, straight, 1.0)) * (apart - straight * along);
  const R slope = real::sqrt(squared(aside));
  const R part = real::select(slope > f.edge, f.edge / real::select(leans, slope, 1.0), 1.0);
  const R lean = smaller_of(slope, f.edge);
  const R length = real::sqrt(R(1.0 + f.normal_q * f.normal_q * lean * lean));
  const R shorter = real::select(leans, 1.0 / length, 1.0);
  f.normal_x = shorter * f.normal_x;
  f.normal_s = shorter * (f.normal_s + R(real::select(leans, f.normal_q * part, 0.0)) * aside);
}

/// The change of direction where the shear stress turns too.
template <class R, class Law>
BARRENO_FUNCTION DirectionChangeOf<R, Law> direction_change_in_full(
    const PredictionOf<R, Law>& p,
    const ReturnedOf<R>& r,
    const ShearIn<R, Law>& end,
    const FlowStartOf<R, Law>& f,
    const R& metric
) {
  R back_x = p.x - r.x;
  // A published backstress moves the surface besides, which is no flow.
  if constexpr (Law::about_centre) back_x = 3.0 * p.used.bulk * (r.evp - p.begin.evp);
  const ShearIn<R, Law> apart = p.s - end;
  DirectionChangeOf<R, Law> c;
  c.distance = real::sqrt(R(back_x * back_x + metric * squared(apart)));
  const R inverse = real::select(c.distance > 0.0, 1.0 / c.distance, 0.0);
  c.normal_x = back_x * inverse;
  c.normal_s = R(real::sqrt(metric) * inverse) * apart;
  c.normal_q = real::sqrt(squared(c.normal_s));
  const R change_x = c.normal_x - f.normal_x;
  const R change = change_x * change_x + squared(c.normal_s - f.normal_s);
  c.error = 0.5 * c.distance * real::sqrt(R(change * (1.0 / 3.0)));
  return c;
}

/// @param end shear stress that the return leaves
template <class R, class Law>
BARRENO_FUNCTION DirectionChangeOf<R, Law> direction_change_of(
    const PredictionOf<R, Law>& p,
    const ReturnedOf<R>& r,
    const ShearIn<R, Law>& end,
    const FlowStartOf<R, Law>& f,
    const R& metric
) {
  if constexpr (Law::angled) return direction_change_in_full<R, Law>(p, r, end, f, metric);
  const R back_x = p.x - r.x, q_apart = p.q - r.q;
  const R distance = real::sqrt(R(back_x * back_x + metric * q_apart * q_apart));
  const R inverse = real::select(distance > 0.0, 1.0 / distance, 0.0);
  DirectionChangeOf<R, Law> c;
  c.distance = distance;
  c.normal_x = back_x * inverse;
  c.normal_q = real::sqrt(metric) * q_apart * inverse;
  const R product = f.q * p.q;
  const MaskOf<R> sheared = product > 0.0;
  const R cosine = real::select(sheared, dot(f.s, p.s) / real::select(sheared, product, 1.0), 1.0);
  const R change_x = c.normal_x - f.normal_x;
  const R change = change_x * change_x + c.normal_q * c.normal_q + f.normal_q * f.normal_q -
                   2.0 * c.normal_q * f.normal_q * cosine;
  c.error = 0.5 * c.distance * real::sqrt(R(real::larger(change, 0.0) * (1.0 / 3.0)));
  return c;
}

/// The pores at the end of a substep that flows.
template <class R, class Law>
BARRENO_FUNCTION PoresOf<R> pores_after(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const ReturnedOf<R>& r
) {
  if constexpr (Law::about_centre) {
    return {rock.zeta(r.evp) / -3.0};
  } else {
    const Constituents& c = rock.constituents;
    const R rise = p.rise - p.fall * (r.evp - step.n.evp);
    return fill_loaded_pores(c, step.pores, step.n.x, r.x, step.dv, rise).end;
  }
}

/// End of a substep from its return: state, moduli, work.
/// @param end shear stress that the return leaves
template <class R, class Law>
BARRENO_FUNCTION void finish_flow(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const ShearIn<R, Law>& end,
    const ReturnedOf<R>& r,
    const FlowStartOf<R, Law>& f,
    AttemptOf<R, Law>& a
) {
  const StateOf<R, Law>& n = step.n;
  if constexpr (Law::rated) a.used = p.used;
  a.end = {r.x, end, r.evp, n.shear_strain};
  const R devp = r.evp - n.evp;
  const ShearIn<R, Law> dep = R(0.5 / p.used.shear) * (p.s - a.end.s);
  a.end.shear_strain = n.shear_strain + real::sqrt(R((4.0 / 3.0) * squared(dep)));
  const R third = devp * (1.0 / 3.0);
  const R end_work = r.x * third + 2.0 * dot(a.end.s, dep);
  const R start_work = f.x * third + 2.0 * f.scale * dot(f.s, dep);
  const R mean_work = 0.5 * (start_work + end_work);
  a.plastic_work = real::select(mean_work >= 0.0, mean_work, end_work);
  if constexpr (Law::damaged) {
    const R mean_x = 0.5 * (f.x + r.x);
    a.breaking_work = rock.breakage.work(mean_x, devp, R(a.plastic_work - mean_x * third));
  }
  a.moduli = rock.elasticity.moduli_at(r.x, rock.elasticity.seen_from(p.evp, r.evp));
  if constexpr (Law::wet) {
    a.pores = pores_after(rock, step, p, r);
    press_moduli(rock, a, r.x, a.moduli);
    a.elastic_work = work_of_stress(step, a) - a.plastic_work;
  } else {
    a.elastic_work =
        0.5 * (n.x + r.x) * ((step.dv - devp) * (1.0 / 3.0)) + dot(n.s + a.end.s, step.de - dep);
  }
}

/// The trial shear moved by half the change of the flow direction.
/// @param half of the correction's distance, in units of shear stress
template <class R, class Law>
BARRENO_FUNCTION ShearIn<R, Law> moved_shear(
    const PredictionOf<R, Law>& p,
    const DirectionChangeOf<R, Law>& c,
    const FlowStartOf<R, Law>& f,
    const R& half
) {
  if constexpr (Law::angled) {
    return p.s + half * (c.normal_s - f.normal_s);
  } else {
    const R ahead = real::select(p.q > 0.0, half * c.normal_q / p.q, 0.0);
    const R behind = real::select(f.q > 0.0, half * f.normal_q / f.q, 0.0);
    return p.s + ahead * p.s - behind * f.s;
  }
}

/// Second pass of a substep: mean moduli of both ends, and the trial point moved by half the change
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
    const DirectionChangeOf<R, Law>& c,
    const FlowStartOf<R, Law>& f,
    AttemptOf<R, Law>& a
) {
  const StateOf<R, Law>& n = step.n;
  PredictionOf<R, Law> p = first;
  const ModuliOf<R> mean = {
      0.5 * (first.start.bulk + a.moduli.bulk), 0.5 * (first.start.shear + a.moduli.shear)};
  follow_pressure(rock, step, mean.bulk, a, p);
  predict_with(step, mean, p);
  const R triple_bulk = stiffness_of_return(p);
  const R metric = metric_of(rock, step, p);
  const R moved_x = p.x + 0.5 * c.distance * (c.normal_x - f.normal_x);
  const R half = 0.5 * c.distance / real::sqrt(metric);
  const ShearIn<R, Law> moved = moved_shear<R, Law>(p, c, f, half);
  const R J2 = squared(moved), q = real::sqrt(J2);
  R evp{};
  if constexpr (Law::about_centre)
    evp = rock.strain_for(n.evp, R(p.x - moved_x), triple_bulk);
  else
    evp = n.evp + (p.x - moved_x) / triple_bulk;
  if (rock.crush.porous()) {
    const MaskOf<R> stays_closed = (!step.cap.present) & (a.end.evp == n.evp) & (evp == n.evp);
    asked = asked & ((evp > rock.crush.last_open()) | stays_closed);
  }
  const CapOf<R> cap = cap_of(rock, evp);
  const MeridianOf<R> m = meridian_at(rock.surface, moved_x, cap);
  const TrialOf<R> trial{moved_x, q, metric, triple_bulk, evp, cap};
  find_angle(rock, moved, p);
  R seen = J2;
  if constexpr (Law::angled) seen = J2 / (p.angle.gamma * p.angle.gamma);
  const MaskOf<R> outside = asked & !contained(rock.surface, moved_x, seen, cap, m);
  auto [r, end] = return_shear(
      rock, p, moved, trial, outside, m, guess_from<R, Law>(p, a.end.s, R(a.end.evp - evp))
  );
  r.x = real::select(outside, r.x, moved_x);
  r.q = real::select(outside, r.q, q);
  r.evp = real::select(outside, r.evp, evp);
  AttemptOf<R, Law> b = a;
  end = select_points(outside, end, moved);
  finish_flow(rock, step, p, end, r, f, b);
  constexpr double round_off = 1e-9;
  const R flow = b.end.shear_strain - n.shear_strain;
  const MaskOf<R> better =
      asked & (b.plastic_work >= -round_off * flow * size_of_stress(b.end.x, J2));
  a.refused = a.refused | (outside & r.refused);
  b.refused = a.refused;
  select_attempt(better, b, a);
}

/// Plastic substep: closest-point return, its error, and the second pass where that is worth it.
/// @param flows    where the trial state is outside
/// @param at_trial the meridian at the trial state
/// @param choose   who decides on the second pass, see OwnSubsteps
template <class R, class Law, class Choice>
BARRENO_FUNCTION AttemptOf<R, Law> flow_points(
    const RockOf<R, Law>& rock,
    const MaskOf<R>& flows,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const MeridianOf<R>& at_trial,
    const Choice& choose
) {
  const StateOf<R, Law>& n = step.n;
  const R metric = metric_of(rock, step, p);
  const TrialOf<R> trial{p.x, p.q, metric, stiffness_of_return(p), n.evp, step.cap};
  const auto [r, end] = return_shear(rock, p, p.s, trial, flows, at_trial, no_guess<R, Law>());
  FlowStartOf<R, Law> f = flow_start_of(rock, flows, step, p, metric);
  if (rock.crush.porous()) {
    // Rock without open pores that keeps them closed flows along its shear stress, not along the
    // normal of the surface: what shear would open crushes at once.
    const MaskOf<R> isochoric = (!step.cap.present) & (r.evp == n.evp) & (f.q > 0.0);
    f.normal_x = real::select(isochoric, 0.0, f.normal_x);
    f.normal_q = real::select(isochoric, 1.0, f.normal_q);
    if constexpr (Law::angled) {
      const DeviatorOf<R> across =
          lengthened(f.normal_s, R(real::sqrt(squared(f.normal_s))), R(R{} + 1.0));
      assign_where(isochoric, across, f.normal_s);
    }
  }
  AttemptOf<R, Law> a;
  if constexpr (Law::angled) lean_into_edge<R, Law>(p, end, f);
  finish_flow(rock, step, p, end, r, f, a);
  a.elastic = none_of<R>();
  a.refused = flows & r.refused;
  a.allowed = allowed_error_of(rock, n, r.x, R(r.q * r.q));
  const DirectionChangeOf<R, Law> change = direction_change_of<R, Law>(p, r, end, f, metric);
  const R of_moduli =
      mismatch_of(p.start, p.used, a.moduli) * size_of_stress(R(r.x - n.x), squared(a.end.s - n.s));
  const MaskOf<R> at_vertex = r.x >= rock.surface.vertex;
  const R way = f.scale * size_of_stress(R(f.x - r.x), R(f.q * f.q));
  a.error = of_moduli + real::select(at_vertex & (way < change.error), way, change.error);
  if constexpr (has_poroplastic_fluid<Law>) a.error = a.error + pressure_error(rock, step, p, a);
  constexpr double largest_retraction = 0.1, negligible = Law::angled ? 0.0 : 0.01;
  const MaskOf<R> retracts =
      (!at_vertex) & (r.evp > n.evp) & step.cap.present & r.cap.present & (r.x < r.cap.kappa);
  const R length = real::select(retracts, step.cap.kappa - step.cap.X, 1.0);
  const R retraction = real::select(
      retracts, a.allowed * (r.cap.X - step.cap.X) / (largest_retraction * length), 0.0
  );
  a.error = larger_of(a.error, retraction);
  const MaskOf<R> substantial = (a.error > negligible * a.allowed) & (a.error <= a.allowed);
  const MaskOf<R> worth = flows & (!at_vertex) & choose.alike(substantial);
  if (real::any(worth)) refine_points(rock, worth, step, p, change, f, a);
  return a;
}

}  // namespace barreno::arenisca
