// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/general_rock.hpp"
#include "barreno/arenisca/rock.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::arenisca {

/// State of a point of the general rock between substeps: x = I1 - zeta and e are seen from the
/// elastic centre (e is the volumetric plastic strain where the published backstress is asked for).
struct GeneralState {
  double x;  ///< [stress]
  Sym3 s;    ///< stress deviator [stress]
  double e, shear_strain;
  bool on_surface = false;  ///< but for round-off, and reached elastically
};

/// End of one substep, and what it cost.
struct GeneralEnd {
  GeneralState state;
  Moduli used;
  bool plastic;
  double elastic_work, plastic_work;  ///< per current volume [stress]
};

/// Elastic trial of a substep with given moduli, and where it lies.
struct GeneralTrial {
  Trial part;  ///< with the full sqrt(J2)
  Sym3 s;      ///< stress deviator [stress]
  double theta;
  bool round;    ///< independent of the Lode angle
  bool outside;  ///< of the surface at the start
};

template <class Counter>
BARRENO_FUNCTION GeneralTrial make_trial(
    const PointRock& point,
    const GeneralState& n,
    const Cap& cap,
    double dv,
    const Sym3& de,
    const Moduli& used,
    Counter& count
) {
  const Lode& lode = point.rock.lode;
  const double metric = point.rock.flow.metric(used, n.x, n.e);
  GeneralTrial t{};
  t.s = n.s + (2.0 * used.shear) * de;
  const double J2 = second_invariant(t.s), q = std::sqrt(J2);
  t.part = {n.x + 3.0 * used.bulk * dv, q, metric, 3.0 * used.bulk, n.e, cap};
  t.round = !lode.active() || q == 0.0;
  t.theta = t.round ? 0.0 : lode_angle(t.s);
  const double gamma = t.round ? 1.0 : lode.at(t.theta).gamma;
  t.outside = !scaled_surface(point.surface, gamma).contains(t.part.x, J2, cap, count);
  return t;
}

/// The trial with given moduli, returned to the hardened surface if it is outside.
template <class Counter>
BARRENO_FUNCTION GeneralEnd return_trial(
    const PointRock& point,
    const GeneralState& n,
    double dv,
    const Sym3& de,
    const Moduli& used,
    Counter& count
) {
  const GeneralTrial t = make_trial(point, n, point.cap_at(n.e), dv, de, used, count);
  GeneralEnd end{{t.part.x, t.s, n.e, n.shear_strain}, used, t.outside, 0.0, 0.0};
  if (!t.outside) return end;
  const double zeta = point.rock.plastic_backstress ? point.zeta(n.e) : 0.0;
  ReturnOverAngles<Counter> over_angles{point, t.part, t.theta, zeta, count};
  const double angle = t.round ? t.theta : over_angles.solve();
  const Returned r = t.round ? return_in_half_plane(point, point.surface, t.part, zeta, count)
                             : over_angles.at(angle, point.rock.lode.at(angle).gamma);
  const Sym3 s_end = t.part.q > 0.0 ? turned(t.s, angle - t.theta, r.q) : t.s;
  end.state = {r.x, s_end, r.evp, n.shear_strain};
  return end;
}

/// Work of a substep: what is stored in rock and fluid, and what is dissipated about the centre,
/// (sigma - zeta/3 I) : d eps_p.
BARRENO_FUNCTION void measure_work(
    const PointRock& point, const GeneralState& n, double dv, const Sym3& de, GeneralEnd& end
) {
  const GeneralState& m = end.state;
  const Sym3 dep = end.plastic ? de - (0.5 / end.used.shear) * (m.s - n.s) : 0.0 * de;
  const double dep_volume = end.plastic ? m.e - n.e : 0.0;
  const double zeta_sum = point.zeta(n.e) + point.zeta(m.e);
  const Sym3 s_sum = n.s + m.s;
  const double total = 0.5 * ((n.x + m.x + zeta_sum) * dv / 3.0 + contract(s_sum, de));
  // Dissipation with the stress at the end, where the flow direction was taken: never negative.
  end.plastic_work = m.x * dep_volume / 3.0 + contract(m.s, dep);
  end.elastic_work = total - end.plastic_work;
  end.state.shear_strain = n.shear_strain + std::sqrt(2.0 / 3.0 * contract(dep, dep));
}

/// One plastic substep: moduli at its middle (two passes), plastic variable and flow direction at
/// its end.
template <class Counter>
BARRENO_FUNCTION GeneralEnd take_substep(
    const PointRock& point, const GeneralState& n, double dv, const Sym3& de, Counter& count
) {
  GeneralEnd end = return_trial(point, n, dv, de, point.moduli(n.x, n.e), count);
  const double middle_e = 0.5 * (n.e + end.state.e);
  const Moduli middle = point.moduli(0.5 * (n.x + end.state.x), middle_e);
  if (middle.bulk != end.used.bulk || middle.shear != end.used.shear) {
    end = return_trial(point, n, dv, de, middle, count);
    // A trace of dilation, and the softer rock no longer reaches the surface: dilated all the same.
    if (!end.plastic && !Elasticity::dilated(n.e) && Elasticity::dilated(middle_e)) {
      end.state.e = 2.0 * Elasticity::at_jump;
    }
  }
  measure_work(point, n, dv, de, end);
  return end;
}

/// A substep as if there were no surface (moduli at its middle, two passes); `plastic` where that
/// leaves the surface.
template <class Counter>
BARRENO_FUNCTION GeneralEnd take_elastically(
    const PointRock& point,
    const GeneralState& n,
    const Moduli& start,
    double dv,
    const Sym3& de,
    Counter& count
) {
  const Moduli used = point.moduli(n.x + 1.5 * start.bulk * dv, n.e);
  const GeneralTrial t = make_trial(point, n, point.cap_at(n.e), dv, de, used, count);
  return {{t.part.x, t.s, n.e, n.shear_strain}, used, t.outside, 0.0, 0.0};
}

