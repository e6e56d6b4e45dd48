// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/solve_velocity.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "grid/coarse_nodes.hpp"
#include "shape/kinematics.hpp"
#include "step/dormant/find_unsolved_tiles.hpp"
#include "step/subcycle/whole_motion.hpp"

#include <vector>

namespace barreno {
namespace {

constexpr int tally_components = 13;
/// So many are more than nothing at a node with forces of its particles alone (is_plain).
constexpr int plain_components = 3;
/// Of each the two parts of add_split.
constexpr int tally_values = 2 * tally_components;

/// Which of them are impulses; the others are energies.
KOKKOS_INLINE_FUNCTION constexpr bool is_impulse(int i) {
  return i == 4 || i == 5 || i == 7 || i == 9 || i == 12;
}

template <unsigned D>
struct SolveVelocity {
  static constexpr int dimensions = D;
  VelocityRule rule;
  Patch patch;
  ArrayView<TileFrame> tile_frame;
  ArrayView<int> neighbours, parent;  ///< parent: empty where nothing is refined
  ArrayView<unsigned char> from_parent, counts;
  ArrayView<double> sums, motion, tally;
  ArrayView<unsigned char> shared_tile;  ///< tiles in which contact acts; empty without contact
  ArrayView<unsigned char> passes_up;  ///< tiles that follow such; empty without levels or contact
  ArrayView<double> impulse;
  DormantNodes dormant;
  Subcycling subcycling;

  /// Nodes of a tile that take as many parts of a step at once.
  struct NodeGroup {
    int period;
    bool all;   ///< the tile has no others
    bool free;  ///< no condition holds at any node of the tile
    double dt;  ///< of their steps [time]
    NodeScales scales;
    PrescribedVelocities velocities;
  };

  /// Those of a row from the first to behind the last that are in a group.
  struct Span {
    int begin, end;
  };

  /// Whole sums of nodes of a patch that share y and z: its own part and its neighbours', in
  /// lexicographic order of the tiles.
  KOKKOS_INLINE_FUNCTION void add_parts(int tile, int y, int z, const Span& span, double* total)
      const {
    for (int i = span.begin * sum_components; i < span.end * sum_components; ++i) total[i] = 0.0;
    const int side = 2 * patch.near + 1;
    for (int oz = -patch.near_along(2); oz <= patch.near_along(2); ++oz) {
      const int from_z = z - oz * patch.tile_cells;
      if (from_z < 0 || from_z >= patch.nodes) continue;
      for (int oy = -patch.near; oy <= patch.near; ++oy) {
        const int from_y = y - oy * patch.tile_cells;
        if (from_y < 0 || from_y >= patch.nodes) continue;
        const int k = ((oz + patch.near_along(2)) * side + oy + patch.near) * side;
        add_row_parts(tile, k, (from_z * patch.nodes + from_y) * patch.nodes, span, total);
      }
    }
  }
  /// The same of the neighbours along x from the k-th on, whose row of nodes begins at a slot.
  KOKKOS_INLINE_FUNCTION void add_row_parts(
      int tile, int k, int slot, const Span& span, double* total
  ) const {
    for (int ox = -patch.near; ox <= patch.near; ++ox, ++k) {
      const int other = neighbours(tile * patch.neighbours + k);
      if (other < 0) continue;
      const int first = patch.overlap_begin(ox), last = patch.overlap_end(ox);
      const int begin = first > span.begin ? first : span.begin;
      const int end = last < span.end ? last : span.end;
      const double* const from =
          &sums(first_sum(patch, other)) + (slot + begin - ox * patch.tile_cells) * sum_components;
      double* const to = total + begin * sum_components;
      for (int i = 0; i < (end - begin) * sum_components; ++i) to[i] += from[i];
    }
  }

  /// The motion of a node that is no unknown of its tile, over the step that the coarser tile ends.
  KOKKOS_INLINE_FUNCTION void take_from_parent(int tile, int slot, double* out) const {
    constexpr int width = motion_components(dimensions);
    const WholeMotion of_step{patch, tile_frame, motion, subcycling};
    const bool whole = subcycling.takes_whole(parent(tile)) && of_step.period_of(tile, slot) > 1;
    const double* const last = &motion(first_motion(patch, parent(tile)));
    for (int i = 0; i < width; ++i) out[i] = 0.0;
    for_each_coarse_node(patch, tile_frame(tile).position, slot, [&](int coarse, double weight) {
      double moved[static_cast<std::size_t>(width)];
      if (whole) of_step.find(parent(tile), coarse, moved);
      const double* const coarser = whole ? moved : last + coarse * width;
      for (int i = 0; i < width; ++i) out[i] += weight * coarser[i];
    });
  }

