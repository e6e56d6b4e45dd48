// SPDX-License-Identifier: BSD-3-Clause
#include "step/project_body_force.hpp"

#include "base/region.hpp"
#include "scene/body_force.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"

namespace barreno {
namespace {

/// m b of one particle.
Vector force_on(const Scene& scene, const Clock& clock, const Particles& particles, int p) {
  Vector reference{};
  for (int c = 0; c < particles.reference_position.components; ++c)
    reference[static_cast<std::size_t>(c)] = particles.reference_position(p, c);
  const bool half_step = clock.step == 0 && is_manufactured(scene.body_force);
  Vector force = body_force(scene.body_force, reference, clock.time);
  for (double& component : force) component *= (half_step ? 0.5 : 1.0) * particles.mass(p);
  return force;
}

/// Forces on the rows of a batch, all in one tile, onto its patch.
template <class M, class S>
void project_batch(
    const PatchFrame<M::dimensions>& frame,
    const Scene& scene,
    const Particles& particles,
    int tile,
    const BatchRows& rows,
    State& state
) {
  SupportBatch<typename S::template Support<M>> supports;
  find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
  double* const patch =
      &state.nodes[static_cast<std::size_t>(particles.field)].sums(first_sum(frame.patch, tile));
  for (int k = 0; k < rows.count; ++k) {
    const Vector force = force_on(scene, state.clock, particles, rows.row[k]);
    supports.get(k).for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
      double* const node = patch + slot * sum_components + first_force(M::dimensions);
      for (std::size_t d = 0; d < M::dimensions; ++d) node[d] += s * force[d];
    });
  }
}

}  // namespace

void project_body_force(const Scene& scene, State& state) {
  if (scene.body_force.kind == BodyForceKind::none) return;
  const Region region("project_body_force");
  visit_kernels(scene, [&](auto mode, auto shape) {
    using M = decltype(mode);
    using S = decltype(shape);
    const PatchFrame<M::dimensions> frame(scene, state.grid);
    for (const Particles& particles : state.particles)
      for (int tile = 0; tile < state.grid.active; ++tile) {
        const int end = particles.tile_begin(tile + 1);
        for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
          project_batch<M, S>(
              frame, scene, particles, tile, BatchRows(particles.order, k, end), state
          );
      }
  });
}

WholeSum tally_body_force(const Scene& scene, double dt, State& state) {
  if (scene.body_force.kind == BodyForceKind::none) return {};
  const Region region("tally_body_force");
  WholeSum work;
  for (const Particles& particles : state.particles)
    for (int tile = 0; !particles.rigid && tile < state.grid.active; ++tile) {
      double of_tile = 0.0, impulse = 0.0;  // rows of a tile have one order
      for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
        const int p = particles.order(k);
        const Vector force = force_on(scene, state.clock, particles, p);
        // Mean velocity of the step: v after it less half of its increment.
        const int dimensions = particles.position.components;
        for (int d = 0; d < dimensions; ++d)
          of_tile += dt * force[static_cast<std::size_t>(d)] *
                     (particles.grid_motion(p, d) - 0.5 * particles.grid_motion(p, d + dimensions));
        impulse += dt * force[1];
      }
      work += of_tile;
      state.ledger.body_impulse += impulse;
    }
  state.ledger.body_work += work;
  return work;
}

}  // namespace barreno
