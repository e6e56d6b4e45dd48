// SPDX-License-Identifier: BSD-3-Clause
#include "step/solve_contact.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "scene/rigid_velocity.hpp"
#include "shape/kinematics.hpp"
#include "step/accelerate_particles.hpp"
#include "step/contact_law.hpp"
#include "step/node_copies.hpp"
#include "step/node_sizes.hpp"

#include <string>

namespace barreno {
namespace {

constexpr int contact_tally_components = 2;
/// Of each the two parts of add_split, as of reactions.
constexpr int contact_tally_values = 2 * contact_tally_components;
constexpr int most_pairs = most_velocity_fields * (most_velocity_fields - 1) / 2;
/// Turns of the pairs where three fields or more meet.
constexpr int turns = 8;

/// The fields at one node: what they have, and what contact does to them.
template <unsigned D>
struct SharedNode {
  unsigned bits;
  double inverse_mass[most_velocity_fields];  ///< 0: rigid
  double start[most_velocity_fields][D];      ///< v^n, then v^n + dt f / m; contact included
  double change[most_velocity_fields][D];
  double impulse[most_velocity_fields][D], tangential[most_velocity_fields][D];
  double taken[most_velocity_fields][D];  ///< of the first impulse, what particles take by PIC
};

template <unsigned D>
struct SolveContact {
  static constexpr int dimensions = D;
  static constexpr int components = impulse_components(D);
  NodeCopies copies;
  int field_count, pair_count;
  FieldPair pairs[most_pairs] = {};
  bool rigid[most_velocity_fields] = {};
  int reaction_count = 0;
  int reaction_of[most_velocity_fields] = {};  ///< of a rigid field its place in State::reactions
  double rigid_velocity[most_velocity_fields][3] = {};
  Kokkos::Array<ArrayView<double>, most_velocity_fields> sums, impulse;
  Kokkos::Array<ArrayView<double>, most_pairs> normal;
  ArrayView<unsigned char> shared_tile, fields, counts;
  ArrayView<double> tally, reactions;
  double dt = 0.0, cell_size = 0.0, damping = 0.0, grid_share = 0.0;
  NodeSizes sizes;

  SolveContact(const Grid& grid, const VelocityFields& of)
      : copies(grid), field_count(of.count), pair_count(static_cast<int>(of.pairs.size())) {}

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    double part[contact_tally_components][2] = {};
    for (int i = 0; i < 2 * reaction_count * dimensions; ++i)
      reactions(2 * tile * reaction_count * dimensions + i) = 0.0;
    if (shared_tile(tile) != 0)
      for (int slot = 0; slot < copies.patch.size; ++slot) solve_node(tile, slot, part);
    for (int i = 0; i < contact_tally_values; ++i)
      tally(tile * contact_tally_values + i) = part[i / 2][i % 2];
  }

