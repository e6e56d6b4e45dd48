// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/general_rock.hpp"
#include "barreno/arenisca/rock.hpp"
#include "barreno/arenisca/substep.hpp"
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
};

/// End of one substep, and what it cost.
struct GeneralEnd {
  GeneralState state;
  Moduli used;
  bool plastic;
  double elastic_work, plastic_work;  ///< per current volume [stress]
};

/// Elastic trial of a substep with given moduli, returned to the hardened surface.
template <class Counter>
BARRENO_FUNCTION GeneralEnd return_trial(
    const PointRock& point,
    const GeneralState& n,
    double dv,
    const Sym3& de,
    const Moduli& used,
    Counter& count
) {
  const GeneralRock& rock = point.rock;
  const Sym3 s = n.s + (2.0 * used.shear) * de;
  const double q = std::sqrt(second_invariant(s));
  const Cap cap = point.cap_at(n.e);
  const double metric = 9.0 * rock.beta * rock.beta * used.bulk / used.shear;
  const Trial trial{n.x + 3.0 * used.bulk * dv, q, metric, 3.0 * used.bulk, n.e, cap};
  const double zeta = rock.plastic_backstress ? point.zeta(n.e) : 0.0;
  const bool round = !rock.lode.active() || q == 0.0;
  const double theta = round ? 0.0 : lode_angle(s);
  ReturnOverAngles<Counter> over_angles{point, trial, theta, zeta, count};
  const YieldSurface surface =
      round ? point.surface : over_angles.scaled(rock.lode.at(theta).gamma);
  GeneralEnd end{{trial.x, s, n.e, n.shear_strain}, used, false, 0.0, 0.0};
  if (surface.contains(trial.x, q * q, cap, count)) return end;
  end.plastic = true;
  const double angle = round ? theta : over_angles.solve();
  const Returned r = round ? return_in_half_plane(point, surface, trial, zeta, count)
                           : over_angles.at(angle, rock.lode.at(angle).gamma);
  const Sym3 s_end = q > 0.0 ? turned(s, angle - theta, r.q) : s;
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

/// One substep: moduli at its middle (two passes), plastic variable and flow direction at its end.
template <class Counter>
BARRENO_FUNCTION GeneralEnd take_substep(
    const PointRock& point, const GeneralState& n, double dv, const Sym3& de, Counter& count
) {
  GeneralEnd end = return_trial(point, n, dv, de, point.moduli(n.x, n.e), count);
  const Moduli middle = point.moduli(0.5 * (n.x + end.state.x), 0.5 * (n.e + end.state.e));
  if (middle.bulk != end.used.bulk || middle.shear != end.used.shear) {
    end = return_trial(point, n, dv, de, middle, count);
  }
  measure_work(point, n, dv, de, end);
  return end;
}

BARRENO_FUNCTION double distance(const GeneralState& a, const GeneralState& b) {
  return stress_size(a.x - b.x, std::sqrt(second_invariant(a.s - b.s)));
}

/// Substep whose error is known: two halves against the whole; an elastic one by its moduli.
template <class Counter>
BARRENO_FUNCTION Attempt attempt_general(
    const PointRock& point,
    const GeneralState& n,
    double dv,
    const Sym3& de,
    GeneralEnd& end,
    Counter& count
) {
  Attempt a;
  const GeneralEnd whole = take_substep(point, n, dv, de, count);
  const double start_size = stress_size(n.x, std::sqrt(second_invariant(n.s)));
  const GeneralState& m = whole.state;
  const double end_size = stress_size(m.x, std::sqrt(second_invariant(m.s)));
  a.allowed = point.rock.tolerance * larger(larger(start_size, end_size), point.rock.stress_floor);
  if (!whole.plastic) {
    end = whole;
    const Moduli first = point.moduli(n.x, n.e), last = point.moduli(m.x, m.e);
    const double bulk = std::fabs(0.5 * (first.bulk + last.bulk) / whole.used.bulk - 1.0);
    const double shear = std::fabs(0.5 * (first.shear + last.shear) / whole.used.shear - 1.0);
    a.error = larger(bulk, shear) * distance(m, n);
    a.order = 3;
    return a;
  }
  const GeneralEnd half = take_substep(point, n, 0.5 * dv, 0.5 * de, count);
  end = take_substep(point, half.state, 0.5 * dv, 0.5 * de, count);
  end.elastic_work += half.elastic_work;
  end.plastic_work += half.plastic_work;
  end.used = {0.5 * (end.used.bulk + half.used.bulk), 0.5 * (end.used.shear + half.used.shear)};
  a.error = distance(end.state, m);
  return a;
}

/// Result of a whole step of the general rock.
struct GeneralStep {
  Outcome outcome;
  double elastic_x = 0.0;  ///< change of I1 had the step been elastic [stress]
  Sym3 elastic_s;          ///< the same for the deviator [stress]
  Moduli last{};           ///< moduli of the last substep
};

/// Integrates a step in error-controlled substeps.
template <class Counter>
BARRENO_FUNCTION GeneralStep
integrate_general(const PointRock& point, GeneralState& state, const Sym3& strain, Counter& count) {
  constexpr int most_attempts = 2000;
  constexpr double smallest = 1.0 / 4096.0, smallest_strain = 1e-6;
  GeneralStep step;
  step.outcome.substeps = 0;
  const double volume = trace(strain), size = norm(strain);
  const Sym3 shape = deviator(strain);
  const double smallest_fraction =
      size * smallest > smallest_strain ? smallest_strain / size : smallest;
  double done = 0.0, fraction = 1.0;
  for (int i = 0; i < most_attempts; ++i) {
    const bool last = done + fraction >= 1.0;
    if (last) fraction = 1.0 - done;
    GeneralEnd end;
    const Attempt a =
        attempt_general(point, state, fraction * volume, fraction * shape, end, count);
    if (!std::isfinite(a.error)) break;
    if (a.error > a.allowed && fraction > smallest_fraction) {
      fraction *= step_factor(a);
      continue;
    }
    state = end.state;
    step.outcome.elastic_work += end.elastic_work;
    step.outcome.plastic_work += end.plastic_work;
    step.elastic_x += 3.0 * end.used.bulk * fraction * volume;
    step.elastic_s = step.elastic_s + (2.0 * end.used.shear * fraction) * shape;
    step.last = end.used;
    ++step.outcome.substeps;
    if (last) return step;
    done += fraction;
    fraction *= step_factor(a);
  }
  step.outcome.status = Status::substep_limit;
  return step;
}

}  // namespace barreno::arenisca
