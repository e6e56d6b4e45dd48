// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scalar_return.hpp"
#include "scalar_state.hpp"

#include <algorithm>
#include <cmath>

namespace barreno::arenisca {

/// Fraction of an elastic path from inside the surface at which it is crossed; roughly, since it
/// only weighs work and the flow direction.
template <class Counter>
BARRENO_FUNCTION double crossing(
    const Rock& rock,
    const Cap& cap,
    const PointState& n,
    const Prediction& p,
    int halvings,
    Counter& count
) {
  double inside = 0.0, outside = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double t = 0.5 * (inside + outside);
    const Sym3 s = n.s + t * (p.s - n.s);
    const double x = n.x + t * (p.x - n.x);
    (rock.surface.contains(x, second_invariant(s), cap, count) ? inside : outside) = t;
  }
  return inside;
}

/// Where plastic flow began within the substep, and the surface's normal there in the transformed
/// space.
struct FlowStart {
  double x;
  Sym3 s;  ///< direction of shear, and after multiplication by `scale` the stress deviator [stress]
  double q;  ///< sqrt(J2) of s
  double scale = 1.0;
  double normal_x = 0.0, normal_q = 0.0;
};

template <class Counter>
BARRENO_FUNCTION FlowStart find_flow_start(
    const Rock& rock,
    const Cap& cap,
    const PointState& n,
    const Prediction& p,
    double metric,
    Counter& count
) {
  // Slightly inside: a point left on the surface by the last step counts as on it.
  constexpr double shrink = 1.0 - 1e-6;
  FlowStart f;
  f.x = n.x;
  f.s = n.s;
  f.q = std::sqrt(second_invariant(n.s));
  MeridianOf<double> m = rock.surface.at(f.x, cap, count);
  const double limit = larger(m.limit, 0.0) * shrink;
  if (f.x < rock.surface.vertex && f.q * f.q < limit * limit * m.cap_squared) {
    constexpr int halvings = 6;
    const double t = crossing(rock, cap, n, p, halvings, count);
    f.x = n.x + t * (p.x - n.x);
    f.s = n.s + t * (p.s - n.s);
    f.q = std::sqrt(second_invariant(f.s));
    m = rock.surface.at(f.x, cap, count);
  }
  // Gradient of q^2 - (Ff fc)^2: regular at the tip, and of sense a little inside the surface too.
  const double along = -std::sqrt(metric) * m.limit * m.slope;
  const double length = std::sqrt(along * along + f.q * f.q);
  // As near the vertex as this, in terms of the trial shear, the shear direction is noise.
  constexpr double near_vertex = 1e-6;
  const double reach = larger(f.q, rock.surface.steepest * (rock.surface.vertex - f.x));
  if (reach <= near_vertex * p.q() || length == 0.0) {
    // Flow that leaves the vertex does so along the steepest generator of the cone, in its own
    // direction.
    const double side = std::sqrt(metric) * rock.surface.steepest;
    const double hypotenuse = std::sqrt(side * side + 1.0);
    f.normal_x = side / hypotenuse;
    f.normal_q = 1.0 / hypotenuse;
    f.s = p.s;
    f.q = p.q();
    f.scale = 0.0;
    return f;
  }
  f.normal_x = along / length;
  f.normal_q = f.q / length;
  return f;
}

/// Plastic correction of a closest-point return in the transformed space: its length and direction.
struct Correction {
  double distance, normal_x, normal_q;
};
BARRENO_FUNCTION Correction
correction_of(const Prediction& p, const Returned& r, double root_metric) {
  const double back_x = p.x - r.x, back_q = root_metric * (p.q() - r.q);
  const double distance = std::sqrt(back_x * back_x + back_q * back_q);
  if (distance == 0.0) return {0.0, 0.0, 0.0};
  return {distance, back_x / distance, back_q / distance};
}

/// Error of the backward (closest-point) return: half the plastic correction times the turn of the
/// flow direction over the substep, i.e. half the difference between the forward and the backward
/// step.
BARRENO_FUNCTION double direction_error(
    const Prediction& p, const Correction& c, const FlowStart& f
) {
  double cosine = 1.0;
  if (f.q > 0.0 && p.q() > 0.0) cosine = contract(f.s, p.s) / (2.0 * f.q * p.q());
  const double turn_x = c.normal_x - f.normal_x;
  const double turn = turn_x * turn_x + c.normal_q * c.normal_q + f.normal_q * f.normal_q -
                      2.0 * c.normal_q * f.normal_q * cosine;
  return 0.5 * c.distance * std::sqrt(larger(turn, 0.0) / 3.0);
}

