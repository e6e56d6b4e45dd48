// SPDX-License-Identifier: BSD-3-Clause
#include "check/gap_notes.hpp"

#include "base/format.hpp"
#include "deck/section_table.hpp"
#include "jet/path.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace barreno {
namespace {

/// Of more bodies not every pair is looked at.
constexpr std::size_t most_bodies = 300;

std::string list_name(const BodySpec& body) {
  return list_of<BodySpec>(body.name);
}

std::string path_gap_note(const Scene& scene) {
  if (!scene.jet.present) return {};
  const std::vector<PathLayer> layers = path_layers(scene, widest_radius(scene));
  if (layers.empty()) return {};
  PathLayer front = layers.front();
  for (const PathLayer& layer : layers) {
    const double gap = layer.near - front.far;
    if (gap > length_tolerance(scene.grid))
      return list_name(scene.bodies[layer.body]) + " and " + list_name(scene.bodies[front.body]) +
             format(
                 " do not touch in the path of the jet (a gap of %.4g m or %.3g cells, which it "
                 "crosses in free flight); if they should, move one of them",
                 gap,
                 gap / scene.grid.cell_size
             );
    if (layer.far > front.far) front = layer;
  }
  return {};
}

bool moves_unevenly(const BodySpec& body) {
  return body.motion.prescribed || body.spin != 0.0 || body.radial_velocity != 0.0 ||
         body.velocity_wave_number != Vector{};
}

bool at_rest_to_each_other(const BodySpec& a, const BodySpec& b) {
  return !moves_unevenly(a) && !moves_unevenly(b) && a.velocity == b.velocity;
}

/// Distance of two boxes that face each other; nothing if they touch, or face each other nowhere.
std::optional<double> facing_gap(const Box& a, const Box& b, const GridSpec& grid) {
  const double tolerance = length_tolerance(grid);
  std::optional<double> gap;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    const double apart = std::max(a.lower[d] - b.upper[d], b.lower[d] - a.upper[d]);
    if (apart < -tolerance) continue;  // they share a part of this axis
    if (gap || apart <= tolerance) return {};
    gap = apart;
  }
  return gap;
}

std::string narrow_gap_note(const Scene& scene) {
  const std::vector<BodySpec>& bodies = scene.bodies;
  if (bodies.size() > most_bodies) return {};
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Box* const first = std::get_if<Box>(&bodies[a].shape);
      const Box* const second = std::get_if<Box>(&bodies[b].shape);
      if (first == nullptr || second == nullptr || !at_rest_to_each_other(bodies[a], bodies[b]))
        continue;
      const auto gap = facing_gap(*first, *second, scene.grid);
      if (!gap || *gap >= scene.grid.cell_size) continue;
      return list_name(bodies[b]) + " and " + list_name(bodies[a]) +
             format(
                 " are at rest %.4g m apart, %.3g cells (bodies within a cell share nodes and act "
                 "on each other across the gap); if they should touch, move one of them, else make "
                 "cells smaller",
                 *gap,
                 *gap / scene.grid.cell_size
             );
    }
  return {};
}

}  // namespace

std::vector<std::string> gap_notes(const Scene& scene) {
  std::vector<std::string> notes;
  std::string path = path_gap_note(scene);
  // One gap, one sentence.
  std::string narrow = path.empty() ? narrow_gap_note(scene) : std::string();
  for (std::string* note : {&path, &narrow})
    if (!note->empty()) notes.push_back(std::move(*note));
  return notes;
}

}  // namespace barreno
