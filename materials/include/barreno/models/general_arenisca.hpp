// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/drain.hpp"
#include "barreno/models/featured_arenisca.hpp"
#include "barreno/pore_point.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// In the order of GeneralArenisca::history_table().
template <class R>
struct GeneralHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R fluid_mass_ratio = R{} + 1.0, coherence = R{} + 1.0;
  R pore_pressure{}, porosity{};
  R overstress_xx{}, overstress_yy{}, overstress_zz{};
  R overstress_xy{}, overstress_yz{}, overstress_zx{};
};

/// Arenisca's forms for comparison: pore fluid in a published form, and dry rock by the published
/// nested bisection; with the other features of a card in both. The step is that of the other
/// forms; what is theirs, moduli, strength and return, knows one point at a time and costs ten
/// times as much (arenisca/general_law.hpp). A card does not ask for it by name: the registry takes
/// it where needed() says so.
///
/// The stress that hosts see is the dynamic one; the overstress is history.
struct GeneralArenisca : FeaturedForm<Arenisca, arenisca::GeneralRock, GeneralHistoryOf> {
  using Base = FeaturedForm<Arenisca, arenisca::GeneralRock, GeneralHistoryOf>;
  static constexpr const char* form = "general";  ///< tells it from others of that name
  static constexpr int history_count = 12;

  static bool needed(const Parameters& p) { return !arenisca::is_plain_law(p, p.fluid_B0 > 0.0); }
  static std::vector<HistoryField> history_table();

  GeneralArenisca(const Parameters& p, double density) : Base(p, density) { add_fluid(p, rock_); }

  History initial_history() const;
  InitialStateOf<Sym3, History> initial_state(double pressure) const;
  /// At rest under a total pressure with a pore pressure of its own, as if the confinement had been
  /// put on slowly: fluid has flowed until it had that pressure. Not possible above the total one.
  InitialStateOf<Sym3, History> initial_state(double pressure, double pore_pressure) const;
  /// Pressure of rock and fluid where the rock itself carries nothing: -p_i I is the virgin stress.
  double virgin_pressure() const { return rock_.fluid.initial_pressure; }

  /// The fluid of a point; rock without fluid or pores, and the published forms, which are for
  /// undrained calibrations, have storage = 0.
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& stress, const History& h) const;
  /// Lets fluid in or out at fixed strain: mass exactly, stress and centre by the model's own
  /// elasticity, plastic flow where that leaves the surface. Overstress stays.
  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const;

  /// Bound on K + 4G/3 over all reachable states: saturated rock without pores is grain [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    arenisca::Moduli m = rock_.elasticity.upper_bound();
    if (parameters().fluid_B0 > 0.0) m.bulk = std::fmax(m.bulk, matrix_modulus(parameters()));
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  /// K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double
  longitudinal_modulus(const Sym3& stress, const History& h, double /*volume_ratio*/) const {
    const arenisca::PointRock point = point_rock(h);
    const arenisca::Moduli m = point.moduli(from_centre(point, stress, h), h.plastic_volume_strain);
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  /// Tangent moduli of the drained rock in this state.
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    const double x = from_centre(point_rock(h), stress, h);
    return rock_.elasticity.moduli_at(x, h.plastic_volume_strain);
  }

  static double matrix_modulus(const Parameters& p) {
    return p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;
  }

private:
  InitialStateOf<Sym3, History> state_at_rest(double pressure, double fluid_mass_ratio) const;
  BARRENO_FUNCTION bool holds_fluid() const {
    return rock_.fluid.present() && !rock_.published.present() && !rock_.plastic_backstress;
  }
  static void add_fluid(const Parameters& p, arenisca::GeneralRock& rock);
  BARRENO_FUNCTION arenisca::PointRock point_rock(const History& h) const {
    return {rock_, h.coherence, h.fluid_mass_ratio};
  }
  /// I1 of the quasi-static stress, from the elastic centre [stress].
  BARRENO_FUNCTION static double from_centre(
      const arenisca::PointRock& point, const Sym3& stress, const History& h
  ) {
    return trace(quasi_static(stress, h)) - point.zeta(h.plastic_volume_strain);
  }
  BARRENO_FUNCTION static bool sound_history(const History& h) {
    return std::isfinite(h.plastic_volume_strain + h.equivalent_plastic_strain) &&
           h.fluid_mass_ratio >= 0.0 && h.fluid_mass_ratio < HUGE_VAL && h.coherence >= 0.0 &&
           h.coherence < HUGE_VAL && is_finite(arenisca::overstress_of<double>(h));
  }
};

