// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/elasticity.hpp"
#include "barreno/arenisca/plastic_flow.hpp"
#include "barreno/arenisca/rock.hpp"
#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Elastic prediction with the moduli at the middle of the substep (second-order Taylor of
/// exp(B2/I1)), I1 held within what the surface admits.
/// @param evp plastic strain to take the moduli at
BARRENO_FUNCTION Prediction predict(const Rock& rock, const Substep& step, double evp) {
  const PointState& n = step.n;
  const Cap& cap = step.cap;
  const Elasticity& e = rock.elasticity;
  const Elasticity::PressureTerm term = e.pressure_term(n.x, evp);
  const double coupling = e.coupling(n.x, evp);
  const Moduli start = e.moduli(term.value, coupling);
  Moduli used = start;
  if (term.slope != 0.0) {
    double x = smaller(n.x + 3.0 * start.bulk * step.dv, rock.surface.vertex);
    if (cap.present) x = larger(x, cap.X);
    const double middle = term.value + 0.5 * term.slope * (x - n.x);
    used = e.moduli(smaller(larger(middle, 0.0), 1.0), coupling);
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
  if (n.x >= 0.0 || Elasticity::dilated(n.evp) || !is_short)
    return rock.elasticity.moduli_at(p.x, n.evp);
  const double value = p.term.value + change * (p.term.slope + 0.5 * change * p.term.curvature);
  return rock.elasticity.moduli(value, p.coupling);
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

BARRENO_FUNCTION Attempt
accept_elastic(const Rock& rock, const Substep& step, const Prediction& p) {
  const PointState& n = step.n;
  Attempt a;
  a.end = {p.x, p.s, n.evp, n.shear_strain};
  a.moduli = moduli_after(rock, n, p);
  a.error =
      moduli_mismatch(p, a.moduli) * stress_size(p.x - n.x, std::sqrt(second_invariant(p.s - n.s)));
  a.allowed = allowed_error(rock, n, p.x, p.q());
  a.order = 3;
  a.elastic_work = 0.5 * ((n.x + p.x) * step.dv / 3.0 + contract(n.s + p.s, step.de));
  return a;
}

/// Flow that dilates from the jump of the moduli: those of dilated rock hold from where it begins
/// to flow.
template <class Counter>
BARRENO_FUNCTION Attempt
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
  Attempt a;
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
  a.error += moduli_mismatch(p, at_flow) * t *
             stress_size(p.x - n.x, std::sqrt(second_invariant(p.s - n.s)));
  return a;
}

template <class Counter>
BARRENO_FUNCTION Attempt
attempt_substep(const Rock& rock, const PointState& n, double dv, const Sym3& de, Counter& count) {
  const Cap cap = rock.cap_at(n.evp);
  const Substep step{n, cap, dv, de};
  const Prediction p = predict(rock, step, n.evp);
  if (rock.surface.contains(p.x, p.J2, cap, count)) return accept_elastic(rock, step, p);
  const Attempt a = flow_plastically(rock, step, p, count);
  if (std::fabs(n.evp) > Elasticity::at_jump || !Elasticity::dilated(a.end.evp)) return a;
  return begin_to_dilate(rock, step, p, count);
}

/// Factor for the next substep, in sixteenths: then round-off does not reach the choice of
/// substeps, and both solvers, or two machines, take the same ones.
BARRENO_FUNCTION double step_factor(const Attempt& a) {
  constexpr double safety = 0.9, smallest = 0.125, largest = 4.0, grain = 16.0;
  if (a.error <= 0.0) return largest;
  const double ratio = a.allowed / a.error;
  const double factor = safety * (a.order == 3 ? std::cbrt(ratio) : std::sqrt(ratio));
  return smaller(larger(std::floor(grain * factor) / grain, smallest), largest);
}

/// Fraction of a step below which a substep is taken as it is: where the law itself jumps (K at I1
/// = 0 with coupling, the cap's return when closed pores open) none is small enough.
BARRENO_FUNCTION double smallest_fraction(const Sym3& strain) {
  constexpr double fraction = 1.0 / 1024.0, smallest_strain = 1e-5;
  const double size = norm(strain);
  return size * fraction > smallest_strain ? smallest_strain / size : fraction;
}

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
  for (int i = 0; i < max_attempts; ++i) {
    const bool last = done + fraction >= 1.0;
    if (last) fraction = 1.0 - done;
    const Attempt a = attempt_substep(rock, state, fraction * volume, fraction * shape, count);
    if (!std::isfinite(a.error)) break;
    const double way = rock.elasticity.way_to_jump(state.evp, a.end.evp);
    if (way < 1.0 && fraction > smallest_fraction(strain)) {
      fraction *= way;
      continue;
    }
    if (a.error > a.allowed && fraction > smallest_fraction(strain)) {
      fraction *= step_factor(a);
      continue;
    }
    state = a.end;
    count.took(fraction);
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

}  // namespace barreno::arenisca

#include "barreno/arenisca/frozen_substeps.hpp"
