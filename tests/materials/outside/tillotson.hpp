// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

namespace barreno::metal::outside {

/// Equation of state of metals that shocks may vaporise. With h = rho / rho0, mu = h - 1 and E the
/// energy per reference volume, w = 1 / (E / (E0 h^2) + 1):
///
///   compressed or cold:       p_c = (a + b w) h E + A mu + B mu^2
///   expanded and vaporised:   p_e = a h E + (b w h E + A mu exp(-beta (1/h - 1))) exp(-alpha (1/h
///   - 1)^2)
///
/// and, where expanded, linear in E between both from the energy at which vaporisation begins to
/// that at which it ends. The pressure is not linear in the energy: the update takes it so about
/// the energy of the pass before.
///
/// Source: J. H. Tillotson, Metallic equations of state for hypervelocity impact, General Atomic
/// GA-3216, 1962. Temperature: dT/T = -(dp/dE) d(V / V_ref) with a constant specific heat, an
/// addition.
struct Tillotson {
  static constexpr const char* name = "Tillotson";
  static constexpr const char* summary = "Tillotson pressure";
  static constexpr int passes = 4;
  struct Parameters {
    double specific_heat = 0.0;
    double gas = 0.0, solid = 0.0, energy = 0.0, linear = 0.0, square = 0.0;
    double alpha = 0.0, beta = 0.0, begins = 0.0, ends = 0.0;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {required(
             &P::specific_heat, "Specific Heat", d::heat_capacity, above(0.0), "heat capacity"
         ),
         required(&P::gas, "Tillotson a", d::none, above(0.0), "a, of the gas"),
         required(&P::solid, "Tillotson b", d::none, at_least(0.0), "b, of the solid"),
         required(&P::energy, "Tillotson E0", d::specific_energy, above(0.0), "E0"),
         required(&P::linear, "Tillotson A", d::stress, above(0.0), "A, the bulk modulus"),
         required(&P::square, "Tillotson B", d::stress, at_least(0.0), "B"),
         required(&P::alpha, "Tillotson alpha", d::none, at_least(0.0), "alpha"),
         required(&P::beta, "Tillotson beta", d::none, at_least(0.0), "beta"),
         required(
             &P::begins,
             "Vaporisation Begins",
             d::specific_energy,
             above(0.0),
             "energy at which it begins"
         ),
         required(
             &P::ends,
             "Vaporisation Ends",
             d::specific_energy,
             above(0.0),
             "energy at which it ends"
         )},
        {}};
  }
  static BulkModulus bulk(const Parameters& p, double /*density*/) {
    return {p.linear, "Tillotson A", "both"};
  }
  static std::string check(const Parameters& p) {
    if (p.ends > p.begins) return "";
    std::ostringstream text;
    text << "Vaporisation Ends = " << p.ends
         << " does not exceed Vaporisation Begins = " << p.begins
         << " (both are energies per mass of the expanded metal); exchange them.";
    return text.str();
  }
  /// Copper: a to B as in the source; alpha, beta and vaporisation as of other metals.
  static void example(Parameters& p) {
    p = {383.0, 0.5, 1.5, 32.5e6, 139e9, 110e9, 5.0, 5.0, 1.38e6, 6.9e6};
  }
  static Tillotson make(const Parameters& p, double density) { return {p, density}; }

  Parameters p;
  double density;

  BARRENO_FUNCTION double bulk_modulus() const { return p.linear; }
  template <class R>
  BARRENO_FUNCTION MaskOf<R> allows(const R& eta, const R& change) const {
    return (eta < 0.9) & ((1.0 - eta) + 0.5 * (p.gas + p.solid) * change > 0.0);
  }