inline std::vector<HistoryField> GeneralArenisca::history_table() {
  namespace d = dimension;
  return {
      {"plastic_volume_strain",
       d::none,
       "volumetric strain of the elastic centre (of plastic flow with the published backstress), "
       "negative in compaction"},
      {"equivalent_plastic_strain",
       d::none,
       "accumulated sqrt(2/3 de_p : de_p) of the plastic deviator"},
      {"fluid_mass_ratio", d::none, "mass of pore fluid over its initial mass"},
      {"coherence", d::none, "strength at the vertex over the card's PEAKI1"},
      {"pore_pressure", d::stress, "pressure of the fluid in the pores"},
      {"porosity", d::none, "pore volume over volume, at the elastic centre"},
      {"overstress_xx", d::stress, "dynamic less quasi-static stress"},
      {"overstress_yy", d::stress, "dynamic less quasi-static stress"},
      {"overstress_zz", d::stress, "dynamic less quasi-static stress"},
      {"overstress_xy", d::stress, "dynamic less quasi-static stress"},
      {"overstress_yz", d::stress, "dynamic less quasi-static stress"},
      {"overstress_zx", d::stress, "dynamic less quasi-static stress"}};
}

inline void GeneralArenisca::add_fluid(const Parameters& p, arenisca::GeneralRock& rock) {
  rock.plastic_backstress = p.backstress_strain == Arenisca::plastic_backstress;
  if (!(p.fluid_B0 > 0.0) || p.p3_crush_curve == 0.0) return;  // no pores, no fluid
  const double porosity = -std::expm1(-p.p3_crush_curve), matrix = matrix_modulus(p);
  rock.fluid = {p.fluid_B0, matrix, p.fluid_pressure_initial, porosity};
  if (p.undrained_moduli == Arenisca::arenisca3_moduli)
    rock.published =
        arenisca::make_published_fluid(p.fluid_B0, matrix, p.fluid_pressure_initial, porosity);
}

inline GeneralArenisca::History GeneralArenisca::initial_history() const {
  History h;
  h.pore_pressure = rock_.fluid.initial_pressure;
  h.porosity = -std::expm1(-parameters().p3_crush_curve);
  return h;
}

/// Rate-form law: the reference volume is that of the confined rock. Without confinement the virgin
/// stress is that of the fluid alone, -p_i I; any other total pressure loads the rock undrained.
inline InitialStateOf<Sym3, GeneralArenisca::History> GeneralArenisca::initial_state(
    double confinement
) const {
  return state_at_rest(confinement == 0.0 ? rock_.fluid.initial_pressure : confinement, 1.0);
}

/// The pore pressure grows with the mass of fluid: halving finds it.
inline InitialStateOf<Sym3, GeneralArenisca::History> GeneralArenisca::initial_state(
    double pressure, double pore_pressure
) const {
  constexpr int halvings = 100;
  const double per_pressure = 1.0 / rock_.fluid.bulk - 1.0 / rock_.fluid.matrix;
  double less = 0.0, more = std::exp((pressure - rock_.fluid.initial_pressure) * per_pressure);
  if (!holds_fluid() || !(pore_pressure >= 0.0 && pore_pressure <= pressure)) {
    auto start = state_at_rest(pressure, 1.0);
    start.possible = start.possible && !holds_fluid() && pore_pressure == 0.0;
    return start;
  }
  for (int i = 0; i < halvings; ++i) {
    const double mass = 0.5 * (less + more);
    const arenisca::PointRock point(rock_, 1.0, mass);
    const double p = point.pore_pressure(-3.0 * pressure - point.zeta(0.0), 0.0);
    (p > pore_pressure ? more : less) = mass;
  }
  return state_at_rest(pressure, less > 0.0 ? less : more);
}

inline InitialStateOf<Sym3, GeneralArenisca::History> GeneralArenisca::state_at_rest(
    double pressure, double fluid_mass_ratio
) const {
  History h = initial_history();
  h.fluid_mass_ratio = fluid_mass_ratio;
  const arenisca::PointRock point(rock_, h.coherence, h.fluid_mass_ratio);
  const double zeta = point.zeta(0.0), x = -3.0 * pressure - zeta;
  const arenisca::Cap cap = point.cap_at(0.0);
  const bool possible = pressure >= 0.0 && (!cap.present || x > cap.X) && x <= point.surface.vertex;
  h.pore_pressure = pressure_of_fluid(point.pore_pressure(x, 0.0), h.fluid_mass_ratio);
  h.porosity = point.porosity(0.0);
  constexpr int intervals = 1000;  // of Simpson's rule for the integral of p dp/K
  const double step = pressure / intervals;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    const double p = i * step;
    sum += weight * p / point.moduli(-3.0 * p - zeta, 0.0).bulk;
  }
  return {isotropic(-pressure), h, 1.0, sum * step / 3.0, possible};
}

}  // namespace barreno

#include "barreno/models/arenisca_drain.hpp"
