// SPDX-License-Identifier: BSD-3-Clause
#include "state/load_table.hpp"

#include "base/view_of.hpp"
#include "state/surface_share.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace barreno {
namespace {

/// visit(index of the load, face or surface, whether it is a surface) for a body's loaded faces.
template <class Visitor>
void for_each_loaded_face(const Scene& scene, int body, Visitor&& visit) {
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const PressureLoadSpec& load = scene.loads[l];
    if (load.body != body) continue;
    for (unsigned face = 0; face < load.faces.size(); ++face)
      if (load.faces[face]) visit(static_cast<int>(l), face, false);
    for (unsigned surface = 0; surface < load.surfaces.size(); ++surface)
      if (load.surfaces[surface]) visit(static_cast<int>(l), surface, true);
  }
}

}  // namespace

LoadTable make_load_table(const Scene& scene) {
  std::vector<AppliedLoad> loads;
  for (const PressureLoadSpec& load : scene.loads)
    loads.push_back({0.0, traits_of(load.kind).absorbs, is_on_surfaces(load)});
  std::vector<LoadedFace> faces;
  std::vector<int> first;
  for (int body = 0; body <= static_cast<int>(scene.bodies.size()); ++body) {
    first.push_back(static_cast<int>(faces.size()));
    for_each_loaded_face(scene, body, [&](int load, unsigned face, bool) {
      faces.push_back({load, static_cast<int>(face)});
    });
  }
  first.push_back(static_cast<int>(faces.size()));
  if (max_loaded_faces(scene) > std::numeric_limits<double>::digits)
    throw std::logic_error("a body has more loaded faces than a double has bits");
  LoadTable table;
  table.loads = view_of("loads", loads);
  table.faces = view_of("loaded_faces", faces);
  table.first = view_of("first_loaded_face", first);
  table.any = !loads.empty();
  table.any_on_surfaces = std::any_of(loads.begin(), loads.end(), [](const AppliedLoad& load) {
    return load.on_surfaces;
  });
  return table;
}

double loaded_face_bits(const Scene& scene, int body, unsigned sides) {
  double bits = 0.0;
  int i = 0;
  for_each_loaded_face(scene, body, [&](int, unsigned face, bool is_surface) {
    // Every particle of a ball has a share of its surfaces.
    if (is_surface || (sides >> face & 1U) != 0) bits += std::ldexp(1.0, i);
    ++i;
  });
  return bits;
}

int max_loaded_faces(const Scene& scene) {
  int most = 0;
  for (int body = 0; body < static_cast<int>(scene.bodies.size()); ++body) {
    int count = 0;
    for_each_loaded_face(scene, body, [&](int, unsigned, bool) { ++count; });
    most = std::max(most, count);
  }
  return most;
}

}  // namespace barreno
