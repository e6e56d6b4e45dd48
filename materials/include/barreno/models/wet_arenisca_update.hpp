// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point update of wet Arenisca and how fluid flows into and out of it. Read first:
// wet_arenisca.hpp, which includes this.
#include "barreno/models/arenisca_update.hpp"
#include "barreno/models/wet_arenisca.hpp"

namespace barreno {

template <class Parts>
BARRENO_FUNCTION double WetAreniscaOf<Parts>::mass_per_volume(const Sym3& stress, const History& h)
    const {
  const double fluid = h.porosity - h.gas;
  if (fluid > 0.0 && h.fluid_mass_ratio > 0.0) return h.fluid_mass_ratio / fluid;
  // Emptied pores: the volume since the beginning from that of the grains.
  const arenisca::Constituents& c = rock_.constituents;
  const double solid = 1.0 - h.porosity;
  const double pressure = h.pore_pressure, virgin = rock_.initial_pressure;
  const double total = -trace(stress) / 3.0;
  double denser = (pressure + (total - pressure) / solid - virgin) * c.per_matrix;
  if (c.change) {
    const double own = c.grain_strain(total) - h.porosity * c.grain_strain(pressure);
    denser = own / solid - c.grain_strain(virgin);
  }
  const double volume = (1.0 - rock_.porosity) / solid * std::exp(-denser);
  return volume / rock_.porosity * std::exp(c.fluid_strain_between(virgin, pressure));
}

template <class Parts>
BARRENO_FUNCTION PorePoint
WetAreniscaOf<Parts>::pore_point(const Sym3& stress, const History& h) const {
  constexpr double gas = 5e-5;  // bulk modulus over the fluid's: of air and water
  const arenisca::Constituents& c = rock_.constituents;
  const arenisca::CompliancesOf<double> k = compliances(stress, h);
  const double bulk = drained_moduli(stress, h).bulk;
  PorePoint p;
  p.pressure = h.pore_pressure;
  p.biot = 1.0 - bulk * k.whole;
  p.storage = arenisca::storage_of(k, pores(h), bulk);
  p.porosity = h.porosity;
  p.fluid_mass = h.fluid_mass_ratio;
  p.mass_per_volume = mass_per_volume(stress, h);
  if (h.pore_pressure == 0.0) {
    p.gap = h.gas;
    p.gap_pressure = gas * c.fluid;
    p.storage += p.gap / p.gap_pressure;
  }
  const bool dry_and_closed = h.fluid_mass_ratio == 0.0 && !(h.porosity > 0.0);
  if (dry_and_closed) p.storage = 0.0;  // they take no fluid
  return p;
}

namespace arenisca {

/// Lets fluid in or out at fixed strain (pore_point.hpp): the model's own update with more or less
/// fluid in it.
template <class Law, class Model>
inline Outcome drain_point(
    const Model& model,
    const Law& rock,
    double fluid_volume,
    Sym3& stress,
    typename Model::History& h
) {
  Outcome outcome;
  outcome.longitudinal_modulus = model.longitudinal_modulus(stress, h, 1.0);
  if (fluid_volume == 0.0) return outcome;
  Outcome refused;
  refused.substeps = 0;
  refused.status = Status::bad_input;
  if (!Model::sound_history(h) || !is_finite(stress)) return refused;
  const PorePoint before = model.pore_point(stress, h);
  const double mass = fluid_mass_after(before, fluid_volume);
  if (!(before.storage > 0.0) || !(mass >= 0.0) || !std::isfinite(mass)) return refused;

  typename Model::template Points<Lanes> p;
  repeat_point(Increment{}, stress, h, p);
  // Fluid moves at fixed strain: what heat the last step brought waits for the next one.
  if constexpr (Law::heated) p.history.thermal_expansion = Lanes{};
  StepOf<Lanes, Law> step[1] = {begin_rock<Lanes>(rock, first_lane(), p)};
  // What empties the pores takes all of it, whatever round-off says.
  const double inflow = mass == 0.0 ? h.gas - h.porosity : fluid_volume;
  step[0].inflow = Lanes{} + inflow;
  finish_steps(rock, step, 1);
  if (real::any(end_step<Lanes>(rock, first_lane(), step[0], p))) {
    refused.status = Status::not_converged;
    return refused;
  }
  stress = lane_of<Sym3>(p.stress, 0);
  const typename Model::History begin = h;
  h = lane_of<typename Model::History>(p.history, 0);
  if constexpr (Law::heated) h.thermal_expansion += begin.thermal_expansion;
  h.fluid_mass_ratio = mass;
  if (mass == 0.0) h.gas = h.porosity;
  outcome.substeps = static_cast<int>(step[0].substeps[0]);
  outcome.plastic_work = step[0].plastic_work[0];
  outcome.elastic_work = step[0].elastic_work[0] + step[0].fluid_work[0];
  outcome.longitudinal_modulus = step[0].modulus[0];
  return outcome;
}

/// Whether the fluid of points can be.
template <class R, class Law, class History>
BARRENO_FUNCTION MaskOf<R> sound_pores(const History& h) {
  const MaskOf<R> some = h.fluid_mass_ratio >= 0.0;
  if constexpr (has_poroplastic_fluid<Law>)
    return some & (h.pore_pressure >= 0.0) & (h.porosity >= 0.0) & (h.porosity < 1.0) &
           (h.gas >= 0.0) & (h.gas <= h.porosity);
  else
    return some;
}

}  // namespace arenisca

template <class Parts>
template <class R>
BARRENO_FUNCTION MaskOf<R> WetAreniscaOf<Parts>::start_points(Points<R>& p) const {
  const HistoryOf<R>& h = p.history;
  const MaskOf<R> sound = arenisca::sound_points(
                              p.increment,
                              p.stress,
                              R(h.plastic_volume_strain + h.fluid_mass_ratio + h.pore_pressure),
                              h.equivalent_plastic_strain
                          ) &
                          arenisca::sound_pores<R, Law>(h);
  return arenisca::start_rock<R>(rock_, sound, p);
}

template <class Parts>
template <class R>
BARRENO_FUNCTION void WetAreniscaOf<Parts>::finish_points(
    Points<R>* groups, const MaskOf<R>* flows, int count
) const {
  constexpr std::size_t room = groups_together;
  arenisca::StepOf<R, Law> steps[room];
  arenisca::finish_rock(rock_, steps, groups, flows, count);
}

template <class Parts>
Outcome WetAreniscaOf<Parts>::update(const Increment& increment, Sym3& stress, History& h) const {
  return arenisca::update_point(*this, rock_, increment, stress, h);
}

template <class Parts>
Outcome WetAreniscaOf<Parts>::drain(double fluid_volume, Sym3& stress, History& h) const {
  return arenisca::drain_point(*this, rock_, fluid_volume, stress, h);
}

}  // namespace barreno
