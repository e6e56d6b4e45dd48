// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/closest_point.hpp"
#include "barreno/arenisca/root_finding.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Where the trial state comes back to: on the surface hardened to `evp`.
struct Returned {
  double x, q, evp;
};

/// I1 of the point of the limit surface (no cap) closest to the trial point; the vertex included.
template <class Counter>
BARRENO_FUNCTION double return_to_limit(
    const YieldSurface& surface, const Trial& trial, Counter& count
) {
  if (trial.x - surface.vertex >= trial.metric * trial.q * surface.steepest) return surface.vertex;
  double x = smaller(trial.x, surface.vertex);
  const Cap none;
  const MeridianOf<double> start = surface.at(x, none, count);
  if (trial.x <= surface.vertex && trial.q <= start.limit) return trial.x;
  // Newton on the monotone condition (x - x_tr) - metric (q_tr - Ff) Ff'; Ff'' <= 0 keeps its slope
  // >= 1.
  double lower = trial.x - trial.metric * trial.q * surface.steepest, upper = x;
  MeridianOf<double> m = start;
  constexpr int max_iterations = 60;
  for (int i = 0; i < max_iterations; ++i) {
    const double curvature = surface.curvature(m.curved);
    const double residual = (x - trial.x) - trial.metric * (trial.q - m.limit) * m.slope;
    const double slope = 1.0 + trial.metric * (m.slope * m.slope - (trial.q - m.limit) * curvature);
    (residual > 0.0 ? upper : lower) = x;
    double next = x - residual / slope;
    if (surface.straight && !surface.limited) return next;
    if (!(next >= lower && next <= upper)) next = 0.5 * (lower + upper);
    const bool done = std::fabs(next - x) <= 1e-14 * (std::fabs(x) + std::fabs(upper - lower));
    x = next;
    if (done) break;
    m = surface.at(x, none, count);
  }
  return x;
}

/// return_with_closed_pores() as a Returned.
template <class Crush>
BARRENO_FUNCTION Returned
closed_pores(const YieldSurface& surface, const Crush& crush, const Trial& trial) {
  const ClosedOf<double> c = return_with_closed_pores(surface, crush.closed(), trial);
  return {c.x, c.q, c.evp};
}

/// True where a return to the limit surface leaves the cap behind it, that is, keeps the pores it
/// opens.
template <class Crush>
BARRENO_FUNCTION bool clears_cap(
    const YieldSurface& surface, const Crush& crush, double x, double evp
) {
  if (crush.p3 == 0.0) return true;
  const double open_evp = larger(evp, crush.last_open());
  return x >= branch_point(surface, crush.strength(open_evp));
}

/// First guess of enough dilation onto the cap: half more than the non-hardening return to the
/// tangent of the surface straight below the trial point.
BARRENO_FUNCTION double dilation_guess(const Trial& trial, const MeridianOf<double>& below) {
  constexpr double margin = 1.5;
  const double fc = std::sqrt(larger(below.cap_squared, 0.0));
  const double slope = below.slope / fc;
  return -margin * trial.metric * (trial.q - below.limit * fc) * slope /
         ((1.0 + trial.metric * slope * slope) * trial.triple_bulk);
}

/// Meridian of a fixed surface as a curve with one parameter, for the nested bisection.
///
/// s in [0, pi/2]: the cap by its angle, x = kappa - (kappa - X) cos s, q = Ff sin s (the angle
/// resolves the tip, where x alone does not); s > pi/2: the limit surface, x = kappa + (s - pi/2)
/// width.
template <class Counter>
struct MeridianCurve {
  const YieldSurface& surface;
  const Trial& trial;
  const Cap& cap;
  double origin, width;  ///< x where the limit surface begins, and stress per unit of s there
  Counter& count;

  static constexpr double quarter_turn = 1.5707963267948966;

  struct Point {
    double x, q, dx, dq;  ///< place and tangent
  };
  BARRENO_FUNCTION Point at(double s) {
    count.add();
    if (s >= quarter_turn) {
      const double x = smaller(origin + (s - quarter_turn) * width, surface.vertex);
      const LimitOf<double> l = surface.limit_at(x);
      return {x, l.value, width, l.slope * width};
    }
    const double length = cap.kappa - cap.X;
    const double half = std::sin(0.5 * s);
    const double x = cap.X + 2.0 * length * half * half;
    const LimitOf<double> l = surface.limit_at(x);
    const double dx = length * std::sin(s);
    return {x, l.value * std::sin(s), dx, l.slope * dx * std::sin(s) + l.value * std::cos(s)};
  }
  /// Half the derivative of the squared distance to the trial point along the curve.
  BARRENO_FUNCTION double operator()(double s) {
    const Point p = at(s);
    return (p.x - trial.x) * p.dx + trial.metric * (p.q - trial.q) * p.dq;
  }
};

/// Sign of the meridian's rise along the curve; falls through zero at its top.
template <class Counter>
struct Fall {
  MeridianCurve<Counter>& curve;
  BARRENO_FUNCTION double operator()(double s) { return -curve.at(s).dq; }
};

