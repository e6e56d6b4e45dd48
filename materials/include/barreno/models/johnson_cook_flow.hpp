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
  /// ln max(rate / rate0, 1) of a plastic increment [-]; dt = 0 switches rate terms off.
  template <class R>
  BARRENO_FUNCTION R log_rate(const R& plastic_increment, const R& dt) const {
    const MaskOf<R> rated = dt > 0.0;
    const R ratio = plastic_increment / (real::select(rated, dt, 1.0) * reference_rate);
    return real::log(real::larger(R(real::select(rated, ratio, 1.0)), 1.0));
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

  template <class R>
  BARRENO_FUNCTION ReturnOf<R> return_to_flow_stress(
      const R& trial, const R& start, const R& dt, const R& temperature, const R& plastic_strain
  ) const;

private:
  /// Y and its derivatives in the plastic increment, at one x.
  template <class R>
  struct Evaluation {
    R x, inverse_x, inverse_end;   ///< end: plastic_strain + x
    R power, logarithm;            ///< end^n, ln max(rate / rate0, 1) [-]
    R static_stress, rate_factor;  ///< Y is their product
    R slope, curvature;            ///< dY/dx and -d2Y/dx2
  };
  /// @param near an evaluation at another x, made use of where it is close
  template <class R>
  BARRENO_FUNCTION Evaluation<R> evaluate(
      const R& x,
      const R& plastic_strain,
      const R& dt,
      const R& theta,
      const PowerNearOne& power_near_one,
      const Evaluation<R>& near
  ) const {
    Evaluation<R> y;
    const R end = plastic_strain + x;
    const R inverse = 1.0 / (x * end);
    y.x = x;
    y.inverse_x = end * inverse;
    y.inverse_end = x * inverse;
    const R change = x - near.x;
    const R w = change * near.inverse_end;
    const MaskOf<R> far_end = !(real::abs(w) <= power_near_one.limit);
    y.power = near.power * power_near_one(w);
    if (real::any(far_end)) y.power = real::select(far_end, real::pow(end, n), y.power);
    const R v = change * near.inverse_x;
    const MaskOf<R> far_rate = !((near.logarithm > 0.0) & (real::abs(v) <= log_limit));
    y.logarithm = real::larger(R(near.logarithm + log_near_one(v)), 0.0);
    if (real::any(far_rate)) y.logarithm = real::select(far_rate, log_rate(x, dt), y.logarithm);
    y.rate_factor = 1.0 + c * y.logarithm;
    y.static_stress = theta * (a + b * y.power);
    const R hardening = theta * b * n * y.power * y.inverse_end;
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
  BARRENO_FUNCTION R mean_flow_stress(
      const R& x,
      const R& plastic_strain,
      const R& power_start,
      const R& power,
      const R& theta,
      const R& rate_factor
  ) const {
    // ep^n integrates exactly; the trapezoid serves where the exact mean would cancel.
    const R end = plastic_strain + x;
    const MaskOf<R> is_long = !(x < 0.1 * end);
    R mean_power = 0.5 * (power_start + power);
    if (real::any(is_long))
      mean_power = real::select(
          is_long, (end * power - plastic_strain * power_start) / ((n + 1.0) * x), mean_power
      );
    return (a + b * mean_power) * theta * rate_factor;
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
  const R theta = softening(temperature);
  const R power_start = real::pow(plastic_strain, n);
  const R static_stress = (a + b * power_start) * theta;
  const MaskOf<R> elastic = !(trial > static_stress);

  // Width of the bracket that ends the search, as a fraction of the trial stress.
  constexpr double tolerance = 1e-14;
  const double compliance = 1.0 / stiffness;
  R low{};
  R high = (trial - static_stress) * compliance;
  // While flow continues the point starts at the flow stress, and all of the step's strain is
  // plastic but for hardening.
  const R hardening = theta * b * n * power_start;  // times the plastic strain
  R x = (trial - start) * plastic_strain / (stiffness * plastic_strain + hardening);
  x = real::select((x > 0.0) & (x < high), x, high);
  R last_step = R{} + HUGE_VAL;
  R power = power_start;
  R rate_factor = R{} + 1.0;
  MaskOf<R> done = elastic;
  const PowerNearOne power_near_one(n);
  Evaluation<R> y{};
  y.power = power_start;
  y.inverse_end = 1.0 / plastic_strain;
  constexpr int max_iterations = 80;
  for (int i = 0; i < max_iterations && !real::all(done); ++i) {
    y = evaluate(x, plastic_strain, dt, theta, power_near_one, y);
    // What a point that is done had; its lane goes on with the others.
    power = real::select(done, power, y.power);
    rate_factor = real::select(done, rate_factor, y.rate_factor);
    const R residual = trial - stiffness * x - y.static_stress * y.rate_factor;
    low = real::select((!done) & (residual > 0.0), x, low);
    high = real::select((!done) & !(residual > 0.0), x, high);
    const R slope = stiffness + y.slope;
    const R step = residual * slope / (slope * slope - 0.5 * residual * y.curvature);
    const R next = x + step;
    const R size = real::abs(step);
    const MaskOf<R> sound = (next >= low) & (next <= high) & (size < 0.5 * last_step);
    const R middle = real::select(low > 0.0, real::sqrt(R(low * high)), 1e-3 * high);
    const MaskOf<R> ends =
        (sound & (size <= 1e-3 * x)) | (high - low <= tolerance * compliance * trial);
    last_step = real::select(sound, size, high - low);
    const R improved = real::select(sound, next, real::select(ends, x, middle));
    x = real::select(done, x, improved);
    done = done | ends;
  }
  // A point that was flowing starts at its old flow stress, not at that of the new rate and heat; a
  // tenth tells it from a point that was elastic and yields within the step.
  const R start_stress = static_stress * rate_factor;
  const R excess = start - start_stress;
  const R mean = mean_flow_stress(x, plastic_strain, power_start, power, theta, rate_factor) +
                 real::select(excess > -0.1 * start_stress, 0.5 * excess, 0.0);
  return {
      real::select(elastic, trial, trial - stiffness * x),
      real::select(elastic, 0.0, x),
      real::select(elastic, 0.0, mean),
      done};
}

}  // namespace barreno
