// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/interpolate_motion.hpp"

#include "base/launch.hpp"
#include "base/pack.hpp"
#include "base/region.hpp"
#include "shape/support_batch.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/space_stress.hpp"

#include <barreno/real.hpp>

namespace barreno {
namespace {

template <class M, class S>
struct InterpolateMotion {
  static constexpr int dimensions = M::dimensions;
  static constexpr int components = motion_components(dimensions);
  using Motion = Pack<components>;

  PatchFrame<M::dimensions> frame;
  Particles particles;
  ArrayView<double> motion;
  Dormancy dormancy;
  Subcycling subcycling;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& largest) const {
    if (dormancy.is_left(tile)) return stay(tile);
    const ArrayView<double>& values = subcycling.takes_whole(tile) ? subcycling.whole : motion;
    const Motion* const patch = as_packs<components>(&values(first_motion(frame.patch, tile)));
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch)
      largest = real::larger(batch(tile, BatchRows(particles.order, k, end), patch), largest);
  }

  /// Rows of a tile that is left as it is move by nothing, as far as they are in a chunk that is
  /// updated.
  KOKKOS_INLINE_FUNCTION void stay(int tile) const {
    const FieldView grid_motion = particles.grid_motion.values;
    const FieldView increment = particles.increment.values;
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      if (particles.chunk_part(p / rows_per_chunk) == no_part_of_chunk) continue;
      for (int c = 0; c < particles.grid_motion.components; ++c) grid_motion(p, c) = 0.0;
      for (int c = 0; c < particles.increment.components; ++c) increment(p, c) = 0.0;
      if (particles.heat.components > 0) particles.heat(p) = 0.0;
    }
  }

  /// Square of the Frobenius norm of D, the symmetric part of L; d[j][i] = dv_i / dx_j.
  KOKKOS_INLINE_FUNCTION static double rate_squared(const Motion* d, double hoop) {
    double sum = hoop * hoop;
    for (int i = 0; i < dimensions; ++i) {
      sum += d[i][i] * d[i][i];
      for (int j = 0; j < i; ++j) {
        const double shear = d[j][i] + d[i][j];
        sum += 0.5 * shear * shear;
      }
    }
    return sum;
  }

  /// Energy that the grid took from row p: the work of its internal forces on the mean velocities
  /// of their nodes, and what FLIP loses since the particle takes one increment where nodes have
  /// many. docs/method.md (2.13)
  template <class Support, class At>
  KOKKOS_INLINE_FUNCTION double heat_of(
      int p, double dt, const Support& support, const At& at, const Motion* patch
  ) const {
    const Sym3 s = space_stress<M>(particles, p);
    const double q = particles.viscous_pressure(p);
    const double stress[3][3] = {
        {s.xx - q, s.xy, s.zx}, {s.xy, s.yy - q, s.yz}, {s.zx, s.yz, s.zz - q}};
    double rate = 0.0;
    for (int i = 0; i < dimensions; ++i)
      for (int j = 0; j < dimensions; ++j)
        rate += stress[i][j] * (at.d[j][i] - 0.5 * at.d[j][dimensions + i]);
    if constexpr (M::hoop) rate += stress[2][2] * (at.hoop[0] - 0.5 * at.hoop[dimensions]);
    double spread = 0.0;
    support.for_each_node(frame.patch, [&](int slot, double weight, const double*, double) {
      for (int i = 0; i < dimensions; ++i) {
        const double off = patch[slot][dimensions + i] - at.value[dimensions + i];
        spread += weight * off * off;
      }
    });
    return dt * particles.volume(p) * rate + 0.5 * particles.mass(p) * spread;
  }

  KOKKOS_INLINE_FUNCTION double batch(int tile, const BatchRows& rows, const Motion* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
    const FieldView grid_motion = particles.grid_motion.values;
    const FieldView increment = particles.increment.values;
    const double dt = frame.tile_frame(tile).dt;
    double largest = 0.0;
    for (int k = 0; k < rows.count; ++k) {
      const int p = rows.row[k];
      const auto support = supports.get(k);
      const auto at = support.template interpolate<M::hoop>(patch, frame.patch);
      if (particles.heat.components > 0) particles.heat(p) = heat_of(p, dt, support, at, patch);
      for (int i = 0; i < 2 * dimensions; ++i) grid_motion(p, i) = at.value[i];
      for (int i = 0; i < dimensions; ++i)
        for (int j = 0; j < dimensions; ++j) increment(p, dimensions * i + j) = dt * at.d[j][i];
      if constexpr (dimensions == 2) increment(p, 4) = dt * at.hoop[0];
      largest = real::larger(dt * dt * rate_squared(at.d, at.hoop[0]), largest);
    }
    return largest;
  }
};

}  // namespace

double interpolate_motion(
    const Grid& grid,
    const Dormancy& dormancy,
    const Subcycling& subcycling,
    const Nodes& nodes,
    Particles& particles
) {
  const Region region("interpolate_motion");
  double largest = 0.0;
  visit_kernels(grid, [&](auto mode, auto shape) {
    using Kernel = InterpolateMotion<decltype(mode), decltype(shape)>;
    launch_reduction(
        "interpolate_motion",
        range(grid.active),
        Kernel{
            PatchFrame<decltype(mode)::dimensions>(grid),
            particles,
            nodes.motion,
            dormancy,
            subcycling},
        Kokkos::Max<double>(largest)
    );
  });
  return std::sqrt(real::larger(largest, 0.0));
}

}  // namespace barreno
