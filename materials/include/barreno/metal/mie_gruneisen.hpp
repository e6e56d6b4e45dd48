// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/metal/part.hpp"
#include "barreno/portability.hpp"
#include "barreno/real.hpp"
#include "barreno/select_members.hpp"

#include <cmath>
#include <string>

namespace barreno {

/// What a solid and a liquid give of their Hugoniot and of their heat.
struct HugoniotParameters {
  double specific_heat = 0.0;
  double sound_speed = 0.0, slope = 0.0, gamma = 0.0;
};
inline ParameterTable<HugoniotParameters> hugoniot_table() {
  using P = HugoniotParameters;
  namespace dim = dimension;
  return {
      {required(
           &P::specific_heat, "Specific Heat", dim::heat_capacity, above(0.0), "heat capacity"
       ),
       required(
           &P::sound_speed,
           "Sound Speed",
           dim::velocity,
           above(0.0),
           "c0 in U_s = c0 + s u_p; K = rho0 c0^2"
       ),
       required(&P::slope, "Hugoniot Slope", dim::none, at_least(0.0), "s in U_s = c0 + s u_p"),
       required(&P::gamma, "Gruneisen", dim::none, at_least(0.0), "Gamma0; Gamma rho is constant")},
      {}};
}

/// Mie-Grueneisen equation of state (list.hpp) about a linear shock Hugoniot U_s = c0 + s u_p, with
/// Gamma rho constant, in energy form. Pressure is positive in compression, eta = 1 - V / V_ref.
///
///   P(eta, e) = a(eta) + Gamma0 rho0 e
///   a(eta) = P_H(eta) (1 - Gamma0 eta / 2),  P_H = rho0 c0^2 eta / (1 - s eta)^2    (eta >= 0)
///   a(eta) = rho0 c0^2 eta                                                          (eta < 0)
///
/// The pressure and its first derivative are continuous at eta = 0. P_H is singular at eta = 1/s,
/// the largest compression a single shock can reach; states at or beyond 0.99 of it are refused.
///
/// With a Cohesive Energy Ec the metal that is expanded, x = V / V_ref - 1 > 0, comes apart: its
/// cold tension has a largest value, K / (e beta), and takes the energy Ec to the end; its hot gas
/// is that of single atoms, Gamma = 2/3.
///
///   P(x, e) = p_c(x) + g(x) (rho0 e - E_c(x))
///   p_c = -K x exp(-beta x),   E_c = rho0 Ec (1 - (1 + beta x) exp(-beta x)),   beta = c0 / Ec^1/2
///   g = Gamma rho / rho0,   Gamma = 2/3 + (Gamma0 - 2/3) rho / rho0
///
/// P is continuous at x = 0, and so is its derivative in the volume without energy; with e > 0
/// it jumps by (2 Gamma0 - 2/3) rho0 e. dE_c/dx = -p_c.
/// @par Source  Marsh (ed.), LASL Shock Hugoniot Data, Univ. of California Press, 1980 (linear
/// U_s-u_p);
///              Wilkins, Computer Simulation of Dynamic Phenomena, Springer, 1999 (energy form);
///              Rose, Smith, Guinea & Ferrante, Phys. Rev. B 29 (1984) 2963 (the shape of E_c; in
///              the volume instead of the distance here).
struct MieGruneisen {
  static constexpr const char* name = "Mie-Grueneisen";
  static constexpr const char* summary = "Mie-Grueneisen pressure";
  static constexpr int passes = 1;  ///< the pressure is linear in the energy
  struct Parameters : HugoniotParameters {
    double cohesive_energy = 0.0;
  };
  static ParameterTable<Parameters> parameter_table() {
    ParameterTable<Parameters> table;
    add_table(hugoniot_table(), table);
    table.numbers.push_back(optional(
        &Parameters::cohesive_energy,
        "Cohesive Energy",
        dimension::specific_energy,
        at_least(0.0),
        0.0,
        "that takes the cold metal's atoms apart; 0: its tension grows without limit, and "
        "Gamma rho is constant where it is expanded too"
    ));
    return table;
  }
  /// Elements and alloys: Marsh, as above.
  static std::vector<PlausibleRange> plausible_ranges() {
    return {
        {"Specific Heat", 50.0, 2e4}, {"Sound Speed", 100.0, 2e4}, {"Cohesive Energy", 1e5, 1e8}};
  }
  static metal::BulkModulus bulk(const Parameters& p, double density) {
    return {density * p.sound_speed * p.sound_speed, "Density * Sound Speed^2", "the three"};
  }
  static std::string check(const Parameters& /*p*/) { return ""; }
  static MieGruneisen make(const Parameters& p, double density) {
    const double ec = p.cohesive_energy;
    return {
        density,
        p.sound_speed,
        p.slope,
        p.gamma,
        ec,
        ec > 0.0 ? p.sound_speed / std::sqrt(ec) : 0.0};
  }

