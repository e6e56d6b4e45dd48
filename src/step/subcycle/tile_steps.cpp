// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/tile_steps.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/tiles.hpp"

namespace barreno {
namespace {

/// Of a tile that ends its step: what its nodes did over all of it, with the path that one step of
/// that length goes beyond several of its parts: without it a vibration gains energy. (12.2)
struct EndTileStep {
  Patch patch;
  double dt;
  ArrayView<TileFrame> frame;
  ArrayView<double> motion;
  Subcycling subcycling;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const double whole_step = subcycling.elapsed(tile) + dt;
    frame(tile).dt = whole_step;
    if (subcycling.elapsed(tile) == 0.0) return;
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    const std::size_t first = first_motion(patch, tile);
    const bool gained = subcycling.gained(tile) != 0;
    const bool moved = subcycling.solved(tile) != 0;  // what is not solved is motionless
    if (!gained && !moved) return;  // it is dormant: its particles ask for no motion
    const double lead = 0.5 * subcycling.elapsed(tile);
    for (int node = 0; node < patch.size; ++node) {
      const double* const of_part = &motion(first) + node * width;
      const double* const before = &subcycling.gain(first) + node * width;
      double* const out = &subcycling.whole(first) + node * width;
      for (int d = 0; d < dimensions; ++d) {
        const double path = (gained ? before[d] : 0.0) + (moved ? dt * of_part[d] : 0.0);
        const double change =
            (gained ? before[dimensions + d] : 0.0) + (moved ? of_part[dimensions + d] : 0.0);
        out[d] = (path + lead * change) / whole_step;
        out[dimensions + d] = change;
      }
      for (int d = 2 * dimensions; d < width; ++d) out[d] = 0.0;
    }
  }
};

/// Of a tile whose step goes on.
struct CarryTileStep {
  Patch patch;
  double dt;
  ArrayView<double> sums, motion;
  Dormancy dormancy;
  Subcycling subcycling;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    subcycling.elapsed(tile) += dt;
    // The motion of dormant tiles counts as none.
    if (subcycling.solved(tile) == 0 || dormancy.is_dormant(tile)) return;
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    const std::size_t first = first_motion(patch, tile);
    double* const of_tile = &sums(first_sum(patch, tile));
    const bool adds = subcycling.gained(tile) != 0;
    for (int node = 0; node < patch.size; ++node) {
      const double* const of_part = &motion(first) + node * width;
      double* const gain = &subcycling.gain(first) + node * width;
      double* const sum = of_tile + node * sum_components;
      for (int d = 0; d < dimensions; ++d) {
        gain[d] = (adds ? gain[d] : 0.0) + dt * of_part[d];
        gain[dimensions + d] = (adds ? gain[dimensions + d] : 0.0) + of_part[dimensions + d];
        sum[1 + d] += sum[0] * of_part[dimensions + d];
      }
    }
    subcycling.gained(tile) = 1;
  }
};

template <class Ends>
void end_tiles(
    const Grid& grid,
    double dt,
    const Nodes& nodes,
    const Subcycling& subcycling,
    const Ends& is_end
) {
  const EndTileStep end{grid.patch, dt, grid.tile_frame, nodes.motion, subcycling};
  launch(
      "end_tile_steps",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        const bool ends = is_end(tile);
        end.subcycling.ends(tile) = ends ? 1 : 0;
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
        subcycling.elapsed(tile) = 0.0;
        subcycling.gained(tile) = 0;
      }
  );
}

void end_tile_steps(const Grid& grid, double dt, const Nodes& nodes, const Subcycling& subcycling) {
  if (!subcycling.on()) return;
  const Region region("end_tile_steps");
  end_tiles(
      grid,
      dt,
      nodes,
      subcycling,
      KOKKOS_LAMBDA(const int tile) { return subcycling.is_over(tile); }
  );
}

void end_other_tile_steps(
    const Grid& grid, double dt, const Nodes& nodes, const Subcycling& subcycling
) {
  const Region region("end_tile_steps");
  end_tiles(
      grid,
      dt,
      nodes,
      subcycling,
      KOKKOS_LAMBDA(const int tile) { return subcycling.ends(tile) == 0; }
  );
}

void carry_tile_steps(
    const Grid& grid,
    double dt,
    const Nodes& nodes,
    const Dormancy& dormancy,
    const Subcycling& subcycling
) {
  const Region region("carry_tile_steps");
  const CarryTileStep carry{grid.patch, dt, nodes.sums, nodes.motion, dormancy, subcycling};
  launch(
      "carry_tile_steps",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (carry.subcycling.ends(tile) == 0) carry(tile);
      }
  );
}

}  // namespace barreno
