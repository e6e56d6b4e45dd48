// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <cmath>

namespace barreno {

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
  struct Return {
    double stress = 0.0;             ///< equivalent stress at the end [stress]
    double plastic_increment = 0.0;  ///< of the equivalent plastic strain [-]
    double mean_stress = 0.0;        ///< mean flow stress over plastic_increment [stress]
    bool converged = true;
  };

  /// T* [-].
  BARRENO_FUNCTION double homologous(double temperature) const {
    const double t = (temperature - room_temperature) * inverse_melting_range;
    return t > 0.0 ? t : 0.0;
  }
  /// 1 - T*^m [-].
  BARRENO_FUNCTION double softening(double temperature) const {
    const double t = homologous(temperature);
    if (t >= 1.0) return 0.0;
    if (t == 0.0) return 1.0;
    return m == 1.0 ? 1.0 - t : 1.0 - std::pow(t, m);
  }
  /// ln max(rate / rate0, 1) of a plastic increment [-]; dt = 0 switches rate terms off.
  BARRENO_FUNCTION double log_rate(double plastic_increment, double dt) const {
    const double ratio = plastic_increment / (dt * reference_rate);
    return dt > 0.0 && ratio > 1.0 ? std::log(ratio) : 0.0;
  }
  /// Y [stress].
  BARRENO_FUNCTION double stress(double plastic_strain, double rate, double temperature) const {
    return (a + b * std::pow(plastic_strain, n)) *
           (1.0 + c * (rate > reference_rate ? std::log(rate / reference_rate) : 0.0)) *
           softening(temperature);
  }
  /// A stress that Y never falls below, without pow and log, to recognise clearly elastic points
  /// [stress]: ep^n >= min(ep, 1) for n <= 1, and 1 - T*^m >= min(1, m) (1 - T*).
  BARRENO_FUNCTION double lower_bound(double plastic_strain, double temperature) const {
    const double t = homologous(temperature);
    if (t >= 1.0) return 0.0;
    const double hardening = n <= 1.0 ? b * (plastic_strain < 1.0 ? plastic_strain : 1.0) : 0.0;
    const double softened = t > 0.0 ? (m < 1.0 ? m : 1.0) * (1.0 - t) : 1.0;
    return (a + hardening) * softened;
  }

  BARRENO_FUNCTION Return return_to_flow_stress(
      double trial, double start, double dt, double temperature, double plastic_strain
  ) const;

private:
  /// Y and its derivatives in the plastic increment, at one x.
  struct Evaluation {
    double x, inverse_x, inverse_ep;    ///< ep is that at the end, plastic_strain + x
    double power, logarithm;            ///< ep^n, ln max(rate / rate0, 1) [-]
    double static_stress, rate_factor;  ///< Y is their product
    double slope, curvature;            ///< dY/dx and -d2Y/dx2
  };
  /// @param near an evaluation at another x, made use of if it is close
  BARRENO_FUNCTION Evaluation evaluate(
      double x,
      double plastic_strain,
      double inverse_reference,
      double theta,
      const Evaluation& near
  ) const {
    Evaluation y{};
    y.x = x;
    y.inverse_x = 1.0 / x;
    y.inverse_ep = 1.0 / (plastic_strain + x);
    const double change = x - near.x, w = change * near.inverse_ep, v = change * near.inverse_x;
    y.power =
        std::fabs(w) <= 0.002 ? near.power * power_near_one(w) : std::pow(plastic_strain + x, n);
    if (near.logarithm > 0.0 && std::fabs(v) <= 0.005) {
      y.logarithm = near.logarithm + log_near_one(v);
    } else if (inverse_reference > 0.0) {
      y.logarithm = std::log(x * inverse_reference);
    }
    if (!(y.logarithm > 0.0)) y.logarithm = 0.0;
    y.rate_factor = 1.0 + c * y.logarithm;
    y.static_stress = theta * (a + b * y.power);
    const double hardening = theta * b * n * y.power * y.inverse_ep;
    const double rating = y.logarithm > 0.0 ? c * y.inverse_x : 0.0;
    y.slope = hardening * y.rate_factor + y.static_stress * rating;
    y.curvature = hardening * ((1.0 - n) * y.inverse_ep * y.rate_factor - 2.0 * rating) +
                  y.static_stress * rating * y.inverse_x;
    return y;
  }
  /// (1 + w)^n for |w| <= 0.002: the binomial series to w^5, exact to round-off.
  BARRENO_FUNCTION double power_near_one(double w) const {
    double sum = 1.0 + (n - 4.0) * 0.2 * w;
    sum = 1.0 + (n - 3.0) * 0.25 * w * sum;
    sum = 1.0 + (n - 2.0) * (1.0 / 3.0) * w * sum;
    sum = 1.0 + (n - 1.0) * 0.5 * w * sum;
    return 1.0 + n * w * sum;
  }
  /// ln(1 + y) for |y| <= 0.005: the power series to y^6, exact to round-off.
  BARRENO_FUNCTION static double log_near_one(double y) {
    return y * (1.0 - y * (0.5 - y * (1.0 / 3.0 - y * (0.25 - y * (0.2 - y * (1.0 / 6.0))))));
  }
};

