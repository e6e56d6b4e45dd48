// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/drain.hpp"
#include "barreno/arenisca/general_step.hpp"
#include "barreno/arenisca/parts/scatter.hpp"
#include "barreno/arenisca/points_rate.hpp"
#include "barreno/models/arenisca.hpp"
#include "barreno/pore_point.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// Arenisca's forms for comparison, written apart for one point at a time: pore fluid in a
/// published form, and dry rock by the published nested bisection; with the other features of a
/// card, third invariant, rate dependence and scatter, in both. Surface, crush curve, flow rule,
/// elasticity and rate are those of the other forms; how steps are divided and returned is its own,
/// at ten times the cost and more. A card does not ask for it by name: the registry takes it where
/// needed() says so.
///
/// The stress that hosts see is the dynamic one; the overstress is history.
struct GeneralArenisca {
  using SpecialForm = Arenisca;
  using Parameters = Arenisca::Parameters;
  static constexpr const char* name = "Arenisca";
  static constexpr const char* form = "general";  ///< tells it from others of that name
  static constexpr const char* summary = Arenisca::summary;

  struct History {
    double plastic_volume_strain = 0.0, equivalent_plastic_strain = 0.0;
    double fluid_mass_ratio = 1.0, coherence = 1.0;
    double pore_pressure = 0.0, porosity = 0.0;
    double overstress_xx = 0.0, overstress_yy = 0.0, overstress_zz = 0.0;
    double overstress_xy = 0.0, overstress_yz = 0.0, overstress_zx = 0.0;
  };
  static constexpr int history_count = 12;

  static bool needed(const Parameters& p) { return !arenisca::goes_in_lanes(p, p.fluid_B0 > 0.0); }
  static ParameterTable<Parameters> parameter_table() { return Arenisca::parameter_table(); }
  static std::vector<HistoryField> history_table();
  static std::string check(const Parameters& p, double density) {
    return Arenisca::check(p, density);
  }

  GeneralArenisca(const Parameters& p, double /*density*/)
      : p_(p),
        rock_(make_rock(p)),
        weibull_(arenisca::Weibull::make(p, arenisca::ShearLimit::largest_factor(p))) {}

  /// Gives a piece of rock the strength of its own; a host that makes pieces calls this once, one
  /// that does not has the mean everywhere.
  void vary(History& h, const Specimen& piece) const { h.coherence = weibull_.factor(piece); }
  const arenisca::Weibull& weibull() const { return weibull_; }

  History initial_history() const;
  InitialStateOf<Sym3, History> initial_state(double pressure) const;
  /// At rest under a total pressure with a pore pressure of its own, as if the confinement had been
  /// put on slowly: fluid has flowed until it had that pressure. Not possible above the total one.
  InitialStateOf<Sym3, History> initial_state(double pressure, double pore_pressure) const;
  /// Pressure of rock and fluid where the rock itself carries nothing: -p_i I is the virgin stress.
  double virgin_pressure() const { return rock_.fluid.initial_pressure; }

  /// Advances a point by a strain increment; as Arenisca::update().
  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    arenisca::NoCounter none;
    return update_counted(increment, stress, h, none);
  }
  template <class Counter>
  BARRENO_FUNCTION Outcome
  update_counted(const Increment& increment, Sym3& stress, History& h, Counter& count) const;

  /// The fluid of a point; rock without fluid or pores, and the published forms, which are for
  /// undrained calibrations, have storage = 0.
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& stress, const History& h) const;
  /// Lets fluid in or out at fixed strain: mass exactly, stress and centre by the model's own
  /// elasticity, plastic flow where that leaves the surface. Overstress stays.
  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const;

  /// Bound on K + 4G/3 over all reachable states: saturated rock without pores is grain [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    arenisca::Moduli m = rock_.elasticity.upper_bound();
    if (p_.fluid_B0 > 0.0) m.bulk = std::fmax(m.bulk, matrix_modulus(p_));
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  /// K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double
  longitudinal_modulus(const Sym3& stress, const History& h, double /*volume_ratio*/) const {
    const arenisca::Moduli m = moduli(stress, h);
    return m.bulk + 4.0 / 3.0 * m.shear;
  }
  /// Tangent moduli of a point in this state.
  BARRENO_FUNCTION arenisca::Moduli moduli(const Sym3& stress, const History& h) const {
    const arenisca::PointRock point(rock_, h.coherence, h.fluid_mass_ratio);
    const double x = trace(stress - overstress(h)) - point.zeta(h.plastic_volume_strain);
    return point.moduli(x, h.plastic_volume_strain);
  }
  const Parameters& parameters() const { return p_; }
  const arenisca::GeneralRock& rock() const { return rock_; }

  static double matrix_modulus(const Parameters& p) {
    return p.matrix_bulk_modulus > 0.0 ? p.matrix_bulk_modulus : p.B0 + p.B1;
  }