  double density;                ///< rho0 [mass/length^3]
  double sound_speed;            ///< c0 [length/time]
  double slope;                  ///< s [-]
  double gamma;                  ///< Gamma0 [-]
  double cohesive_energy = 0.0;  ///< Ec [energy/mass]; 0: none
  double fading = 0.0;           ///< beta [-]

  static constexpr double gas_gamma = 2.0 / 3.0;  ///< of single atoms
  BARRENO_FUNCTION bool comes_apart() const { return cohesive_energy > 0.0; }

  /// rho0 c0^2, the bulk modulus of the unstrained material [stress].
  BARRENO_FUNCTION double bulk_modulus() const { return density * sound_speed * sound_speed; }

  /// First eta that is refused [-]. With s <= 1 it is the vanishing volume that limits, not the
  /// shock.
  BARRENO_FUNCTION double compression_limit() const { return slope > 1.0 ? 0.99 / slope : 0.99; }

  /// Whether the update can take a step that changes V / V_ref by `change` to this compression.
  template <class R>
  BARRENO_FUNCTION MaskOf<R> allows(const R& eta, const R& change) const {
    const double most = comes_apart() && gamma < gas_gamma ? gas_gamma : gamma;
    return (eta < compression_limit()) & (1.0 + 0.5 * most * change > 0.0);
  }

  /// a(eta), g(eta) and their derivatives.
  template <class R>
  struct ReferenceOf {
    R pressure;                 ///< a(eta), the pressure at zero internal energy [stress]
    R derivative;               ///< d a / d eta [stress]
    R per_energy;               ///< g, what the pressure gains per energy per reference volume [-]
    R per_energy_derivative{};  ///< d g / d eta [-]
  };
  template <class R>
  BARRENO_FUNCTION ReferenceOf<R> reference(const R& eta) const {
    const double bulk = bulk_modulus();
    const R closure = 1.0 / (1.0 - slope * eta);
    const R factor = 1.0 - 0.5 * gamma * eta;
    const R hugoniot = bulk * closure * closure;  // P_H / eta
    const R growth = (1.0 + slope * eta) * closure;
    const MaskOf<R> expanded = eta <= 0.0;
    ReferenceOf<R> at{
        real::select(expanded, bulk * eta, hugoniot * eta * factor),
        real::select(expanded, R{} + bulk, hugoniot * (growth * factor - 0.5 * gamma * eta)),
        R{} + gamma};
    if (comes_apart() && real::any(expanded)) assign_where(expanded, expanded_reference(eta), at);
    return at;
  }
  /// Of a metal that comes apart, where it is expanded.
  template <class R>
  BARRENO_FUNCTION ReferenceOf<R> expanded_reference(const R& eta) const {
    const R x = real::larger(R(-eta), 0.0), share = 1.0 / (1.0 + x);  // rho / rho0
    const R fade = real::exp(R(-fading * x));
    const R tension = bulk_modulus() * x * fade;
    const R energy = (density * cohesive_energy) * (1.0 - (1.0 + fading * x) * fade);
    const R g = share * (gas_gamma + (gamma - gas_gamma) * share);
    const R slope_g = share * share * (gas_gamma + 2.0 * (gamma - gas_gamma) * share);
    return {
        R{} - tension - g * energy,
        bulk_modulus() * (1.0 - fading * x) * fade - slope_g * energy + g * tension,
        g,
        slope_g};
  }

  /// The part of the pressure that no energy gives, about a state with this energy per reference
  /// volume, and what the pressure gains per energy.
  template <class R>
  BARRENO_FUNCTION ReferenceOf<R> at(const R& eta, const R& /*energy*/) const {
    return reference(eta);
  }
  template <class R>
  BARRENO_FUNCTION R per_energy(const ReferenceOf<R>& at) const {
    return at.per_energy;
  }

  /// P(eta, e) [stress]; energy is the specific internal energy [energy/mass].
  BARRENO_FUNCTION double pressure(double eta, double energy) const {
    const auto at = reference(eta);
    return at.pressure + at.per_energy * density * energy;
  }

  /// eta at which the pressure is 0 with this specific internal energy [-]: exact where the metal
  /// is expanded, a(eta) = K eta; by two steps of Newton's method where e < 0, which is small.
  /// Of a metal that comes apart by Newton's method from eta = 0, which stays on the side of the
  /// pressure and before the largest cold tension.
  template <class R>
  BARRENO_FUNCTION R relaxed_compression(const R& energy) const {
    if (comes_apart()) return relaxed_apart(R(density * energy));
    const R thermal = gamma * density * energy;
    R eta = thermal * (-1.0 / bulk_modulus());
    for (int i = 0; i < 2; ++i) {
      const auto at = reference(eta);
      eta = eta - (at.pressure + thermal) / at.derivative;
    }
    return eta;
  }

