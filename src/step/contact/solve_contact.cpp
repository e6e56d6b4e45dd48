// SPDX-License-Identifier: BSD-3-Clause
#include "step/contact/solve_contact.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "shape/kinematics.hpp"
#include "step/contact/contact_law.hpp"
#include "step/nodes/node_copies.hpp"

namespace barreno {
namespace {

constexpr int max_pairs = max_velocity_fields * (max_velocity_fields - 1) / 2;
/// Turns of the pairs where three fields or more meet.
constexpr int turns = 8;
/// Fields that overlap by more along every direction have no surface between them: particles of one
/// are embedded in the other, and the two move as one [cells].
constexpr double most_overlap = 1.0;

/// The fields at one node: what they have, and what contact does to them.
template <unsigned D>
struct SharedNode {
  unsigned bits;
  double inverse_mass[max_velocity_fields];  ///< 0: rigid
  double start[max_velocity_fields][D];      ///< v^n, then v^n + dt f / m; contact included
  double change[max_velocity_fields][D];
  double impulse[max_velocity_fields][D], tangential[max_velocity_fields][D];
  double taken[max_velocity_fields][D];  ///< of the first impulse, what particles take by PIC
};

/// What contact reads of the tile that it is in.
struct ContactTile {
  int tile;
  double cell_size, dt, grid_share;
  NodeScales scales;
  double rigid_velocity[max_velocity_fields][3] = {};  ///< by field
};

/// What rigid bodies give in a tile, each number in the two parts of add_split.
struct TileTally {
  double work[2] = {}, tangential_work[2] = {};
  double reaction[max_velocity_fields][3][2] = {};
};

KOKKOS_INLINE_FUNCTION void add(const TileTally& tile, int bodies, RigidTally& sum) {
  for (int part = 0; part < 2; ++part) {
    sum.work += tile.work[part];
    sum.tangential_work += tile.tangential_work[part];
    for (int r = 0; r < bodies; ++r)
      for (int d = 0; d < 3; ++d)
        sum.reaction[static_cast<std::size_t>(r)][static_cast<std::size_t>(d)] +=
            tile.reaction[r][d][part];
  }
}

template <unsigned D>
struct SolveContact {
  static constexpr int dimensions = D;
  static constexpr int components = impulse_components(D);
  NodeCopies copies;
  ArrayView<TileFrame> tile_frame;
  int field_count, pair_count;
  FieldPair pairs[max_pairs] = {};
  RigidMotions motions;
  ContactStep step;
  Kokkos::Array<ArrayView<double>, max_velocity_fields> sums, impulse;
  Kokkos::Array<ArrayView<double>, max_pairs> normal;
  ArrayView<unsigned char> shared_tile, fields, counts;

  SolveContact(
      const Grid& grid, const VelocityFields& of, const RigidMotions& rigid, const ContactStep& now
  )
      : copies(grid),
        tile_frame(grid.tile_frame),
        field_count(of.count),
        pair_count(static_cast<int>(of.pairs.size())),
        motions(rigid),
        step(now),
        counts(grid.counts) {}

  KOKKOS_INLINE_FUNCTION bool is_rigid(int field) const { return motions.of_field[field] >= 0; }

  KOKKOS_INLINE_FUNCTION ContactTile contact_tile(int tile) const {
    const double dt = tile_frame(tile).dt;
    const double cell_size = tile_frame(tile).cell_size;
    ContactTile out{tile, cell_size, dt, step.grid_share(dt), step.scales(cell_size, dt)};
    for (int r = 0; r < motions.count; ++r)
      motions.over_step(r, step.time, dt, out.rigid_velocity[motions.field[r]]);
    return out;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile, RigidTally& tally) const {
    if (shared_tile(tile) == 0) return;
    const ContactTile of = contact_tile(tile);
    TileTally part;
    for (int slot = 0; slot < copies.patch.size; ++slot) solve_node(of, slot, part);
    add(part, motions.count, tally);
  }

  KOKKOS_INLINE_FUNCTION void solve_node(const ContactTile& of, int slot, TileTally& part) const {
    const Patch& patch = copies.patch;
    const int tile = of.tile;
    SharedNode<D> node;
    node.bits = fields(tile * patch.size + slot);
    double force[max_velocity_fields][D];
    for (int f = 0; f < field_count; ++f) {
      node.inverse_mass[f] = 0.0;  // of a field that is not here: no impulse changes it
      for (int d = 0; d < dimensions; ++d) node.impulse[f][d] = node.tangential[f][d] = 0.0;
      for (int d = 0; d < dimensions; ++d) node.change[f][d] = 0.0;
      if (node.bits >> f & 1U) load(of, slot, f, node, force[f]);
    }
    if (node.bits != 0) {
      apply_pairs(of, slot, node);
      for (int f = 0; f < field_count; ++f)
        for (int d = 0; d < dimensions; ++d) {
          node.change[f][d] = node.impulse[f][d] * node.inverse_mass[f];
          node.taken[f][d] = of.grid_share * node.impulse[f][d];
          node.impulse[f][d] = node.tangential[f][d] = 0.0;
          if (node.bits >> f & 1U) node.start[f][d] += of.dt * force[f][d] * node.inverse_mass[f];
        }
      apply_pairs(of, slot, node);
      if (counts(tile * patch.size + slot) != 0) tally_rigid(of, node, part);
    }
    for (int f = 0; f < field_count; ++f) {
      double* const out = &impulse[f](first_value(patch, tile, components)) + slot * components;
      for (int d = 0; d < dimensions; ++d) {
        out[d] = node.change[f][d];
        out[dimensions + d] = node.impulse[f][d];
        out[2 * dimensions + d] = node.tangential[f][d];
      }
    }
  }

