// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/tile_steps.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/tiles.hpp"
#include "step/subcycle/whole_motion.hpp"

namespace barreno {
namespace {

/// Of a tile that ends its step: what its nodes did over all of it. (12.2)
struct EndTileStep {
  WholeMotion of;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Subcycling& subcycling = of.subcycling;
    of.frame(tile).dt = of.step_of(tile, subcycling.period(tile));
    if (!subcycling.takes_whole(tile)) return;
    // What is not solved and has gained nothing is dormant: its particles ask for no motion.
    if (subcycling.gained(tile) == 0 && subcycling.solved(tile) == 0) return;
    const int width = motion_components(of.patch.dimensions);
    double* const out = &subcycling.whole(first_motion(of.patch, tile));
    for (int node = 0; node < of.patch.size; ++node) of.find(tile, node, out + node * width);
  }
};

/// Of a tile whose step goes on.
struct CarryTileStep {
  WholeMotion of;
  ArrayView<double> sums;
  Dormancy dormancy;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Subcycling& subcycling = of.subcycling;
    // The motion of dormant tiles counts as none.
    if (subcycling.solved(tile) == 0 || dormancy.is_dormant(tile)) return;
    const Patch& patch = of.patch;
    const std::size_t first = first_motion(patch, tile);
    const auto width = static_cast<std::size_t>(motion_components(patch.dimensions));
    double* const of_tile = &sums(first_sum(patch, tile));
    const bool adds = subcycling.gained(tile) != 0;
    for (int node = 0; node < patch.size; ++node) {
      const std::size_t at = first + static_cast<std::size_t>(node) * width;
      if (!adds)
        for (std::size_t i = 0; i < width; ++i) subcycling.gain(at + i) = 0.0;
      const int period = of.period_of(tile, node);
      if (subcycling.solves(period))
        carry_node(of.step_of(tile, period), at, of_tile + node * sum_components);
    }
    subcycling.gained(tile) = 1;
  }

  KOKKOS_INLINE_FUNCTION void carry_node(double step, std::size_t at, double* sum) const {
    const int dimensions = of.patch.dimensions;
    const double* const moved = &of.motion(at);
    double* const gain = &of.subcycling.gain(at);
    for (int d = 0; d < dimensions; ++d) {
      gain[d] += step * moved[d];
      gain[dimensions + d] += moved[dimensions + d];
      sum[1 + d] += sum[0] * moved[dimensions + d];
    }
  }
};

template <class Ends>
void end_tiles(
    const Grid& grid, const Nodes& nodes, const Subcycling& subcycling, const Ends& is_end
) {
  const EndTileStep end{{grid.patch, grid.tile_frame, nodes.motion, subcycling}};
  launch(
      "end_tile_steps",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        const bool ends = is_end(tile);
        end.of.subcycling.ends(tile) = ends ? 1 : 0;
        if (ends) end(tile);
      }
  );
}

}  // namespace

void start_tile_steps(const Grid& grid, double dt, const Subcycling& subcycling) {
  if (!subcycling.on()) return set_tile_steps(grid, dt);
  const ArrayView<TileFrame> frame = grid.tile_frame;
  launch(
      "start_tile_steps",
      RowPolicy(0, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) {
        frame(tile).part = dt;
        if (!subcycling.starts(tile)) return;
        frame(tile).dt = subcycling.period(tile) * dt;
        subcycling.gained(tile) = 0;
      }
  );
}

void end_tile_steps(const Grid& grid, const Nodes& nodes, const Subcycling& subcycling) {
  if (!subcycling.on()) return;
  const Region region("end_tile_steps");
  end_tiles(
      grid, nodes, subcycling, KOKKOS_LAMBDA(const int tile) { return subcycling.is_over(tile); }
  );
}

void end_other_tile_steps(const Grid& grid, const Nodes& nodes, const Subcycling& subcycling) {
  const Region region("end_tile_steps");
  end_tiles(
      grid, nodes, subcycling, KOKKOS_LAMBDA(const int tile) { return subcycling.ends(tile) == 0; }
  );
}

void carry_tile_steps(
    const Grid& grid, const Nodes& nodes, const Dormancy& dormancy, const Subcycling& subcycling
) {
  const Region region("carry_tile_steps");
  const CarryTileStep carry{
      {grid.patch, grid.tile_frame, nodes.motion, subcycling}, nodes.sums, dormancy};
  launch(
      "carry_tile_steps",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (carry.of.subcycling.ends(tile) == 0) carry(tile);
      }
  );
}

}  // namespace barreno
