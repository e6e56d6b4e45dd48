// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/outcome.hpp"
#include "barreno/symmetric_functions.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace barreno {

/// Compressible neo-Hookean solid, the law of the manufactured solutions (docs/verification.md).
///
///   sigma = [lambda ln J I + mu (B - I)] / J,   W = lambda/2 (ln J)^2 - mu ln J + mu/2 (tr B - 3)
///
/// lambda = K - 2G/3, mu = G, W per reference volume. In the unrotated frame B is C = U^2, which
/// the history holds as Green's strain; J is the volume ratio of the increment. Stress and energy
/// are functions of the two, so that no path gains energy from the law.
///
/// C is not told by the host but follows the strain increment d:
///
///   C <- U exp(2 d') U,   d' = d - (w d - d w)/2,   w U + U w = U d - d U
///
/// w is the spin dU/dt U^-1 has beside its symmetric part d; d' is d turned back from the middle of
/// the step to its start. Exact where d and U share axes, else an error of the third power of the
/// strain of a step. det C = J^2 to round-off.
/// @par Source  T. Belytschko, W. Liu, B. Moran, Nonlinear Finite Elements, 2000, section 5.4 (law)
struct NeoHookean {
  static constexpr const char* name = "Neo-Hookean";
  static constexpr const char* summary = "Compressible neo-Hookean elasticity.";
  struct Parameters {
    double bulk_modulus, shear_modulus;
  };
  struct History {
    Sym3 green_strain;  ///< E = (C - I) / 2
  };
  static constexpr int history_count = 6;

  static ParameterTable<Parameters> parameter_table() {
    return {
        {required(
             &Parameters::bulk_modulus,
             "Bulk Modulus",
             dimension::stress,
             above(0.0),
             "bulk modulus K of the undeformed material, at least 2/3 G"
         ),
         required(
             &Parameters::shear_modulus,
             "Shear Modulus",
             dimension::stress,
             above(0.0),
             "shear modulus G of the undeformed material"
         )},
        {}};
  }
  static std::vector<HistoryField> history_table() {
    const char* const meaning = "Green's strain (U^2 - I) / 2, F = R U";
    return {
        {"green_strain_xx", dimension::none, meaning},
        {"green_strain_yy", dimension::none, meaning},
        {"green_strain_zz", dimension::none, meaning},
        {"green_strain_xy", dimension::none, meaning},
        {"green_strain_yz", dimension::none, meaning},
        {"green_strain_zx", dimension::none, meaning}};
  }

  /// lambda < 0 softens under pressure; round-off of a Poisson's ratio of zero is allowed.
  static std::string check(const Parameters& p, double /*density*/) {
    constexpr double round_off = 1e-6;
    if (p.bulk_modulus >= (1.0 - round_off) * 2.0 / 3.0 * p.shear_modulus) return {};
    std::ostringstream text;
    text << "Bulk Modulus = " << p.bulk_modulus
         << " is below 2/3 of Shear Modulus = " << p.shear_modulus
         << " (Poisson's ratio would be negative, and the law unstable under pressure); raise it.";
    return text.str();
  }

  NeoHookean(const Parameters& p, double /*density*/)
      : p_(p), lambda_(std::fmax(p.bulk_modulus - 2.0 / 3.0 * p.shear_modulus, 0.0)) {}

  History initial_history() const { return {}; }

