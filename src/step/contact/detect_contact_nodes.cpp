// SPDX-License-Identifier: BSD-3-Clause
#include "step/contact/detect_contact_nodes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/coarse_nodes.hpp"
#include "step/nodes/node_copies.hpp"

namespace barreno {
namespace {

using SumsOfFields = Kokkos::Array<ArrayView<double>, max_velocity_fields>;

/// Bits of the fields that have mass at the nodes that other ranks' tiles share with ours; none yet
/// in the own ones.
struct FindGhostFields {
  Patch patch;
  int active, count;
  SumsOfFields sums;
  ArrayView<unsigned char> fetched, tile_fields;

  KOKKOS_INLINE_FUNCTION bool has_mass(int field, int tile) const {
    const double* const values = &sums[field](first_sum(patch, tile));
    for (int slot = 0; slot < patch.size; ++slot)
      if (fetched((tile - active) * patch.size + slot) != 0 && values[slot * sum_components] > 0.0)
        return true;
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

/// Sums of a finer tile are in those of the coarser one around it (restrict_sums), which so has its
/// fields.
void add_finer_fields(const Grid& grid, const ArrayView<unsigned char>& tile_fields) {
  const BoxTiles box = grid.box;
  const ArrayView<TileFrame> frame = grid.tile_frame;
  const TileDirectory directory = grid.directory;
  for (int level = grid.box.levels - 2; level >= 0; --level)
    launch(
        "add_finer_fields",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          for_each_finer_tile(box, frame(tile).position, [&](const TilePosition& at) {
            const int other = directory(box.id(at));
            if (other >= 0)
              tile_fields(tile) =
                  static_cast<unsigned char>(tile_fields(tile) | tile_fields(other));
          });
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
  ArrayView<TileFrame> tile_frame;
  ArrayView<int> parent;  ///< empty, as is the next, where nothing is refined
  ArrayView<unsigned char> from_parent;
  ArrayView<unsigned char> tile_fields, shared_tile, passes_up, fields;

  KOKKOS_INLINE_FUNCTION bool follows_coarser(int tile, int slot) const {
    return from_parent.extent(0) > 0 && tile_frame(tile).position.level > 0 &&
           from_parent(tile * copies.patch.size + slot) != 0;
  }

  /// Whether a node stands for one of a coarser tile where fields meet.
  KOKKOS_INLINE_FUNCTION bool stands_for_shared(int tile, int slot) const {
    if (!follows_coarser(tile, slot)) return false;
    const int coarser = parent(tile);
    bool found = false;
    for_each_coarse_node(copies.patch, tile_frame(tile).position, slot, [&](int at, double) {
      const bool shared =
          shared_tile(coarser) != 0 && fields(coarser * copies.patch.size + at) != 0;
      found = found || shared || stands_for_shared(coarser, at);
    });
    return found;
  }

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
    if (passes_up.extent(0) > 0) passes_up(tile) = 0;
    for (int slot = 0; several(near) && slot < patch.size; ++slot) {
      const unsigned bits = follows_coarser(tile, slot) ? 0U : fields_at(tile, slot);
      fields(tile * patch.size + slot) = static_cast<unsigned char>(several(bits) ? bits : 0U);
      if (several(bits)) shared_tile(tile) = 1;
    }
    pass_up(tile);
  }

  /// The coarser tile around it may have shared nodes where this one has a single field.
  KOKKOS_INLINE_FUNCTION void pass_up(int tile) const {
    if (from_parent.extent(0) == 0 || tile_frame(tile).position.level == 0) return;
    const int coarser = parent(tile);
    if (shared_tile(coarser) == 0 && passes_up(coarser) == 0) return;
    for (int slot = 0; passes_up(tile) == 0 && slot < copies.patch.size; ++slot)
      if (stands_for_shared(tile, slot)) passes_up(tile) = 1;
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
  if (grid.is_refined()) grow_view(contact.passes_up, tiles);
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
      FindGhostFields{
          grid.patch, grid.active, fields.count, sums, grid.fetched, contact.tile_fields}
  );
  for (const Particles& particles : sets) add_tile_fields(grid, particles, contact.tile_fields);
  add_finer_fields(grid, contact.tile_fields);
  const DetectContactNodes detect{
      NodeCopies(grid),
      sums,
      fields.count,
      grid.tile_frame,
      grid.parent,
      grid.from_parent,
      contact.tile_fields,
      contact.shared_tile,
      contact.passes_up,
      contact.fields};
  for (int level = 0; level < grid.box.levels; ++level)  // finer tiles ask coarser ones
    launch(
        "detect_contact_nodes",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        detect
    );
}

}  // namespace barreno
