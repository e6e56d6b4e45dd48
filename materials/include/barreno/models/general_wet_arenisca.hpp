// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/frozen_substeps.hpp"
#include "barreno/models/general_arenisca.hpp"
#include "barreno/models/wet_arenisca.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace barreno {

/// Wet Arenisca with third invariant, rate dependence or variability: the drained general form for
/// the effective stress, and the pore pressure as an unknown around its update. The equations are
/// those of models/wet_arenisca.hpp; the cost is that of three to five dry updates.
struct GeneralWetArenisca {
  using SpecialForm = Arenisca;
  using Parameters = Arenisca::Parameters;
  static constexpr const char* name = "Arenisca";
  static constexpr const char* form = "general wet";  ///< tells it from others of that name
  static constexpr const char* summary = Arenisca::summary;

  using History = GeneralArenisca::History;
  static constexpr int history_count = GeneralArenisca::history_count;

  static bool needed(const Parameters& p) {
    return arenisca::is_poroplastic(p) && p.return_solver != 0;
  }
  static ParameterTable<Parameters> parameter_table() { return arenisca_parameter_table(); }
  static std::vector<HistoryField> history_table() { return GeneralArenisca::history_table(); }
  static std::string check(const Parameters& p, double density) {
    return Arenisca::check(p, density);
  }

  GeneralWetArenisca(const Parameters& p, double density)
      : wet_(p, density), skeleton_(drained(p), density) {}

  void vary(History& h, const Specimen& piece) const { skeleton_.vary(h, piece); }
  const arenisca::Weibull& weibull() const { return skeleton_.weibull(); }

  History initial_history() const { return with_fluid({}, wet_.initial_history()); }
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    return with_fluid(wet_.initial_state(pressure));
  }
  InitialStateOf<Sym3, History> initial_state(double pressure, double pore_pressure) const {
    return with_fluid(wet_.initial_state(pressure, pore_pressure));
  }
  double virgin_pressure() const { return wet_.virgin_pressure(); }

  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    arenisca::NoCounter none;
    return update_counted(increment, stress, h, none);
  }
  template <class Counter>
  BARRENO_FUNCTION Outcome
  update_counted(const Increment& increment, Sym3& stress, History& h, Counter& count) const;

  /// See WetArenisca; the elastic tangents are the same.
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& stress, const History& h) const {
    return wet_.pore_point(stress, fluid_of(h));
  }
  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const;
  BARRENO_FUNCTION double longitudinal_modulus() const { return wet_.longitudinal_modulus(); }
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& h, double volume_ratio
  ) const {
    return wet_.longitudinal_modulus(stress, fluid_of(h), volume_ratio);
  }
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    return wet_.drained_moduli(stress, fluid_of(h));
  }
  const Parameters& parameters() const { return wet_.parameters(); }
  /// The dry rock between grains, for the effective stress.
  const GeneralArenisca& skeleton() const { return skeleton_; }

private:
  /// A step with fluid that comes in.
  template <class Counter>
  BARRENO_FUNCTION Outcome
  step(const Increment& increment, double inflow, Sym3& stress, History& h, Counter& count) const;

  /// The dry rock between grains.
  static Parameters drained(Parameters p) {
    p.fluid_B0 = p.fluid_pressure_initial = p.matrix_bulk_modulus = 0.0;
    return p;
  }
  /// What wet Arenisca knows of a point; the overstress is not part of its elastic law.
  BARRENO_FUNCTION static WetArenisca::History fluid_of(const History& h) {
    return {
        h.plastic_volume_strain,
        h.equivalent_plastic_strain,
        h.fluid_mass_ratio,
        h.pore_pressure,
        h.porosity,
        h.gas};
  }
  BARRENO_FUNCTION static History with_fluid(History h, const WetArenisca::History& wet) {
    h.plastic_volume_strain = wet.plastic_volume_strain;
    h.equivalent_plastic_strain = wet.equivalent_plastic_strain;
    h.fluid_mass_ratio = wet.fluid_mass_ratio;
    h.pore_pressure = wet.pore_pressure;
    h.porosity = wet.porosity;
    h.gas = wet.gas;
    return h;
  }
  BARRENO_FUNCTION static void put_fluid(
      const arenisca::PoresOf<double>& pores, double mass_ratio, History& h
  ) {
    h.fluid_mass_ratio = mass_ratio;
    h.pore_pressure = pores.pressure;
    h.porosity = 1.0 - pores.solid;
    h.gas = pores.pressure > 0.0 ? 0.0 : std::fmax(0.0, h.porosity - pores.fluid);
  }
  static InitialStateOf<Sym3, History> with_fluid(
      const InitialStateOf<Sym3, WetArenisca::History>& s
  ) {
    return {s.stress, with_fluid({}, s.history), s.volume_ratio, s.stored_energy, s.possible};
  }

  WetArenisca wet_;
  GeneralArenisca skeleton_;
};

