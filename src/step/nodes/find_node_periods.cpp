// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/find_node_periods.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "step/subcycle/count_rows.hpp"
#include "step/subcycle/tile_exits.hpp"

namespace barreno {
namespace {

/// Tiles that hold particles at the start of the step, or that some may enter from a tile beside.
struct FindHoldingTiles {
  Patch patch;
  BoxTiles box;
  ArrayView<TileFrame> frame;
  ArrayView<unsigned char> level_of_tile;
  ArrayView<int> neighbours, rows;
  ArrayView<double> told;

  /// Within a step no particle enters a tile around finer ones (find_early_arrivals).
  KOKKOS_INLINE_FUNCTION bool takes_particles(int tile) const {
    const TilePosition& at = frame(tile).position;
    return level_of_tile.extent(0) == 0 || level_of_tile(box.box_tile(at)) == at.level;
  }
  KOKKOS_INLINE_FUNCTION bool may_be_entered(int tile) const {
    bool entered = false;
    for_each_neighbour(patch, [&](int k, int x, int y, int z) {
      if (x * x > 1 || y * y > 1 || z * z > 1) return;
      const int other = neighbours(tile * patch.neighbours + k);
      if (other < 0 || other == tile) return;
      entered = entered || (exits_of_tile(told, other) >> back(direction(x, y, z)) & 1U) != 0;
    });
    return entered;
  }
  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const bool holds = takes_particles(tile) && (rows(tile) > 0 || may_be_entered(tile));
    told(tile * told_of_tile + told_holds) = holds ? 1.0 : 0.0;
  }
};

/// @post told_holds of own tiles and ghosts
void find_holding_tiles(
    const Grid& grid, const std::vector<Particles>& sets, const Subcycling& subcycling
) {
  const ArrayView<int> rows = subcycling.entrants;
  count_rows(grid, sets, rows);
  const ArrayView<double> told = subcycling.reach;
  launch(
      "find_holding_tiles",
      range(grid.active),
      FindHoldingTiles{
          grid.patch, grid.box, grid.tile_frame, grid.level_of_tile, grid.neighbours, rows, told}
  );
  const ArrayView<int> parent = grid.parent;
  for (int level = grid.box.levels - 1; level > 0; --level)
    launch(
        "pass_holding_up",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          if (told(tile * told_of_tile + told_holds) != 0.0)
            told(parent(tile) * told_of_tile + told_holds) = 1.0;
        }
    );
  exchange_tiles(grid, told, told_of_tile);
}

struct FindNodePeriods {
  SymmetryPlanes planes;
  NodeConditions conditions;
  Patch patch;
  ArrayView<TileFrame> frame;
  ArrayView<int> neighbours, parent;
  ArrayView<unsigned char> from_parent;
  Subcycling subcycling;

  KOKKOS_INLINE_FUNCTION bool holds(int tile) const {
    return subcycling.reach(tile * told_of_tile + told_holds) != 0.0;
  }
  /// visit(period, offset) of the tiles that count and share nodes with one, itself among them.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_period(int tile, const Visitor& visit) const {
    for_each_neighbour(patch, [&](int k, int x, int y, int z) {
      const int other = neighbours(tile * patch.neighbours + k);
      if (other >= 0 && holds(other)) visit(subcycling.period(other), x, y, z);
    });
  }

  /// 0 among the periods of nodes: no tile that counts has been seen.
  KOKKOS_INLINE_FUNCTION static void join(int period, unsigned char& joint) {
    if (joint == 0)
      joint = static_cast<unsigned char>(period);
    else if (joint != period)
      joint = 1;
  }
  KOKKOS_INLINE_FUNCTION void take_periods(int tile, unsigned char* out) const {
    unsigned char joint = 0;
    for_each_period(tile, [&](int period, int, int, int) { join(period, joint); });
    const bool alike = joint != 1;
    const auto parts = static_cast<unsigned char>(subcycling.parts);
    for (int slot = 0; slot < patch.size; ++slot)
      out[slot] = !alike ? 0 : joint == 0 ? parts : joint;
    if (alike) return;
    for_each_period(tile, [&](int period, int x, int y, int z) {
      for_each_shared_slot(patch, {x, y, z}, [&](int slot) { join(period, out[slot]); });
    });
    for (int slot = 0; slot < patch.size; ++slot)
      if (out[slot] == 0) out[slot] = parts;
  }

  KOKKOS_INLINE_FUNCTION bool is_moved(const TilePosition& at, int slot) const {
    int node[3] = {};
    position_of_slot(patch, slot, node);
    for (int d = 0; d < patch.dimensions; ++d) node[d] += at[d] * patch.tile_cells - patch.reach;
    bool moved = false;
    for (int i = 0; i < conditions.count; ++i) {
      const NodeCondition& c = conditions.list[i];
      moved = moved || (c.table >= 0 && c.holds(node, at.level));
    }
    return moved;
  }
  KOKKOS_INLINE_FUNCTION bool any_is_moved() const {
    bool any = false;
    for (int i = 0; i < conditions.count; ++i) any = any || conditions.list[i].table >= 0;
    return any;
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    unsigned char* const out = &subcycling.node_period(tile * patch.size);
    const TilePosition at = frame(tile).position;
    take_periods(tile, out);
    if (any_is_moved())
      for (int slot = 0; slot < patch.size; ++slot)
        if (is_moved(at, slot)) out[slot] = 1;
    if (at.level > 0) {
      const auto coarser = static_cast<unsigned char>(subcycling.period(parent(tile)));
      for (int slot = 0; slot < patch.size; ++slot)
        if (from_parent(tile * patch.size + slot) != 0) out[slot] = coarser;
    }
    for (int i = 0; i < planes.count; ++i)
      SymmetryPlanes::for_each_image(planes.list[i], patch, at, [&](int behind, int image) {
        out[behind] = out[image];
      });
    unsigned char all = 0;
    for (int slot = 0; slot < patch.size; ++slot) all |= out[slot];
    subcycling.node_periods(tile) = all;
  }
};

}  // namespace

void find_node_periods(
    const SymmetryPlanes& planes,
    const NodeConditions& conditions,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Subcycling& subcycling
) {
  if (!subcycling.on()) return;
  const Region region("find_node_periods");
  find_holding_tiles(grid, sets, subcycling);
  const int parts = subcycling.parts;
  launch(
      "free_empty_tiles",
      RowPolicy(0, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) {
        if (subcycling.reach(tile * told_of_tile + told_holds) == 0.0)
          subcycling.period(tile) = parts;
      }
  );
  launch(
      "find_node_periods",
      range(grid.active),
      FindNodePeriods{
          planes,
          conditions,
          grid.patch,
          grid.tile_frame,
          grid.neighbours,
          grid.parent,
          grid.from_parent,
          subcycling}
  );
}

}  // namespace barreno
