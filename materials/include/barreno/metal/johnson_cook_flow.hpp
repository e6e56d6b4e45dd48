// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/metal/part.hpp"
#include "barreno/metal/radial_return.hpp"

#include <cmath>
#include <string>
#include <vector>

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

/// Johnson-Cook flow stress, a strength (list.hpp).
///
///   Y(ep, rate, T) = (A + B ep^n) (1 + C ln max(rate / rate0, 1)) (1 - T*^m)
///   T* = (T - T_room) / (T_melt - T_room), at least 0; Y = 0 from T_melt on
///
/// @par Source  Johnson & Cook, 7th Int. Symp. Ballistics, The Hague, 1983, 541-547
struct JohnsonCookFlow {
  static constexpr const char* name = "Johnson-Cook";
  static constexpr const char* summary = "Johnson-Cook flow stress";
  struct Parameters {
    double shear_modulus = 0.0;
    double a = 0.0, b = 0.0, c = 0.0, n = 1.0, m = 1.0;
    double reference_rate = 1.0;
    double room_temperature = 294.0, melt_temperature = 0.0;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace dim = dimension;
    return {
        {required(&P::shear_modulus, "Shear Modulus", dim::stress, above(0.0), "shear modulus G"),
         required(&P::a, "A", dim::stress, at_least(0.0), "yield stress at no plastic strain"),
         required(&P::b, "B", dim::stress, at_least(0.0), "hardening coefficient"),
         required(&P::c, "C", dim::none, at_least(0.0), "rate coefficient"),
         required(&P::n, "n", dim::none, at_least(0.0), "hardening exponent"),
         required(&P::m, "m", dim::none, above(0.0), "thermal softening exponent"),
         optional(
             &P::reference_rate,
             "Reference Strain Rate",
             dim::rate,
             above(0.0),
             1.0,
             "plastic strain rate up to which A and B apply"
         ),
         optional(
             &P::room_temperature,
             "Room Temperature",
             dim::temperature,
             above(0.0),
             294.0,
             "temperature at the start; below it there is no thermal hardening"
         ),
         required(
             &P::melt_temperature,
             "Melt Temperature",
             dim::temperature,
             above(0.0),
             "no strength at or above it"
         )},
        {}};
  }
  /// Elements and alloys: Johnson and Cook 1983; Steinberg 1996, UCRL-MA-106439. Metals melt from
  /// 234 K on (mercury); a high number turns thermal softening off.
  static std::vector<PlausibleRange> plausible_ranges() {
    return {
        {"Shear Modulus", 1e6, 1e12},
        {"A", 1e4, 2e10},
        {"B", 1e4, 2e10},
        {"Reference Strain Rate", 1e-6, 1e8},
        {"Room Temperature", 1.0, 3000.0},
        {"Melt Temperature", 200.0, 1e12}};
  }
  static std::string check(const Parameters& p, const metal::BulkModulus& bulk) {
    std::ostringstream text;
    text << metal::check_solid(p.shear_modulus, p.room_temperature, p.melt_temperature, bulk);
    if (text.str().empty() && p.a > p.shear_modulus) {
      text << "A = " << p.a << " exceeds Shear Modulus = " << p.shear_modulus
           << " (the metal would yield at strains above 1/3); check the units of both.";
    }
    return text.str();
  }
  template <class R>
  using HistoryOf = metal::PlasticStrainOf<R>;
  static std::vector<HistoryField> history_table() { return metal::plastic_strain_table(); }
  static JohnsonCookFlow make(const Parameters& p) {
    return {
        p.a,
        p.b,
        p.c,
        p.n,
        p.m,
        p.reference_rate,
        p.room_temperature,
        1.0 / (p.melt_temperature - p.room_temperature),
        3.0 * p.shear_modulus};
  }

  double a, b, c, n, m;          ///< A, B [stress]; C, n, m [-]
  double reference_rate;         ///< rate0 [1/time]
  double room_temperature;       ///< T_room [temperature]
  double inverse_melting_range;  ///< 1 / (T_melt - T_room) [1/temperature]
  double stiffness;              ///< 3G [stress]
  /// (1 + w)^n, with its coefficients found once
  PowerNearOne power_near_one = PowerNearOne(n);

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

  /// What stays during a return.
  template <class R>
  struct KnownOf {
    R theta, power;   ///< 1 - T*^m and plastic_strain^n
    R static_stress;  ///< Y at no plastic increment and no rate [stress]
    R hardening;      ///< its derivative times the plastic strain [stress]
  };
  /// Y and its derivatives in the plastic increment, at one x.
  template <class R>
  struct EvaluationOf {
    R x, inverse_x, inverse_end;   ///< end: plastic_strain + x
    R power, logarithm;            ///< end^n, ln max(rate / rate0, 1) [-]
    R static_stress, rate_factor;  ///< Y is their product
    R slope, curvature;            ///< dY/dx and -d2Y/dx2
  };
  /// What the mean of Y needs of an evaluation.
  template <class R>
  struct KeptOf {
    R power, rate_factor;
  };
  template <class R>
  BARRENO_FUNCTION static KeptOf<R> kept_of(const EvaluationOf<R>& y) {
    return {y.power, y.rate_factor};
  }