namespace arenisca {

/// Updates of the same step for slightly different strains: the first chooses its substeps, the
/// others take the same ones, so that the result is smooth in the strain.
template <class Counter>
struct RepeatedUpdate {
  Counter& count;
  SubstepRecord record{};
  template <class Update>
  BARRENO_FUNCTION Outcome first(const Update& update) {
    return update(record);
  }
  template <class Update>
  BARRENO_FUNCTION Outcome again(const Update& update) const {
    SubstepReplay replay{record};
    return update(replay);
  }
};
template <>
struct RepeatedUpdate<SubstepRecord> {
  SubstepRecord& count;
  template <class Update>
  BARRENO_FUNCTION Outcome first(const Update& update) {
    return update(count);
  }
  template <class Update>
  BARRENO_FUNCTION Outcome again(const Update& update) const {
    SubstepReplay replay{count};
    return update(replay);
  }
};
template <>
struct RepeatedUpdate<SubstepReplay> {
  SubstepReplay& count;
  template <class Update>
  BARRENO_FUNCTION Outcome first(const Update& update) {
    return again(update);
  }
  template <class Update>
  BARRENO_FUNCTION Outcome again(const Update& update) const {
    SubstepReplay replay{count.record};
    return update(replay);
  }
};

}  // namespace arenisca

/// The rise of the pressure is a fixed point: the skeleton's update at a rise gives a load on the
/// grains, and that load a rise (fill_pores()). The secant method finds it.
template <class Counter>
BARRENO_FUNCTION Outcome GeneralWetArenisca::step(
    const Increment& increment, double inflow, Sym3& stress, History& h, Counter& count
) const {
  constexpr int max_iterations = 20;
  constexpr double agreed = 1e-15, good_enough = 1e-6;
  const arenisca::Constituents& c = wet_.rock().constituents;
  const WetArenisca::History fluid = fluid_of(h);
  arenisca::PoresOf<double> n = arenisca::pores_of<double>(fluid);
  n.fluid = std::fmax(0.0, n.fluid + inflow);
  const double dv = trace(increment.strain);
  const Sym3 begin = stress + isotropic(n.pressure);

  Sym3 end{};
  History h_end = h;
  arenisca::RepeatedUpdate<Counter> repeated{count};
  const auto update = [&](double rise, auto& counter) {
    Increment skeleton = increment;
    skeleton.strain = increment.strain + isotropic(rise * c.per_matrix / 3.0);
    end = begin;
    h_end = h;
    return skeleton_.update_counted(skeleton, end, h_end, counter);
  };
  const auto filled = [&](double rise) {
    const double load = trace(end - begin);
    return arenisca::fill_pores(c, n, arenisca::loaded_grains(c, n, load), dv, rise);
  };

  const double bulk = wet_.drained_moduli(stress, fluid).bulk;
  double rise = arenisca::fill_pores(c, n, arenisca::elastic_grains(c, n, bulk, dv), dv, 0.0).rise;
  Outcome outcome = repeated.first([&](auto& counter) { return update(rise, counter); });
  if (outcome.failed()) return outcome;
  auto f = filled(rise);
  double miss = f.rise - rise, last_rise = rise, last_miss = miss;
  const double scale = wet_.rock().stress_floor + norm(begin) + n.pressure;
  rise = f.rise;
  for (int i = 0; i < max_iterations && std::fabs(miss) > agreed * scale; ++i) {
    outcome = repeated.again([&](auto& counter) { return update(rise, counter); });
    if (outcome.failed()) return outcome;
    f = filled(rise);
    miss = f.rise - rise;
    // Round-off is reached where the last step gained nothing.
    if (std::fabs(miss) >= std::fabs(last_miss) && std::fabs(miss) <= 1e-12 * scale) break;
    const double slope = rise == last_rise ? 0.0 : (miss - last_miss) / (rise - last_rise);
    last_rise = rise;
    last_miss = miss;
    rise = std::fmax(-n.pressure, slope < 0.0 ? rise - miss / slope : f.rise);
  }
  if (!(std::fabs(miss) <= good_enough * (scale + norm(end) + f.end.pressure))) {
    outcome.status = Status::not_converged;
    return outcome;
  }
  h = h_end;
  put_fluid(f.end, fluid.fluid_mass_ratio, h);
  const Sym3 new_stress = end - isotropic(h.pore_pressure);
  const double mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
  const double work = contract(0.5 * (stress + new_stress), increment.strain);
  stress = new_stress;
  outcome.elastic_work = mean_ratio * work - outcome.plastic_work;
  outcome.longitudinal_modulus = longitudinal_modulus(stress, h, 1.0);
  return outcome;
}