  KOKKOS_INLINE_FUNCTION void solve_node(
      int tile, int slot, double (&part)[contact_tally_components][2]
  ) const {
    const Patch& patch = copies.patch;
    SharedNode<D> node;
    node.bits = fields(tile * patch.size + slot);
    double force[most_velocity_fields][D];
    for (int f = 0; f < field_count; ++f) {
      node.inverse_mass[f] = 0.0;  // of a field that is not here: no impulse changes it
      for (int d = 0; d < dimensions; ++d) node.impulse[f][d] = node.tangential[f][d] = 0.0;
      for (int d = 0; d < dimensions; ++d) node.change[f][d] = 0.0;
      if (node.bits >> f & 1U) load(tile, slot, f, node, force[f]);
    }
    if (node.bits != 0) {
      apply_pairs(tile, slot, node);
      for (int f = 0; f < field_count; ++f)
        for (int d = 0; d < dimensions; ++d) {
          node.change[f][d] = node.impulse[f][d] * node.inverse_mass[f];
          node.taken[f][d] = grid_share * node.impulse[f][d];
          node.impulse[f][d] = node.tangential[f][d] = 0.0;
          if (node.bits >> f & 1U) node.start[f][d] += dt * force[f][d] * node.inverse_mass[f];
        }
      apply_pairs(tile, slot, node);
      if (counts(tile * patch.size + slot) != 0) tally_rigid(tile, node, part);
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
      int tile, int slot, int f, SharedNode<D>& node, double (&force)[D]
  ) const {
    double total[sum_components];
    copies.add(sums[f], sum_components, tile, slot, total);
    node.inverse_mass[f] = rigid[f] ? 0.0 : 1.0 / total[0];
    // What impedances leave of the forces, as in solve_velocity: contact acts on what comes of
    // that.
    const double left = total[0] / (total[0] + dt * total[impedance_component]);
    for (int d = 0; d < dimensions; ++d) {
      node.start[f][d] = rigid[f] ? rigid_velocity[f][d] : total[1 + d] * node.inverse_mass[f];
      force[d] = left * (total[1 + dimensions + d] - damping * total[1 + d]);
    }
  }

  KOKKOS_INLINE_FUNCTION void apply_pairs(int tile, int slot, SharedNode<D>& node) const {
    const bool two = (node.bits & (node.bits - 1U) & ((node.bits & (node.bits - 1U)) - 1U)) == 0;
    for (int turn = 0; turn < (two ? 1 : turns); ++turn)
      for (int i = 0; i < pair_count; ++i)
        if ((node.bits >> pairs[i].a & 1U) && (node.bits >> pairs[i].b & 1U))
          apply_pair(tile, slot, i, node);
  }

  KOKKOS_INLINE_FUNCTION void apply_pair(int tile, int slot, int i, SharedNode<D>& node) const {
    const FieldPair& pair = pairs[i];
    double n[D] = {};
    double gap_speed = 0.0;
    if (pair.kind != ContactKind::bonded) {
      constexpr int normals = normal_components(dimensions);
      const double* const at =
          &normal[i](first_value(copies.patch, tile, normals)) + slot * normals;
      for (int d = 0; d < dimensions; ++d) n[d] = at[d];
      gap_speed = std::fmax(at[dimensions], 0.0) * cell_size / dt;
    }
    double w[D];
    for (int d = 0; d < dimensions; ++d) w[d] = node.start[pair.b][d] - node.start[pair.a][d];
    const double mass = 1.0 / (node.inverse_mass[pair.a] + node.inverse_mass[pair.b]);
    const ContactImpulse<D> given =
        contact_impulse<D>(pair.kind, pair.friction, mass, w, n, gap_speed);
    for (int d = 0; d < dimensions; ++d) {
      node.start[pair.a][d] += given.total[d] * node.inverse_mass[pair.a];
      node.start[pair.b][d] -= given.total[d] * node.inverse_mass[pair.b];
      node.impulse[pair.a][d] += given.total[d];
      node.impulse[pair.b][d] -= given.total[d];
      node.tangential[pair.a][d] += given.tangential[d];
      node.tangential[pair.b][d] -= given.tangential[d];
    }
  }

  KOKKOS_INLINE_FUNCTION void tally_rigid(
      int tile, const SharedNode<D>& node, double (&part)[contact_tally_components][2]
  ) const {
    for (int f = 0; f < field_count; ++f) {
      if (!rigid[f] || !(node.bits >> f & 1U)) continue;
      for (int d = 0; d < dimensions; ++d) {
        add_split(-node.impulse[f][d] * rigid_velocity[f][d], sizes.energy, part[0]);
        add_split(-node.tangential[f][d] * rigid_velocity[f][d], sizes.energy, part[1]);
        const int first = 2 * ((tile * reaction_count + reaction_of[f]) * dimensions + d);
        double given[2] = {reactions(first), reactions(first + 1)};
        add_split(node.impulse[f][d] + node.taken[f][d], sizes.impulse, given);
        for (int i = 0; i < 2; ++i) reactions(first + i) = given[i];
      }
    }
  }
};

template <unsigned D>
SolveContact<D> make_kernel(
    const Scene& scene, const Clock& clock, double dt, double damping, State& state
) {
  SolveContact<D> kernel(state.grid, state.fields);
  for (std::size_t i = 0; i < state.fields.pairs.size(); ++i) {
    kernel.pairs[i] = state.fields.pairs[i];
    kernel.normal[i] = state.contact.normal[i];
  }
  for (std::size_t f = 0; f < state.nodes.size(); ++f) {
    kernel.sums[f] = state.nodes[f].sums;
    kernel.impulse[f] = state.nodes[f].impulse;
    const int body = state.fields.rigid_body[f];
    kernel.rigid[f] = body >= 0;
    if (body < 0) continue;
    const Vector v = rigid_velocity(scene.bodies[static_cast<std::size_t>(body)], clock.time, dt);
    for (std::size_t d = 0; d < 3; ++d) kernel.rigid_velocity[f][d] = v[d];
  }
  kernel.reaction_count = static_cast<int>(state.reactions.size());
  for (int r = 0; r < kernel.reaction_count; ++r)
    kernel.reaction_of[state.reactions[static_cast<std::size_t>(r)].field] = r;
  kernel.shared_tile = state.contact.shared_tile;
  kernel.fields = state.contact.fields;
  kernel.counts = state.grid.counts;
  kernel.tally = state.contact.tally;
  kernel.reactions = state.contact.given;
  kernel.grid_share = grid_share(scene.step, dt);
  kernel.dt = dt;
  kernel.sizes = node_sizes(scene, dt);
  kernel.cell_size = scene.grid.cell_size;
  kernel.damping = damping;
  return kernel;
}

/// The tiles' impulses on rigid bodies.
RigidImpulses add_reactions(const Scene& scene, const State& state) {
  RigidImpulses sum{};
  const auto axes = static_cast<std::size_t>(dimensions(scene.grid.mode));
  std::size_t i = 0;
  for (int tile = 0; tile < state.grid.active; ++tile)
    for (std::size_t r = 0; r < state.reactions.size(); ++r)
      for (std::size_t d = 0; d < axes; ++d)
        for (int part = 0; part < 2; ++part) sum[r][d] += state.contact.given(i++);
  return sum;
}

/// A view of at least so many values; twice as long when it must grow.
template <class View>
void make_room(const char* name, std::size_t values, View& view) {
  if (view.extent(0) < values) view = View(std::string(name), 2 * values);
}

}  // namespace

RigidTally solve_contact(
    const Scene& scene, const Clock& clock, double dt, double damping, State& state
) {
  if (state.fields.count == 1) return {};
  const Region region("solve_contact");
  const auto values = static_cast<std::size_t>(state.grid.active) * contact_tally_values;
  const std::size_t impulses = static_cast<std::size_t>(state.grid.active) *
                               static_cast<std::size_t>(dimensions(scene.grid.mode));
  make_room("tally", values, state.contact.tally);
  make_room("given", 2 * impulses * state.reactions.size(), state.contact.given);
  visit_mode(scene.grid.mode, [&](auto mode) {
    launch(
        "solve_contact",
        range(state.grid.active),
        make_kernel<decltype(mode)::dimensions>(scene, clock, dt, damping, state)
    );
  });
  RigidTally sum{{}, {}, add_reactions(scene, state)};
  for (std::size_t i = 0; i < values; ++i)
    (i % contact_tally_values < 2 ? sum.work : sum.tangential_work) += state.contact.tally(i);
  return sum;
}

}  // namespace barreno
