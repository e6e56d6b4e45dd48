// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/points.hpp"
#include "grid/grid.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Cell size and step of the tile that a particle is in; captured by value in kernels over rows.
/// @pre the particles are in their tiles (place_particles), whose steps are set (set_tile_steps)
struct RowFrames {
  ArrayView<TileFrame> tile_frame;
  ArrayView<CellKey> key;
  int cell_bits;  ///< of a key; the tile stands above them

  RowFrames(const Grid& grid, const Particles& particles)
      : tile_frame(grid.tile_frame),
        key(particles.key),
        cell_bits(grid.patch.tile_bits * grid.patch.dimensions) {}

  KOKKOS_INLINE_FUNCTION int tile(int p) const { return index_of(key(p)) >> cell_bits; }
  KOKKOS_INLINE_FUNCTION double dt(int p) const { return tile_frame(tile(p)).dt; }
  KOKKOS_INLINE_FUNCTION double cell_size(int p) const { return tile_frame(tile(p)).cell_size; }
};

/// The same of `count` neighbouring rows, as PointGroup takes them: by lanes.
template <class R>
struct GroupFrame {
  R cell_size, dt;

  KOKKOS_INLINE_FUNCTION GroupFrame(const RowFrames& frames, int first, int count) {
    if constexpr (width<R> == 1) {
      cell_size = frames.cell_size(first);
      dt = frames.dt(first);
    } else {
      // Neighbouring rows are in one tile nearly always.
      const int tile = frames.tile(first);
      int others = 0;
      for (int i = 1; i < count; ++i) others |= frames.tile(first + i) ^ tile;
      const TileFrame& frame = frames.tile_frame(tile);
      cell_size = R{} + frame.cell_size;
      dt = R{} + frame.dt;
      for (int i = 1; others != 0 && i < width<R>; ++i) {
        const int p = first + (i < count ? i : count - 1);
        cell_size[i] = frames.cell_size(p);
        dt[i] = frames.dt(p);
      }
    }
  }
};

}  // namespace barreno
