// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frozen_substeps.hpp"
#include "scalar_flow.hpp"

#include <barreno/models/arenisca.hpp>
#include <cmath>
#include <type_traits>

namespace barreno::arenisca {

/// Elastic prediction with the moduli at the middle of the substep (second-order Taylor of
/// exp(B2/I1)), I1 held within what the surface admits.
/// @param evp plastic strain to take the moduli at
BARRENO_FUNCTION Prediction predict(const Rock& rock, const Substep& step, double evp) {
  const PointState& n = step.n;
  const Cap& cap = step.cap;
  const Elasticity& e = rock.elasticity;
  const PressureTermOf<double> term = e.pressure_term(n.x, evp);
  const double coupling = e.coupling(n.x, evp);
  const Moduli start = e.moduli(n.x, term.value, coupling);
  Moduli used = start;
  if (term.slope != 0.0) {
    double x = smaller(n.x + 3.0 * start.bulk * step.dv, rock.surface.vertex);
    if (cap.present) x = larger(x, cap.X);
    const double middle = term.value + 0.5 * term.slope * (x - n.x);
    used = e.moduli(n.x + 0.5 * (x - n.x), smaller(larger(middle, 0.0), 1.0), coupling);
  }
  Prediction p = predict_with(n, start, used, step.dv, step.de);
  p.term = term;
  p.coupling = coupling;
  p.evp = evp;
  return p;
}

/// Moduli at the end of an elastic substep: a parabola in I1 for short steps in compression (its
/// relative error in exp(B2/I1) is below (B2/I1 dI1/I1)^3, here 1e-6), else the exponential.
BARRENO_FUNCTION Moduli moduli_after(const Rock& rock, const PointState& n, const Prediction& p) {
  constexpr double short_step = 0.01;
  const double change = p.x - n.x;
  const bool is_short =
      std::fabs(change) * (std::fabs(n.x) + rock.elasticity.B2) <= short_step * n.x * n.x;
  if (n.x >= 0.0 || rock.elasticity.dilated(n.evp) || !is_short)
    return rock.elasticity.moduli_at(p.x, n.evp);
  const double value = p.term.value + change * (p.term.slope + 0.5 * change * p.term.curvature);
  return rock.elasticity.moduli(p.x, value, p.coupling);
}

/// Whole step at once if it is elastic, well inside and the moduli hardly change: most points of a
/// run. Inside the virgin rock's surface is inside that of compacted rock: no logarithm is needed.
template <class Counter>
BARRENO_FUNCTION bool step_elastically(
    const Rock& rock, PointState& n, double dv, const Sym3& de, Outcome& outcome, Counter& count
) {
  if (n.evp > 0.0) return false;
  const Prediction p = predict(rock, {n, rock.first_cap, dv, de}, n.evp);
  if (!rock.surface.contains(p.x, p.J2, rock.first_cap, count)) return false;
  const Moduli end = moduli_after(rock, n, p);
  // |d sigma| <= 2 max(|sigma_n|, |sigma_n1|): no need to measure the stresses.
  if (2.0 * moduli_mismatch(p, end) > rock.tolerance) return false;
  outcome.elastic_work = 0.5 * ((n.x + p.x) * dv / 3.0 + contract(n.s + p.s, de));
  outcome.longitudinal_modulus = end.bulk + 4.0 / 3.0 * end.shear;
  n.x = p.x;
  n.s = p.s;
  return true;
}

BARRENO_FUNCTION ScalarAttempt
accept_elastic(const Rock& rock, const Substep& step, const Prediction& p) {
  const PointState& n = step.n;
  ScalarAttempt a;
  a.end = {p.x, p.s, n.evp, n.shear_strain};
  a.moduli = moduli_after(rock, n, p);
  a.error = moduli_mismatch(p, a.moduli) * size_of_stress(p.x - n.x, second_invariant(p.s - n.s));
  a.allowed = allowed_error(rock, n, p.x, p.q());
  a.order = 3;
  a.elastic_work = 0.5 * ((n.x + p.x) * step.dv / 3.0 + contract(n.s + p.s, step.de));
  return a;
}

/// Flow that dilates from the jump of the moduli: those of dilated rock hold from where it begins
/// to flow.
template <class Counter>
BARRENO_FUNCTION ScalarAttempt
begin_to_dilate(const Rock& rock, const Substep& step, const Prediction& p, Counter& count) {
  const PointState& n = step.n;
  const Cap& cap = step.cap;
  constexpr int halvings = 30;
  constexpr double other_side = 2.0 * Elasticity::at_jump;
  const double t = crossing(rock, cap, n, p, halvings, count);
  const Moduli soft = predict(rock, step, other_side).used;
  const Moduli used = {
      t * p.used.bulk + (1.0 - t) * soft.bulk, t * p.used.shear + (1.0 - t) * soft.shear};
  // Such a start that the mean of both ends is what was used.
  const Moduli start = {2.0 * used.bulk - soft.bulk, 2.0 * used.shear - soft.shear};
  Prediction mixed = predict_with(n, start, used, step.dv, step.de);
  mixed.evp = other_side;
  ScalarAttempt a;
  if (rock.surface.contains(mixed.x, mixed.J2, cap, count)) {
    // A trace of dilation, and the softer rock no longer reaches the surface.
    a.end = {mixed.x, mixed.s, other_side, n.shear_strain};
    a.moduli = soft;
    a.elastic_work = 0.5 * ((n.x + mixed.x) * step.dv / 3.0 + contract(n.s + mixed.s, step.de));
    a.allowed = allowed_error(rock, n, mixed.x, mixed.q());
  } else {
    a = flow_plastically(rock, step, mixed, count);
  }
  // The elastic part has its own error, that of its moduli on the way to the surface.
  const double x_flow = n.x + t * (p.x - n.x);
  const Moduli at_flow = rock.elasticity.moduli_at(x_flow, n.evp);
  a.error +=
      moduli_mismatch(p, at_flow) * t * size_of_stress(p.x - n.x, second_invariant(p.s - n.s));
  return a;
}

template <class Counter>
BARRENO_FUNCTION ScalarAttempt
attempt_substep(const Rock& rock, const PointState& n, double dv, const Sym3& de, Counter& count) {
  const Cap cap = rock.cap_at(n.evp);
  const Substep step{n, cap, dv, de};
  const Prediction p = predict(rock, step, n.evp);
  if (rock.surface.contains(p.x, p.J2, cap, count)) return accept_elastic(rock, step, p);
  const ScalarAttempt a = flow_plastically(rock, step, p, count);
  if (!is_at_jump(rock, n.evp) || !rock.elasticity.dilated(a.end.evp)) return a;
  return begin_to_dilate(rock, step, p, count);
}

/// Fraction of a step below which a substep is taken as it is: where the law itself jumps (K at I1
/// = 0 with coupling, the cap's return when closed pores open) none is small enough.
BARRENO_FUNCTION double smallest_fraction(const Sym3& strain) {
  constexpr double fraction = 1.0 / 1024.0, smallest_strain = 1e-5;
  const double size = norm(strain);
  return size * fraction > smallest_strain ? smallest_strain / size : fraction;
}

/// Attempts at one substep that went beyond the jump of the moduli.
struct Crossings {
  int count = 0;
  double fraction = 0.0, end = 0.0;  ///< of the last one

