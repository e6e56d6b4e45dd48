// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How fluid flows into and out of Arenisca. Read first: general_arenisca.hpp, which includes this.
#include "barreno/models/general_arenisca.hpp"

#include <cmath>

namespace barreno {

BARRENO_FUNCTION PorePoint GeneralArenisca::pore_point(const Sym3& stress, const History& h) const {
  PorePoint p{h.pore_pressure, 0.0, 0.0, h.porosity, h.fluid_mass_ratio, 0.0};
  if (!holds_fluid()) return p;
  const arenisca::PointRock point = point_rock(h);
  p = arenisca::fluid_of(point, from_centre(point, stress, h), h.plastic_volume_strain);
  p.fluid_mass = h.fluid_mass_ratio;
  const bool dry_and_closed = p.fluid_mass == 0.0 && p.pressure > 0.0;
  if (dry_and_closed) p.storage = 0.0;  // they take no fluid
  p.pressure = pressure_of_fluid(p.pressure, p.fluid_mass);
  return p;
}

BARRENO_FUNCTION Outcome
GeneralArenisca::drain(double fluid_volume, Sym3& stress, History& h) const {
  Outcome outcome;
  if (fluid_volume == 0.0) {
    outcome.longitudinal_modulus = longitudinal_modulus(stress, h, 1.0);
    return outcome;
  }
  Outcome refused;
  refused.substeps = 0;
  refused.status = Status::bad_input;
  if (!holds_fluid() || !sound_history(h) || !is_finite(stress)) return refused;
  const PorePoint before = pore_point(stress, h);
  const double mass = fluid_mass_after(before, fluid_volume);
  if (!(before.storage > 0.0) || !(mass >= 0.0) || !std::isfinite(mass)) return refused;
  const Sym3 over = arenisca::overstress_of<double>(h);
  const arenisca::CentreState begin{
      from_centre(point_rock(h), stress, h),
      deviator(stress - over),
      h.plastic_volume_strain,
      h.equivalent_plastic_strain};
  const arenisca::DrainEnd end =
      arenisca::drain_rock(rock_, h.coherence, begin, h.fluid_mass_ratio, mass);
  const arenisca::PointRock point(rock_, h.coherence, mass);
  const arenisca::CentreState& n = end.state;
  const Sym3 new_stress = n.s + isotropic((n.x + point.zeta(n.e)) / 3.0) + over;
  const arenisca::Moduli m = point.moduli(n.x, n.e);
  const PorePoint after = arenisca::fluid_of(point, n.x, n.e);
  const double sum = end.fluid_work + end.plastic_work + m.bulk + m.shear + after.pressure;
  if (end.status != Status::ok || !is_finite(new_stress) || !std::isfinite(sum)) {
    refused.status = end.status != Status::ok ? end.status : Status::not_converged;
    refused.substeps = end.substeps;
    return refused;
  }
  stress = new_stress;
  h.plastic_volume_strain = n.e;
  h.equivalent_plastic_strain = n.shear_strain;
  h.fluid_mass_ratio = mass;
  h.pore_pressure = pressure_of_fluid(after.pressure, mass);
  h.porosity = after.porosity;
  outcome.substeps = end.substeps;
  outcome.plastic_work = end.plastic_work;
  outcome.elastic_work = end.fluid_work - end.plastic_work;
  outcome.longitudinal_modulus = m.bulk + 4.0 / 3.0 * m.shear;
  return outcome;
}

}  // namespace barreno
