// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"
#include "barreno/pore_point.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// Arenisca with fluid in its pores, in the poroplastic form: the dry law for the effective stress
/// sigma + p I, and a pore pressure that follows from the volumes of grains and fluid
/// (arenisca/points_pores.hpp; docs/method.md 10). Nothing in strength, flow or crush curve is its
/// own. Source: O. Coussy, Poromechanics (2004), grains that keep their volume in plastic flow.
template <class Parts>
struct WetAreniscaOf {
  using SpecialForm = Arenisca;
  using Parameters = Arenisca::Parameters;
  using Law = arenisca::SaturatedRock<Parts>;
  static constexpr const char* name = "Arenisca";
  static constexpr const char* form = "wet";  ///< tells it from others of that name
  static constexpr const char* summary = Arenisca::summary;

  template <class R>
  struct HistoryOf {
    R plastic_volume_strain{}, equivalent_plastic_strain{};
    R fluid_mass_ratio = R{} + 1.0;
    R pore_pressure{}, porosity{}, gas{};
  };
  using History = HistoryOf<double>;
  static constexpr int history_count = 6;

  static bool needed(const Parameters& p) {
    return arenisca::is_poroplastic(p) && arenisca::is_plain(p) &&
           arenisca::count_of_others(p) == 0;
  }
  static ParameterTable<Parameters> parameter_table() { return arenisca_parameter_table(); }
  static std::vector<HistoryField> history_table();
  static std::string check(const Parameters& p, double density) {
    return Arenisca::check(p, density);
  }

  WetAreniscaOf(const Parameters& p, double /*density*/) : p_(p), rock_(make_rock(p)) {}

  History initial_history() const;
  /// Under a pressure that was put on without a way out for the fluid.
  InitialStateOf<Sym3, History> initial_state(double pressure) const;
  /// At rest under a total pressure with a pore pressure of its own, as if the confinement had been
  /// put on slowly: fluid has flowed until it had that pressure. Not possible above the total one.
  InitialStateOf<Sym3, History> initial_state(double pressure, double pore_pressure) const;
  /// Pressure of rock and fluid where the rock itself carries nothing: -p_i I is the virgin stress.
  double virgin_pressure() const { return rock_.initial_pressure; }

  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const;

  template <class R>
  using Points = PointsOf<Sym3Of<R>, HistoryOf<R>>;
  static constexpr int groups_together = 32;
  template <class R>
  BARRENO_FUNCTION MaskOf<R> start_points(Points<R>& p) const;
  template <class R>
  BARRENO_FUNCTION void finish_points(Points<R>* groups, const MaskOf<R>* flows, int count) const;

  /// The fluid of a point, see PorePoint.
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& stress, const History& h) const;
  /// Lets fluid in or out at fixed strain: the model's own update with more or less fluid in it.
  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const;

  /// Bound on K + 4G/3 over all reachable states: saturated rock without pores is grain. Without
  /// bound where grains or fluid stiffen [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const {
    const arenisca::Moduli m = rock_.elasticity.upper_bound();
    if (rock_.constituents.change) return HUGE_VAL;
    return std::fmax(m.bulk, rock_.constituents.matrix) + 4.0 / 3.0 * m.shear;
  }
  /// K + 4G/3 of a point in this state, without a way out for the fluid [stress].
  BARRENO_FUNCTION double
  longitudinal_modulus(const Sym3& stress, const History& h, double /*volume_ratio*/) const {
    const arenisca::Moduli m = drained_moduli(stress, h);
    return arenisca::undrained_bulk(rock_.constituents, pores(h), effective_I1(stress, h), m.bulk) +
           4.0 / 3.0 * m.shear;
  }
  /// Tangent moduli of the drained rock in this state.
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    const double x = effective_I1(stress, h);
    arenisca::Moduli m = rock_.elasticity.moduli_at(x, h.plastic_volume_strain);
    m.bulk = arenisca::bulk_under_pressure(rock_.constituents, pores(h), x, m.bulk);
    return m;
  }
  const Parameters& parameters() const { return p_; }
  const Law& rock() const { return rock_; }

  BARRENO_FUNCTION static bool sound_history(const History& h) {
    const double sum = h.plastic_volume_strain + h.equivalent_plastic_strain + h.fluid_mass_ratio;
    return std::isfinite(sum + h.pore_pressure) && h.fluid_mass_ratio >= 0.0 &&
           h.pore_pressure >= 0.0 && h.porosity >= 0.0 && h.porosity < 1.0 && h.gas >= 0.0 &&
           h.gas <= h.porosity;
  }

private:
  InitialStateOf<Sym3, History> state_at_rest(double pressure, double pore_pressure) const;
  static Law make_rock(const Parameters& p);
  BARRENO_FUNCTION static arenisca::PoresOf<double> pores(const History& h) {
    return {h.pore_pressure, 1.0 - h.porosity, h.porosity - h.gas};
  }
  BARRENO_FUNCTION static double effective_I1(const Sym3& stress, const History& h) {
    return trace(stress) + 3.0 * h.pore_pressure;
  }
  BARRENO_FUNCTION arenisca::CompliancesOf<double> compliances(const Sym3& stress, const History& h)
      const {
    return arenisca::compliances_at(rock_.constituents, pores(h), effective_I1(stress, h));
  }
  /// Fluid mass ratio for one volume of the fluid in the pores.
  BARRENO_FUNCTION double mass_per_volume(const Sym3& stress, const History& h) const;

  Parameters p_;
  Law rock_;
};