  /// The part of an attempt that ends at the jump; 1 where it does not go beyond it.
  BARRENO_FUNCTION double way(const Rock& rock, double begin, double end_now, double now) {
    if (is_at_jump(rock, begin)) return 1.0;
    double part = way_to_jump(rock.elasticity, begin, end_now);
    if (part == 1.0) return part;
    // Where proportion has failed several times: the line through both ends.
    if (count >= 4 && fraction > now && std::fabs(end) > std::fabs(end_now)) {
      const double secant = 1.0 - (fraction / now - 1.0) * end_now / (end - end_now);
      if (secant > 0.0) part = secant;
    }
    ++count;
    fraction = now;
    end = end_now;
    return part;
  }
};

/// Integrates a step in error-controlled substeps.
/// @param[in,out] state  stress and history; meaningful only when the outcome is ok
template <class Counter>
BARRENO_FUNCTION Outcome
integrate(const Rock& rock, PointState& state, const Sym3& strain, Counter& count) {
  constexpr int max_attempts =
      2000;  // bounds the cost of any input; 100 % strain needs some hundred
  Outcome outcome;
  const double volume = trace(strain);
  const Sym3 shape = deviator(strain);
  if (step_elastically(rock, state, volume, shape, outcome, count)) return outcome;
  outcome.substeps = 0;
  double done = 0.0, fraction = 1.0;
  Crossings crossings;
  for (int i = 0; i < max_attempts; ++i) {
    const bool last = done + fraction >= 1.0;
    if (last) fraction = 1.0 - done;
    const ScalarAttempt a =
        attempt_substep(rock, state, fraction * volume, fraction * shape, count);
    if (!std::isfinite(a.error)) break;
    const double way = crossings.way(rock, state.evp, a.end.evp, fraction);
    if (way < 1.0 && fraction > smallest_fraction(strain)) {
      fraction *= way;
      continue;
    }
    crossings = {};
    if (a.error > a.allowed && fraction > smallest_fraction(strain)) {
      fraction *= step_factor(a);
      continue;
    }
    state = a.end;
    if constexpr (std::is_same_v<Counter, SubstepRecord>) count.took(fraction);
    outcome.elastic_work += a.elastic_work;
    outcome.plastic_work += a.plastic_work;
    outcome.longitudinal_modulus = a.moduli.bulk + 4.0 / 3.0 * a.moduli.shear;
    ++outcome.substeps;
    if (last) return outcome;
    done += fraction;
    fraction *= step_factor(a);
  }
  outcome.status = Status::substep_limit;
  return outcome;
}

/// Integrates a step in the substeps of the record, whatever their error.
/// @param[in,out] state  stress and history; meaningful only when the outcome is ok
BARRENO_FUNCTION Outcome
integrate(const Rock& rock, PointState& state, const Sym3& strain, SubstepReplay& replay) {
  const SubstepRecord& record = replay.record;
  const double volume = trace(strain);
  const Sym3 shape = deviator(strain);
  Outcome outcome;
  outcome.substeps = record.count > 0 ? record.count : 1;
  for (int i = 0; i < outcome.substeps; ++i) {
    const double fraction = record.count > 0 ? record.fractions[i] : 1.0;
    const ScalarAttempt a =
        attempt_substep(rock, state, fraction * volume, fraction * shape, replay);
    if (!std::isfinite(a.error)) {
      outcome.status = Status::not_converged;
      return outcome;
    }
    state = a.end;
    outcome.elastic_work += a.elastic_work;
    outcome.plastic_work += a.plastic_work;
    outcome.longitudinal_modulus = a.moduli.bulk + 4.0 / 3.0 * a.moduli.shear;
  }
  return outcome;
}

}  // namespace barreno::arenisca