  using Velocity = NodeVelocity<D>;

  /// Kinetic energies before and after, the work of the forces, and of the drag and of the
  /// impedances among them.
  KOKKOS_INLINE_FUNCTION void tally_node(
      double dt,
      double mass,
      const double* force,
      const double* drag,
      const double* resisted,
      const Velocity& v,
      double* part
  ) const {
    double before = 0.0;
    double after = 0.0;
    double power = 0.0;
    double lost = 0.0;
    double absorbed = 0.0;
    for (int d = 0; d < dimensions; ++d) {
      before += v.before[d] * v.before[d];
      after += v.after[d] * v.after[d];
      power += force[d] * (v.before[d] + v.after[d]);
      lost += drag[d] * (v.before[d] + v.after[d]);
      absorbed -= resisted[d] * (v.before[d] + v.after[d]);
    }
    part[0] = 0.5 * mass * before;
    part[1] = 0.5 * mass * after;
    part[2] = 0.5 * dt * power;
    part[6] = 0.5 * dt * lost;
    part[7] = -dt * drag[1];
    part[8] = 0.5 * dt * absorbed;
    part[9] = -dt * resisted[1];
  }

  /// Contact's change of v^n, and its impulse as one more force. It comes after the impedances: it
  /// was found for the velocities that these leave (solve_contact), so that surfaces that close end
  /// with one velocity; were it resisted too, they would not, and momentum would go amiss.
  KOKKOS_INLINE_FUNCTION void add_contact(
      double dt, const double* contact, double inverse_mass, double (&force)[D], Velocity& v
  ) const {
    for (int d = 0; d < dimensions; ++d) {
      v.before[d] += contact[d];
      v.after[d] += contact[d] + contact[dimensions + d] * inverse_mass;
      force[d] += contact[dimensions + d] / dt;
    }
  }
  KOKKOS_INLINE_FUNCTION void tally_contact(const double* contact, const Velocity& v, double* part)
      const {
    for (int d = 0; d < dimensions; ++d) {
      const double mean = 0.5 * (v.before[d] + v.after[d]);
      part[10] += contact[dimensions + d] * mean;
      part[11] += contact[2 * dimensions + d] * mean;
    }
  }

  /// A node's velocities and the forces that gave them.
  struct SolvedNode {
    Velocity v;
    double force[D], drag[D], resisted[D];
    bool prescribed;  ///< a condition gives work or axial momentum there
  };

  /// @param node     its whole sums
  /// @param contact  its impulses; null where there are none
  /// @param own      gets what conditions do to it
  KOKKOS_INLINE_FUNCTION SolvedNode solve_node(
      const PrescribedVelocities& velocities,
      const NodePlace& place,
      double dt,
      const double* node,
      const double* contact,
      double* own
  ) const {
    const double mass = node[0];
    const double inverse = mass > 0.0 ? 1.0 / mass : 0.0;
    // An impedance Z resists the change of velocity too: f - Z (v' - v).
    const double resisted_share =
        mass > 0.0 ? 1.0 - mass / (mass + dt * node[impedance_component]) : 1.0;
    SolvedNode out;
    double net_force[D];
    for (int d = 0; d < dimensions; ++d) {
      out.drag[d] = rule.damping * node[1 + d];
      out.force[d] = node[first_force(dimensions) + d] - out.drag[d];
      out.resisted[d] = resisted_share * out.force[d];
      out.force[d] -= out.resisted[d];
      net_force[d] = out.force[d];
      out.v.before[d] = node[1 + d] * inverse;
      out.v.after[d] = out.v.before[d] + dt * out.force[d] * inverse;
    }
    if (contact != nullptr) add_contact(dt, contact, inverse, net_force, out.v);
    ConditionTally of_conditions;
    out.prescribed = prescribe_velocities(
        rule.conditions, velocities, place, NodeForces<D>{dt, mass, net_force}, out.v, of_conditions
    );
    own[3] = of_conditions.work;
    own[4] = of_conditions.axial_impulse;
    own[5] = of_conditions.axial_of_start;
    return out;
  }

