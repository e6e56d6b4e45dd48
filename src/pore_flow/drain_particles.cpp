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
double line_at(const Scene& scene, const PoreNetwork& network, std::size_t i, const Vector& x) {
  const PoreCell& cell = network.cells.cells[i];
  double p = cell.pressure + network.change[i];
  for (std::size_t d = 0; d < 3; ++d) {
    if (!(cell.mobility[d] > 0.0)) continue;
    const double slope = scene.pore_flow.fluid_weight[d] -
                         network.steepness[i] * network.flux[i][d] / cell.mobility[d];
    p += slope * (x[d] - cell.centroid[d]);
  }
  return p;
}

/// The material's own drain, in pieces where it does not manage at once (rock that jumps on the
/// way). A point that fails is as before.
template <class Model>
Outcome drain_point(const Model& model, double fluid_volume, PorousPoint<Model>& point) {
  constexpr int most_pieces = 64;
  const PorousPoint<Model> before = point;
  const double mass_per_volume = model.pore_point(point.stress, point.history).mass_per_volume;
  Outcome outcome;
  for (int pieces = 1; pieces <= most_pieces; pieces *= 4) {
    Outcome sum;
    sum.substeps = 0;
    point = before;
    for (int i = 0; i < pieces && !sum.failed(); ++i) {
      double volume = fluid_volume / pieces;
      // The mass counts: its density changes on the way.
      if (i > 0)
        volume *= mass_per_volume / model.pore_point(point.stress, point.history).mass_per_volume;
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
  const Scene& scene;
  const PoreNetwork& network;
  const Model& model;
  double cell_size, dt;
  const MaterialSpec& spec;
  double first_porosity = initial_pore_point(model).porosity;

  /// dp_p of a particle in own cell i. (7.4)
  double change_of(const PorePoint& point, const Vector& x, std::size_t i) const {
    const double share = evened_share(network.cells.cells[i], cell_size, dt);
    const double cell = network.change[i];
    if (share == 0.0) return cell;
    return cell + share * (line_at(scene, network, i, x) - point.pressure - cell);
  }

  void drain(const Particles& particles, int p, std::size_t i, DrainTally& tally) const {
    auto at = PorousPoint<Model>::read(particles, p);
    const PorePoint point = model.pore_point(at.stress, at.history);
    const double whole = fluid_volume(scene, particles, p, first_porosity);
    tally.fluid_before += whole * point.fluid_mass;
    tally.fluid += whole * point.fluid_mass;
    if (!(point.storage > 0.0)) return;
    const GasGap gap = gas_gap(model, point);
    double storage = point.storage, change = 0.0;
    if (gap.volume > 0.0 && network.cells.filled[i]) {
      storage -= gap.volume / gap.pressure;
      change = gap.volume;
    }
    change += change_of(point, vector_of(particles.position, p), i) * storage;
    const Outcome outcome = drain_point(model, change, at);
    if (outcome.failed()) {
      if (spec.bad_particles == BadParticlePolicy::hold) tally.held += 1.0;
      if (spec.bad_particles == BadParticlePolicy::stop) tally.stops += 1.0;
      treat_bad_particle(particles, p, spec.bad_particles, failed_key);
      return;
    }
    at.write(p, particles);
    for (int d = 0; d < particles.darcy_velocity.components; ++d)
      particles.darcy_velocity(p, d) = network.flux[i][static_cast<std::size_t>(d)];
    tally.fluid += whole * point.mass_per_volume * change;
    const double volume = particles.volume(p);
    tally.elastic += volume * outcome.elastic_work;
    tally.plastic += volume * outcome.plastic_work;
  }
};

}  // namespace

DrainTally drain_particles(
    const Scene& scene, double dt, State& state, const PoreNetwork& network
) {
  const Region region("drain_particles");
  DrainTally tally;
  for (const Particles& particles : state.particles) {
    const MaterialSpec& spec = scene.materials[static_cast<std::size_t>(particles.material)];
    visit_porous(scene, particles, [&](const auto& model) {
      using Model = std::decay_t<decltype(model)>;
      const DrainSet<Model> set{scene, network, model, state.grid.cell_size, dt, spec};
      for_each_solid_row(state.grid, particles, [&](int p, int key) {
        set.drain(
            particles,
            p,
            static_cast<std::size_t>(network.cells.index_of_key[static_cast<std::size_t>(key)]),
            tally
        );
      });
    });
  }
  return tally;
}

}  // namespace barreno
