// SPDX-License-Identifier: BSD-3-Clause
#include "scene/input_speeds.hpp"

#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

double largest_factor(const Table& factor) {
  double largest = 0.0;
  for (const double value : factor.value) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

double rim_speed(const BodySpec& body, const GridSpec& grid) {
  if (body.spin == 0.0) return 0.0;
  const Box box = box_around(body.shape, grid);
  return std::abs(body.spin) * std::hypot(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
}

double body_speed(const BodySpec& body, const GridSpec& grid) {
  return length_of(body.velocity) + std::abs(body.radial_velocity) + rim_speed(body, grid);
}

double motion_speed(const MotionSpec& motion) {
  return length_of(motion.velocity) * largest_factor(motion.factor);
}

double face_speed(const ConditionSpec& condition) {
  return length_of(condition.velocity) * largest_factor(condition.factor);
}

double largest_input_speed(const Scene& scene) {
  double largest = 0.0;
  for (const BodySpec& body : scene.bodies) {
    const double moved = body.motion.prescribed ? motion_speed(body.motion) : 0.0;
    largest = std::max({largest, moved, body_speed(body, scene.grid)});
  }
  for (const JetSlug& slug : scene.jet.slugs) largest = std::max(largest, slug.velocity);
  for (const ConditionSpec& face : scene.conditions) largest = std::max(largest, face_speed(face));
  return largest;
}

}  // namespace barreno
