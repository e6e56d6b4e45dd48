// SPDX-License-Identifier: BSD-3-Clause
#include "step/boundary/mirror_nodes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "base/view_of.hpp"

namespace barreno {
namespace {

/// A node behind a plane across y keeps its mass where its image has the impedance, which it needs
/// no more.
constexpr int kept_mass = impedance_component;

/// Momentum and force of a tile in Nodes::mirrored.
KOKKOS_INLINE_FUNCTION std::size_t first_mirrored(int tile) {
  return 2 * static_cast<std::size_t>(tile);
}

/// Takes what a component holds and leaves nothing there.
KOKKOS_INLINE_FUNCTION double take(double& from) {
  const double value = from;
  from = 0.0;
  return value;
}

struct MirrorSums {
  SymmetryPlanes planes;
  Patch patch;
  ArrayView<TileFrame> tile_frame;
  Nodes nodes;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    // Nothing is left behind planes of kept sums; those across y have more to tell of them.
    if (!planes.any_axial && nodes.keeps_sums(tile)) return;
    if (planes.any_axial)
      for (std::size_t i = 0; i < 2; ++i) nodes.mirrored(first_mirrored(tile) + i) = 0.0;
    for (int i = 0; i < planes.count; ++i) {
      const SymmetryPlane& plane = planes.list[i];
      SymmetryPlanes::for_each_image(
          plane,
          patch,
          tile_frame(tile).position,
          [&](int behind, int image) { add_to_image(plane, tile, behind, image); }
      );
    }
  }

  KOKKOS_INLINE_FUNCTION void add_to_image(
      const SymmetryPlane& plane, int tile, int behind, int image
  ) const {
    const int dimensions = patch.dimensions;
    const int force = first_force(dimensions);
    double* const values = &nodes.sums(first_sum(patch, tile));
    double* const from = values + behind * sum_components;
    double* const to = values + image * sum_components;
    to[impedance_component] += take(from[impedance_component]);
    if (plane.axis == 1) {
      nodes.mirrored(first_mirrored(tile)) += from[2];
      nodes.mirrored(first_mirrored(tile) + 1) += from[force + 1];
      from[kept_mass] = from[0];
    }
    to[0] += take(from[0]);
    for (int d = 0; d < dimensions; ++d) {
      const double sign = d == plane.axis ? -1.0 : 1.0;
      to[1 + d] += sign * take(from[1 + d]);
      to[force + d] += sign * take(from[force + d]);
    }
  }
};

/// Axial impulses that symmetry planes give to particles, what of them changes v^n, and what of
/// that particles take.
struct MirrorTally {
  ReproducibleSum impulse, before, taken;
};
KOKKOS_INLINE_FUNCTION void add(const MirrorTally& part, MirrorTally& sum) {
  sum.impulse += part.impulse;
  sum.before += part.before;
  sum.taken += part.taken;
}

struct MirrorVelocities {
  SymmetryPlanes planes;
  GridShare grid_share;
  Patch patch;
  ArrayView<TileFrame> tile_frame;
  ArrayView<double> sums, motion, mirrored;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, MirrorTally& tally) const {
    const double dt = tile_frame(tile).part;
    const double share = grid_share(dt);
    for (int i = 0; i < planes.count; ++i) mirror_tile(planes.list[i], tile, share, tally);
    if (!planes.any_axial) return;
    // With M p_I' for p_I' the grid holds -2 p_y more than the particles gave; what they take back
    // from nodes behind is -2 m v_y more than these would give unmirrored.
    const double* const of_tile = &mirrored(first_mirrored(tile));
    enter(-2.0 * dt * of_tile[1], -2.0 * of_tile[0], share, tally);
  }

  KOKKOS_INLINE_FUNCTION void mirror_tile(
      const SymmetryPlane& plane, int tile, double share, MirrorTally& tally
  ) const {
    const int dimensions = patch.dimensions;
    const int width = motion_components(dimensions);
    double* const nodes = &motion(first_motion(patch, tile));
    const double* const masses = &sums(first_sum(patch, tile));
    double impulse = 0.0, before = 0.0;
    SymmetryPlanes::for_each_image(
        plane,
        patch,
        tile_frame(tile).position,
        [&](int behind, int image) {
          const double* const from = nodes + image * width;
          mirror_motion(plane.axis, from, nodes + behind * width);
          if (plane.axis != 1) return;
          const double mass = masses[behind * sum_components + kept_mass];
          const double change = from[dimensions + 1];
          impulse -= 2.0 * mass * change;
          before -= 2.0 * mass * (from[1] - change);
        }
    );
    if (plane.axis == 1) enter(impulse, before, share, tally);
  }

  /// The motion of a node behind a plane is its image's, mirrored.
  KOKKOS_INLINE_FUNCTION void mirror_motion(int axis, const double* from, double* to) const {
    const int dimensions = patch.dimensions;
    for (int d = 0; d < dimensions; ++d) {
      const double sign = d == axis ? -1.0 : 1.0;
      to[d] = sign * from[d];
      to[dimensions + d] = sign * from[dimensions + d];
    }
  }

  KOKKOS_INLINE_FUNCTION static void enter(
      double impulse, double before, double share, MirrorTally& tally
  ) {
    tally.impulse += impulse;
    tally.before += before;
    tally.taken += share * before;
  }
};

}  // namespace

void mirror_sums(const SymmetryPlanes& planes, const Grid& grid, Nodes& nodes) {
  if (planes.count == 0) return;
  const Region region("mirror_sums");
  if (planes.any_axial) make_room("mirrored", first_mirrored(grid.active), nodes.mirrored);
  launch("mirror_sums", range(grid.active), MirrorSums{planes, grid.patch, grid.tile_frame, nodes});
}

void mirror_velocities(
    const SymmetryPlanes& planes,
    const Grid& grid,
    const GridShare& grid_share,
    const Nodes& nodes,
    GridTally& tally
) {
  if (planes.count == 0) return;
  const Region region("mirror_velocities");
  MirrorTally sum;
  launch_reduction(
      "mirror_velocities",
      range(grid.active),
      MirrorVelocities{
          planes,
          grid_share,
          grid.patch,
          grid.tile_frame,
          nodes.sums,
          nodes.motion,
          nodes.mirrored},
      TallyReducer<MirrorTally>(sum)
  );
  tally.condition_impulse += sum.impulse;
  tally.filter_impulse += sum.before;
  tally.taken_impulse += sum.taken;
}

}  // namespace barreno