  /// Whether neither drag nor impedance acts at a node.
  KOKKOS_INLINE_FUNCTION bool is_plain(const double* node) const {
    return rule.damping == 0.0 && node[impedance_component] == 0.0;
  }

  /// Whether no condition holds at any node of a tile.
  KOKKOS_INLINE_FUNCTION bool is_free(int tile) const {
    const TilePosition at = tile_frame(tile).position;
    for (int i = 0; i < rule.conditions.count; ++i) {
      const NodeCondition& c = rule.conditions.list[i];
      int node[3] = {};
      node[c.axis] = at[c.axis] * patch.tile_cells - patch.reach + (c.lower ? 0 : patch.nodes - 1);
      if (c.holds(node, at.level)) return false;
    }
    return true;
  }
  KOKKOS_INLINE_FUNCTION bool is_free(const NodePlace& place) const {
    for (int i = 0; i < rule.conditions.count; ++i)
      if (rule.conditions.list[i].holds(place.index, place.level)) return false;
    return true;
  }

  /// solve_node and tally_node of a node that forces of its particles alone move.
  KOKKOS_INLINE_FUNCTION void solve_plain_node(
      double dt,
      const double* node,
      bool counted,
      const NodeScales& scales,
      double* out,
      double (&part)[tally_components][2]
  ) const {
    const double mass = node[0];
    const double inverse = mass > 0.0 ? 1.0 / mass : 0.0;
    double before = 0.0, after = 0.0, power = 0.0;
    for (int d = 0; d < dimensions; ++d) {
      const double force = node[first_force(dimensions) + d];
      const double v_n = node[1 + d] * inverse;
      const double v = v_n + dt * force * inverse;
      out[d] = v;
      out[dimensions + d] = v - v_n;
      before += v_n * v_n;
      after += v * v;
      power += force * (v_n + v);
    }
    for (int d = 2 * dimensions; d < motion_components(dimensions); ++d) out[d] = 0.0;
    if (!counted || mass <= 0.0) return;
    add_split(0.5 * mass * before, scales.energy, part[0]);
    add_split(0.5 * mass * after, scales.energy, part[1]);
    add_split(0.5 * dt * power, scales.energy, part[2]);
  }

  /// Sums of a row of nodes. Without branches for the compiler to vectorise.
  KOKKOS_INLINE_FUNCTION bool are_zero(const double* row, const Span& span) const {
    int others = 0;
    for (int i = span.begin * sum_components; i < span.end * sum_components; ++i)
      others |= row[i] != 0.0 ? 1 : 0;
    return others == 0;
  }
  /// Whether a tile wants nothing of the nodes that share y and z: neither its particles nor loads
  /// reach them, and they count elsewhere. Particles that have spread leave most rows so.
  KOKKOS_INLINE_FUNCTION bool is_unreached(int tile, int row) const {
    if (!are_zero(&sums(first_sum(patch, tile)) + row * sum_components, {0, patch.nodes}))
      return false;
    const unsigned char* const counted = &counts(tile * patch.size + row);
    for (int x = 0; x < patch.nodes; ++x)
      if (counted[x] != 0) return false;
    return true;
  }
  /// Whole sums of a row. Of a tile that may be dormant all nodes are asked whether they move.
  /// @return whether the tile wants anything of them
  KOKKOS_INLINE_FUNCTION bool sum_row(int tile, int y, int z, const Span& span, double* total)
      const {
    const bool may_rest = !dormant.is_candidate(tile);
    if (may_rest && is_unreached(tile, (z * patch.nodes + y) * patch.nodes)) return false;
    add_parts(tile, y, z, span, total);
    return !(may_rest && are_zero(total, span));
  }
  KOKKOS_INLINE_FUNCTION void rest_row(int tile, int row, const Span& span) const {
    constexpr int width = motion_components(dimensions);
    double* const moved = &motion(first_motion(patch, tile)) + row * width;
    for (int i = span.begin * width; i < span.end * width; ++i) moved[i] = 0.0;
  }

