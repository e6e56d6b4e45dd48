// SPDX-License-Identifier: BSD-3-Clause
#include "scene/lighting.hpp"

#include "scene/lighting_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// a + t b
Vector along(const Vector& a, double t, const Vector& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

Vector nearest_on_line(const DetonatorSpec& line, const Vector& x) {
  const Vector way = difference(line.end, line.position);
  const double part = dot(difference(x, line.position), way) / dot(way, way);
  return along(line.position, std::clamp(part, 0.0, 1.0), way);
}

Vector nearest_on_ring(const DetonatorSpec& ring, Mode mode, const Vector& x) {
  if (mode == Mode::axisymmetric) return {ring.radius, ring.position[1], 0.0};
  const Vector from = difference(x, ring.position);
  const Vector across = along(from, -dot(from, ring.normal), ring.normal);
  const double distance = std::sqrt(dot(across, across));
  if (distance > 0.0) return along(ring.position, ring.radius / distance, across);
  // On the ring's axis all of it is equally far: any of its points.
  const bool steep = std::abs(ring.normal[0]) > 0.9;
  const Vector other{steep ? 0.0 : 1.0, steep ? 1.0 : 0.0, 0.0};
  const Vector flat = along(other, -dot(other, ring.normal), ring.normal);
  return along(ring.position, ring.radius / std::sqrt(dot(flat, flat)), flat);
}

}  // namespace

bool is_explosive(const Scene& scene, const BodySpec& body) {
  return scene.materials[static_cast<std::size_t>(body.material)].detonation_speed().has_value();
}

Vector nearest_point(const DetonatorSpec& detonator, Mode mode, const Vector& x) {
  switch (detonator.kind) {
    case DetonatorKind::line:
      return nearest_on_line(detonator, x);
    case DetonatorKind::ring:
      return nearest_on_ring(detonator, mode, x);
    case DetonatorKind::plane:
      return along(x, -dot(difference(x, detonator.position), detonator.normal), detonator.normal);
    default:
      return detonator.position;
  }
}

double straight_lighting_time(const DetonationSpec& detonation, Mode mode, const Vector& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const DetonatorSpec& detonator : detonation.detonators) {
    const Vector way = difference(x, nearest_point(detonator, mode, x));
    least = std::min(least, detonator.time + std::sqrt(dot(way, way)) / detonation.speed);
  }
  return least;
}

double lighting_time(const DetonationSpec& detonation, Mode mode, const Vector& x) {
  if (detonation.map) return detonation.map->time_at(x);
  return straight_lighting_time(detonation, mode, x);
}

}  // namespace barreno
