// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/reached_tiles.hpp"

#include "base/launch.hpp"
#include "step/subcycle/tile_exits.hpp"

#include <algorithm>

namespace barreno {
namespace {

struct ReachedTiles {
  BoxTiles box;
  int deep;  ///< layers of tiles beside one along z
  ArrayView<TileFrame> frame;
  ArrayView<unsigned char> level_of_tile;
  TileDirectory directory;
  ArrayView<double> reach;

  ReachedTiles(const Grid& grid, const Subcycling& subcycling)
      : box(grid.box),
        deep(grid.patch.dimensions == 3 ? 1 : 0),
        frame(grid.tile_frame),
        level_of_tile(grid.level_of_tile),
        directory(grid.directory),
        reach(subcycling.reach) {}

  /// @return the tile that holds the particles at a place, or -1 if there is none that takes them
  KOKKOS_INLINE_FUNCTION int tile_at(TilePosition at) const {
    if (!box.has(at)) return -1;
    const int level = level_of_tile.extent(0) > 0 ? level_of_tile(box.box_tile(at)) : 0;
    if (level > at.level) return -1;
    while (at.level > level) at = box.parent(at);
    return box.id(at);
  }

  /// visit(number) of the tiles that particles of one may enter and that are not active.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each_of(int tile, const Visitor& visit) const {
    const unsigned exits = exits_of_tile(reach, tile);
    if (exits == 0) return;
    const TilePosition at = frame(tile).position;
    for (int z = -deep; z <= deep; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          if ((exits >> direction(x, y, z) & 1U) == 0) continue;
          const int reached = tile_at({{at[0] + x, at[1] + y, at[2] + z}, at.level});
          if (reached >= 0 && directory(reached) < 0) visit(reached);
        }
  }
};

}  // namespace

int count_reached_tiles(const Grid& grid, const Subcycling& subcycling) {
  const ReachedTiles tiles(grid, subcycling);
  int count = 0;
  launch_reduction(
      "count_reached_tiles",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile, int& sum) { tiles.for_each_of(tile, [&](int) { ++sum; }); },
      count
  );
  return count;
}

std::vector<int> reached_tiles(const Grid& grid, const Subcycling& subcycling) {
  const ReachedTiles tiles(grid, subcycling);
  const auto most = static_cast<std::size_t>(count_reached_tiles(grid, subcycling));
  const ArrayView<int> list("reached_tiles", most), count("reached_count", 1);
  launch(
      "reached_tiles",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        tiles.for_each_of(tile, [&](int reached) { list(fetch_add(count(0), 1)) = reached; });
      }
  );
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), list);
  std::vector<int> out(on_host.data(), on_host.data() + most);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace barreno