  /// Isotropic stretch that holds the pressure: p J = mu (1 - J^(2/3)) - lambda ln J, by bisection
  /// in ln J, which is exact to round-off and cannot fail.
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    double lower = -1.0;
    while (-mean_stress(lower) < pressure) lower *= 2.0;
    double upper = 0.0;
    for (int i = 0; i < 200 && pressure > 0.0; ++i) {
      const double middle = 0.5 * (lower + upper);
      (-mean_stress(middle) < pressure ? upper : lower) = middle;
    }
    const double volume_strain = pressure > 0.0 ? 0.5 * (lower + upper) : 0.0;
    const History start{isotropic(0.5 * std::expm1(2.0 / 3.0 * volume_strain))};
    return {
        isotropic(-pressure), start, std::exp(volume_strain), energy(start, volume_strain), true};
  }

  /// @param[in]     increment strain, dt and volume ratios of the step
  /// @param[in,out] stress    unrotated Cauchy stress [stress]
  /// @param[in,out] history   as in history_table()
  /// @return bad_input for values that are not finite or volume ratios that are not positive
  BARRENO_FUNCTION Outcome
  update(const Increment& increment, Sym3& stress, History& history) const {
    const double begin = std::log(increment.volume_ratio_begin);
    const double end = std::log(increment.volume_ratio_end);
    const History stretched{history.green_strain + 0.5 * growth(history, increment.strain)};
    const Sym3 result = stress_of(stretched, end);
    Outcome outcome;
    outcome.elastic_work = energy(stretched, end) - energy(history, begin);
    outcome.longitudinal_modulus = modulus(stretched, end);
    if (!std::isfinite(outcome.elastic_work) || !std::isfinite(outcome.longitudinal_modulus) ||
        !is_finite(result)) {
      outcome = Outcome{};
      outcome.status = Status::bad_input;
      return outcome;
    }
    stress = result;
    history = stretched;
    return outcome;
  }

  /// Bound on K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& /*stress*/, const History& h, double volume_ratio
  ) const {
    return modulus(h, std::log(volume_ratio));
  }
  const Parameters& parameters() const { return p_; }
  double lambda() const { return lambda_; }

private:
  double mean_stress(double volume_strain) const {
    return (lambda_ * volume_strain + p_.shear_modulus * std::expm1(2.0 / 3.0 * volume_strain)) *
           std::exp(-volume_strain);
  }

  /// Change of C over a step; exactly zero without strain.
  BARRENO_FUNCTION static Sym3 growth(const History& history, const Sym3& d) {
    const Sym3 u = square_root(isotropic(1.0) + 2.0 * history.green_strain);
    const Mat3 ud = product(full(u), full(d));
    // Vectors of the skew tensors: w of U d - d U = U d - (U d)^T, and (tr U I - U) times that of
    // the spin.
    const double right[3] = {ud(2, 1) - ud(1, 2), ud(0, 2) - ud(2, 0), ud(1, 0) - ud(0, 1)};
    const Mat3 solve = full(inverse(isotropic(trace(u)) - u));
    double spin[3];
    for (int i = 0; i < 3; ++i)
      spin[i] = solve(i, 0) * right[0] + solve(i, 1) * right[1] + solve(i, 2) * right[2];
    const Mat3 w{{{0.0, -spin[2], spin[1]}, {spin[2], 0.0, -spin[0]}, {-spin[1], spin[0], 0.0}}};
    // (w d - d w)/2 is the symmetric part of w d.
    const Sym3 at_start = d - symmetric_part(product(w, full(d)));
    return congruent(u, exponential_less_one(2.0 * at_start));
  }

  BARRENO_FUNCTION Sym3 stress_of(const History& h, double volume_strain) const {
    return std::exp(-volume_strain) *
           (isotropic(lambda_ * volume_strain) + (2.0 * p_.shear_modulus) * h.green_strain);
  }
  BARRENO_FUNCTION double energy(const History& h, double volume_strain) const {
    return volume_strain * (0.5 * lambda_ * volume_strain - p_.shear_modulus) +
           p_.shear_modulus * trace(h.green_strain);
  }
  /// Plane waves along a principal axis: [lambda (1 - ln J) + mu (1 + b)] / J with the largest b of
  /// B, bounded by tr B / 3 + 2 (J2 / 3)^(1/2).
  BARRENO_FUNCTION double modulus(const History& h, double volume_strain) const {
    const double j2 = second_invariant(deviator(h.green_strain));
    const double largest = 1.0 + 2.0 * (trace(h.green_strain) / 3.0 + 2.0 * std::sqrt(j2 / 3.0));
    return std::exp(-volume_strain) *
           (lambda_ * std::fmax(1.0 - volume_strain, 0.0) + p_.shear_modulus * (1.0 + largest));
  }

  Parameters p_;
  double lambda_;
};

}  // namespace barreno
