// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/drain_particles.hpp"

#include "base/region.hpp"
#include "pore_flow/porous_points.hpp"
#include "state/bad_particle.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// How far the pressures within a cell have come to a line.
double evened_share(const PoreCell& cell, double cell_size, double dt) {
  const double pi = std::acos(-1.0);
  const double mobility = std::max({cell.mobility[0], cell.mobility[1], cell.mobility[2]});
  const double diffusivity = mobility * cell.volume / cell.storage;
  return -std::expm1(-pi * pi * diffusivity * dt / (cell_size * cell_size));
}

/// The pressure of a cell along a line through its centroid after the solve.
double line_at(
    const Vector& fluid_weight, const PoreNetwork& network, std::size_t i, const Vector& x
) {
  const PoreCell& cell = network.cells.cells[i];
  double p = cell.pressure + network.change[i];
  for (std::size_t d = 0; d < 3; ++d) {
    if (!(cell.mobility[d] > 0.0)) continue;
    const double slope =
        fluid_weight[d] - network.steepness[i] * network.flux[i][d] / cell.mobility[d];
    p += slope * (x[d] - cell.centroid[d]);
  }
  return p;
}

/// The material's own drain, in parts where it fails in one (rock that jumps on the
/// way). A point that fails is as before.
///
/// @param start  what the flow sees of the point
template <class Model>
Outcome drain_point(
    const Model& model, const PorePoint& start, double fluid_volume, MaterialPoint<Model>& point
) {
  constexpr int max_pieces = 64;
  const MaterialPoint<Model> before = point;
  const bool emptied = fluid_mass_after(start, fluid_volume) == 0.0;
  Outcome outcome;
  for (int pieces = 1; pieces <= max_pieces; pieces *= 4) {
    Outcome sum;
    sum.substeps = 0;
    point = before;
    for (int i = 0; i < pieces && !sum.failed(); ++i) {
      double volume = fluid_volume / pieces;
      // The mass counts: its density changes on the way.
      if (i > 0) {
        const PorePoint now = model.pore_point(point.stress, point.history);
        volume *= start.mass_per_volume / now.mass_per_volume;
        if (emptied && i + 1 == pieces) volume = -now.fluid_mass / now.mass_per_volume;
      }
      outcome = model.drain(volume, point.stress, point.history);
      sum.status = outcome.status;
      sum.substeps += outcome.substeps;
      sum.elastic_work += outcome.elastic_work;
      sum.plastic_work += outcome.plastic_work;
      sum.longitudinal_modulus = outcome.longitudinal_modulus;
    }
    outcome = sum;
    if (!sum.failed() || sum.status == Status::bad_input) break;
  }
  if (outcome.failed()) point = before;
  return outcome;
}

/// The particles of one material.
template <class Model>
struct DrainSet {
  const Vector& fluid_weight;
  const PoreNetwork& network;
  const Model& model;
  const MaterialSpec& spec;
  double first_porosity = initial_pore_point(model).porosity;

  /// dp_p of a particle in own cell i. (7.4)
  double change_of(const PorePoint& point, const Vector& x, std::size_t i) const {
    const double share = network.shares.evened[i];
    const double cell = network.change[i];
    if (share == 0.0) return cell;
    return cell + share * (line_at(fluid_weight, network, i, x) - point.pressure - cell);
  }

  /// The fluid that a particle of own cell i wants, and what it and its cell can spare.
  void want(const Particles& particles, int p, std::size_t i, PoreShares& shares) const {
    const auto at = MaterialPoint<Model>::read(particles, p);
    const PorePoint point = model.pore_point(at.stress, at.history);
    shares.points.push_back({point, 0.0});
    if (!(point.storage > 0.0)) return;
    double storage = point.storage, change = 0.0;
    if (point.gap > 0.0 && network.cells.filled[i]) {
      storage -= point.gap / point.gap_pressure;
      change = point.gap;
    }
    change += change_of(point, vector_of(particles.position, p), i) * storage;
    const double content = point.fluid_mass / point.mass_per_volume;
    if (network.cells.emptied[i]) change = -content;
    shares.points.back().wanted = change;
    const double whole = fluid_volume(spec, particles.mass(p), first_porosity);
    (change < -content ? shares.lacking : shares.spare)[i] +=
        whole * point.mass_per_volume * std::fabs(content + change);
  }