/// Of the published parts.
using WetArenisca = WetAreniscaOf<arenisca::PublishedParts>;

template <class Parts>
std::vector<HistoryField> WetAreniscaOf<Parts>::history_table() {
  namespace d = dimension;
  return {
      {"plastic_volume_strain", d::none, "volumetric plastic strain, negative in compaction"},
      {"equivalent_plastic_strain",
       d::none,
       "accumulated sqrt(2/3 de_p : de_p) of the plastic deviator"},
      {"fluid_mass_ratio", d::none, "mass of pore fluid over its initial mass"},
      {"pore_pressure", d::stress, "pressure of the fluid in the pores"},
      {"porosity", d::none, "pore volume over volume"},
      {"gas", d::none, "volume in the pores that the fluid does not fill, over volume"}};
}

template <class Parts>
typename WetAreniscaOf<Parts>::Law WetAreniscaOf<Parts>::make_rock(const Parameters& p) {
  Law rock;
  static_cast<arenisca::DryRock<Parts>&>(rock) = AreniscaOf<Parts>(p, 1.0).rock();
  rock.constituents = arenisca::Constituents::make(p);
  rock.initial_pressure = p.fluid_pressure_initial;
  rock.porosity = -std::expm1(-p.p3_crush_curve);
  return rock;
}

template <class Parts>
typename WetAreniscaOf<Parts>::History WetAreniscaOf<Parts>::initial_history() const {
  History h;
  h.pore_pressure = rock_.initial_pressure;
  h.porosity = rock_.porosity;
  return h;
}

/// Rock and fluid are first brought to the pore pressure together, which keeps the porosity; the
/// rest of the confinement compresses the drained rock.
template <class Parts>
InitialStateOf<Sym3, typename WetAreniscaOf<Parts>::History> WetAreniscaOf<Parts>::state_at_rest(
    double pressure, double pore_pressure
) const {
  const arenisca::Constituents& c = rock_.constituents;
  constexpr int intervals = 1000;
  const double effective = pressure - pore_pressure, step = effective / intervals;
  double solid = 1.0 - rock_.porosity;
  double strain = -c.grain_strain_between(rock_.initial_pressure, pore_pressure);
  double energy = c.work_on_grains(rock_.initial_pressure, pore_pressure);
  for (int i = 0; i < intervals; ++i) {
    const double middle = (i + 0.5) * step, x = -3.0 * middle;
    const double dry = rock_.elasticity.moduli_at(x, 0.0).bulk;
    const arenisca::PoresOf<double> pores{pore_pressure, solid};
    const double part = -step / arenisca::bulk_under_pressure(c, pores, x, dry);
    solid *= std::exp(-step * arenisca::compliances_at(c, pores, x).whole / solid - part);
    strain += part;
    energy -= (pore_pressure + middle) * part;
  }
  History h;
  h.pore_pressure = pore_pressure;
  h.porosity = std::fmax(0.0, 1.0 - solid);
  h.fluid_mass_ratio =
      h.porosity / rock_.porosity *
      std::exp(strain + c.fluid_strain_between(rock_.initial_pressure, pore_pressure));
  const arenisca::Cap cap = rock_.cap_at(0.0);
  const double x = -3.0 * effective;
  const bool possible = pressure >= 0.0 && pore_pressure >= 0.0 && (!cap.present || x > cap.X) &&
                        x <= rock_.surface.vertex;
  return {isotropic(-pressure), h, 1.0, energy, possible};
}

/// The mass of fluid grows with its pressure: halving finds where it is the initial one.
template <class Parts>
InitialStateOf<Sym3, typename WetAreniscaOf<Parts>::History> WetAreniscaOf<Parts>::initial_state(
    double confinement
) const {
  const double pressure = confinement == 0.0 ? rock_.initial_pressure : confinement;
  if (pressure == rock_.initial_pressure)
    return {isotropic(-pressure), initial_history(), 1.0, 0.0, true};
  constexpr int halvings = 60;
  double less = 0.0, more = std::fmax(pressure, rock_.initial_pressure);
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (less + more);
    const bool too_much = state_at_rest(pressure, middle).history.fluid_mass_ratio > 1.0;
    (too_much ? more : less) = middle;
  }
  auto start = state_at_rest(pressure, more);
  start.history.fluid_mass_ratio = 1.0;
  return start;
}

template <class Parts>
InitialStateOf<Sym3, typename WetAreniscaOf<Parts>::History> WetAreniscaOf<Parts>::initial_state(
    double pressure, double pore_pressure
) const {
  auto start = state_at_rest(pressure, pore_pressure);
  start.possible = start.possible && pore_pressure <= pressure;
  return start;
}

}  // namespace barreno

#include "barreno/models/wet_arenisca_update.hpp"