/// Solve trial - 3G x = Y(plastic_strain + x, x / dt, temperature) for the plastic increment x.
///
/// The left side falls and the right side rises with x: the root is single, and lies between 0 and
/// (trial - Y(x = 0)) / 3G. Halley steps (third order); a step that leaves the bracket or does not
/// shrink is replaced by bisection in the logarithm of x, since with a small n or a large C the
/// root may be many decades below the upper end, and since steps may jump to and fro over the kink
/// of Y at rate0. Powers and logarithms next to known ones come from short series: they would be
/// most of the cost otherwise.
/// @param trial equivalent stress of the elastic trial [stress]
/// @param start equivalent stress at the start of the step in the direction of flow [stress]
/// @param plastic_strain at the start of the step [-]
BARRENO_FUNCTION JohnsonCookFlow::Return JohnsonCookFlow::return_to_flow_stress(
    double trial, double start, double dt, double temperature, double plastic_strain
) const {
  const double theta = softening(temperature);
  if (theta == 0.0) return {0.0, trial / stiffness, start > 0.0 ? 0.5 * start : 0.0, true};
  const double power_start = std::pow(plastic_strain, n);
  const double static_stress = (a + b * power_start) * theta;
  if (trial <= static_stress) return {trial, 0.0, 0.0, true};

  // Width of the bracket that ends the search, as a fraction of the trial stress.
  constexpr double tolerance = 1e-14;
  const double compliance = 1.0 / stiffness;
  const double inverse_reference = dt > 0.0 ? 1.0 / (dt * reference_rate) : 0.0;
  double low = 0.0, high = (trial - static_stress) * compliance;
  Evaluation y{};
  y.power = power_start;
  y.inverse_ep = plastic_strain > 0.0 ? 1.0 / plastic_strain : HUGE_VAL;
  // While flow continues the point starts at the flow stress, and all of the step's strain is
  // plastic but for hardening.
  const double hardening = plastic_strain > 0.0 ? theta * b * n * power_start * y.inverse_ep : 0.0;
  double x = (trial - start) / (stiffness + hardening);
  if (!(x > 0.0 && x < high)) x = high;
  double last_step = HUGE_VAL;
  bool converged = false;
  for (int i = 0; i < 80 && !converged; ++i) {
    y = evaluate(x, plastic_strain, inverse_reference, theta, y);
    const double residual = trial - stiffness * x - y.static_stress * y.rate_factor;
    (residual > 0.0 ? low : high) = x;
    const double slope = stiffness + y.slope;
    const double step = residual * slope / (slope * slope - 0.5 * residual * y.curvature);
    const double next = x + step;
    const bool sound = next >= low && next <= high && std::fabs(step) < 0.5 * last_step;
    // A step leaves C / 3 of its relative size to the third power: less than 1e-10 of the stress.
    converged =
        (sound && std::fabs(step) <= 1e-3 * x) || high - low <= tolerance * trial * compliance;
    if (sound) {
      last_step = std::fabs(step);
      x = next;
    } else if (!converged) {
      last_step = high - low;
      x = low > 0.0 ? std::sqrt(low * high) : 1e-3 * high;
    }
  }
  // ep^n integrates exactly; the trapezoid serves where the exact mean would cancel.
  const double end = plastic_strain + x;
  const double mean_power = x < 0.1 * end
                                ? 0.5 * (power_start + y.power)
                                : (end * y.power - plastic_strain * power_start) / ((n + 1.0) * x);
  // A point that was flowing starts at its old flow stress, not at that of the new rate and heat; a
  // tenth tells it from a point that was elastic and yields within the step.
  const double start_stress = static_stress * y.rate_factor, excess = start - start_stress;
  const double mean = (a + b * mean_power) * theta * y.rate_factor +
                      (excess > -0.1 * start_stress ? 0.5 * excess : 0.0);
  return {trial - stiffness * x, x, mean, converged};
}

}  // namespace barreno
