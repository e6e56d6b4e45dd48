// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/centre_path.hpp"
#include "barreno/arenisca/general_law.hpp"
#include "barreno/arenisca/points_queue.hpp"
#include "barreno/arenisca/points_start.hpp"
#include "barreno/pore_point.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Mass of fluid, over the initial one, that volume 1 of it has at the density within the pores at
/// the centre, per volume there: fluid_mass/porosity, without gas.
BARRENO_FUNCTION double mass_per_volume(const PointRock& point, double centre_pressure, double e) {
  const PoreFluid& fluid = point.fluid;
  const double q = centre_pressure - fluid.initial_pressure;
  return point.density / fluid.porosity * std::exp(q / fluid.bulk + e);
}

/// How the fluid of a point answers more of it at fixed strain (PorePoint). Full pores:
///
///   1/M = phi (1/Kf - 1/Km) + alpha/Km,   alpha = 1 - Kd/Km,   Kd the drained tangent
///
/// exactly, whatever Kd(x) is. After a gas gap was closed the way there is another, and so are
/// slope and alpha: 1/M = phi (1/Kf - 1/Km)/(1 - Ks B'/Km), B' at the closing. A gap that is open
/// stores by its gas.
BARRENO_FUNCTION PorePoint fluid_of(const PointRock& point, double x, double e) {
  constexpr double gas = 5e-5;  // bulk modulus over the fluid's: of air and water
  const PoreFluid& fluid = point.fluid;
  const Elasticity& elasticity = point.rock.elasticity;
  const FluidState at = point.at_centre(e);
  const double drained = elasticity.moduli_at(x, e).bulk;
  const double pores = at.porosity * (1.0 / fluid.bulk - 1.0 / fluid.matrix);
  const CentrePath path = centre_path(fluid, elasticity, at, x, e);
  PorePoint p;
  p.pressure = path.pressure;
  p.porosity = at.porosity;
  p.biot = 1.0 - drained / fluid.matrix;
  p.storage = p.biot / fluid.matrix + pores;
  p.mass_per_volume = mass_per_volume(point, at.pressure, e);
  if (x >= at.threshold) {
    const double start = at.gap ? 0.0 : at.threshold;
    const double strain =
        at.gap ? path.strain : (x - start) / (3.0 * elasticity.moduli_at(x, e).bulk);
    const double centre_gap = at.gap ? -std::expm1(point.filling - e) : 0.0;
    const double gap = centre_gap + strain - (x - start) / (3.0 * fluid.matrix);
    p.gap = larger(0.0, gap);
    p.gap_pressure = gas * fluid.bulk;
    p.storage += p.gap / p.gap_pressure;
  } else if (at.gap) {
    const double at_closing = elasticity.moduli_at(at.threshold, e).bulk;
    const double coupling =
        fluid.saturated(drained, at.porosity) * fluid.skempton(at_closing, at.porosity);
    p.storage = pores / (1.0 - coupling / fluid.matrix);
    p.biot = coupling * p.storage;
  }
  return p;
}

/// The elastic centre after fluid has flowed at fixed strain. What the rock has undergone stays, so
/// grains and pores of the centre change alike, as under one pressure within and without:
///
///   e + e_v + p_c/Km and phi are as before,   d ln(mass) = (1/Kf - 1/Km) d p_c
///
/// with e_v = (p_i - p_v)/Km and p_v of virgin rock with that mass (PoreFluid::holding()). Where
/// p_c comes to 0 a gas gap opens.
struct DrainedCentre {
  double e;
  double rise;  ///< of p_c [stress]
};
BARRENO_FUNCTION DrainedCentre
drained_centre(const PointRock& before, const PointRock& after, double e) {
  const double matrix = before.fluid.matrix, p_v = before.fluid.initial_pressure;
  const double p_w = after.fluid.initial_pressure;
  const double p_c = before.at_centre(e).pressure;
  const bool full = before.mu == 1.0 && after.mu == 1.0 && p_c > 0.0;
  if (full && p_c + (p_w - p_v) >= 0.0) return {e, p_w - p_v};
  const double kept = e + (p_c - p_v) / matrix;
  const double phi = -std::expm1(std::log1p(-before.fluid.porosity) - kept);
  const double per_pressure = 1.0 / before.fluid.bulk - 1.0 / matrix;
  const double q = (std::log(after.mu * before.fluid.porosity / phi) - kept) / per_pressure;
  const double pressure = larger(0.0, p_w + q);
  return {kept - (pressure - p_w) / matrix, pressure - p_c};
}

/// State of a point, seen from its elastic centre.
struct CentreState {
  double x;  ///< [stress]
  Sym3 s;    ///< stress deviator [stress]
  double e, shear_strain;
};
BARRENO_FUNCTION double distance(const CentreState& a, const CentreState& b) {
  return size_of_stress(a.x - b.x, second_invariant(a.s - b.s));
}
BARRENO_FUNCTION double size_of(const CentreState& n) {
  return size_of_stress(n.x, second_invariant(n.s));
}

/// Whether a state lies outside the surface of the rock.
BARRENO_FUNCTION bool is_outside(const PointRock& point, const CentreState& n) {
  NoCounter none;
  const Lode& lode = point.rock.lode;
  const double gamma = lode.active() ? lode.at(lode_angle(n.s)).gamma : 1.0;
  const YieldSurface surface = scaled_surface(point.surface, gamma);
  return !surface.contains(n.x, second_invariant(n.s), point.cap_at(n.e), none);
}

