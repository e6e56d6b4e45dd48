// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"
#include "barreno/real.hpp"

#include <cmath>

namespace barreno {

/// (1 + w)^n for small w by the binomial series to w^11, exact to round-off: its terms are at most
/// (1/16)^k / k, and (n w)^k / k! for n > 1.
struct PowerNearOne {
  static constexpr int pairs = 6;
  double even[pairs] = {}, odd[pairs] = {};  ///< coefficients of w^0, w^2, ... and of w, w^3, ...
  double limit;                              ///< of |w|

  BARRENO_FUNCTION explicit PowerNearOne(double n) : limit(1.0 / (16.0 * (n > 1.0 ? n : 1.0))) {
    double coefficient = 1.0;
    for (int k = 0; k < 2 * pairs; ++k) {
      (k % 2 == 0 ? even : odd)[k / 2] = coefficient;
      coefficient *= (n - k) / (k + 1.0);
    }
  }
  template <class R>
  BARRENO_FUNCTION R operator()(const R& w) const {
    return real::even_odd_sum(even, odd, w);
  }
};

/// Johnson-Cook flow stress and the return of an equivalent stress to it.
///
///   Y(ep, rate, T) = (A + B ep^n) (1 + C ln max(rate / rate0, 1)) (1 - T*^m)
///   T* = (T - T_room) / (T_melt - T_room), at least 0; Y = 0 from T_melt on
///
/// @par Source  Johnson & Cook, 7th Int. Symp. Ballistics, The Hague, 1983, 541-547
struct JohnsonCookFlow {
  double a, b, c, n, m;          ///< A, B [stress]; C, n, m [-]
  double reference_rate;         ///< rate0 [1/time]
  double room_temperature;       ///< T_room [temperature]
  double inverse_melting_range;  ///< 1 / (T_melt - T_room) [1/temperature]
  double stiffness;              ///< 3G [stress]
  /// (1 + w)^n, with its coefficients found once
  PowerNearOne power_near_one = PowerNearOne(n);

  /// Result of a return.
  template <class R>
  struct ReturnOf {
    R stress{};             ///< equivalent stress at the end [stress]
    R plastic_increment{};  ///< of the equivalent plastic strain [-]
    R mean_stress{};        ///< mean flow stress over plastic_increment [stress]
    MaskOf<R> converged{};
  };
  using Return = ReturnOf<double>;

  /// T* [-].
  template <class R>
  BARRENO_FUNCTION R homologous(const R& temperature) const {
    return real::larger(R((temperature - room_temperature) * inverse_melting_range), 0.0);
  }
  /// 1 - T*^m [-].
  template <class R>
  BARRENO_FUNCTION R softening(const R& temperature) const {
    const R t = homologous(temperature);
    return real::select(t < 1.0, 1.0 - (m == 1.0 ? t : real::pow(t, m)), 0.0);
  }
  /// What makes rate / rate0 of a plastic increment; dt = 0 switches rate terms off.
  template <class R>
  BARRENO_FUNCTION R rate_scale(const R& dt) const {
    return real::select(dt > 0.0, 1.0 / (dt * reference_rate), 0.0);
  }
  /// ln max(rate / rate0, 1) of a plastic increment [-].
  template <class R>
  BARRENO_FUNCTION static R log_rate(const R& plastic_increment, const R& rate_scale) {
    return real::log(real::larger(R(plastic_increment * rate_scale), 1.0));
  }
  /// Y [stress].
  BARRENO_FUNCTION double stress(double plastic_strain, double rate, double temperature) const {
    return (a + b * std::pow(plastic_strain, n)) *
           (1.0 + c * (rate > reference_rate ? std::log(rate / reference_rate) : 0.0)) *
           softening(temperature);
  }
  /// A stress that Y never falls below, without pow and log, to recognise clearly elastic points
  /// [stress]: ep^n >= min(ep, 1) for n <= 1, and 1 - T*^m >= min(1, m) (1 - T*).
  template <class R>
  BARRENO_FUNCTION R lower_bound(const R& plastic_strain, const R& temperature) const {
    const R t = homologous(temperature);
    const R hardening = n <= 1.0 ? b * real::smaller(plastic_strain, 1.0) : R{};
    const R softened = real::select(t > 0.0, (m < 1.0 ? m : 1.0) * (1.0 - t), R{} + 1.0);
    return real::select(t < 1.0, (a + hardening) * softened, 0.0);
  }