  /// What the particle gets: no point loses more than it holds, the others of its cell give the
  /// rest.
  double granted(const PoreShare& share, std::size_t i, const PoreShares& shares) const {
    const double content = share.point.fluid_mass / share.point.mass_per_volume;
    if (share.wanted <= -content) return -content;
    if (!(shares.lacking[i] > 0.0)) return share.wanted;
    return (content + share.wanted) * std::max(0.0, 1.0 - shares.lacking[i] / shares.spare[i]) -
           content;
  }

  void drain(
      const Particles& particles,
      int p,
      std::size_t i,
      const PoreShare& share,
      const PoreShares& shares,
      DrainTally& tally
  ) const {
    const PorePoint& point = share.point;
    const double whole = fluid_volume(spec, particles.mass(p), first_porosity);
    tally.fluid_before += whole * point.fluid_mass;
    tally.fluid += whole * point.fluid_mass;
    if (!(point.storage > 0.0)) return;
    auto at = MaterialPoint<Model>::read(particles, p);
    const double change = granted(share, i, shares);
    const Outcome outcome = drain_point(model, point, change, at);
    if (outcome.failed()) {
      if (spec.bad_particles == BadParticlePolicy::hold) tally.held += 1.0;
      if (spec.bad_particles == BadParticlePolicy::stop) tally.stops += 1.0;
      treat_bad_particle(particles, p, spec.bad_particles, Fault::failed);
      return;
    }
    at.write(p, particles);
    for (int d = 0; d < particles.darcy_velocity.components; ++d)
      particles.darcy_velocity(p, d) = network.flux[i][static_cast<std::size_t>(d)];
    tally.fluid += whole * point.mass_per_volume * change;
    const double volume = particles.volume(p);
    DrainTally::Works& works = tally.materials[static_cast<std::size_t>(particles.material)];
    works.elastic += volume * outcome.elastic_work;
    works.plastic += volume * outcome.plastic_work;
  }
};

/// visit(set, particles, row, own cell) for every particle of rock.
template <class Visitor>
void for_each_porous(const PorousMedium& medium, const PoreNetwork& network, Visitor&& visit) {
  for (const Particles& particles : medium.particles) {
    const MaterialSpec& spec = medium.material_of(particles);
    visit_porous(spec, [&](const auto& model) {
      using Model = std::decay_t<decltype(model)>;
      const DrainSet<Model> set{medium.flow.fluid_weight, network, model, spec};
      for_each_solid_row(medium.grid, particles, [&](int p, int key) {
        const int cell = network.cells.index_of_key[static_cast<std::size_t>(key)];
        visit(set, particles, p, static_cast<std::size_t>(cell));
      });
    });
  }
}

}  // namespace

DrainTally drain_particles(const PorousMedium& medium, double dt, PoreNetwork& network) {
  const Region region("drain_particles");
  PoreShares& shares = network.shares;
  shares.points.clear();
  shares.evened.clear();
  for (std::size_t i = 0; i < network.links.size(); ++i)
    shares.evened.push_back(evened_share(network.cells.cells[i], medium.grid.cell_size, dt));
  shares.lacking.assign(network.links.size(), 0.0);
  shares.spare.assign(network.links.size(), 0.0);
  for_each_porous(medium, network, [&](const auto& set, const auto& rock, int p, auto i) {
    set.want(rock, p, i, shares);
  });
  DrainTally tally;
  tally.materials.resize(medium.particles.size());  // a set for each
  std::size_t next = 0;
  for_each_porous(medium, network, [&](const auto& set, const auto& rock, int p, auto i) {
    set.drain(rock, p, i, shares.points[next++], shares, tally);
  });
  return tally;
}

}  // namespace barreno
