// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/drain_particles.hpp"

#include "base/region.hpp"
#include "pore_flow/porous_points.hpp"

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
  const bool gravity = scene.body_force.kind == BodyForceKind::gravity;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!(cell.mobility[d] > 0.0)) continue;
    double slope = -network.flux[i][d] / cell.mobility[d];
    if (gravity) slope += scene.pore_flow.fluid_density * scene.body_force.acceleration[d];
    p += slope * (x[d] - cell.centroid[d]);
  }
  return p;
}

}  // namespace

DrainTally drain_particles(
    const Scene& scene, double dt, State& state, const PoreNetwork& network
) {
  const Region region("drain_particles");
  DrainTally tally;
  for (const Particles& particles : state.particles) {
    visit_porous(scene, particles, [&](const auto& model) {
      using Model = std::decay_t<decltype(model)>;
      for_each_solid_row(state.grid, particles, [&](int p, int key) {
        const auto i =
            static_cast<std::size_t>(network.cells.index_of_key[static_cast<std::size_t>(key)]);
        const double share = evened_share(network.cells.cells[i], state.grid.cell_size, dt);
        if (share == 0.0 && network.change[i] == 0.0) return;
        auto at = PorousPoint<Model>::read(particles, p);
        const PorePoint point = model.pore_point(at.stress, at.history);
        const double moved = point.pressure + network.change[i];
        const double line = line_at(scene, network, i, vector_of(particles.position, p));
        const double change = network.change[i] + share * (line - moved);
        const Outcome outcome = model.drain(change * point.storage, at.stress, at.history);
        if (outcome.failed()) {
          tally.failures += 1.0;
          return;
        }
        at.write(p, particles);
        for (int d = 0; d < particles.darcy_velocity.components; ++d)
          particles.darcy_velocity(p, d) = network.flux[i][static_cast<std::size_t>(d)];
        const double reference =
            particles.mass(p) /
            scene.materials[static_cast<std::size_t>(particles.material)].material.density;
        tally.elastic += reference * outcome.elastic_work;
        tally.plastic += reference * outcome.plastic_work;
      });
    });
  }
  return tally;
}

}  // namespace barreno
