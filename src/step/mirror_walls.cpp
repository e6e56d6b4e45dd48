// SPDX-License-Identifier: BSD-3-Clause
#include "step/mirror_walls.hpp"

#include "base/region.hpp"
#include "step/accelerate_particles.hpp"

#include <algorithm>
#include <utility>

namespace barreno {
namespace {

/// A node beyond a plane across y keeps its mass where its image has the impedance, which it needs
/// no more.
constexpr int kept_mass = impedance_component;

struct Plane {
  int axis = 0;
  int node = 0;
  bool lower = true;
  bool is_beyond(int index) const { return lower ? index < node : index > node; }
};

/// visit(plane) for every symmetry plane, those across y last: they leave masses where the others
/// would look for impedances.
template <class Visitor>
void for_each_plane(const Scene& scene, const Grid& grid, Visitor&& visit) {
  for (const bool across_y : {false, true})
    for (const ConditionSpec& condition : scene.conditions) {
      const int face = static_cast<int>(condition.face);
      if (condition.kind != ConditionKind::symmetry || (face / 2 == 1) != across_y) continue;
      const bool lower = face % 2 == 0;
      visit(Plane{face / 2, lower ? 0 : grid.cells[face / 2], lower});
    }
}

int first_node(const Grid& grid, int axis, int tile) {
  return grid.tile_place(tile)[axis] * grid.patch.tile_cells - grid.patch.reach;
}
bool reaches(const Grid& grid, const Plane& plane, int tile) {
  const int first = first_node(grid, plane.axis, tile);
  return plane.is_beyond(plane.lower ? first : first + grid.patch.nodes - 1);
}

/// visit(slot beyond the plane, slot of its image) of a tile's patch.
template <class Visitor>
void for_each_image(const Grid& grid, const Plane& plane, int tile, Visitor&& visit) {
  if (!reaches(grid, plane, tile)) return;
  const Patch& patch = grid.patch;
  const int first = first_node(grid, plane.axis, tile);
  int stride = 1;
  for (int axis = 0; axis < plane.axis; ++axis) stride *= patch.nodes;
  for (int slot = 0; slot < patch.size; ++slot) {
    const int i = slot / stride % patch.nodes;
    const int image = 2 * (plane.node - first) - i;
    if (plane.is_beyond(first + i) && image >= 0 && image < patch.nodes)
      visit(slot, slot + (image - i) * stride);
  }
}

bool has_plane_across_y(const Scene& scene) {
  return std::any_of(
      scene.conditions.begin(),
      scene.conditions.end(),
      [](const ConditionSpec& condition) {
        return condition.kind == ConditionKind::symmetry &&
               static_cast<int>(condition.face) / 2 == 1;
      }
  );
}

/// Momentum and force of a tile in Nodes::beyond.
std::size_t first_beyond(int tile) {
  return 2 * static_cast<std::size_t>(tile);
}
void clear_beyond(const Scene& scene, const Grid& grid, Nodes& nodes) {
  if (!has_plane_across_y(scene)) return;
  const std::size_t values = first_beyond(grid.active);
  if (nodes.beyond.extent(0) < values) nodes.beyond = ArrayView<double>("beyond", 2 * values);
  std::fill_n(nodes.beyond.data(), values, 0.0);
}

/// Axial impulse that a mirror gives to a tile's particles, and what it changes in v^n.
struct Given {
  double impulse = 0.0, before = 0.0;
};
void enter(const Given& given, double share, GridTally& tally) {
  tally.condition_impulse += given.impulse;
  tally.filter_impulse += given.before;
  tally.taken_impulse += share * given.before;
}

}  // namespace

bool is_mirrored_along_axis(const Scene& scene, const Grid& grid, int tile) {
  bool mirrored = false;
  for_each_plane(scene, grid, [&](const Plane& plane) {
    mirrored = mirrored || (plane.axis == 1 && reaches(grid, plane, tile));
  });
  return mirrored;
}

void fold_walls(const Scene& scene, const Grid& grid, Nodes& nodes) {
  const Region region("fold_walls");
  const int dimensions = grid.patch.dimensions;
  const int force = first_force(dimensions);
  clear_beyond(scene, grid, nodes);
  for_each_plane(scene, grid, [&](const Plane& plane) {
    for (int tile = 0; tile < grid.active; ++tile)
      for_each_image(grid, plane, tile, [&](int beyond, int inside) {
        double* const patch = &nodes.sums(first_sum(grid.patch, tile));
        double* const from = patch + beyond * sum_components;
        double* const to = patch + inside * sum_components;
        to[impedance_component] += std::exchange(from[impedance_component], 0.0);
        if (plane.axis == 1) {
          nodes.beyond(first_beyond(tile)) += from[2];
          nodes.beyond(first_beyond(tile) + 1) += from[force + 1];
          from[kept_mass] = from[0];
        }
        to[0] += std::exchange(from[0], 0.0);
        for (int d = 0; d < dimensions; ++d) {
          const double sign = d == plane.axis ? -1.0 : 1.0;
          to[1 + d] += sign * std::exchange(from[1 + d], 0.0);
          to[force + d] += sign * std::exchange(from[force + d], 0.0);
        }
      });
  });
}

namespace {

/// The motion of a node beyond a plane is its image's, mirrored.
void mirror_motion(int dimensions, int axis, const double* from, double* to) {
  for (int d = 0; d < dimensions; ++d) {
    const double sign = d == axis ? -1.0 : 1.0;
    to[d] = sign * from[d];
    to[dimensions + d] = sign * from[dimensions + d];
  }
}

/// @return what a plane across y gives to the momentum of the tile's nodes beyond it
Given unfold_tile(const Grid& grid, const Plane& plane, int tile, Nodes& nodes) {
  const int dimensions = grid.patch.dimensions;
  const int width = motion_components(dimensions);
  Given given;
  for_each_image(grid, plane, tile, [&](int beyond, int inside) {
    double* const patch = &nodes.motion(first_motion(grid.patch, tile));
    const double* const from = patch + inside * width;
    mirror_motion(dimensions, plane.axis, from, patch + beyond * width);
    if (plane.axis != 1) return;
    const double* const sums = &nodes.sums(first_sum(grid.patch, tile));
    const double mass = sums[beyond * sum_components + kept_mass];
    const double change = from[dimensions + 1];
    given.impulse -= 2.0 * mass * change;
    given.before -= 2.0 * mass * (from[1] - change);
  });
  return given;
}

}  // namespace

void unfold_walls(const Scene& scene, const Grid& grid, double dt, Nodes& nodes, GridTally& tally) {
  const Region region("unfold_walls");
  for_each_plane(scene, grid, [&](const Plane& plane) {
    for (int tile = 0; tile < grid.active; ++tile)
      enter(unfold_tile(grid, plane, tile, nodes), grid_share(scene.step, dt), tally);
  });
  // With M p_I' for p_I' the grid holds -2 p_y more than the particles gave; what they take back
  // from nodes beyond is -2 m v_y more than these would give unmirrored.
  for (int tile = 0; has_plane_across_y(scene) && tile < grid.active; ++tile) {
    const double* const beyond = &nodes.beyond(first_beyond(tile));
    enter({-2.0 * dt * beyond[1], -2.0 * beyond[0]}, grid_share(scene.step, dt), tally);
  }
}

}  // namespace barreno
