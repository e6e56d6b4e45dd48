// SPDX-License-Identifier: BSD-3-Clause
#include "scene/tile_levels.hpp"

#include "base/work_counts.hpp"
#include "scene/geometry.hpp"
#include "scene/tile_size.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// Of a tile of the box, x fastest.
std::size_t index_of(const std::array<int, 3>& tiles, const std::array<int, 3>& at) {
  const auto along = [](int n) { return static_cast<std::size_t>(n); };
  return (along(at[2]) * along(tiles[1]) + along(at[1])) * along(tiles[0]) + along(at[0]);
}

/// visit(index of a tile of the box, its place) for all of them.
template <class Visitor>
void for_each_box_tile(const std::array<int, 3>& tiles, Visitor&& visit) {
  std::size_t index = 0;
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < tiles[2]; ++at[2])
    for (at[1] = 0; at[1] < tiles[1]; ++at[1])
      for (at[0] = 0; at[0] < tiles[0]; ++at[0]) visit(index++, at);
}

std::array<int, 3> box_tiles_of(const GridSpec& grid, int bits) {
  std::array<int, 3> tiles{1, 1, 1};
  const int along = 1 << bits;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    // A box that is a whole number of cells up to round-off has that number.
    const double cells = std::ceil((grid.upper[d] - grid.lower[d]) / grid.cell_size - 1e-9);
    tiles[d] = (static_cast<int>(cells) + along - 1) / along;
  }
  return tiles;
}

std::size_t count_of(const std::array<int, 3>& tiles) {
  return index_of(tiles, {0, 0, tiles[2]});
}

Box box_of_tile(const GridSpec& grid, const std::array<int, 3>& at, double size) {
  Box box{grid.lower, grid.upper};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    box.lower[d] = grid.lower[d] + at[d] * size;
    box.upper[d] = std::min(box.lower[d] + size, grid.upper[d]);
  }
  return box;
}

/// The largest level around a tile.
int level_around(
    const std::vector<unsigned char>& level,
    const std::array<int, 3>& tiles,
    const std::array<int, 3>& at
) {
  std::array<int, 3> from{}, to{};
  for (std::size_t d = 0; d < 3; ++d) {
    from[d] = std::max(at[d] - 1, 0);
    to[d] = std::min(at[d] + 1, tiles[d] - 1);
  }
  int most = 0;
  for (int z = from[2]; z <= to[2]; ++z)
    for (int y = from[1]; y <= to[1]; ++y)
      for (int x = from[0]; x <= to[0]; ++x)
        most = std::max<int>(most, level[index_of(tiles, {x, y, z})]);
  return most;
}

/// Raises levels until neighbours differ by one at most: from the finest down, since a level that
/// is raised is below all that were looked at.
void grade(const std::array<int, 3>& tiles, std::vector<unsigned char>& level) {
  for (int l = max_level; l > 1; --l) {
    const std::vector<unsigned char> before = level;
    for_each_box_tile(tiles, [&](std::size_t t, const std::array<int, 3>& at) {
      if (level_around(before, tiles, at) >= l && level[t] < l - 1)
        level[t] = static_cast<unsigned char>(l - 1);
    });
  }
}

std::vector<unsigned char> levels_of_tiles(
    const GridSpec& grid, const std::vector<RefinedRegion>& regions, int bits
) {
  const std::array<int, 3> tiles = box_tiles_of(grid, bits);
  const double size = grid.cell_size * (1 << bits);
  std::vector<unsigned char> level(count_of(tiles));
  work_counts().undivided_points += static_cast<long long>(level.size());
  for_each_box_tile(tiles, [&](std::size_t t, const std::array<int, 3>& at) {
    for (const RefinedRegion& region : regions)
      if (region.level > level[t] &&
          overlap(region.shape, box_of_tile(grid, at, size), grid, grid.cell_size))
        level[t] = static_cast<unsigned char>(region.level);
  });
  grade(tiles, level);
  return level;
}

/// Steps of all cells: one of half the size is one of 2^d, and takes twice as many.
double cell_steps(const GridSpec& grid, const std::vector<unsigned char>& levels, int bits) {
  const int dimension = dimensions(grid.mode);
  double sum = 0.0;
  for (const unsigned char level : levels) sum += std::pow(2.0, level * (dimension + 1));
  return sum * std::pow(2.0, bits * dimension);
}

}  // namespace

int tile_bits_of(const GridSpec& grid) {
  const std::size_t levels = grid.level_of_tile.size();
  return levels == 0 || levels == count_of(box_tiles_of(grid, tile_bits)) ? tile_bits
                                                                          : small_tile_bits;
}

double tile_size_of(const GridSpec& grid) {
  return grid.cell_size * (1 << tile_bits_of(grid));
}

std::array<int, 3> box_tiles(const GridSpec& grid) {
  return box_tiles_of(grid, tile_bits_of(grid));
}

std::vector<unsigned char> find_tile_levels(
    const GridSpec& grid, const std::vector<RefinedRegion>& regions
) {
  if (regions.empty()) return {};
  return levels_of_tiles(grid, regions, tile_bits);
}

std::vector<unsigned char> find_cheapest_levels(
    const GridSpec& grid, const std::vector<RefinedRegion>& regions
) {
  constexpr double worth_it = 6.0 / 7.0;
  std::vector<unsigned char> usual = find_tile_levels(grid, regions);
  if (usual.empty()) return usual;
  std::vector<unsigned char> small = levels_of_tiles(grid, regions, small_tile_bits);
  const bool saves =
      cell_steps(grid, small, small_tile_bits) < worth_it * cell_steps(grid, usual, tile_bits);
  // The number of levels tells the two apart (tile_bits_of).
  return saves && small.size() != usual.size() ? small : usual;
}

int level_at(const GridSpec& grid, const Vector& x) {
  if (grid.level_of_tile.empty()) return 0;
  const std::array<int, 3> tiles = box_tiles(grid);
  const double size = tile_size_of(grid);
  std::array<int, 3> at{};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    const double tile = std::floor((x[d] - grid.lower[d]) / size);
    at[d] = static_cast<int>(std::clamp(tile, 0.0, tiles[d] - 1.0));
  }
  return grid.level_of_tile[index_of(tiles, at)];
}

GridSpec uniform_grid(const GridSpec& grid, int level) {
  return {grid.mode, grid.lower, grid.upper, grid.cell_size / (1 << level), {}};
}

int finest_level(const GridSpec& grid) {
  const auto& levels = grid.level_of_tile;
  return levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
}

double smallest_cell(const GridSpec& grid) {
  return uniform_grid(grid, finest_level(grid)).cell_size;
}

double refined_share(const GridSpec& grid, const Box& box) {
  if (grid.level_of_tile.empty()) return 1.0;
  const int dimension = dimensions(grid.mode);
  const double size = tile_size_of(grid);
  double whole = 0.0;
  double weighted = 0.0;
  for_each_box_tile(box_tiles(grid), [&](std::size_t t, const std::array<int, 3>& at) {
    const Box tile = box_of_tile(grid, at, size);
    double common = 1.0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
      common *= std::max(
          0.0, std::min(box.upper[d], tile.upper[d]) - std::max(box.lower[d], tile.lower[d])
      );
    whole += common;
    weighted += common * std::pow(2.0, dimension * grid.level_of_tile[t]);
  });
  return whole > 0.0 ? weighted / whole : 1.0;
}

}  // namespace barreno