  template <class R>
  BARRENO_FUNCTION KnownOf<R> known(const R& temperature, const R& plastic_strain) const {
    KnownOf<R> k;
    k.theta = softening(temperature);
    k.power = real::pow(plastic_strain, n);
    k.static_stress = (a + b * k.power) * k.theta;
    k.hardening = k.theta * (b * n) * k.power;
    return k;
  }
  /// At x = 0, as far as series may start from there.
  template <class R>
  BARRENO_FUNCTION EvaluationOf<R> start(
      const metal::ReturnProblemOf<R>& problem, const KnownOf<R>& known
  ) const {
    EvaluationOf<R> y{};
    y.power = known.power;
    y.rate_factor = R{} + 1.0;
    y.inverse_end = 1.0 / problem.plastic_strain;
    return y;
  }
  /// @param near an evaluation at another x, made use of where it is close
  template <class R>
  BARRENO_FUNCTION EvaluationOf<R> evaluate(
      const R& x,
      const metal::ReturnProblemOf<R>& problem,
      const KnownOf<R>& known,
      const EvaluationOf<R>& near
  ) const {
    EvaluationOf<R> y;
    const R end = problem.plastic_strain + x;
    const R inverse = 1.0 / (x * end);
    y.x = x;
    y.inverse_x = end * inverse;
    y.inverse_end = x * inverse;
    const R change = x - near.x;
    y.power = power_of(end, change, near);
    y.logarithm = logarithm_of(x, problem.rate_scale, change, near);
    y.rate_factor = 1.0 + c * y.logarithm;
    y.static_stress = known.theta * (a + b * y.power);
    const R hardening = known.theta * (b * n) * y.power * y.inverse_end;
    const R rating = real::select(y.logarithm > 0.0, c * y.inverse_x, 0.0);
    y.slope = hardening * y.rate_factor + y.static_stress * rating;
    y.curvature = hardening * ((1.0 - n) * y.inverse_end * y.rate_factor - 2.0 * rating) +
                  y.static_stress * rating * y.inverse_x;
    return y;
  }
  /// Y at x = 0 with the rate of the step [stress].
  template <class R>
  BARRENO_FUNCTION R start_stress(const KnownOf<R>& known, const KeptOf<R>& kept) const {
    return (a + b * known.power) * known.theta * kept.rate_factor;
  }
  /// Mean of Y over the increment [stress].
  template <class R>
  BARRENO_FUNCTION R mean_stress(
      const metal::ReturnProblemOf<R>& problem,
      const KnownOf<R>& known,
      const KeptOf<R>& kept,
      const R& x
  ) const {
    // ep^n integrates exactly; the trapezoid serves where the exact mean would cancel.
    const R end = problem.plastic_strain + x;
    const MaskOf<R> is_long = !(x < 0.1 * end);
    R mean_power = 0.5 * (known.power + kept.power);
    if (real::any(is_long))
      mean_power = real::select(
          is_long,
          (end * kept.power - problem.plastic_strain * known.power) / ((n + 1.0) * x),
          mean_power
      );
    return (a + b * mean_power) * known.theta * kept.rate_factor;
  }

private:
  /// end^n. @param near an evaluation at another x, of which a series starts if it is close
  template <class R>
  BARRENO_FUNCTION R power_of(const R& end, const R& change, const EvaluationOf<R>& near) const {
    const R w = change * near.inverse_end;
    const MaskOf<R> far = !(real::abs(w) <= power_near_one.limit);
    if (!real::any(far)) return near.power * power_near_one(w);
    const R power = real::pow(end, n);
    if (real::all(far)) return power;
    return real::select(far, power, near.power * power_near_one(w));
  }
  /// ln max(rate / rate0, 1) in the same way.
  template <class R>
  BARRENO_FUNCTION R logarithm_of(
      const R& x, const R& rate_scale, const R& change, const EvaluationOf<R>& near
  ) const {
    const R v = change * near.inverse_x;
    const MaskOf<R> far = !((near.logarithm > 0.0) & (real::abs(v) <= log_limit));
    R logarithm{};
    if (!real::all(far)) logarithm = real::larger(R(near.logarithm + log_near_one(v)), 0.0);
    if (!real::any(far)) return logarithm;
    return real::select(far, metal::log_rate(x, rate_scale), logarithm);
  }
  /// ln(1 + v) for |v| <= log_limit: the power series to v^12, exact to round-off.
  static constexpr double log_limit = 1.0 / 16.0;
  template <class R>
  BARRENO_FUNCTION static R log_near_one(const R& v) {
    constexpr double even[] = {1.0, 1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11};
    constexpr double odd[] = {-1.0 / 2, -1.0 / 4, -1.0 / 6, -1.0 / 8, -1.0 / 10, -1.0 / 12};
    return v * real::even_odd_sum(even, odd, v);
  }
};

}  // namespace barreno
