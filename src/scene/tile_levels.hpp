// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/grid_section.hpp"
#include "deck/sections/refinement_section.hpp"

#include <array>
#include <vector>

namespace barreno {

/// Tiles of the whole box along each axis; one along z in two dimensions.
std::array<int, 3> box_tiles(const GridSpec& grid);

/// Cells of a tile along each axis are 2 to this; a refined grid has as many levels as tiles of
/// that size.
int tile_bits_of(const GridSpec& grid);

/// Edge of a tile of level 0 [length].
double tile_size_of(const GridSpec& grid);

/// Levels of the tiles of the box: that of the finest region which shares more than a boundary with
/// a tile, and so that neighbouring tiles, those at corners included, differ by one level at most.
///
/// @return by tile, x fastest; empty without a region
std::vector<unsigned char> find_tile_levels(
    const GridSpec& grid, const std::vector<RefinedRegion>& regions
);

/// The same, of small tiles where those make the cells' steps fewer by more than they cost
/// themselves: their patches have more nodes.
std::vector<unsigned char> find_cheapest_levels(
    const GridSpec& grid, const std::vector<RefinedRegion>& regions
);

/// Level of the tile that holds a point; a point outside the box has that of the nearest tile.
int level_at(const GridSpec& grid, const Vector& x);

/// Largest of all levels; 0 where nothing is refined.
int finest_level(const GridSpec& grid);

/// The same box with cells of one level everywhere.
GridSpec uniform_grid(const GridSpec& grid, int level);

/// Edge of the cells of the finest level [length].
double smallest_cell(const GridSpec& grid);

/// Particles that a box is filled with for each that it would hold at level 0, on average.
double refined_share(const GridSpec& grid, const Box& box);

}  // namespace barreno
