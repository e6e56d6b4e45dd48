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

/// Gradient of the mean velocity of the nodes over a step, and the mean square of what the nodes'
/// increments are off the particle's, one array per number.
template <unsigned D>
struct NodesOfBatch {
  alignas(64) double gradient[D * D][rows_per_batch];
  alignas(64) double hoop[rows_per_batch];
  alignas(64) double spread[rows_per_batch];
};

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

  /// What of a strain counts towards Largest Strain, squared.
  KOKKOS_INLINE_FUNCTION double counted_squared(int p, double square) const {
    const VoidRule& rule = particles.void_rule;
    const bool is_open = rule.column >= 0 && particles.history(p, rule.column) > rule.open;
    return is_open ? rule.share * rule.share * square : square;
  }

  /// @param at  motion of the nodes at the particle
  template <class Support, class At>
  KOKKOS_INLINE_FUNCTION void keep_nodes(
      int k,
      const Support& support,
      const At& at,
      const Motion* patch,
      NodesOfBatch<M::dimensions>& n
  ) const {
    for (int i = 0; i < dimensions; ++i)
      for (int j = 0; j < dimensions; ++j)
        n.gradient[dimensions * i + j][k] = at.d[j][i] - 0.5 * at.d[j][dimensions + i];
    n.hoop[k] = M::hoop ? at.hoop[0] - 0.5 * at.hoop[dimensions] : 0.0;
    Motion squares{};
    support.for_each_node(frame.patch, [&](int slot, double weight, const double*, double) {
      const Motion off = patch[slot] - at.value;
      squares += weight * (off * off);
    });
    double spread = 0.0;
    for (int i = 0; i < dimensions; ++i) spread += squares[dimensions + i];
    n.spread[k] = spread;
  }

  /// Energy that the grid took from each row: the work of its internal forces on the mean
  /// velocities of their nodes, and what FLIP loses since the particle takes one increment where
  /// nodes have many. docs/method.md (2.13)
  KOKKOS_INLINE_FUNCTION void put_heat(
      double dt, const BatchRows& rows, const NodesOfBatch<M::dimensions>& n
  ) const {
    alignas(64) double heat[rows_per_batch];
    const StressColumns<M> given(particles, rows);
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) {
      const Sym3 s = given.space_stress(k);
      const double q = given.viscous_pressure(k);
      double rate = (s.xx - q) * n.gradient[0][k] + s.xy * n.gradient[1][k];
      if constexpr (dimensions == 2) {
        rate += s.xy * n.gradient[2][k] + (s.yy - q) * n.gradient[3][k];
        rate += (s.zz - q) * n.hoop[k];
      } else {
        rate += s.zx * n.gradient[2][k] + s.xy * n.gradient[3][k] + (s.yy - q) * n.gradient[4][k];
        rate += s.yz * n.gradient[5][k] + s.zx * n.gradient[6][k] + s.yz * n.gradient[7][k];
        rate += (s.zz - q) * n.gradient[8][k];
      }
      heat[k] = dt * given.volume(k) * rate + 0.5 * given.mass(k) * n.spread[k];
    }
    for (int k = 0; k < rows.count; ++k) particles.heat(rows.row[k]) = heat[k];
  }

  KOKKOS_INLINE_FUNCTION double batch(int tile, const BatchRows& rows, const Motion* patch) const {
    SupportBatch<typename S::template Support<M>> supports;
    find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
    const FieldView grid_motion = particles.grid_motion.values;
    const FieldView increment = particles.increment.values;
    const double dt = frame.tile_frame(tile).dt;
    const bool returns = particles.heat.components > 0;
    NodesOfBatch<M::dimensions> nodes;
    double largest = 0.0;
    for (int k = 0; k < rows.count; ++k) {
      const int p = rows.row[k];
      const auto support = supports.get(k);
      const auto at = support.template interpolate<M::hoop>(patch, frame.patch);
      if (returns) keep_nodes(k, support, at, patch, nodes);
      for (int i = 0; i < 2 * dimensions; ++i) grid_motion(p, i) = at.value[i];
      for (int i = 0; i < dimensions; ++i)
        for (int j = 0; j < dimensions; ++j) increment(p, dimensions * i + j) = dt * at.d[j][i];
      if constexpr (dimensions == 2) increment(p, 4) = dt * at.hoop[0];
      const double square = dt * dt * rate_squared(at.d, at.hoop[0]);
      if (square > largest) largest = real::larger(counted_squared(p, square), largest);
    }
    if (!returns) return largest;
    for (int k = rows.count; k < rows_per_batch; ++k) repeat_last(rows.count - 1, k, nodes);
    put_heat(dt, rows, nodes);
    return largest;
  }

  /// Lanes without a row of their own are computed too, and not kept.
  KOKKOS_INLINE_FUNCTION static void repeat_last(int from, int to, NodesOfBatch<M::dimensions>& n) {
    for (auto& one : n.gradient) one[to] = one[from];
    n.hoop[to] = n.hoop[from];
    n.spread[to] = n.spread[from];
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