/// What became of a point into which fluid has flowed.
struct DrainEnd {
  CentreState state;
  bool plastic = false;
  bool crossed = false;     ///< a gas gap opened or closed at the centre
  double fluid_work = 0.0;  ///< integral of p dv [stress]
  double plastic_work = 0.0;
  int substeps = 0;
  Status status = Status::ok;
};

/// The model's own step under a volume strain about the centre.
BARRENO_FUNCTION void strain_volume(const PointRock& point, double strain, DrainEnd& end) {
  const Lanes none{}, coherence = none + point.coherence, mass = none + point.mass;
  const GeneralPiecesOf<Lanes> rock(point.rock, coherence, mass);
  const CentreState& n = end.state;
  StartOf<Lanes, GeneralRock> start{};
  start.x = none + n.x;
  start.s = {
      none + n.s.xx, none + n.s.yy, none + n.s.zz, none + n.s.xy, none + n.s.yz, none + n.s.zx};
  start.evp = none + n.e;
  start.dv = none + strain;
  LaneMask first{};
  first[0] = -1;
  StepOf<Lanes, GeneralRock> step[1] = {
      begin_step<Lanes, GeneralRock>(rock, start, none + n.shear_strain, first)};
  step[0].coherence = coherence;
  step[0].fluid_mass_ratio = mass;
  finish_steps(point.rock, step, 1);
  if (step[0].refused[0] != 0) end.status = Status::substep_limit;
  const StateOf<Lanes, GeneralRock>& m = step[0].state;
  end.state = {m.x[0], one_tensor(m.s.tensor, 0), m.evp[0], m.shear_strain[0]};
  end.plastic_work += step[0].plastic_work[0];
  end.substeps += static_cast<int>(step[0].substeps[0]);
}

/// One part of the flow. The strain about the centre is what the total strain leaves,
///
///   elastic strain = that before + (p_c' - p_c)/Km
///
/// and x follows from it exactly if the rock stays elastic, else by the model's own step.
BARRENO_FUNCTION void drain_part(const PointRock& before, const PointRock& after, DrainEnd& end) {
  const CentreState n = end.state;
  const Elasticity& elasticity = before.rock.elasticity;
  const DrainedCentre centre = drained_centre(before, after, n.e);
  const CentrePath old = centre_path(before.fluid, elasticity, before.at_centre(n.e), n.x, n.e);
  const FluidState at = after.at_centre(centre.e);
  const double strain = old.strain + centre.rise / before.fluid.matrix;
  CentreState elastic{n.x, n.s, centre.e, n.shear_strain};
  elastic.x = end_of_path(after.fluid, elasticity, at, strain, n.x, centre.e);
  const bool plastic = is_outside(after, elastic);
  end.crossed = end.crossed || at.gap != before.at_centre(n.e).gap;
  end.state = elastic;
  if (!plastic) {
    end.substeps += 1;
    return;
  }
  end.plastic = true;
  end.state.x = n.x;
  const double left = strain - centre_path(after.fluid, elasticity, at, n.x, centre.e).strain;
  strain_volume(after, left, end);
}

/// Pressure times volume per mass of the fluid.
BARRENO_FUNCTION double work_per_mass(const PointRock& point, const CentreState& n) {
  const FluidState at = point.at_centre(n.e);
  const double p = centre_path(point.fluid, point.rock.elasticity, at, n.x, n.e).pressure;
  return p / mass_per_volume(point, at.pressure, n.e);
}

/// The flow from one mass to another in `parts` equal parts.
BARRENO_FUNCTION DrainEnd drain_in_parts(
    const GeneralRock& rock,
    double coherence,
    const CentreState& begin,
    double mass,
    double mass_end,
    int parts
) {
  DrainEnd end;
  end.state = begin;
  const double change = mass_end - mass;
  double at = mass;
  for (int i = 1; i <= parts && end.status == Status::ok; ++i) {
    const double next = i == parts ? mass_end : mass + i * (change / parts);
    const PointRock before(rock, coherence, at), after(rock, coherence, next);
    const double work = work_per_mass(before, end.state);
    drain_part(before, after, end);
    end.fluid_work += 0.5 * (work + work_per_mass(after, end.state)) * (next - at);
    at = next;
  }
  return end;
}

/// Lets fluid in or out at fixed strain until the point holds mass_end. Elastic rock takes it at
/// once, flowing rock in as many parts as twice as many agree with, to the rock's tolerance (in one
/// if less than that changes). Where a gas gap opens or closes rock may flow on the way although
/// its end is elastic.
BARRENO_FUNCTION DrainEnd drain_rock(
    const GeneralRock& rock,
    double coherence,
    const CentreState& begin,
    double mass,
    double mass_end
) {
  constexpr int max_parts = 64, parts_of_crossing = 8;
  DrainEnd end = drain_in_parts(rock, coherence, begin, mass, mass_end, 1);
  const auto agree = [&](const CentreState& a, const DrainEnd& b) {
    const double allowed = rock.tolerance * larger(rock.stress_floor, size_of(b.state));
    return b.status == Status::ok && distance(a, b.state) <= allowed;
  };
  if (agree(begin, end)) return end;
  const int fewest = end.crossed ? parts_of_crossing : 2;
  for (int parts = fewest; (end.plastic || end.crossed) && parts <= max_parts; parts *= 2) {
    const DrainEnd finer = drain_in_parts(rock, coherence, begin, mass, mass_end, parts);
    const bool agreed = end.status == Status::ok && agree(end.state, finer);
    const int before = end.substeps;
    end = finer;
    end.substeps += before;
    if (agreed) break;
  }
  return end;
}

}  // namespace barreno::arenisca