namespace barreno::test {

/// Arenisca by this law.
struct ScalarArenisca : Arenisca {
  using Arenisca::Arenisca;

  Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    arenisca::NoCounter none;
    return update_counted(increment, stress, h, none);
  }
  /// Counts yield-function evaluations, or records or replays substeps.
  template <class Counter>
  Outcome update_counted(const Increment& increment, Sym3& stress, History& h, Counter& count)
      const {
    Outcome refused;
    refused.status = Status::bad_input;
    refused.substeps = 0;
    const bool sound =
        std::isfinite(h.plastic_volume_strain) && std::isfinite(h.equivalent_plastic_strain);
    if (!arenisca::sound_increment(increment, stress) || !sound) return refused;
    arenisca::PointState state{
        trace(stress), deviator(stress), h.plastic_volume_strain, h.equivalent_plastic_strain};
    Outcome outcome = arenisca::integrate(rock(), state, increment.strain, count);
    const Sym3 end = state.s + isotropic(state.x / 3.0);
    if (outcome.failed() || !is_finite(end)) {
      refused.status = outcome.failed() ? outcome.status : Status::not_converged;
      refused.substeps = outcome.substeps;
      return refused;
    }
    stress = end;
    h = {state.evp, state.shear_strain};
    const double mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
    outcome.elastic_work *= mean_ratio;
    outcome.plastic_work *= mean_ratio;
    return outcome;
  }
};

}  // namespace barreno::test
