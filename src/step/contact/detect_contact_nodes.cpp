// SPDX-License-Identifier: BSD-3-Clause
#include "step/contact/detect_contact_nodes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "step/nodes/node_copies.hpp"

namespace barreno {
namespace {

using SumsOfFields = Kokkos::Array<ArrayView<double>, max_velocity_fields>;

/// Bits of the fields that have mass in the patches of other ranks' tiles; none yet in the own
/// ones.
struct FindGhostFields {
  Patch patch;
  int active, count;
  SumsOfFields sums;
  ArrayView<unsigned char> tile_fields;

  KOKKOS_INLINE_FUNCTION bool has_mass(int field, int tile) const {
    const double* const values = &sums[field](first_sum(patch, tile));
    for (int slot = 0; slot < patch.size; ++slot)
      if (values[slot * sum_components] > 0.0) return true;
    return false;
  }
  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    unsigned bits = 0;
    for (int f = 0; tile >= active && f < count; ++f)
      if (has_mass(f, tile)) bits |= 1U << f;
    tile_fields(tile) = static_cast<unsigned char>(bits);
  }
};

/// The bit of a set's field in the tiles that it has particles in.
void add_tile_fields(
    const Grid& grid, const Particles& particles, const ArrayView<unsigned char>& tile_fields
) {
  const ArrayView<int> tile_begin = particles.tile_begin;
  const unsigned bit = 1U << static_cast<unsigned>(particles.field);
  launch(
      "add_tile_fields",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (tile_begin(tile + 1) > tile_begin(tile))
          tile_fields(tile) = static_cast<unsigned char>(tile_fields(tile) | bit);
      }
  );
}

KOKKOS_INLINE_FUNCTION bool several(unsigned bits) {
  return (bits & (bits - 1U)) != 0;
}

struct DetectContactNodes {
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
void grow_view(View& view, std::size_t count) {
  if (view.extent(0) < count) view = View("contact", 5 * count / 4);
}

void make_room_for_contact(
    const Grid& grid, const VelocityFields& fields, std::vector<Nodes>& nodes, ContactNodes& contact
) {
  const Patch& patch = grid.patch;
  const auto tiles = static_cast<std::size_t>(grid.active);
  const auto all = tiles + static_cast<std::size_t>(grid.ghosts);
  const auto values = [&](std::size_t n, int components) {
    return n * static_cast<std::size_t>(patch.size * components);
  };
  const int d = patch.dimensions;
  contact.moments.resize(nodes.size());
  contact.normal.resize(fields.pairs.size());
  contact.reach.resize(fields.pairs.size());
  grow_view(contact.tile_fields, all);
  grow_view(contact.shared_tile, tiles);
  grow_view(contact.fields, values(tiles, 1));
  for (Nodes& field : nodes) grow_view(field.impulse, values(tiles, impulse_components(d)));
  for (auto& moments : contact.moments) grow_view(moments, values(all, moment_components(d)));
  for (auto& normal : contact.normal) grow_view(normal, values(tiles, normal_components(d)));
  for (auto& reach : contact.reach) grow_view(reach, values(all, 2 * directions_about(d)));
}

}  // namespace

void detect_contact_nodes(
    const Grid& grid,
    const VelocityFields& fields,
    const std::vector<Particles>& sets,
    std::vector<Nodes>& nodes,
    ContactNodes& contact
) {
  if (fields.count == 1) return;
  const Region region("detect_contact_nodes");
  make_room_for_contact(grid, fields, nodes, contact);
  SumsOfFields sums;
  for (std::size_t f = 0; f < nodes.size(); ++f) sums[f] = nodes[f].sums;
  launch(
      "find_ghost_fields",
      range(grid.active + grid.ghosts),
      FindGhostFields{grid.patch, grid.active, fields.count, sums, contact.tile_fields}
  );
  for (const Particles& particles : sets) add_tile_fields(grid, particles, contact.tile_fields);
  launch(
      "detect_contact_nodes",
      range(grid.active),
      DetectContactNodes{
          NodeCopies(grid),
          sums,
          fields.count,
          contact.tile_fields,
          contact.shared_tile,
          contact.fields}
  );
}

}  // namespace barreno