template <class Counter>
BARRENO_FUNCTION Outcome GeneralWetArenisca::update_counted(
    const Increment& increment, Sym3& stress, History& h, Counter& count
) const {
  if (!arenisca::sound_increment(increment, stress) || !WetArenisca::sound_history(fluid_of(h))) {
    Outcome refused;
    refused.status = Status::bad_input;
    refused.substeps = 0;
    return refused;
  }
  return step(increment, 0.0, stress, h, count);
}

/// In equal parts, so many that the pressure changes little in each.
BARRENO_FUNCTION Outcome
GeneralWetArenisca::drain(double fluid_volume, Sym3& stress, History& h) const {
  constexpr int parts = 8;
  Outcome outcome;
  outcome.longitudinal_modulus = longitudinal_modulus(stress, h, 1.0);
  if (fluid_volume == 0.0) return outcome;
  Outcome refused;
  refused.substeps = 0;
  refused.status = Status::bad_input;
  if (!WetArenisca::sound_history(fluid_of(h)) || !is_finite(stress)) return refused;
  const PorePoint before = pore_point(stress, h);
  const double mass = fluid_mass_after(before, fluid_volume);
  if (!(before.storage > 0.0) || !(mass >= 0.0) || !std::isfinite(mass)) return refused;
  Sym3 end = stress;
  History h_end = h;
  arenisca::NoCounter none;
  double inflow = mass == 0.0 ? h.gas - h.porosity : fluid_volume, work = 0.0;
  outcome.substeps = 0;
  for (int i = 0; i < parts; ++i) {
    const double part = inflow / (parts - i), p = h_end.pore_pressure;
    const Outcome one = step(Increment{}, part, end, h_end, none);
    if (one.failed()) return one;
    const double p_end = h_end.pore_pressure;
    const double ratio = std::exp((p - p_end) / wet_.rock().constituents.fluid);
    work += 0.5 * (p + p_end * ratio) * part;
    inflow = (inflow - part) * ratio;
    outcome.plastic_work += one.plastic_work;
    outcome.substeps += one.substeps;
    outcome.longitudinal_modulus = one.longitudinal_modulus;
  }
  stress = end;
  h = h_end;
  h.fluid_mass_ratio = mass;
  if (mass == 0.0) h.gas = h.porosity;
  outcome.elastic_work = work - outcome.plastic_work;
  return outcome;
}

}  // namespace barreno
