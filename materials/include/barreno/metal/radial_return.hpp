// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"
#include "barreno/select_members.hpp"

#include <cmath>

namespace barreno::metal {

// The return of an equivalent stress to the flow stress Y of a strength (list.hpp):
//
//   trial - 3G x = Y(plastic_strain + x, x / dt, temperature)
//
// for the plastic increment x. The left side falls and the right side rises with x: the root is
// single, and lies between 0 and (trial - Y(x = 0)) / 3G.

/// What a return needs beside its temperature.
template <class R>
struct ReturnProblemOf {
  R trial;           ///< equivalent stress of the elastic trial [stress]
  R start;           ///< at the start of the step in the direction of flow [stress]
  R rate_scale;      ///< 1 / (rate0 dt), 0 where rate terms are off (rate_scale())
  R plastic_strain;  ///< at the start of the step [-]
};

/// Result of a return.
template <class R>
struct ReturnOf {
  R stress{};             ///< equivalent stress at the end [stress]
  R plastic_increment{};  ///< of the equivalent plastic strain [-]
  R mean_stress{};        ///< mean flow stress over plastic_increment [stress]
  MaskOf<R> converged{};
};

/// A return under way.
template <class Strength, class R>
struct ReturnSearchOf {
  typename Strength::template KnownOf<R> known;  ///< of Y, the same for every x
  R x, low, high;                                ///< plastic increment and what encloses it [-]
  R last_step;
  typename Strength::template KeptOf<R> kept;  ///< of Y at the last x of a point that is done
  MaskOf<R> elastic, done;
  typename Strength::template EvaluationOf<R> y;  ///< at the last x
};

/// What makes rate / rate0 of a plastic increment; dt = 0 switches rate terms off.
template <class R>
BARRENO_FUNCTION R rate_scale(const R& dt, double reference_rate) {
  return real::select(dt > 0.0, 1.0 / (dt * reference_rate), 0.0);
}
/// ln max(rate / rate0, 1) of a plastic increment [-].
template <class R>
BARRENO_FUNCTION R log_rate(const R& plastic_increment, const R& rate_scale) {
  return real::log(real::larger(R(plastic_increment * rate_scale), 1.0));
}

/// Bracket and first guess.
template <class Strength, class R>
BARRENO_FUNCTION void begin_return(
    const Strength& strength,
    const R& temperature,
    const ReturnProblemOf<R>& problem,
    ReturnSearchOf<Strength, R>& search
) {
  const R& plastic_strain = problem.plastic_strain;
  search.known = strength.known(temperature, plastic_strain);
  const R static_stress = search.known.static_stress;
  search.elastic = !(problem.trial > static_stress);
  search.done = search.elastic;
  search.low = R{};
  search.high = (problem.trial - static_stress) * (1.0 / strength.stiffness);
  // While flow continues the point starts at the flow stress, and all of the step's strain is
  // plastic but for hardening.
  const R x = (problem.trial - problem.start) * plastic_strain /
              (strength.stiffness * plastic_strain + search.known.hardening);
  search.x = real::select((x > 0.0) & (x < search.high), x, search.high);
  search.last_step = R{} + HUGE_VAL;
  search.y = strength.start(problem, search.known);
  search.kept = strength.kept_of(search.y);
}

/// The search ends where the bracket has no width; else `halved` points go to its middle, in the
/// logarithm of x.
template <class Strength, class R>
BARRENO_FUNCTION void bisect(
    const Strength& strength,
    const MaskOf<R>& halved,
    const R& trial,
    ReturnSearchOf<Strength, R>& search
) {
  // Width of the bracket that ends the search, as a fraction of the trial stress.
  constexpr double tolerance = 1e-14;
  const R width = search.high - search.low;
  const MaskOf<R> narrow = width <= (tolerance / strength.stiffness) * trial;
  if (real::any(halved)) {
    const R middle =
        real::select(search.low > 0.0, real::sqrt(R(search.low * search.high)), 1e-3 * search.high);
    search.x = real::select(halved & !narrow, middle, search.x);
    search.last_step = real::select(halved, width, search.last_step);
  }
  search.done = search.done | narrow;
}

/// One evaluation and the step that follows from it: Halley's (third order). A step that leaves the
/// bracket or does not shrink is replaced by bisection in the logarithm of x, since with a small n
/// or a large C the root may be many decades below the upper end, and since steps may jump to and
/// fro over the kink of Y at rate0. From 1e-3 of x on a step leaves C / 3 of its relative size to
/// the third power: less than 1e-10 of the stress.
template <class Strength, class R>
BARRENO_FUNCTION void take_step(
    const Strength& strength, const ReturnProblemOf<R>& problem, ReturnSearchOf<Strength, R>& search
) {
  const R x = search.x;
  const MaskOf<R> done = search.done;
  const auto y = strength.evaluate(x, problem, search.known, search.y);
  search.y = y;
  // What a point that is done had; its lane goes on with the others.
  search.kept = select_points(done, search.kept, strength.kept_of(y));
  const R residual = problem.trial - strength.stiffness * x - y.static_stress * y.rate_factor;
  const MaskOf<R> below = residual > 0.0;
  search.low = real::select(below, x, search.low);
  search.high = real::select(below, search.high, x);
  const R slope = strength.stiffness + y.slope;
  const R step = residual * slope / (slope * slope - 0.5 * residual * y.curvature);
  const R next = x + step;
  const R size = real::abs(step);
  const MaskOf<R> sound =
      (next >= search.low) & (next <= search.high) & (size < 0.5 * search.last_step);
  search.x = real::select(done | !sound, x, next);
  search.last_step = size;
  search.done = done | (sound & (size <= 1e-3 * x));
  const MaskOf<R> going_on = !search.done;
  if (real::any(going_on)) bisect(strength, MaskOf<R>(going_on & !sound), problem.trial, search);
}

template <class Strength, class R>
BARRENO_FUNCTION void search_return(
    const Strength& strength,
    const R& temperature,
    const ReturnProblemOf<R>& problem,
    ReturnSearchOf<Strength, R>& search
) {
  constexpr int max_iterations = 80;
  begin_return(strength, temperature, problem, search);
  for (int i = 0; i < max_iterations && !real::all(search.done); ++i)
    take_step(strength, problem, search);
}

template <class Strength, class R>
BARRENO_FUNCTION ReturnOf<R> end_return(
    const Strength& strength,
    const ReturnProblemOf<R>& problem,
    const ReturnSearchOf<Strength, R>& search
) {
  // A point that was flowing starts at its old flow stress, not at that of the new rate and heat; a
  // tenth tells it from a point that was elastic and yields within the step.
  const R start_stress = strength.start_stress(search.known, search.kept);
  const R excess = problem.start - start_stress;
  const R mean = strength.mean_stress(problem, search.known, search.kept, search.x) +
                 real::select(excess > -0.1 * start_stress, 0.5 * excess, 0.0);
  return {
      real::select(search.elastic, problem.trial, problem.trial - strength.stiffness * search.x),
      real::select(search.elastic, 0.0, search.x),
      real::select(search.elastic, 0.0, mean),
      search.done};
}

}  // namespace barreno::metal