template <class Counter>
BARRENO_FUNCTION Returned return_with(const Rock& rock, const Trial& trial, Counter& count) {
  return rock.bisection ? return_bisection(rock.surface, rock.crush, trial, count, rock.resolution)
                        : return_fast(rock.surface, rock.crush, trial, count);
}

/// End of a substep from the return of the point (x, s) with q = sqrt(J2(s)): state, moduli, work.
BARRENO_FUNCTION void finish(
    const Rock& rock,
    const Substep& step,
    const Prediction& p,
    const Prediction& returned_from,
    const Returned& r,
    const FlowStart& f,
    ScalarAttempt& a
) {
  const PointState& n = step.n;
  const double kept = returned_from.q() > 0.0 ? r.q / returned_from.q() : 0.0;
  a.end = {r.x, kept * returned_from.s, r.evp, n.shear_strain};
  // Plastic strain = increment - C^-1 : stress increment, split in volume and deviator.
  const double devp = r.evp - n.evp;
  const Sym3 dep = (0.5 / p.used.shear) * (p.s - a.end.s);
  a.end.shear_strain += std::sqrt(2.0 / 3.0 * contract(dep, dep));

  const double end_work = r.x * devp / 3.0 + contract(a.end.s, dep);
  const double start_work = f.x * devp / 3.0 + f.scale * contract(f.s, dep);
  const double mean_work = 0.5 * (start_work + end_work);
  a.plastic_work = mean_work >= 0.0 ? mean_work : end_work;
  a.elastic_work =
      0.5 * ((n.x + r.x) * (step.dv - devp) / 3.0 + contract(n.s + a.end.s, step.de - dep));
  a.moduli = rock.elasticity.moduli_at(r.x, rock.elasticity.seen_from(p.evp, r.evp));
}

/// Weight of (q_tr - q)^2 beside (x_tr - x)^2, from where a substep starts: 9 beta^2 K/G.
/// beta^2 falls with dilation and pressure, and is whole again at the end of the cap.
BARRENO_FUNCTION double metric_of(const Rock& rock, const Substep& step, const Moduli& moduli) {
  const double whole = 9.0 * rock.flow.beta * rock.flow.beta * moduli.bulk / moduli.shear;
  if (rock.flow.per_strain == 0.0 && rock.flow.per_pressure == 0.0) return whole;
  const double pressure = std::max(-step.n.x / 3.0, 0.0);
  const double room = 1.0 - rock.flow.per_strain * std::max(step.n.evp, 0.0);
  const double share = std::max(
      std::max(room, rock.flow.least) * std::exp(-pressure * rock.flow.per_pressure),
      rock.flow.least_of_all
  );
  if (!step.cap.present || step.n.x >= step.cap.kappa) return share * whole;
  const double c = (step.cap.kappa - step.n.x) / (step.cap.kappa - step.cap.X);
  return (share + (1.0 - share) * std::min(c, 1.0)) * whole;
}

