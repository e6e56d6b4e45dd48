// SPDX-License-Identifier: BSD-3-Clause
#include "step/solve_velocity.hpp"

#include "base/region.hpp"

#include <vector>

namespace barreno {
namespace {

constexpr int tally_components = 6;

/// A condition on the nodes beyond one index of an axis: components that it sets, and to what.
struct NodeCondition {
  int axis = 0;
  int bound = 0;  ///< nodes <= bound (lower face) or >= bound (upper face)
  bool lower = true;
  bool sets[2] = {false, false};
  double velocity[2] = {0.0, 0.0};

  KOKKOS_INLINE_FUNCTION bool holds(const int (&node)[2]) const {
    return lower ? node[axis] <= bound : node[axis] >= bound;
  }
};

constexpr int most_conditions = 5;
struct NodeConditions {
  int count = 0;
  NodeCondition list[most_conditions];
};

/// The axis of revolution is a symmetry condition that no deck needs to ask for.
NodeConditions node_conditions(const Scene& scene, const Grid& grid) {
  NodeConditions out;
  if (scene.grid.mode == Mode::axisymmetric && grid.lower[0] == 0.0) {
    NodeCondition& axis = out.list[out.count++];
    axis.sets[0] = true;
  }
  for (const ConditionSpec& spec : scene.conditions) {
    NodeCondition& c = out.list[out.count++];
    const int face = static_cast<int>(spec.face);
    c.axis = face / 2;
    c.lower = face % 2 == 0;
    c.bound = c.lower ? 0 : grid.cells[c.axis];
    for (int d = 0; d < 2; ++d) {
      c.sets[d] = spec.kind != ConditionKind::symmetry || d == c.axis;
      if (spec.kind == ConditionKind::prescribed_velocity)
        c.velocity[d] = spec.velocity[static_cast<std::size_t>(d)];
    }
  }
  return out;
}

struct SolveVelocity {
  NodeConditions conditions;
  ArrayView<int> tile_x, tile_y, neighbours;
  ArrayView<unsigned char> counts;
  ArrayView<double> sums, motion, tally;
  double dt;

  /// Whole sums of a patch: its own part and its neighbours', in lexicographic order of the tiles.
  KOKKOS_INLINE_FUNCTION void add_parts(int tile, double* total) const {
    for (int i = 0; i < patch_size * sum_components; ++i) total[i] = 0.0;
    for (int k = 0; k < neighbour_count; ++k) {
      const int other = neighbours(tile * neighbour_count + k);
      if (other < 0) continue;
      const int ox = k % 3 - 1;
      const int oy = k / 3 - 1;
      const int x0 = ox > 0 ? tile_cells : 0;
      const int x1 = ox < 0 ? patch_nodes - tile_cells : patch_nodes;
      const int y0 = oy > 0 ? tile_cells : 0;
      const int y1 = oy < 0 ? patch_nodes - tile_cells : patch_nodes;
      const double* const part =
          &sums(static_cast<std::size_t>(other) * patch_size * sum_components);
      for (int y = y0; y < y1; ++y) {
        double* const to = total + (y * patch_nodes + x0) * sum_components;
        const double* const from =
            part + ((y - oy * tile_cells) * patch_nodes + x0 - ox * tile_cells) * sum_components;
        for (int i = 0; i < (x1 - x0) * sum_components; ++i) to[i] += from[i];
      }
    }
  }

  KOKKOS_INLINE_FUNCTION void apply_conditions(
      const int (&node)[2],
      double mass,
      const double (&force)[2],
      double (&before)[2],
      double (&after)[2],
      double* part
  ) const {
    const double raw = before[1];
    bool set_y = false;
    for (int i = 0; i < conditions.count; ++i) {
      const NodeCondition& c = conditions.list[i];
      if (!c.holds(node)) continue;
      for (int d = 0; d < 2; ++d) {
        if (!c.sets[d]) continue;
        before[d] = c.velocity[d];
        after[d] = c.velocity[d];
        part[3] -= force[d] * c.velocity[d] * dt;
        set_y = set_y || d == 1;
      }
    }
    if (!set_y) return;
    part[4] -= force[1] * dt;
    part[5] += mass * (before[1] - raw);
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    alignas(64) double total[patch_size * sum_components];
    add_parts(tile, total);
    double part[tally_components] = {};
    for (int slot = 0; slot < patch_size; ++slot) {
      const double* const node = total + slot * sum_components;
      double* const out = &motion(
          (static_cast<std::size_t>(tile) * patch_size + static_cast<std::size_t>(slot)) *
          motion_components
      );
      const double mass = node[0];
      const double inverse = mass > 0.0 ? 1.0 / mass : 0.0;
      const double force[2] = {node[3], node[4]};
      double before[2] = {node[1] * inverse, node[2] * inverse};
      double after[2] = {before[0] + dt * force[0] * inverse, before[1] + dt * force[1] * inverse};
      double own[tally_components] = {};
      const int index[2] = {
          tile_x(tile) * tile_cells - reach + slot % patch_nodes,
          tile_y(tile) * tile_cells - reach + slot / patch_nodes};
      apply_conditions(index, mass, force, before, after, own);
      out[0] = after[0];
      out[1] = after[1];
      out[2] = after[0] - before[0];
      out[3] = after[1] - before[1];
      if (counts(tile * patch_size + slot) == 0 || mass <= 0.0) continue;
      own[0] = 0.5 * mass * (before[0] * before[0] + before[1] * before[1]);
      own[1] = 0.5 * mass * (after[0] * after[0] + after[1] * after[1]);
      own[2] = 0.5 * dt * (force[0] * (before[0] + after[0]) + force[1] * (before[1] + after[1]));
      for (int i = 0; i < tally_components; ++i) part[i] += own[i];
    }
    for (int i = 0; i < tally_components; ++i)
      tally(static_cast<std::size_t>(tile * tally_components + i)) = part[i];
  }
};

}  // namespace

GridTally solve_velocity(const Scene& scene, const Grid& grid, double dt, Nodes& nodes) {
  const Region region("solve_velocity");
  const auto values = static_cast<std::size_t>(grid.active) * tally_components;
  if (nodes.tally.extent(0) < values) nodes.tally = ArrayView<double>("tally", 2 * values);
  Kokkos::parallel_for(
      "solve_velocity",
      range(grid.active),
      SolveVelocity{
          node_conditions(scene, grid),
          grid.tile_x,
          grid.tile_y,
          grid.neighbours,
          grid.counts,
          nodes.sums,
          nodes.motion,
          nodes.tally,
          dt}
  );
  double sum[tally_components] = {};
  for (int t = 0; t < grid.active; ++t)
    for (int i = 0; i < tally_components; ++i)
      sum[i] += nodes.tally(static_cast<std::size_t>(t * tally_components + i));
  return {sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
}

}  // namespace barreno
