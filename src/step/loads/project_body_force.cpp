// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/project_body_force.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "scene/body_force.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"

namespace barreno {
namespace {

/// The body force on the particles of one set.
struct BodyForce {
  BodyForceSpec spec;
  double time;
  double share;  ///< of the step in which it acts
  Particles particles;

  BodyForce(const BodyForceSpec& force, const Clock& clock, const Particles& of)
      : spec(force),
        time(clock.time),
        share(clock.step == 0 && is_manufactured(force) ? 0.5 : 1.0),
        particles(of) {}

  /// m b of one particle.
  KOKKOS_INLINE_FUNCTION Vector operator()(int p) const {
    Vector reference{};
    for (int c = 0; c < particles.reference_position.components; ++c)
      reference[static_cast<std::size_t>(c)] = particles.reference_position(p, c);
    Vector force = body_force(spec, reference, time);
    for (double& component : force) component *= share * particles.mass(p);
    return force;
  }
};

template <class M, class S>
struct ProjectBodyForce {
  PatchFrame<M::dimensions> frame;
  BodyForce force;
  Nodes nodes;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Particles& particles = force.particles;
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      project_batch(tile, BatchRows(particles.order, k, end));
  }

  /// Forces on the rows of a batch, all in one tile, onto its patch.
  KOKKOS_INLINE_FUNCTION void project_batch(int tile, const BatchRows& rows) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(frame, tile, rows, shape_fields(force.particles), supports);
    double* const patch = &nodes.sums(first_sum(frame.patch, tile));
    for (int k = 0; k < rows.count; ++k) {
      const Vector of_row = force(rows.row[k]);
      supports.get(k).for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
        double* const node = patch + slot * sum_components + first_force(M::dimensions);
        for (std::size_t d = 0; d < M::dimensions; ++d) node[d] += s * of_row[d];
      });
    }
  }
};

struct BodyForceTally {
  ReproducibleSum work, impulse;
};
KOKKOS_INLINE_FUNCTION void add(const BodyForceTally& part, BodyForceTally& sum) {
  sum.work += part.work;
  sum.impulse += part.impulse;
}

struct TallyBodyForce {
  ArrayView<TileFrame> tile_frame;
  BodyForce force;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, BodyForceTally& tally) const {
    const Particles& particles = force.particles;
    const double dt = tile_frame(tile).dt;
    const int dimensions = particles.position.components;
    double of_tile = 0.0, impulse = 0.0;  // rows of a tile have one order
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      const Vector of_row = force(p);
      // Mean velocity of the step: v after it less half of its increment.
      for (int d = 0; d < dimensions; ++d)
        of_tile += dt * of_row[static_cast<std::size_t>(d)] *
                   (particles.grid_motion(p, d) - 0.5 * particles.grid_motion(p, d + dimensions));
      impulse += dt * of_row[1];
    }
    tally.work += of_tile;
    tally.impulse += impulse;
  }
};

}  // namespace

void project_body_force(
    const BodyForceSpec& force,
    const Clock& clock,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const std::vector<Nodes>& nodes
) {
  if (force.kind == BodyForceKind::none) return;
  const Region region("project_body_force");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using M = decltype(mode);
    for (const Particles& particles : sets)
      launch(
          "project_body_force",
          range(grid.active),
          ProjectBodyForce<M, decltype(shape)>{
              PatchFrame<M::dimensions>(grid),
              BodyForce(force, clock, particles),
              nodes[static_cast<std::size_t>(particles.field)]}
      );
  });
}

ReproducibleSum tally_body_force(
    const BodyForceSpec& force,
    const Clock& clock,
    const Grid& grid,
    const std::vector<Particles>& sets,
    OwnLedger& ledger
) {
  if (force.kind == BodyForceKind::none) return {};
  const Region region("tally_body_force");
  BodyForceTally sum;
  for (const Particles& particles : sets) {
    if (particles.rigid) continue;
    BodyForceTally of_set;
    launch_reduction(
        "tally_body_force",
        range(grid.active),
        TallyBodyForce{grid.tile_frame, BodyForce(force, clock, particles)},
        TallyReducer<BodyForceTally>(of_set)
    );
    add(of_set, sum);
  }
  ledger.body_work += sum.work;
  ledger.body_impulse += sum.impulse;
  return sum.work;
}

}  // namespace barreno