  KOKKOS_INLINE_FUNCTION bool is_in(const NodeGroup& group, int tile, int slot) const {
    return group.all || subcycling.node_period(tile * patch.size + slot) == group.period;
  }
  KOKKOS_INLINE_FUNCTION Span span_in(const NodeGroup& group, int tile, int row) const {
    Span out{0, patch.nodes};
    while (out.begin < out.end && !is_in(group, tile, row + out.begin)) ++out.begin;
    while (out.begin < out.end && !is_in(group, tile, row + out.end - 1)) --out.end;
    return out;
  }
  /// An impedance lets a velocity change less than in proportion to the length of the step: bounds
  /// of steps of one length do not hold for others.
  KOKKOS_INLINE_FUNCTION bool defies_bounds(const double* node) const {
    return subcycling.on() && node[impedance_component] != 0.0;
  }

  /// @return whether what one of its nodes gives to work or axial momentum counts in any case
  KOKKOS_INLINE_FUNCTION bool solve_row(
      int tile, int y, int z, const NodeGroup& group, double (&part)[tally_components][2]
  ) const {
    const int row = (z * patch.nodes + y) * patch.nodes;
    const Span span = span_in(group, tile, row);
    if (span.begin == span.end) return false;
    alignas(64) double total[max_patch_nodes * sum_components];
    if (!sum_row(tile, y, z, span, total)) {
      rest_row(tile, row, span);
      return false;
    }
    const TilePosition at = tile_frame(tile).position;
    const unsigned char* const taken =
        at.level > 0 ? &from_parent(tile * patch.size + row) : nullptr;
    double* const moved = &motion(first_motion(patch, tile)) + row * motion_components(dimensions);
    constexpr int impulses = impulse_components(dimensions);
    const double* const contact =
        shared_tile.extent(0) > 0 && shared_tile(tile) != 0
            ? &impulse(first_value(patch, tile, impulses)) + row * impulses
            : nullptr;
    const double dt = group.dt;
    const NodeScales& scales = group.scales;
    NodePlace place{{}, at.level};
    for (int d = 0; d < 3; ++d) place.index[d] = at[d] * patch.tile_cells - patch.reach;
    place.index[0] += span.begin;
    place.index[1] += y;
    place.index[2] += z;
    bool prescribed = false;
    for (int x = span.begin; x < span.end; ++x, ++place.index[0]) {
      const double* const node = total + x * sum_components;
      double* const out = moved + x * motion_components(dimensions);
      if (!is_in(group, tile, row + x)) continue;
      if (taken != nullptr && taken[x] != 0) {
        take_from_parent(tile, row + x, out);
        continue;
      }
      const bool counted = counts(tile * patch.size + row + x) != 0;
      const double* const of_contact = contact != nullptr ? contact + x * impulses : nullptr;
      // By what the node is, not its tile: which one counts it hangs on the tiles that are active.
      if (shared_tile.extent(0) == 0 && is_plain(node) && (group.free || is_free(place))) {
        solve_plain_node(dt, node, counted, scales, out, part);
        continue;
      }
      double own[tally_components] = {};
      const SolvedNode solved = solve_node(group.velocities, place, dt, node, of_contact, own);
      const Velocity& v = solved.v;
      prescribed |= solved.prescribed || defies_bounds(node);
      for (int d = 0; d < dimensions; ++d) {
        out[d] = v.after[d];
        out[dimensions + d] = v.after[d] - v.before[d];
      }
      for (int d = 2 * dimensions; d < motion_components(dimensions); ++d) out[d] = 0.0;
      if (!counted || node[0] <= 0.0) continue;
      tally_node(dt, node[0], solved.force, solved.drag, solved.resisted, v, own);
      if (of_contact != nullptr) tally_contact(of_contact, v, own);
      own[12] = rule.grid_share(dt) * own[5];
      for (int i = 0; i < plain_components; ++i) add_split(own[i], scales.energy, part[i]);
      if (of_contact == nullptr && !solved.prescribed && is_plain(node)) continue;
      for (int i = plain_components; i < tally_components; ++i)
        add_split(own[i], is_impulse(i) ? scales.impulse : scales.energy, part[i]);
    }
    return prescribed;
  }

  /// On nodes of a tile, or on those of coarser ones that they follow.
  KOKKOS_INLINE_FUNCTION bool contact_acts(int tile) const {
    return (shared_tile.extent(0) > 0 && shared_tile(tile) != 0) ||
           (passes_up.extent(0) > 0 && passes_up(tile) != 0);
  }