  /// @param energy per reference volume [stress]
  template <class R>
  BARRENO_FUNCTION R relaxed_apart(const R& energy) const {
    const double largest_tension = -1.0 / fading;
    const double least_rise = 1e-3 * bulk_modulus();
    R eta{};
    for (int i = 0; i < 8; ++i) {
      const auto at = reference(eta);
      const R rise = at.derivative + at.per_energy_derivative * energy;
      eta = eta - (at.pressure + at.per_energy * energy) / real::larger(rise, least_rise);
      eta = real::larger(eta, largest_tension);
    }
    return eta;
  }

  /// Isentropic bulk modulus -V (dP/dV)_s = rho c^2 with the current density rho [stress]. It
  /// follows from de = -P dV / m on an isentrope; it may become negative in strong tension.
  template <class R>
  BARRENO_FUNCTION R
  isentropic_modulus(const R& eta, const ReferenceOf<R>& at, const R& pressure_now) const {
    R rise = at.derivative;
    if (comes_apart()) {
      // The energy, from the pressure; without a Gamma0 compressed metal does not tell it.
      const R per_energy = real::larger(at.per_energy, 1e-30);
      rise += at.per_energy_derivative * (pressure_now - at.pressure) / per_energy;
    }
    return (1.0 - eta) * (rise + at.per_energy * pressure_now);
  }

  /// T / T_begin of an isentropic volume change [-]: dT / T = -Gamma dV / V = -g d(V / V_ref).
  /// The trapezoidal rule, (1 - x/2) / (1 + x/2), avoids the exponential where its error x^3 / 12
  /// is far below a step's others.
  /// @param change   of V / V_ref
  /// @param implicit 1 / (1 + g change / 2), which a caller has at hand
  template <class R>
  BARRENO_FUNCTION R
  isentropic_temperature_ratio(const ReferenceOf<R>& at, const R& change, const R& implicit) const {
    const R x = at.per_energy * change;
    const R short_step = (1.0 - 0.5 * x) * implicit;
    const MaskOf<R> is_long = !(real::abs(x) < 0.02);
    if (!real::any(is_long)) return short_step;
    return real::select(is_long, real::exp(R(-x)), short_step);
  }

  /// Internal energy per reference volume on the isentrope through the unstrained cold state
  /// [stress]:
  ///   E(eta) = integral over x from 0 to eta of a(x) exp(Gamma0 (eta - x)) dx   (from dE/deta =
  ///   P).
  /// Gauss-Legendre with 3 points on 64 panels: for states a scene starts from (eta below 0.1)
  /// exact to round-off. Set-up only.
  double isentrope_energy(double eta) const {
    constexpr int panels = 64;
    const double node = std::sqrt(0.6);
    const double h = eta / panels;
    double sum = 0.0;
    for (int i = 0; i < panels; ++i) {
      const double mid = (i + 0.5) * h;
      const double x[3] = {mid - 0.5 * node * h, mid, mid + 0.5 * node * h};
      const double w[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
      for (int k = 0; k < 3; ++k) {
        sum += h * w[k] * reference(x[k]).pressure * std::exp(gamma * (eta - x[k]));
      }
    }
    return sum;
  }

  /// Pressure on that isentrope [stress].
  double isentrope_pressure(double eta) const {
    return pressure(eta, isentrope_energy(eta) / density);
  }

  /// Largest eta, to 1/256 of the compression limit, up to which that pressure rises: where Gamma0
  /// is large it falls again before the limit. Set-up only.
  double rising_limit() const {
    constexpr int parts = 256;
    const double part = compression_limit() / parts;
    for (int i = 1; i <= parts; ++i) {
      const double eta = i * part;
      if (!(reference(eta).derivative + gamma * isentrope_pressure(eta) > 0.0))
        return (i - 1) * part;
    }
    return compression_limit();
  }

  /// The state on that isentrope with this pressure.
  metal::IsentropeState isentrope_at(double asked) const {
    double limit = compression_limit();
    if (!(asked < isentrope_pressure(limit))) limit = rising_limit();
    if (!(asked >= 0.0 && asked < isentrope_pressure(limit))) return {};
    double low = 0.0, high = limit;
    double eta = asked / bulk_modulus();
    // Newton on the isentrope, where dP/deta = a' + Gamma0 P; bisection when a step leaves the
    // bracket.
    for (int i = 0; i < 100; ++i) {
      if (!(eta >= low && eta <= high)) eta = 0.5 * (low + high);
      const double p = pressure(eta, isentrope_energy(eta) * (1.0 / density));
      (p > asked ? high : low) = eta;
      const double step = (asked - p) / (reference(eta).derivative + gamma * p);
      if (std::fabs(step) <= 1e-15 * eta) break;
      eta += step;
    }
    return {true, eta, isentrope_energy(eta), std::exp(gamma * eta)};
  }

  /// Solid over mean density above which a shock from rest leaves voids, or this metal less dense
  /// than at reference: with the heat U^2/2, p = a(eta) / (1 - Gamma0 (alpha - 1 + eta) / 2).
  double largest_porous_expansion() const { return 1.0 + 2.0 / gamma; }
};

}  // namespace barreno
