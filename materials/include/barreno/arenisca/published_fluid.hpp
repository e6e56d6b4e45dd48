// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/root_finding.hpp"
#include "barreno/portability.hpp"

#include <cmath>

namespace barreno::arenisca {

/// The pore fluid as the published reference code has it, for calibrations made against that code
/// (`Undrained moduli` = "arenisca3"). Differences to PoreFluid, all of them kept: the saturated
/// modulus subtracts phi/Km twice and leaves out B1; the rate of zeta,
///
///   d zeta/d evp = 3 Kf Km exp(evp) / (exp(evp) (Kf + Km) - S Km - F Kf),  0 beyond evp = ev0,
///   S = (1 - phi_i) exp(zeta/3Km),  F = phi_i exp(p_i/Kf + zeta/3Kf),
///
/// belongs to exp(evp) = S + F, which does not hold at the start if p_i > 0.
struct PublishedFluid {
  static constexpr int knots = 257;

  double bulk = 0.0;  ///< Kf, 0: not this form [stress]
  double matrix = 0.0, initial_pressure = 0.0, porosity = 0.0;
  double end = 0.0;                   ///< ev0, where the fluid is without pressure
  double first = 0.0, spacing = 0.0;  ///< evp of the first knot, and between knots
  double value[knots] = {};           ///< zeta at the knots [stress]

  BARRENO_FUNCTION bool present() const { return bulk > 0.0; }

  BARRENO_FUNCTION double rate(double evp, double zeta) const {
    const double grown = std::exp(evp);
    const double solid = (1.0 - porosity) * std::exp(zeta / (3.0 * matrix));
    const double fluid = porosity * std::exp((3.0 * initial_pressure + zeta) / (3.0 * bulk));
    return 3.0 * bulk * matrix * grown / (grown * (bulk + matrix) - solid * matrix - fluid * bulk);
  }

  /// Cubic between the knots with the exact rates at them.
  BARRENO_FUNCTION double zeta(double evp) const {
    const double bounded = smaller(larger(evp, first), end);
    const double place = (bounded - first) / spacing;
    const int i = static_cast<int>(smaller(larger(std::floor(place), 0.0), knots - 2.0));
    const double t = place - i;
    const double a = value[i], b = value[i + 1];
    const double da = spacing * rate(first + i * spacing, a);
    const double db = spacing * rate(first + (i + 1) * spacing, b);
    const double u = 1.0 - t;
    return u * u * (1.0 + 2.0 * t) * a + t * t * (3.0 - 2.0 * t) * b + u * u * t * da -
           t * t * u * db;
  }

  BARRENO_FUNCTION double porosity_at(double evp) const {
    const double c1 = bulk * (1.0 - porosity) + matrix * porosity;
    const double pore = std::exp(evp * matrix / c1) * porosity;
    return pore / (std::exp(evp * bulk / c1) * (1.0 - porosity) + pore);
  }
  BARRENO_FUNCTION double saturated(const Elasticity& elasticity, double evp) const {
    const double drained = elasticity.B0 - elasticity.coupling(-1.0, evp);
    const double phi = porosity_at(evp);
    const double alpha = 1.0 - drained / matrix;
    return drained + alpha * alpha / ((alpha - phi) / matrix + phi * (1.0 / bulk - 1.0 / matrix));
  }
  BARRENO_FUNCTION Moduli moduli(const Elasticity& elasticity, double x, double evp) const {
    Moduli m = elasticity.moduli_at(x, evp);
    if (evp <= end) m.bulk = saturated(elasticity, evp);
    return m;
  }
  BARRENO_FUNCTION double strength(const Elasticity& elasticity, double dry, double evp) const {
    if (evp > end) return dry;
    // B1 even when dilated, as in that code.
    const double fit = elasticity.B0 - elasticity.coupling(-1.0, evp) +
                       elasticity.B1 * std::exp(2.0 * elasticity.B2 / dry);
    return dry * saturated(elasticity, evp) / fit;
  }
};

/// Tabulates zeta by the classical Runge-Kutta method, many steps between knots.
inline PublishedFluid make_published_fluid(
    double bulk, double matrix, double initial_pressure, double porosity
) {
  PublishedFluid f;
  f.bulk = bulk;
  f.matrix = matrix;
  f.initial_pressure = initial_pressure;
  f.porosity = porosity;
  f.end = (bulk * (1.0 - porosity) + matrix * porosity) * initial_pressure / (bulk * matrix);
  // Beyond this compaction the pores would be closed by the fluid's own stiffness.
  const double farthest = std::log1p(-porosity);
  f.first = farthest;
  f.spacing = (f.end - farthest) / (PublishedFluid::knots - 1);
  constexpr int steps = 200;
  const auto advance = [&](double from, double to, double zeta) {
    const double h = (to - from) / steps;
    for (int i = 0; i < steps; ++i) {
      const double e = from + i * h;
      const double k1 = f.rate(e, zeta), k2 = f.rate(e + 0.5 * h, zeta + 0.5 * h * k1);
      const double k3 = f.rate(e + 0.5 * h, zeta + 0.5 * h * k2), k4 = f.rate(e + h, zeta + h * k3);
      zeta += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
    return zeta;
  };
  const double start = -3.0 * initial_pressure;
  const int middle =
      static_cast<int>(std::floor(-farthest / f.spacing));  // last knot at or below evp = 0
  double zeta = start, e = 0.0;
  for (int i = middle; i >= 0; --i) {
    zeta = advance(e, f.first + i * f.spacing, zeta);
    e = f.first + i * f.spacing;
    f.value[i] = zeta;
  }
  zeta = start;
  e = 0.0;
  for (int i = middle + 1; i < PublishedFluid::knots; ++i) {
    zeta = advance(e, f.first + i * f.spacing, zeta);
    e = f.first + i * f.spacing;
    f.value[i] = zeta;
  }
  return f;
}

}  // namespace barreno::arenisca
