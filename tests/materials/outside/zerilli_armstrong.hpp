// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace barreno::metal::outside {

/// Flow stress of face-centred cubic metals from the motion of dislocations, a strength:
///
///   Y(ep, rate, T) = C0 + C2 sqrt(ep) exp(-C3 T + C4 T ln max(rate / rate0, 1)),   0 from T_melt
///   on
///
/// Source: F. J. Zerilli and R. W. Armstrong, Dislocation-mechanics-based constitutive relations
/// for material dynamics calculations, J. Appl. Phys. 61 (1987) 1816-1825, with rate0 = 1/s. The
/// melting point, and that slower rates count as rate0, are additions.
struct ZerilliArmstrong {
  static constexpr const char* name = "Zerilli-Armstrong";
  static constexpr const char* summary = "Zerilli-Armstrong flow stress";
  struct Parameters {
    double shear_modulus = 0.0, c0 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0;
    double reference_rate = 1.0, room_temperature = 294.0, melt_temperature = 0.0;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    constexpr Dimension per_kelvin{0, 0, 0, -1};
    return {
        {required(&P::shear_modulus, "Shear Modulus", d::stress, above(0.0), "shear modulus G"),
         required(&P::c0, "C0", d::stress, at_least(0.0), "yield stress at no plastic strain"),
         required(&P::c2, "C2", d::stress, at_least(0.0), "hardening coefficient"),
         required(&P::c3, "C3", per_kelvin, at_least(0.0), "thermal softening"),
         required(&P::c4, "C4", per_kelvin, at_least(0.0), "rate coefficient"),
         optional(&P::reference_rate, "Reference Strain Rate", d::rate, above(0.0), 1.0, "rate0"),
         optional(
             &P::room_temperature,
             "Room Temperature",
             d::temperature,
             above(0.0),
             294.0,
             "temperature at the start"
         ),
         required(
             &P::melt_temperature,
             "Melt Temperature",
             d::temperature,
             above(0.0),
             "no strength at or above it"
         )},
        {}};
  }
  static std::vector<PlausibleRange> plausible_ranges() {
    return {{"Shear Modulus", 1e6, 1e12}, {"C0", 1e4, 2e10}, {"Melt Temperature", 200.0, 1e12}};
  }
  static std::string check(const Parameters& p, const BulkModulus& bulk) {
    return check_solid(p.shear_modulus, p.room_temperature, p.melt_temperature, bulk);
  }
  /// Copper, as in the source.
  static void example(Parameters& p) {
    p.shear_modulus = 47.7e9;
    p.c0 = 65e6;
    p.c2 = 890e6;
    p.c3 = 0.0028;
    p.c4 = 0.000115;
    p.melt_temperature = 1356.0;
  }
  template <class R>
  using HistoryOf = PlasticStrainOf<R>;
  static std::vector<HistoryField> history_table() { return plastic_strain_table(); }
  static ZerilliArmstrong make(const Parameters& p) {
    return {p, 3.0 * p.shear_modulus, p.reference_rate};
  }

  Parameters p;
  double stiffness;  // 3G
  double reference_rate;

  template <class R>
  BARRENO_FUNCTION R homologous(const R& temperature) const {
    const double range = p.melt_temperature - p.room_temperature;
    return real::larger(R((temperature - p.room_temperature) / range), 0.0);
  }
  BARRENO_FUNCTION double stress(double plastic_strain, double rate, double temperature) const {
    const double logarithm = rate > p.reference_rate ? std::log(rate / p.reference_rate) : 0.0;
    if (temperature >= p.melt_temperature) return 0.0;
    return p.c0 +
           p.c2 * std::sqrt(plastic_strain) * std::exp(temperature * (p.c4 * logarithm - p.c3));
  }
  template <class R>
  BARRENO_FUNCTION R lower_bound(const R& /*plastic_strain*/, const R& temperature) const {
    return real::select(temperature < p.melt_temperature, R{} + p.c0, 0.0);
  }

  template <class R>
  struct KnownOf {
    R yield, factor, power;  // C0, C2 exp(-C3 T), 0 if molten; C4 T
    R static_stress, hardening;
  };
  template <class R>
  struct EvaluationOf {
    R static_stress, rate_factor, slope, curvature;  // Y is a product with 1
    R speed;                                         // exp(C4 T ln max(rate / rate0, 1))
  };
  template <class R>
  struct KeptOf {
    R speed;
  };
  template <class R>
  BARRENO_FUNCTION static KeptOf<R> kept_of(const EvaluationOf<R>& y) {
    return {y.speed};
  }
  template <class R>
  BARRENO_FUNCTION KnownOf<R> known(const R& temperature, const R& plastic_strain) const {
    const MaskOf<R> solid = temperature < p.melt_temperature;
    KnownOf<R> k;
    k.yield = real::select(solid, R{} + p.c0, 0.0);
    k.factor = real::select(solid, p.c2 * real::exp(R(-p.c3 * temperature)), 0.0);
    k.power = p.c4 * temperature;
    const R hardened = k.factor * real::sqrt(plastic_strain);
    k.static_stress = k.yield + hardened;
    k.hardening = 0.5 * hardened;
    return k;
  }
  template <class R>
  BARRENO_FUNCTION EvaluationOf<R> start(
      const ReturnProblemOf<R>& /*problem*/, const KnownOf<R>& /*known*/
  ) const {
    EvaluationOf<R> y{};
    y.speed = R{} + 1.0;
    return y;
  }
  template <class R>
  BARRENO_FUNCTION EvaluationOf<R> evaluate(
      const R& x,
      const ReturnProblemOf<R>& problem,
      const KnownOf<R>& known,
      const EvaluationOf<R>& /*near*/
  ) const {
    const R end = problem.plastic_strain + x;
    const R logarithm = log_rate(x, problem.rate_scale);
    EvaluationOf<R> y;
    y.speed = real::exp(R(known.power * logarithm));
    y.rate_factor = R{} + 1.0;
    const R hardened = known.factor * real::sqrt(end) * y.speed;
    y.static_stress = known.yield + hardened;
    const R hardens = 0.5 / end, rates = real::select(logarithm > 0.0, known.power / x, 0.0);
    y.slope = hardened * (hardens + rates);
    y.curvature =
        hardened * (2.0 * hardens * hardens + rates / x - (hardens + rates) * (hardens + rates));
    return y;
  }
  template <class R>
  BARRENO_FUNCTION R start_stress(const KnownOf<R>& known, const KeptOf<R>& kept) const {
    return known.yield + 2.0 * known.hardening * kept.speed;
  }
  template <class R>
  BARRENO_FUNCTION R mean_stress(
      const ReturnProblemOf<R>& problem, const KnownOf<R>& known, const KeptOf<R>& kept, const R& x
  ) const {
    // The mean of the square root: 2/3 of (first^2 + first last + last^2) / (first + last).
    const R first = real::sqrt(problem.plastic_strain);
    const R last = real::sqrt(R(problem.plastic_strain + x));
    const R mean = (first * first + first * last + last * last) / (1.5 * (first + last));
    return known.yield + known.factor * kept.speed * mean;
  }
};

}  // namespace barreno::metal::outside