BARRENO_FUNCTION double distance(const GeneralState& a, const GeneralState& b) {
  return size_of_stress(a.x - b.x, second_invariant(a.s - b.s));
}
BARRENO_FUNCTION double size_of(const GeneralState& n) {
  return size_of_stress(n.x, second_invariant(n.s));
}

/// The elastic part of a substep that ends outside: its fraction, and its end. Without it two half
/// substeps, the first of them elastic, would be the whole one exactly and show no error.
/// @return 0 where the surface is left at once
template <class Counter>
BARRENO_FUNCTION double elastic_part(
    const PointRock& point,
    const GeneralState& n,
    const Moduli& start,
    double dv,
    const Sym3& de,
    GeneralEnd& end,
    Counter& count
) {
  constexpr double at_once = 1.0 / 1024.0;
  constexpr int halvings = 40;
  const auto at = [&](double t) {
    return take_elastically(point, n, start, t * dv, t * de, count);
  };
  GeneralEnd e = at(at_once);
  if (e.plastic) return 0.0;
  double inside = at_once, outside = 1.0;
  end = e;
  for (int i = 0; i < halvings; ++i) {
    const double t = 0.5 * (inside + outside);
    e = at(t);
    if (e.plastic) {
      outside = t;
    } else {
      inside = t;
      end = e;
    }
  }
  return inside;
}

/// Two halves and the whole of a plastic substep, extrapolated to second order and back on the
/// surface. Left as the halves are where a regime changes within.
template <class Counter>
BARRENO_FUNCTION void extrapolate(
    const PointRock& point, const GeneralEnd& whole, GeneralEnd& end, Counter& count
) {
  const GeneralState &m = whole.state, &n = end.state;
  GeneralEnd b = end;
  b.state = {
      2.0 * n.x - m.x, 2.0 * n.s - m.s, 2.0 * n.e - m.e, 2.0 * n.shear_strain - m.shear_strain};
  b.elastic_work = 2.0 * end.elastic_work - whole.elastic_work;
  b.plastic_work = 2.0 * end.plastic_work - whole.plastic_work;
  const auto regime = [&](double e) {
    return (Elasticity::dilated(e) ? 1 : 0) + (point.p3 > 0.0 && e <= point.last_open() ? 2 : 0);
  };
  if (b.plastic_work < 0.0 || regime(b.state.e) != regime(n.e)) return;
  const GeneralEnd back = return_trial(point, b.state, 0.0, Sym3{}, end.used, count);
  b.state.x = back.state.x;
  b.state.s = back.state.s;
  b.state.e = back.state.e;
  end = b;
}

/// What is known of the error of an attempt at a substep.
struct Attempt {
  double error = 0.0;    ///< estimated local error [stress]
  double allowed = 0.0;  ///< what it may be [stress]
  int order = 2;         ///< power of the step size in `error`
};

/// Factor for the next substep, in sixteenths: then round-off does not reach the choice of
/// substeps, and both solvers, or two machines, take the same ones.
BARRENO_FUNCTION double step_factor(const Attempt& a) {
  constexpr double safety = 0.9, smallest = 0.125, largest = 4.0, grain = 16.0;
  if (a.error <= 0.0) return largest;
  const double ratio = a.allowed / a.error;
  const double factor = safety * (a.order == 3 ? std::cbrt(ratio) : std::sqrt(ratio));
  return smaller(larger(std::floor(grain * factor) / grain, smallest), largest);
}

/// Substep whose error is known: an elastic one by its moduli, a plastic one by two halves against
/// the whole.
/// @param[out] taken  fraction that was taken: up to the surface, if that is crossed
template <class Counter>
BARRENO_FUNCTION Attempt attempt_general(
    const PointRock& point,
    const GeneralState& n,
    double dv,
    const Sym3& de,
    GeneralEnd& end,
    double& taken,
    Counter& count
) {
  Attempt a;
  taken = 1.0;
  const Moduli first = point.moduli(n.x, n.e);
  end = take_elastically(point, n, first, dv, de, count);
  if (end.plastic && !n.on_surface) {
    const double part = elastic_part(point, n, first, dv, de, end, count);
    if (part > 0.0) taken = part;
    end.state.on_surface = part > 0.0;
  }
  const double floor = larger(size_of(n), point.rock.stress_floor);
  if (!end.plastic) {
    measure_work(point, n, taken * dv, taken * de, end);
    const Moduli last = point.moduli(end.state.x, n.e);
    const double bulk = std::fabs(0.5 * (first.bulk + last.bulk) / end.used.bulk - 1.0);
    const double shear = std::fabs(0.5 * (first.shear + last.shear) / end.used.shear - 1.0);
    a.error = larger(bulk, shear) * distance(end.state, n);
    a.order = 3;
  } else {
    const GeneralEnd whole = take_substep(point, n, dv, de, count);
    const GeneralEnd half = take_substep(point, n, 0.5 * dv, 0.5 * de, count);
    end = take_substep(point, half.state, 0.5 * dv, 0.5 * de, count);
    end.elastic_work += half.elastic_work;
    end.plastic_work += half.plastic_work;
    end.used = {0.5 * (end.used.bulk + half.used.bulk), 0.5 * (end.used.shear + half.used.shear)};
    a.error = distance(end.state, whole.state);
    if (whole.plastic && half.plastic && end.plastic) extrapolate(point, whole, end, count);
  }
  a.allowed = point.rock.tolerance * larger(floor, size_of(end.state));
  return a;
}

}  // namespace barreno::arenisca
