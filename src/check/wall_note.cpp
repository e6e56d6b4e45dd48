// SPDX-License-Identifier: BSD-3-Clause
#include "check/wall_note.hpp"

#include "base/format.hpp"
#include "base/numbers.hpp"
#include "deck/section_table.hpp"
#include "geometry/piece.hpp"
#include "scene/geometry.hpp"
#include "scene/lighting.hpp"
#include "scene/tile_levels.hpp"
#include "state/bodies/body_particles.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr double fewest_cells = 2.0;
/// Few directions and places find a wall to some percent.
constexpr double accuracy = 0.05;
constexpr long long most_places = 400;

/// Evenly on the circle, or nearly so on the sphere (a Fibonacci spiral).
std::vector<Vector> directions_in(int dimensions) {
  const int count = dimensions == 2 ? 32 : 128;
  const double golden_angle = pi * (3.0 - std::sqrt(5.0));
  std::vector<Vector> directions;
  for (int i = 0; i < count; ++i) {
    const double angle = dimensions == 2 ? two_pi * i / count : golden_angle * i;
    const double z = dimensions == 2 ? 0.0 : (2.0 * i + 1.0) / count - 1.0;
    const double across = std::sqrt(1.0 - z * z);
    directions.push_back({across * std::cos(angle), across * std::sin(angle), z});
  }
  return directions;
}

/// A body and its images in the axis and in planes of symmetry, where it has no surface.
class MirroredBody {
public:
  MirroredBody(const Scene& scene, const BodySpec& body)
      : scene_(scene), body_(body), dimensions_(dimensions(scene.grid.mode)) {}

  bool holds_at(Vector x) const {
    if (scene_.grid.mode == Mode::axisymmetric) x[0] = std::abs(x[0]);
    for (const ConditionSpec& condition : scene_.conditions) {
      if (condition.kind != ConditionKind::symmetry) continue;
      const auto face = static_cast<std::size_t>(condition.face);
      const std::size_t axis = face / 2;
      const bool lower = face % 2 == 0;
      const double at = lower ? scene_.grid.lower[axis] : scene_.grid.upper[axis];
      if (lower ? x[axis] < at : x[axis] > at) x[axis] = 2.0 * at - x[axis];
    }
    return holds(body_.shape, x, dimensions_);
  }

  /// Where a ray leaves the body; no more than `most` [length].
  double way_out(const Vector& from, const Vector& direction, double most) const {
    constexpr int steps = 12, halvings = 6;
    const auto held = [&](double way) {
      return holds_at(
          {from[0] + way * direction[0], from[1] + way * direction[1], from[2] + way * direction[2]}
      );
    };
    double inside = 0.0, outside = 0.0;
    for (int i = 1; i <= steps && outside == 0.0; ++i)
      (held(most * i / steps) ? inside : outside) = most * i / steps;
    if (outside == 0.0) return most;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (held(middle) ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
  }

private:
  const Scene& scene_;
  const BodySpec& body_;
  int dimensions_;
};

bool boxes_touch(const Scene& scene, const BodySpec& a, const BodySpec& b) {
  const Box one = box_around(a.shape, scene.grid), other = box_around(b.shape, scene.grid);
  const double tolerance = length_tolerance(scene.grid);
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++d)
    if (std::max(one.lower[d] - other.upper[d], other.lower[d] - one.upper[d]) > tolerance)
      return false;
  return true;
}

bool is_beside_explosive(const Scene& scene, const BodySpec& body) {
  if (body.motion.prescribed || is_explosive(scene, body)) return false;
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& other) {
    return is_explosive(scene, other) && boxes_touch(scene, body, other);
  });
}

}  // namespace

double cells_of_wall(const Scene& scene, const BodySpec& body) {
  const MirroredBody mirrored(scene, body);
  const std::vector<Vector> directions = directions_in(dimensions(scene.grid.mode));
  const long long stride =
      count_body_particles(scene.grid, body, box_cuts(scene)) / most_places + 1;
  long long particle = 0;
  double sum = 0.0, count = 0.0;
  for_each_body_particle(
      scene.grid,
      body,
      0,
      [&](const NewParticle& p) {
        if (particle++ % stride != 0) return;
        const double cell = scene.grid.cell_size / (1 << level_at(scene.grid, p.x));
        double least = cell;
        for (const Vector& direction : directions)
          least = std::min(least, mirrored.way_out(p.x, direction, least));
        sum += least / cell;
        count += 1.0;
      },
      box_cuts(scene)
  );
  return count > 0.0 ? 4.0 * sum / count : 0.0;
}

std::string wall_note(const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    if (!is_beside_explosive(scene, body)) continue;
    const double cells = cells_of_wall(scene, body);
    if (cells >= fewest_cells * (1.0 - accuracy)) continue;
    return list_of<BodySpec>(body.name) +
           format(
               " has a wall of about %.2g cells beside the explosive, fewer than %g, so neither "
               "its motion nor a jet of it is resolved; make cells smaller or the wall thicker",
               cells,
               fewest_cells
           );
  }
  return {};
}

}  // namespace barreno