  KOKKOS_INLINE_FUNCTION bool solve_group(
      int tile, const NodeGroup& group, double (&part)[tally_components][2]
  ) const {
    bool prescribed = false;
    for (int z = 0; z < patch.nodes_along(2); ++z)
      for (int y = 0; y < patch.nodes; ++y) prescribed |= solve_row(tile, y, z, group, part);
    return prescribed;
  }
  KOKKOS_INLINE_FUNCTION NodeGroup group_of(int tile, int period, bool free) const {
    const double dt = dormant.step_of(tile, period);
    const bool all = !subcycling.on() || subcycling.node_periods(tile) == period;
    return {
        period,
        all,
        free,
        dt,
        rule.scales(tile_frame(tile).cell_size, dt),
        rule.conditions.over_step(dt)};
  }

  /// Whether any of its nodes are solved in this part of a step.
  KOKKOS_INLINE_FUNCTION void note_solved(int tile, int periods) const {
    if (!subcycling.on() || (subcycling.catches_up && periods == 0)) return;
    subcycling.solved(tile) = periods != 0 ? 1 : 0;
    if (periods == 0 && !dormant.leaves_unsolved(tile)) dormant.forget_bounds(tile);
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    double part[tally_components][2] = {};
    const int periods = dormant.leaves_unsolved(tile) ? 0 : subcycling.solved_periods(tile);
    note_solved(tile, periods);
    bool counts_nothing = periods == 0;
    if (!counts_nothing) {
      const bool free = is_free(tile);
      bool prescribed = contact_acts(tile);
      for (int period = 1; period <= periods; period *= 2)
        if ((periods & period) != 0)
          prescribed |= solve_group(tile, group_of(tile, period, free), part);
      counts_nothing = dormant.enter(tile, &motion(first_motion(patch, tile)), prescribed, periods);
    }
    for (int i = 0; i < tally_values; ++i)
      tally(static_cast<std::size_t>(tile * tally_values + i)) =
          counts_nothing ? 0.0 : part[i / 2][i % 2];
  }
};

struct NodeTally {
  ReproducibleSum sum[tally_components];
};
KOKKOS_INLINE_FUNCTION void add(const NodeTally& part, NodeTally& total) {
  for (int i = 0; i < tally_components; ++i) total.sum[i] += part.sum[i];
}

/// What the tiles have found.
GridTally add_tiles(int tiles, const ArrayView<double>& tally) {
  NodeTally all;
  launch_reduction(
      "add_tiles",
      range(tiles),
      KOKKOS_LAMBDA(const int tile, NodeTally& part) {
        for (int i = 0; i < tally_values; ++i)
          part.sum[i / 2] += tally(static_cast<std::size_t>(tile * tally_values + i));
        if (tile % max_summed_rows == 0)
          for (ReproducibleSum& sum : part.sum) sum.carry();
      },
      TallyReducer<NodeTally>(all)
  );
  const auto& sum = all.sum;
  return {
      sum[0],
      sum[1],
      sum[2],
      sum[3],
      sum[4],
      sum[5],
      sum[12],
      sum[6],
      sum[7],
      sum[8],
      sum[9],
      sum[10],
      sum[11]};
}

}  // namespace

GridTally solve_velocity(
    const Grid& grid, const VelocityRule& rule, const SpecialTiles& special, Nodes& nodes
) {
  const Region region("solve_velocity");
  const auto values = static_cast<std::size_t>(grid.active) * tally_values;
  if (nodes.tally.extent(0) < values) nodes.tally = ArrayView<double>("tally", 2 * values);
  const DormantNodes dormant(
      grid, special.dormancy, special.first_field, special.subcycling, nodes
  );
  if (special.first_field && !special.subcycling.catches_up) find_unsolved_tiles(grid, dormant);
  visit_mode(grid.mode, [&](auto mode) {
    const SolveVelocity<decltype(mode)::dimensions> solve{
        rule,
        grid.patch,
        grid.tile_frame,
        grid.neighbours,
        grid.parent,
        grid.from_parent,
        grid.counts,
        nodes.sums,
        nodes.motion,
        nodes.tally,
        special.shared,
        special.passes_up,
        nodes.impulse,
        dormant,
        special.subcycling};
    for (int level = 0; level < grid.box.levels; ++level)  // finer tiles ask coarser ones
      launch(
          "solve_velocity",
          RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
          solve
      );
  });
  return add_tiles(grid.active, nodes.tally);
}

}  // namespace barreno