/// Non-hardening return: closest point of the surface with this cap, by bisection along the
/// meridian.
///
/// The paper turns a search line about the trial point and tests which side of the surface a
/// rotated point falls on. That test compares distances, which are flat at the closest point, so it
/// resolves the angle to sqrt(round-off) = 1e-8 only, too coarse for an oracle; here the sign of
/// the distance's derivative is bisected instead, which is exact to round-off. The bracket is the
/// arc that the trial point sees: from its own x to the top of the meridian.
/// @param resolution of s; 0: the last bit
template <class Counter>
BARRENO_FUNCTION Returned return_without_hardening(
    const YieldSurface& surface,
    const Trial& trial,
    const Cap& cap,
    Counter& count,
    double resolution = 0.0
) {
  using Curve = MeridianCurve<Counter>;
  const double reach = trial.metric * trial.q * surface.steepest;
  const double highest = smaller(trial.x, surface.vertex);
  const double origin = cap.present ? cap.kappa : highest - reach;
  const bool on_cap = cap.present && trial.x < cap.kappa;
  const double width = larger(highest - origin, cap.present ? cap.kappa - cap.X : 0.0);
  Curve curve{surface, trial, cap, origin, width, count};
  double below = Curve::quarter_turn;
  if (cap.present) {
    Fall<Counter> fall{curve};
    below = bisect(fall, 0.0, Curve::quarter_turn, resolution);
  }
  double above = Curve::quarter_turn + 1.0;
  if (on_cap) {
    const double part = larger(trial.x - cap.X, 0.0) / (2.0 * (cap.kappa - cap.X));
    above = 2.0 * std::asin(std::sqrt(part));
    if (above < below) {
      const double top = below;
      below = above;
      above = top;
    }
  }
  // A vertex closer than any point of the meridian: the distance still falls at its end.
  const bool at_vertex = !on_cap && highest == surface.vertex && curve(above) <= 0.0;
  const auto p = curve.at(at_vertex ? above : bisect(curve, below, above, resolution));
  const double q = smaller(larger(p.q, 0.0), trial.q);
  return {p.x, q, trial.evp + (trial.x - p.x) / trial.triple_bulk};
}

/// Isotropic part of the return to the surface hardened by a fraction eta of the non-hardening
/// return, less that fraction: the quantity whose sign the paper bisects.
template <class Crush, class Counter>
struct ConsistencyOfEta {
  const YieldSurface& surface;
  const Crush& crush;
  const Trial& trial;
  double devp0;
  Counter& count;
  double resolution;

  BARRENO_FUNCTION Returned returned(double eta) {
    const double evp = trial.evp + eta * devp0;
    const Cap cap = crush.has_cap(evp) ? cap_with(surface, crush.strength(evp)) : Cap{};
    return return_without_hardening(surface, trial, cap, count, resolution);
  }
  /// Negative while eta is too small.
  BARRENO_FUNCTION double operator()(double eta) {
    const double evp = trial.evp + eta * devp0;
    const bool closed = crush.p3 > 0.0 && !crush.has_cap(evp);
    if (closed && devp0 < 0.0) return 1.0;
    if (closed) return -1.0;
    // Hardening may swallow the trial point: then the surface has moved too far.
    const Cap cap = crush.has_cap(evp) ? cap_with(surface, crush.strength(evp)) : Cap{};
    if (surface.contains(trial.x, trial.q * trial.q, cap, count)) return 1.0;
    const double devp =
        return_without_hardening(surface, trial, cap, count, resolution).evp - trial.evp;
    return devp0 > 0.0 ? eta * devp0 - devp : devp - eta * devp0;
  }
};

/// The paper's return: non-hardening return, then eta by bisection. Slow; the oracle of
/// return_points().
/// @param resolution of eta and of the angle along the meridian; 0, the oracle's: the last bit
template <class Crush, class Counter>
BARRENO_FUNCTION Returned return_bisection(
    const YieldSurface& surface,
    const Crush& crush,
    const Trial& trial,
    Counter& count,
    double resolution = 0.0
) {
  const Returned first = return_without_hardening(surface, trial, trial.cap, count, resolution);
  const double devp0 = first.evp - trial.evp;
  if (crush.p3 == 0.0) return first;
  if (devp0 >= 0.0 && clears_cap(surface, crush, first.x, first.evp)) return first;
  if (devp0 == 0.0) {
    return trial.cap.present ? first : closed_pores(surface, crush, trial);
  }
  ConsistencyOfEta<Crush, Counter> consistency{surface, crush, trial, devp0, count, resolution};
  // Steep retraction of the cap: the paper's eta <= 1 does not hold, and there may be several
  // roots; the same places are tried as in return_points(), so that both take the same one.
  double above = 1.0;
  if (devp0 > 0.0) {
    const double x_limit = return_to_limit(surface, trial, count);
    above = (trial.x - x_limit) / (trial.triple_bulk * devp0);
  }
  if (devp0 > 0.0 && trial.cap.present && trial.x < trial.cap.kappa) {
    above = dilation_guess(trial, surface.at(trial.x, trial.cap, count)) / devp0;
  }
  const double start = larger(trial.evp, crush.last_open());
  if (!trial.cap.present && consistency((start - trial.evp) / devp0) >= 0.0) {
    return closed_pores(surface, crush, trial);
  }
  const double X = trial.cap.present ? trial.cap.X : crush.strength(start);
  const double farthest = (trial.x - X) / (trial.triple_bulk * devp0);
  double below = 0.0;
  const double first_step = above;
  while (devp0 > 0.0 && above < farthest && consistency(above) < 0.0) {
    below = above;
    above = next_dilation(above, first_step);
  }
  if (devp0 > 0.0) above = smaller(above, farthest);
  const double eta = bisect(consistency, below, above, resolution);
  const double evp = trial.evp + eta * devp0;
  if (evp <= crush.last_open()) {
    return closed_pores(surface, crush, trial);
  }
  // evp as bisected: that of the closest point at eta multiplies the last digit of evp by the ratio
  // of dX/d(evp) to 3K, thousands where the pores are all but closed.
  const Returned last = consistency.returned(eta);
  return {trial.x - trial.triple_bulk * (evp - trial.evp), last.q, evp};
}

}  // namespace barreno::arenisca
