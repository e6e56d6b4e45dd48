// SPDX-License-Identifier: BSD-3-Clause
#include "step/share_nodes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "step/node_copies.hpp"

namespace barreno {
namespace {

using SumsOfFields = Kokkos::Array<ArrayView<double>, most_velocity_fields>;

/// Bits of the fields that have mass in the patch of each local tile.
void find_tile_fields(const State& state) {
  const Grid& grid = state.grid;
  const Patch patch = grid.patch;
  const auto& bits = state.contact.tile_fields;
  for (int t = 0; t < grid.active + grid.ghosts; ++t) bits(t) = 0;
  for (const Particles& particles : state.particles)
    for (int t = 0; t < grid.active; ++t)
      if (particles.tile_begin(t + 1) > particles.tile_begin(t))
        bits(t) =
            static_cast<unsigned char>(bits(t) | 1U << static_cast<unsigned>(particles.field));
  for (std::size_t f = 0; f < state.nodes.size(); ++f)
    for (int t = grid.active; t < grid.active + grid.ghosts; ++t) {
      const double* const sums = &state.nodes[f].sums(first_sum(patch, t));
      for (int slot = 0; slot < patch.size; ++slot)
        if (sums[slot * sum_components] > 0.0)
          bits(t) = static_cast<unsigned char>(bits(t) | 1U << f);
    }
}

KOKKOS_INLINE_FUNCTION bool several(unsigned bits) {
  return (bits & (bits - 1U)) != 0;
}

struct ShareNodes {
  NodeCopies copies;
  SumsOfFields sums;
  int count;
  ArrayView<unsigned char> tile_fields, shared_tile, fields;

  /// Fields with mass at a node: sums of masses, none below zero, are positive where a part is.
  KOKKOS_INLINE_FUNCTION unsigned fields_at(int tile, int slot) const {
    unsigned bits = 0;
    copies.for_each(tile, slot, [&](int other, int there) {
      for (int f = 0; f < count; ++f)
        if ((tile_fields(other) >> f & 1U) &&
            sums[f](
                first_sum(copies.patch, other) + static_cast<std::size_t>(there * sum_components)
            ) > 0.0)
          bits |= 1U << f;
    });
    return bits;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Patch& patch = copies.patch;
    unsigned near = 0;
    for (int k = 0; k < patch.neighbours; ++k) {
      const int other = copies.neighbours(tile * patch.neighbours + k);
      if (other >= 0) near |= tile_fields(other);
    }
    shared_tile(tile) = 0;
    if (!several(near)) return;
    for (int slot = 0; slot < patch.size; ++slot) {
      const unsigned bits = fields_at(tile, slot);
      fields(tile * patch.size + slot) = static_cast<unsigned char>(several(bits) ? bits : 0U);
      if (several(bits)) shared_tile(tile) = 1;
    }
  }
};

template <class View>
void make_room(View& view, std::size_t count) {
  if (view.extent(0) < count) view = View("contact", 5 * count / 4);
}

void make_room(State& state) {
  const Patch& patch = state.grid.patch;
  ContactNodes& contact = state.contact;
  const auto tiles = static_cast<std::size_t>(state.grid.active);
  const auto all = tiles + static_cast<std::size_t>(state.grid.ghosts);
  const auto nodes = [&](std::size_t n, int components) {
    return n * static_cast<std::size_t>(patch.size * components);
  };
  const int d = patch.dimensions;
  contact.moments.resize(state.nodes.size());
  contact.normal.resize(state.fields.pairs.size());
  contact.reach.resize(state.fields.pairs.size());
  make_room(contact.tile_fields, all);
  make_room(contact.shared_tile, tiles);
  make_room(contact.fields, nodes(tiles, 1));
  for (Nodes& field : state.nodes) make_room(field.impulse, nodes(tiles, impulse_components(d)));
  for (auto& moments : contact.moments) make_room(moments, nodes(all, moment_components(d)));
  for (auto& normal : contact.normal) make_room(normal, nodes(tiles, normal_components(d)));
  for (auto& reach : contact.reach) make_room(reach, nodes(all, 2 * directions_about(d)));
}

}  // namespace

void share_nodes(State& state) {
  if (state.fields.count == 1) return;
  const Region region("share_nodes");
  make_room(state);
  find_tile_fields(state);
  SumsOfFields sums;
  for (std::size_t f = 0; f < state.nodes.size(); ++f) sums[f] = state.nodes[f].sums;
  launch(
      "share_nodes",
      range(state.grid.active),
      ShareNodes{
          NodeCopies(state.grid),
          sums,
          state.fields.count,
          state.contact.tile_fields,
          state.contact.shared_tile,
          state.contact.fields}
  );
}

}  // namespace barreno