/// Second pass of a substep: mean moduli of both ends, and the trial point moved by half the turn
/// of the flow direction, so that the closest-point return corrects along the mean direction.
/// Second-order accurate, and still on the hardened surface: evp starts where the moved trial point
/// keeps x = x_tr - 3K (evp - evp_n).
template <class Counter>
BARRENO_FUNCTION void refine(
    const Rock& rock,
    const Substep& step,
    const Prediction& first,
    const Correction& c,
    const FlowStart& f,
    ScalarAttempt& a,
    Counter& count
) {
  const PointState& n = step.n;
  const Moduli mean = {
      0.5 * (first.start.bulk + a.moduli.bulk), 0.5 * (first.start.shear + a.moduli.shear)};
  const Prediction p = predict_with(n, first.start, mean, step.dv, step.de);
  const double metric = metric_of(rock, step, mean);
  Prediction moved = p;
  moved.x += 0.5 * c.distance * (c.normal_x - f.normal_x);
  const double half = 0.5 * c.distance / std::sqrt(metric);
  if (p.q() > 0.0) moved.s = moved.s + (half * c.normal_q / p.q()) * p.s;
  if (f.q > 0.0) moved.s = moved.s - (half * f.normal_q / f.q) * f.s;
  moved.J2 = second_invariant(moved.s);
  const double triple_bulk = 3.0 * mean.bulk;
  const double evp = n.evp + (p.x - moved.x) / triple_bulk;
  const bool stays_closed = !step.cap.present && a.end.evp == n.evp && evp == n.evp;
  if (rock.crush.p3 > 0.0 && evp <= rock.crush.last_open() && !stays_closed) return;
  const Cap cap = rock.cap_at(evp);
  Returned r = {moved.x, moved.q(), evp};
  if (!rock.surface.contains(moved.x, moved.J2, cap, count)) {
    r = return_with(rock, Trial{moved.x, moved.q(), metric, triple_bulk, evp, cap}, count);
  }
  ScalarAttempt b = a;
  finish(rock, step, p, moved, r, f, b);
  // Where the flow is too short to have a mean direction, the first pass dissipates and is kept.
  // Rock without strength dissipates nothing: round-off must not decide.
  constexpr double round_off = 1e-9;
  const double flow = b.end.shear_strain - n.shear_strain;
  if (b.plastic_work >= -round_off * flow * size_of_stress(b.end.x, moved.J2)) a = b;
}

/// How far the cap retracted onto the returned point, in parts of its length; 0 when it stayed out
/// of the way.
BARRENO_FUNCTION double retraction(
    const Rock& rock, const PointState& n, const Cap& cap, const Returned& r
) {
  if (r.evp <= n.evp || !cap.present) return 0.0;
  const Cap end = rock.cap_at(r.evp);
  return r.x < end.kappa ? (end.X - cap.X) / (cap.kappa - cap.X) : 0.0;
}

/// Rock without open pores that keeps them closed flows along its shear stress, not along the
/// surface's normal: what shear would open crushes at once.
BARRENO_FUNCTION bool flows_isochorically(
    const Rock& rock, const PointState& n, const Cap& cap, const Returned& r
) {
  return rock.crush.p3 > 0.0 && !cap.present && r.evp == n.evp;
}

/// Plastic substep: closest-point return, its error, and the second pass where that is worth it.
template <class Counter>
BARRENO_FUNCTION ScalarAttempt
flow_plastically(const Rock& rock, const Substep& step, const Prediction& p, Counter& count) {
  const PointState& n = step.n;
  const Cap& cap = step.cap;
  const double metric = metric_of(rock, step, p.used);
  const Trial trial{p.x, p.q(), metric, 3.0 * p.used.bulk, n.evp, cap};
  const Returned r = return_with(rock, trial, count);
  FlowStart f = find_flow_start(rock, cap, n, p, metric, count);
  if (flows_isochorically(rock, n, cap, r) && f.q > 0.0) {
    f.normal_x = 0.0;
    f.normal_q = 1.0;
  }
  ScalarAttempt a;
  finish(rock, step, p, p, r, f, a);
  a.error =
      moduli_mismatch(p, a.moduli) * size_of_stress(r.x - n.x, second_invariant(a.end.s - n.s));
  a.allowed = allowed_error(rock, n, r.x, r.q);
  const Correction c = correction_of(p, r, std::sqrt(metric));
  if (r.x >= rock.surface.vertex) {
    // A long step goes to the vertex where the path slides towards it; wrong by the way left at
    // most.
    const double way = f.scale * size_of_stress(f.x - r.x, f.q * f.q);
    a.error += smaller(direction_error(p, c, f), way);
    return a;
  }
  a.error += direction_error(p, c, f);
  // A cap that retracts softens, and in a long substep the consistency equation then has several
  // roots.
  constexpr double largest_retraction = 0.1;
  a.error = larger(a.error, a.allowed * retraction(rock, n, cap, r) / largest_retraction);
  constexpr double negligible = 0.01;
  if (a.error > negligible * a.allowed && a.error <= a.allowed) {
    refine(rock, step, p, c, f, a, count);
  }
  return a;
}

}  // namespace barreno::arenisca