private:
  InitialStateOf<Sym3, History> state_at_rest(double pressure, double fluid_mass_ratio) const;
  BARRENO_FUNCTION bool holds_fluid() const {
    return rock_.fluid.present() && !rock_.published.present() && !rock_.plastic_backstress;
  }
  static arenisca::GeneralRock make_rock(const Parameters& p);

  BARRENO_FUNCTION static Sym3 overstress(const History& h) {
    return arenisca::overstress_of<double>(h);
  }
  BARRENO_FUNCTION static bool sound_history(const History& h) {
    return std::isfinite(h.plastic_volume_strain + h.equivalent_plastic_strain) &&
           h.fluid_mass_ratio >= 0.0 && h.fluid_mass_ratio < HUGE_VAL && h.coherence >= 0.0 &&
           h.coherence < HUGE_VAL && is_finite(overstress(h));
  }

  Parameters p_;
  arenisca::GeneralRock rock_;
  arenisca::Weibull weibull_;
};

template <class Counter>
BARRENO_FUNCTION Outcome GeneralArenisca::update_counted(
    const Increment& increment, Sym3& stress, History& h, Counter& count
) const {
  Outcome refused;
  refused.substeps = 0;
  if (!arenisca::sound_increment(increment, stress) || !sound_history(h)) {
    refused.status = Status::bad_input;
    return refused;
  }
  const arenisca::PointRock point(rock_, h.coherence, h.fluid_mass_ratio);
  const Sym3 over = overstress(h), quasi_static = stress - over;
  const double zeta = point.zeta(h.plastic_volume_strain);
  const arenisca::GeneralState begin{
      trace(quasi_static) - zeta,
      deviator(quasi_static),
      h.plastic_volume_strain,
      h.equivalent_plastic_strain};
  arenisca::GeneralState end = begin;
  auto step = arenisca::integrate_general(point, end, increment.strain, count);
  if (step.outcome.failed()) {
    refused.status = step.outcome.status;
    refused.substeps = step.outcome.substeps;
    return refused;
  }
  const arenisca::PointRock::Seen seen = point.seen(end.x, end.e);
  const Sym3 new_quasi_static = end.s + isotropic((end.x + seen.zeta) / 3.0);
  Sym3 new_over{};
  if (rock_.T1 > 0.0) {
    const Sym3 elastic = step.elastic_s + isotropic(step.elastic_x / 3.0);
    const Sym3 change = new_quasi_static - quasi_static;
    new_over = arenisca::relaxed(rock_.T1, rock_.T2, increment, elastic - change, over);
  }
  const Sym3 new_stress = new_quasi_static + new_over;
  const arenisca::Moduli& m = seen.moduli;
  if (!is_finite(new_stress) || !std::isfinite(seen.pore_pressure + m.bulk + m.shear)) {
    refused.status = Status::not_converged;
    return refused;
  }
  if (rock_.T1 > 0.0) {
    const Sym3& strain = increment.strain;
    const Sym3 centre = isotropic((zeta + seen.zeta) / 6.0);
    const double dissipated =
        arenisca::dissipated_work(strain, stress - centre, new_stress - centre, step.last);
    step.outcome.plastic_work = dissipated;
    step.outcome.elastic_work = 0.5 * contract(stress + new_stress, strain) - dissipated;
  }
  stress = new_stress;
  h.plastic_volume_strain = end.e;
  h.equivalent_plastic_strain = end.shear_strain;
  h.pore_pressure = pressure_of_fluid(seen.pore_pressure, h.fluid_mass_ratio);
  h.porosity = seen.porosity;
  arenisca::set_overstress<double>(true, new_over, h);
  const double mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
  step.outcome.elastic_work *= mean_ratio;
  step.outcome.plastic_work *= mean_ratio;
  step.outcome.longitudinal_modulus = m.bulk + 4.0 / 3.0 * m.shear;
  return step.outcome;
}

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

inline arenisca::GeneralRock GeneralArenisca::make_rock(const Parameters& p) {
  const arenisca::Rock drained = Arenisca(p, 1.0).rock();
  arenisca::GeneralRock rock{};
  rock.elasticity = drained.elasticity;
  rock.PEAKI1 = p.PEAKI1;
  rock.FSLOPE = p.FSLOPE;
  rock.STREN = p.STREN;
  rock.YSLOPE = p.YSLOPE;
  rock.CR = p.CR;
  rock.crush = drained.crush;
  rock.lode.kind = p.J3_type;
  rock.lode.psi = p.J3_psi;
  rock.T1 = p.T1_rate_dependence;
  rock.T2 = p.T2_rate_dependence;
  rock.flow = drained.flow;
  rock.tolerance = drained.tolerance;
  rock.stress_floor = drained.stress_floor;
  rock.bisection = drained.bisection;
  rock.plastic_backstress = p.backstress_strain == Arenisca::plastic_backstress;
  if (!(p.fluid_B0 > 0.0) || p.p3_crush_curve == 0.0) return rock;  // no pores, no fluid
  const double porosity = -std::expm1(-p.p3_crush_curve), matrix = matrix_modulus(p);
  rock.fluid = {p.fluid_B0, matrix, p.fluid_pressure_initial, porosity};
  if (p.undrained_moduli == Arenisca::arenisca3_moduli) {
    rock.published =
        arenisca::make_published_fluid(p.fluid_B0, matrix, p.fluid_pressure_initial, porosity);
  }
  return rock;
}

inline GeneralArenisca::History GeneralArenisca::initial_history() const {
  History h;
  h.pore_pressure = rock_.fluid.initial_pressure;
  h.porosity = -std::expm1(-p_.p3_crush_curve);
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
