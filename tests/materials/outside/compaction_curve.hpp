// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

namespace barreno::arenisca::outside {

/// A crush curve that closes all pores at a pressure of its own: in terms of the open part of the
/// pore strain, f = 1 + evp/p3,
///
///   evp <= 0:  X = Xs - (Xs - p0) sqrt(f)          f = ((Xs - X)/(Xs - p0))^2
///   evp >  0:  X = p0 (1 + evp)^m                  dilation retracts the cap; C1 at evp = 0
///
/// Source: the quadratic compaction of W. Herrmann, Constitutive equation for the dynamic
/// compaction of ductile porous materials, J. Appl. Phys. 40 (1969), in strains instead of
/// densities. p0 and p3 are the published parameters.
struct CompactionCurve {
  struct Parameters {
    double solid_pressure;
  };
  static ParameterTable<Parameters> parameter_table() {
    return {
        {optional(
            &Parameters::solid_pressure,
            "Solid pressure",
            dimension::stress,
            at_least(0.0),
            0.0,
            "pressure at which all pores are closed, -Xs/3; 0: the published crush curve"
        )},
        {}};
  }
  static constexpr const char* word = "Solid pressure";
  template <class P>
  static bool asked(const P& p) {
    return p.solid_pressure > 0.0;
  }
  template <class P>
  static std::string check(const P& p) {
    if (!asked(p) || (p.p3_crush_curve > 0.0 && -3.0 * p.solid_pressure < p.p0_crush_curve))
      return {};
    return named("Solid pressure", p.solid_pressure) +
           " must exceed the pressure at which crushing begins, -p0_crush_curve/3, in rock with "
           "pores; raise it.";
  }
  /// A sound card with it.
  template <class P>
  static void ask(P& p) {
    p.solid_pressure = 1.5e9;
  }

  double p0 = 0.0, p3 = 0.0, Xs = 0.0;
  double per_p3 = 0.0, power = 0.0;

  CompactionCurve() = default;
  template <class P>
  explicit CompactionCurve(const P& p)
      : p0(p.p0_crush_curve), p3(p.p3_crush_curve), Xs(-3.0 * p.solid_pressure) {
    if (p3 == 0.0) return;
    per_p3 = 1.0 / p3;
    power = 0.5 * (p0 - Xs) * per_p3 / p0;
  }

  template <class R>
  BARRENO_FUNCTION CrushedOf<R> at(const R& evp) const {
    CrushedOf<R> c{none_of<R>()};
    if (p3 == 0.0) return c;
    const R left = 1.0 + per_p3 * evp;
    c.open = left > CrushCurve::closed_fraction;
    const R root = real::sqrt(R(real::select(c.open, left, 1.0)));
    c.X = Xs - (Xs - p0) * root;
    c.slope = 0.5 * (p0 - Xs) * per_p3 / root;
    const MaskOf<R> dilates = evp > 0.0;
    if (!real::any(dilates)) return c;
    const R volume = real::select(dilates, 1.0 + evp, 1.0);
    const R ratio =
        real::larger(real::exp(R(power * real::log(volume))), CrushCurve::retraction_limit);
    c.X = real::select(dilates, p0 * ratio, c.X);
    c.slope = real::select(dilates, p0 * power * ratio / volume, c.slope);
    return c;
  }
  BARRENO_FUNCTION bool porous() const { return p3 != 0.0; }
  BARRENO_FUNCTION bool has_cap(double evp) const { return at(evp).open; }
  BARRENO_FUNCTION double last_open() const {
    return -p3 * (1.0 - 1.001 * CrushCurve::closed_fraction);
  }
  BARRENO_FUNCTION double closed() const { return -p3; }
};

}  // namespace barreno::arenisca::outside