  KOKKOS_INLINE_FUNCTION void load(
      const ContactTile& of, int slot, int f, SharedNode<D>& node, double (&force)[D]
  ) const {
    double total[sum_components];
    copies.add(sums[f], sum_components, of.tile, slot, total);
    const bool rigid = is_rigid(f);
    node.inverse_mass[f] = rigid ? 0.0 : 1.0 / total[0];
    // What impedances leave of the forces, as in solve_velocity: contact acts on what comes of
    // that.
    const double left = total[0] / (total[0] + of.dt * total[impedance_component]);
    for (int d = 0; d < dimensions; ++d) {
      node.start[f][d] = rigid ? of.rigid_velocity[f][d] : total[1 + d] * node.inverse_mass[f];
      force[d] = left * (total[1 + dimensions + d] - step.damping * total[1 + d]);
    }
  }

  /// Each pair is solved for what the others have left, as if its own impulse of the turn before
  /// had not been: one that pushed too much then takes back some of it. Without that the impulses
  /// do work where the fields part, and nodes of three fields gain energy in every step.
  KOKKOS_INLINE_FUNCTION void apply_pairs(const ContactTile& of, int slot, SharedNode<D>& node)
      const {
    const bool two = (node.bits & (node.bits - 1U) & ((node.bits & (node.bits - 1U)) - 1U)) == 0;
    const auto meet = [&](const FieldPair& pair) {
      return (node.bits >> pair.a & 1U) != 0 && (node.bits >> pair.b & 1U) != 0;
    };
    for (int i = 0; two && i < pair_count; ++i) {
      ContactImpulse<D> none;
      if (meet(pairs[i])) apply_pair(of, slot, i, none, node);
    }
    if (two) return;
    ContactImpulse<D> of_pair[max_pairs];
    for (int turn = 0; turn < turns; ++turn)
      for (int i = 0; i < pair_count; ++i)
        if (meet(pairs[i])) apply_pair(of, slot, i, of_pair[i], node);
  }

  KOKKOS_INLINE_FUNCTION void apply_pair(
      const ContactTile& of, int slot, int i, ContactImpulse<D>& of_pair, SharedNode<D>& node
  ) const {
    const FieldPair& pair = pairs[i];
    double n[D] = {};
    double gap_speed = 0.0;
    ContactKind kind = pair.kind;
    if (kind != ContactKind::bonded) {
      constexpr int normals = normal_components(dimensions);
      const double* const at =
          &normal[i](first_value(copies.patch, of.tile, normals)) + slot * normals;
      for (int d = 0; d < dimensions; ++d) n[d] = at[d];
      gap_speed = std::fmax(at[dimensions], 0.0) * of.cell_size / of.dt;
      if (at[dimensions] < -most_overlap) kind = ContactKind::bonded;
    }
    const double inverse = node.inverse_mass[pair.a] + node.inverse_mass[pair.b];
    double w[D];
    for (int d = 0; d < dimensions; ++d)
      w[d] = node.start[pair.b][d] - node.start[pair.a][d] + of_pair.total[d] * inverse;
    const ContactImpulse<D> now =
        contact_impulse<D>(kind, pair.friction, 1.0 / inverse, w, n, gap_speed);
    for (int d = 0; d < dimensions; ++d) {
      const double total = now.total[d] - of_pair.total[d];
      const double tangential = now.tangential[d] - of_pair.tangential[d];
      node.start[pair.a][d] += total * node.inverse_mass[pair.a];
      node.start[pair.b][d] -= total * node.inverse_mass[pair.b];
      node.impulse[pair.a][d] += total;
      node.impulse[pair.b][d] -= total;
      node.tangential[pair.a][d] += tangential;
      node.tangential[pair.b][d] -= tangential;
    }
    of_pair = now;
  }

  KOKKOS_INLINE_FUNCTION void tally_rigid(
      const ContactTile& of, const SharedNode<D>& node, TileTally& part
  ) const {
    for (int f = 0; f < field_count; ++f) {
      if (!is_rigid(f) || !(node.bits >> f & 1U)) continue;
      for (int d = 0; d < dimensions; ++d) {
        const double v = of.rigid_velocity[f][d];
        add_split(-node.impulse[f][d] * v, of.scales.energy, part.work);
        add_split(-node.tangential[f][d] * v, of.scales.energy, part.tangential_work);
        add_split(
            node.impulse[f][d] + node.taken[f][d],
            of.scales.impulse,
            part.reaction[motions.of_field[f]][d]
        );
      }
    }
  }
};

template <unsigned D>
RigidTally launch_contact(int tiles, const SolveContact<D>& kernel) {
  RigidTally tally;
  launch_reduction("solve_contact", range(tiles), kernel, TallyReducer<RigidTally>(tally));
  return tally;
}

}  // namespace

RigidTally solve_contact(
    const Grid& grid,
    const VelocityFields& fields,
    const RigidMotions& motions,
    const ContactStep& step,
    const ContactNodes& contact,
    const std::vector<Nodes>& nodes
) {
  if (fields.count == 1) return {};
  const Region region("solve_contact");
  return visit_mode(grid.mode, [&](auto mode) {
    SolveContact<decltype(mode)::dimensions> kernel(grid, fields, motions, step);
    for (std::size_t i = 0; i < fields.pairs.size(); ++i) {
      kernel.pairs[i] = fields.pairs[i];
      kernel.normal[i] = contact.normal[i];
    }
    for (std::size_t f = 0; f < nodes.size(); ++f) {
      kernel.sums[f] = nodes[f].sums;
      kernel.impulse[f] = nodes[f].impulse;
    }
    kernel.shared_tile = contact.shared_tile;
    kernel.fields = contact.fields;
    return launch_contact(grid.active, kernel);
  });
}

}  // namespace barreno