  /// What a return needs beside its temperature.
  template <class R>
  struct ProblemOf {
    R trial;           ///< equivalent stress of the elastic trial [stress]
    R start;           ///< at the start of the step in the direction of flow [stress]
    R rate_scale;      ///< 1 / (rate0 dt), 0 where rate terms are off (rate_scale())
    R plastic_strain;  ///< at the start of the step [-]
  };
  /// Y and its derivatives in the plastic increment, at one x.
  template <class R>
  struct Evaluation {
    R x, inverse_x, inverse_end;   ///< end: plastic_strain + x
    R power, logarithm;            ///< end^n, ln max(rate / rate0, 1) [-]
    R static_stress, rate_factor;  ///< Y is their product
    R slope, curvature;            ///< dY/dx and -d2Y/dx2
  };
  /// A return under way.
  template <class R>
  struct SearchOf {
    R theta, power_start;  ///< 1 - T*^m and plastic_strain^n, which stay
    R x, low, high;        ///< plastic increment and what encloses it [-]
    R last_step;
    R power, rate_factor;  ///< at the last x of a point that is done
    MaskOf<R> elastic, done;
    Evaluation<R> y;
  };

  template <class R>
  BARRENO_FUNCTION ReturnOf<R> return_to_flow_stress(
      const R& trial, const R& start, const R& dt, const R& temperature, const R& plastic_strain
  ) const;
  template <class R>
  BARRENO_FUNCTION void begin_return(
      const R& temperature, const ProblemOf<R>& problem, SearchOf<R>& search
  ) const;
  template <class R>
  BARRENO_FUNCTION void take_step(const ProblemOf<R>& problem, SearchOf<R>& search) const;
  template <class R>
  BARRENO_FUNCTION void take_steps(const ProblemOf<R>& problem, SearchOf<R>& search) const;
  template <class R>
  BARRENO_FUNCTION void bisect(const MaskOf<R>& halved, const R& trial, SearchOf<R>& search) const;
  template <class R>
  BARRENO_FUNCTION ReturnOf<R> end_return(const ProblemOf<R>& problem, const SearchOf<R>& search)
      const;

private:
  static constexpr int max_iterations = 80;
  /// end^n. @param near an evaluation at another x, of which a series starts if it is close
  template <class R>
  BARRENO_FUNCTION R power_of(const R& end, const R& change, const Evaluation<R>& near) const {
    const R w = change * near.inverse_end;
    const MaskOf<R> far = !(real::abs(w) <= power_near_one.limit);
    if (!real::any(far)) return near.power * power_near_one(w);
    const R power = real::pow(end, n);
    if (real::all(far)) return power;
    return real::select(far, power, near.power * power_near_one(w));
  }
  /// ln max(rate / rate0, 1) in the same way.
  template <class R>
  BARRENO_FUNCTION R
  logarithm_of(const R& x, const R& rate_scale, const R& change, const Evaluation<R>& near) const {
    const R v = change * near.inverse_x;
    const MaskOf<R> far = !((near.logarithm > 0.0) & (real::abs(v) <= log_limit));
    R logarithm{};
    if (!real::all(far)) logarithm = real::larger(R(near.logarithm + log_near_one(v)), 0.0);
    if (!real::any(far)) return logarithm;
    return real::select(far, log_rate(x, rate_scale), logarithm);
  }
  /// @param near an evaluation at another x, made use of where it is close
  template <class R>
  BARRENO_FUNCTION Evaluation<R> evaluate(
      const R& x, const ProblemOf<R>& problem, const R& theta, const Evaluation<R>& near
  ) const {
    Evaluation<R> y;
    const R end = problem.plastic_strain + x;
    const R inverse = 1.0 / (x * end);
    y.x = x;
    y.inverse_x = end * inverse;
    y.inverse_end = x * inverse;
    const R change = x - near.x;
    y.power = power_of(end, change, near);
    y.logarithm = logarithm_of(x, problem.rate_scale, change, near);
    y.rate_factor = 1.0 + c * y.logarithm;
    y.static_stress = theta * (a + b * y.power);
    const R hardening = theta * (b * n) * y.power * y.inverse_end;
    const R rating = real::select(y.logarithm > 0.0, c * y.inverse_x, 0.0);
    y.slope = hardening * y.rate_factor + y.static_stress * rating;
    y.curvature = hardening * ((1.0 - n) * y.inverse_end * y.rate_factor - 2.0 * rating) +
                  y.static_stress * rating * y.inverse_x;
    return y;
  }
  /// ln(1 + v) for |v| <= log_limit: the power series to v^12, exact to round-off.
  static constexpr double log_limit = 1.0 / 16.0;
  template <class R>
  BARRENO_FUNCTION static R log_near_one(const R& v) {
    constexpr double even[] = {1.0, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11};
    constexpr double odd[] = {-1.0 / 2, -1.0 / 4, -1.0 / 6, -1.0 / 8, -1.0 / 10, -1.0 / 12};
    return v * real::even_odd_sum(even, odd, v);
  }
  /// Mean of Y over the increment.
  template <class R>
  BARRENO_FUNCTION R
  mean_flow_stress(const ProblemOf<R>& problem, const SearchOf<R>& search) const {
    // ep^n integrates exactly; the trapezoid serves where the exact mean would cancel.
    const R& x = search.x;
    const R end = problem.plastic_strain + x;
    const MaskOf<R> is_long = !(x < 0.1 * end);
    R mean_power = 0.5 * (search.power_start + search.power);
    if (real::any(is_long))
      mean_power = real::select(
          is_long,
          (end * search.power - problem.plastic_strain * search.power_start) / ((n + 1.0) * x),
          mean_power
      );
    return (a + b * mean_power) * search.theta * search.rate_factor;
  }
};

/// Solve trial - 3G x = Y(plastic_strain + x, x / dt, temperature) for the plastic increment x.
///
/// The left side falls and the right side rises with x: the root is single, and lies between 0 and
/// (trial - Y(x = 0)) / 3G. Halley steps (third order); a step that leaves the bracket or does not
/// shrink is replaced by bisection in the logarithm of x, since with a small n or a large C the
/// root may be many decades below the upper end, and since steps may jump to and fro over the kink
/// of Y at rate0. From 1e-3 of x on a step leaves C / 3 of its relative size to the third power:
/// less than 1e-10 of the stress.
/// @param trial equivalent stress of the elastic trial [stress]
/// @param start equivalent stress at the start of the step in the direction of flow [stress]
/// @param plastic_strain at the start of the step [-]
template <class R>
BARRENO_FUNCTION JohnsonCookFlow::ReturnOf<R> JohnsonCookFlow::return_to_flow_stress(
    const R& trial, const R& start, const R& dt, const R& temperature, const R& plastic_strain
) const {
  const ProblemOf<R> problem{trial, start, rate_scale(dt), plastic_strain};
  SearchOf<R> search;
  begin_return(temperature, problem, search);
  take_steps(problem, search);
  return end_return(problem, search);
}

/// Bracket and first guess.
template <class R>
BARRENO_FUNCTION void JohnsonCookFlow::begin_return(
    const R& temperature, const ProblemOf<R>& problem, SearchOf<R>& search
) const {
  const R& plastic_strain = problem.plastic_strain;
  search.theta = softening(temperature);
  search.power_start = real::pow(plastic_strain, n);
  const R static_stress = (a + b * search.power_start) * search.theta;
  search.elastic = !(problem.trial > static_stress);
  search.done = search.elastic;
  search.low = R{};
  search.high = (problem.trial - static_stress) * (1.0 / stiffness);
  // While flow continues the point starts at the flow stress, and all of the step's strain is
  // plastic but for hardening.
  const R hardening = search.theta * (b * n) * search.power_start;  // times the plastic strain
  const R x =
      (problem.trial - problem.start) * plastic_strain / (stiffness * plastic_strain + hardening);
  search.x = real::select((x > 0.0) & (x < search.high), x, search.high);
  search.last_step = R{} + HUGE_VAL;
  search.power = search.power_start;
  search.rate_factor = R{} + 1.0;
  search.y = Evaluation<R>{};
  search.y.power = search.power_start;
  search.y.inverse_end = 1.0 / plastic_strain;
}

/// One evaluation and the step that follows from it.
template <class R>
BARRENO_FUNCTION void JohnsonCookFlow::take_step(const ProblemOf<R>& problem, SearchOf<R>& search)
    const {
  const R x = search.x;
  const MaskOf<R> done = search.done;
  const Evaluation<R> y = evaluate(x, problem, search.theta, search.y);
  search.y = y;
  // What a point that is done had; its lane goes on with the others.
  search.power = real::select(done, search.power, y.power);
  search.rate_factor = real::select(done, search.rate_factor, y.rate_factor);
  const R residual = problem.trial - stiffness * x - y.static_stress * y.rate_factor;
  const MaskOf<R> below = residual > 0.0;
  search.low = real::select(below, x, search.low);
  search.high = real::select(below, search.high, x);
  const R slope = stiffness + y.slope;
  const R step = residual * slope / (slope * slope - 0.5 * residual * y.curvature);
  const R next = x + step;
  const R size = real::abs(step);
  const MaskOf<R> sound =
      (next >= search.low) & (next <= search.high) & (size < 0.5 * search.last_step);
  search.x = real::select(done | !sound, x, next);
  search.last_step = size;
  search.done = done | (sound & (size <= 1e-3 * x));
  const MaskOf<R> going_on = !search.done;
  if (real::any(going_on)) bisect(MaskOf<R>(going_on & !sound), problem.trial, search);
}

/// The search ends where the bracket has no width; else `halved` points go to its middle, in the
/// logarithm of x.
template <class R>
BARRENO_FUNCTION void JohnsonCookFlow::bisect(
    const MaskOf<R>& halved, const R& trial, SearchOf<R>& search
) const {
  // Width of the bracket that ends the search, as a fraction of the trial stress.
  constexpr double tolerance = 1e-14;
  const R width = search.high - search.low;
  const MaskOf<R> narrow = width <= (tolerance / stiffness) * trial;
  if (real::any(halved)) {
    const R middle =
        real::select(search.low > 0.0, real::sqrt(R(search.low * search.high)), 1e-3 * search.high);
    search.x = real::select(halved & !narrow, middle, search.x);
    search.last_step = real::select(halved, width, search.last_step);
  }
  search.done = search.done | narrow;
}

template <class R>
BARRENO_FUNCTION void JohnsonCookFlow::take_steps(const ProblemOf<R>& problem, SearchOf<R>& search)
    const {
  for (int i = 0; i < max_iterations && !real::all(search.done); ++i) take_step(problem, search);
}

template <class R>
BARRENO_FUNCTION JohnsonCookFlow::ReturnOf<R> JohnsonCookFlow::end_return(
    const ProblemOf<R>& problem, const SearchOf<R>& search
) const {
  // A point that was flowing starts at its old flow stress, not at that of the new rate and heat; a
  // tenth tells it from a point that was elastic and yields within the step.
  const R start_stress = (a + b * search.power_start) * search.theta * search.rate_factor;
  const R excess = problem.start - start_stress;
  const R mean = mean_flow_stress(problem, search) +
                 real::select(excess > -0.1 * start_stress, 0.5 * excess, 0.0);
  return {
      real::select(search.elastic, problem.trial, problem.trial - stiffness * search.x),
      real::select(search.elastic, 0.0, search.x),
      real::select(search.elastic, 0.0, mean),
      search.done};
}

}  // namespace barreno
