// SPDX-License-Identifier: BSD-3-Clause
#include "step/gather_affine.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/node_moments.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct GatherAffine {
  static constexpr int dimensions = M::dimensions;
  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> motion, tally;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    double energy = 0.0;
    const double* const patch = &motion(first_motion(frame.patch, tile));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
      const BatchRows rows(particles.order, k, end);
      SupportBatch<typename S::template Support<M>> supports;
      find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
      for (int i = 0; i < rows.count; ++i)
        energy += gather_row(rows.row[i], supports.get(i), patch);
    }
    tally(tile) = energy;
  }

  /// @return the energy that the row remembers
  template <class Support>
  KOKKOS_INLINE_FUNCTION double gather_row(int p, const Support& support, const double* patch)
      const {
    const NodeMoments<dimensions> moments(frame.patch, support);
    double first[extent<dimensions>][extent<dimensions>] = {};
    support.for_each_node(frame.patch, [&](int slot, double s, const double*, double) {
      double at[extent<dimensions>];
      place_of_slot(frame.patch, slot, at);
      const double* const v = patch + slot * motion_components(dimensions);
      for (int i = 0; i < dimensions; ++i)
        for (int d = 0; d < dimensions; ++d) first[i][d] += s * v[i] * (at[d] - moments.centre[d]);
    });
    const InverseMoments<dimensions> inverse(moments.second);
    double square = 0.0;
    for (int i = 0; i < dimensions; ++i) {
      double slope[extent<dimensions>];
      inverse.solve(first[i], slope);
      for (int d = 0; d < dimensions; ++d) {
        particles.affine(p, dimensions * i + d) = first[i][d] / frame.per_cell;
        square += first[i][d] * slope[d];
      }
    }
    return 0.5 * particles.mass(p) * square;
  }
};

}  // namespace

void gather_affine(const Scene& scene, State& state) {
  if (scene.step.transfer != Transfer::apic) return;
  const Region region("gather_affine");
  state.ledger.remembered = {};
  visit_kernels(scene, [&](auto mode, auto shape) {
    using Kernel = GatherAffine<decltype(mode), decltype(shape)>;
    const PatchFrame<decltype(mode)::dimensions> frame(scene, state.grid);
    for (const Particles& particles : state.particles) {
      if (particles.rigid) continue;
      const Nodes& nodes = state.nodes[static_cast<std::size_t>(particles.field)];
      // solve_velocity has made room for it, and its own tally is read.
      launch(
          "gather_affine",
          range(state.grid.active),
          Kernel{frame, particles, nodes.motion, nodes.tally}
      );
      for (int tile = 0; tile < state.grid.active; ++tile)
        state.ledger.remembered += nodes.tally(tile);
    }
  });
}

}  // namespace barreno