  template <class R>
  struct ReferenceOf {
    R pressure, per_energy, derivative;  // p at no energy on the tangent; dp/dE, dp/d eta
  };
  template <class R>
  BARRENO_FUNCTION ReferenceOf<R> at(const R& eta, const R& E) const {
    const double E0 = density * p.energy;
    const R v = 1.0 - eta, h = 1.0 / v, mu = h - 1.0, t = v - 1.0;
    const R z = E / (E0 * h * h), w = 1.0 / (z + 1.0);
    const R bound = p.solid * w * h * E;  // and its derivatives in E and h
    const R bound_E = p.solid * h * w * w, bound_h = p.solid * E * w * (1.0 + 2.0 * w * z);
    const R cold = (p.gas * h) * E + bound + mu * (p.linear + p.square * mu);
    const R cold_E = p.gas * h + bound_E;
    const R cold_h = p.gas * E + bound_h + p.linear + 2.0 * p.square * mu;
    const MaskOf<R> expanded = (v > 1.0) & (E > density * p.begins);
    ReferenceOf<R> r{cold, cold_E, cold_h};
    if (real::any(expanded)) {
      const R fade = real::exp(R(-p.alpha * t * t)), tear = real::exp(R(-p.beta * t));
      const R inner = bound + p.linear * mu * tear;
      const R hot = (p.gas * h) * E + inner * fade;
      const R hot_E = p.gas * h + bound_E * fade;
      // dv/dh = -v^2
      const R inner_h = bound_h + p.linear * tear * (1.0 + p.beta * mu * v * v);
      const R hot_h = p.gas * E + fade * (inner_h + 2.0 * p.alpha * t * v * v * inner);
      const double range = 1.0 / (density * (p.ends - p.begins));
      const R share = real::smaller(R((E - density * p.begins) * range), 1.0);
      const R share_E = real::select(share < 1.0, R{} + range, 0.0);
      r.pressure = real::select(expanded, cold + share * (hot - cold), r.pressure);
      r.per_energy = real::select(
          expanded, cold_E + share * (hot_E - cold_E) + share_E * (hot - cold), r.per_energy
      );
      r.derivative = real::select(expanded, cold_h + share * (hot_h - cold_h), r.derivative);
    }
    r.derivative = r.derivative * h * h;
    r.pressure = r.pressure - r.per_energy * E;
    return r;
  }
  template <class R>
  BARRENO_FUNCTION R per_energy(const ReferenceOf<R>& at) const {
    return at.per_energy;
  }
  BARRENO_FUNCTION double pressure(double eta, double energy) const {
    const auto r = at(eta, density * energy);
    return r.pressure + r.per_energy * (density * energy);
  }
  template <class R>
  BARRENO_FUNCTION R
  isentropic_modulus(const R& eta, const ReferenceOf<R>& at, const R& pressure_now) const {
    return (1.0 - eta) * (at.derivative + at.per_energy * pressure_now);
  }
  template <class R>
  BARRENO_FUNCTION R isentropic_temperature_ratio(
      const ReferenceOf<R>& at, const R& change, const R& /*implicit*/
  ) const {
    return real::exp(R(-at.per_energy * change));
  }
  /// Newton's method from the cold state.
  template <class R>
  BARRENO_FUNCTION R relaxed_compression(const R& energy) const {
    const R E = density * energy;
    R eta{};
    for (int i = 0; i < 8; ++i) {
      const auto r = at(eta, E);
      eta = eta - (r.pressure + r.per_energy * E) / r.derivative;
    }
    return eta;
  }
  double largest_porous_expansion() const { return 1.0 + 2.0 / (p.gas + p.solid); }

  /// dE/d eta = p on the isentrope, by the classical method of Runge and Kutta; its pressure by
  /// Newton's.
  IsentropeState isentrope_at(double asked) const {
    if (!(asked >= 0.0 && asked < 0.5 * p.linear)) return {};
    double eta = asked / p.linear;
    IsentropeState state = isentrope(eta);
    for (int i = 0; i < 50; ++i) {
      const double now = pressure(eta, state.energy / density);
      const auto r = at(eta, state.energy);
      const double step = (asked - now) / (r.derivative + r.per_energy * now);
      eta += step;
      state = isentrope(eta);
      if (std::fabs(step) <= 1e-15 * eta) break;
    }
    return state;
  }
  IsentropeState isentrope(double eta) const {
    constexpr int steps = 64;
    const double d = eta / steps;
    double E = 0.0, log_T = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double x = i * d;
      const auto p_at = [&](double y, double e) { return pressure(y, e / density); };
      const double k1 = p_at(x, E), k2 = p_at(x + 0.5 * d, E + 0.5 * d * k1);
      const double k3 = p_at(x + 0.5 * d, E + 0.5 * d * k2), k4 = p_at(x + d, E + d * k3);
      log_T += d * at(x + 0.5 * d, E + 0.5 * d * k2).per_energy;
      E += d / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return {true, eta, E, std::exp(log_T)};
  }
};

}  // namespace barreno::metal::outside
